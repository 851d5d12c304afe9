// SPDX-License-Identifier: Apache-2.0
#include "core/titles/TitleLanguage.h"

namespace core {

namespace {

/// An argument as text.
struct Argument {
    const RowTitle& title; ///< whose it is
    const TitleLanguage& language;

    QString operator()(const TitleCount& count) const { return grouped(count.count); }
    QString operator()(const TitleNumber& number) const { return QString::number(number.number); }
    QString operator()(const TitleDecimal& decimal) const
    {
        return QString::number(decimal.value, 'f', decimal.decimals);
    }
    QString operator()(const TitleDigits& digits) const
    {
        return QString::number(digits.value, 'g', digits.digits);
    }
    QString operator()(const QString& text) const { return text; }
    QString operator()(const std::vector<RowTitle>& titles) const
    {
        QStringList texts;
        for (const RowTitle& each : titles)
            texts += worded(each, language);
        return texts.join(language.joiner(title.code));
    }
};

} // namespace

QString worded(const RowTitle& title, const TitleLanguage& language)
{
    QStringList arguments;
    for (const TitleArgument& argument : title.arguments)
        arguments += std::visit(Argument{.title = title, .language = language}, argument);
    QString text = language.text(title, arguments);
    for (const RowTitle& more : title.then)
        text += language.comma() + worded(more, language);
    return text;
}

QString grouped(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

bool isOfOne(const RowTitle& title)
{
    const auto* count =
        title.arguments.empty() ? nullptr : std::get_if<TitleCount>(&title.arguments.front());
    return count && count->count == 1;
}

} // namespace core
