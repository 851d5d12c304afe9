// SPDX-License-Identifier: Apache-2.0
#include "core/titles/TitleJson.h"

#include "core/titles/TitleForms.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <limits>
#include <utility>

namespace core {

namespace {

constexpr QLatin1String codeKey("code");
constexpr QLatin1String argumentsKey("arguments");
constexpr QLatin1String thenKey("then");
constexpr QLatin1String countKey("count");
constexpr QLatin1String numberKey("number");
constexpr QLatin1String decimalKey("decimal");
constexpr QLatin1String decimalsKey("decimals");
constexpr QLatin1String valueKey("value");
constexpr QLatin1String digitsKey("digits");

QJsonArray toJson(const std::vector<RowTitle>& titles)
{
    QJsonArray list;
    for (const RowTitle& title : titles)
        list.append(titleToJson(title));
    return list;
}

struct ArgumentToJson {
    QJsonValue operator()(const TitleCount& count) const
    {
        return QJsonObject{{countKey, qint64(count.count)}};
    }
    QJsonValue operator()(const TitleNumber& number) const
    {
        return QJsonObject{{numberKey, qint64(number.number)}};
    }
    QJsonValue operator()(const TitleDecimal& decimal) const
    {
        return QJsonObject{{decimalKey, decimal.value}, {decimalsKey, decimal.decimals}};
    }
    QJsonValue operator()(const TitleDigits& digits) const
    {
        return QJsonObject{{valueKey, digits.value}, {digitsKey, digits.digits}};
    }
    QJsonValue operator()(const QString& text) const { return text; }
    QJsonValue operator()(const std::vector<RowTitle>& titles) const { return toJson(titles); }
};

std::optional<RowTitle> titleWithin(const QJsonObject& json, int depth);

/// None where one of them is none.
std::optional<std::vector<RowTitle>> titlesWithin(const QJsonArray& list, int depth)
{
    if (list.size() > TitleLimits::titles)
        return std::nullopt;
    std::vector<RowTitle> titles;
    for (const QJsonValue& each : list) {
        std::optional<RowTitle> title = titleWithin(each.toObject(), depth);
        if (!title)
            return std::nullopt;
        titles.push_back(*std::move(title));
    }
    return titles;
}

std::optional<std::int64_t> wholeOf(const QJsonValue& value)
{
    constexpr qint64 none = std::numeric_limits<qint64>::min();
    const qint64 whole = value.toInteger(none);
    return whole == none ? std::nullopt : std::optional<std::int64_t>(whole);
}

std::optional<int> digitsOf(const QJsonValue& value)
{
    constexpr int most = 15;
    const int digits = value.toInt(-1);
    return digits < 0 || digits > most ? std::nullopt : std::optional(digits);
}

std::optional<TitleArgument> numberArgument(const QJsonObject& json)
{
    if (const auto count = wholeOf(json.value(countKey)))
        return TitleCount{*count};
    if (const auto number = wholeOf(json.value(numberKey)))
        return TitleNumber{*number};
    const QJsonValue decimal = json.value(decimalKey);
    const auto decimals = digitsOf(json.value(decimalsKey));
    if (decimal.isDouble() && decimals)
        return TitleDecimal{.value = decimal.toDouble(), .decimals = *decimals};
    const QJsonValue value = json.value(valueKey);
    const auto digits = digitsOf(json.value(digitsKey));
    if (value.isDouble() && digits)
        return TitleDigits{.value = value.toDouble(), .digits = *digits};
    return std::nullopt;
}

std::optional<TitleArgument> argumentWithin(const QJsonValue& json, int depth)
{
    if (json.isString())
        return json.toString();
    if (json.isObject())
        return numberArgument(json.toObject());
    if (!json.isArray())
        return std::nullopt;
    std::optional<std::vector<RowTitle>> titles = titlesWithin(json.toArray(), depth);
    if (!titles)
        return std::nullopt;
    return *std::move(titles);
}

std::optional<RowTitle> titleWithin(const QJsonObject& json, int depth)
{
    const std::optional<RowTitleCode> code = titleCodeFrom(json.value(codeKey).toString());
    const QJsonArray arguments = json.value(argumentsKey).toArray();
    if (depth < 1 || !code || arguments.size() > TitleLimits::arguments)
        return std::nullopt;
    RowTitle title{.code = *code};
    for (const QJsonValue& each : arguments) {
        std::optional<TitleArgument> argument = argumentWithin(each, depth - 1);
        if (!argument)
            return std::nullopt;
        title.arguments.push_back(*std::move(argument));
    }
    std::optional<std::vector<RowTitle>> then =
        titlesWithin(json.value(thenKey).toArray(), depth - 1);
    if (!then)
        return std::nullopt;
    title.then = *std::move(then);
    return title;
}

/// How many arguments the text of a title has places for.
std::size_t placesOf(RowTitleCode code)
{
    const QLatin1String text(formOf(code).text);
    std::size_t places = 0;
    for (std::size_t number = 1; number <= TitleLimits::arguments; ++number) {
        const char place[] = {'%', char('0' + number), '\0'};
        if (text.contains(QLatin1String(place)))
            places = number;
    }
    return places;
}

bool saysAllThatItHolds(const RowTitle& title);

bool sayAllThatTheyHold(const std::vector<RowTitle>& titles)
{
    return std::all_of(titles.begin(), titles.end(), saysAllThatItHolds);
}

/// Whether each argument has a place in the text: what nobody sees is no part of a title.
bool saysAllThatItHolds(const RowTitle& title)
{
    return title.arguments.size() == placesOf(title.code) && sayAllThatTheyHold(title.then)
        && std::all_of(
            title.arguments.begin(), title.arguments.end(), [](const TitleArgument& argument) {
                const auto* titles = std::get_if<std::vector<RowTitle>>(&argument);
                return !titles || sayAllThatTheyHold(*titles);
            });
}

} // namespace

QJsonObject titleToJson(const RowTitle& title)
{
    QJsonObject json{{codeKey, QLatin1String(formOf(title.code).id)}};
    if (!title.arguments.empty()) {
        QJsonArray list;
        for (const TitleArgument& argument : title.arguments)
            list.append(std::visit(ArgumentToJson(), argument));
        json.insert(argumentsKey, list);
    }
    if (!title.then.empty())
        json.insert(thenKey, toJson(title.then));
    return json;
}

std::optional<RowTitle> titleFromJson(const QJsonObject& json)
{
    return titleWithin(json, TitleLimits::depth);
}

QString titleText(const RowTitle& title)
{
    const QJsonObject json = titleToJson(title);
    const QString text = QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact));
    return text.size() <= TitleLimits::letters && titleFromJson(json) ? text : QString();
}

std::optional<RowTitle> titleFromText(const QString& text, const QString& name)
{
    if (text.isEmpty() || text.size() > TitleLimits::letters)
        return std::nullopt;
    std::optional<RowTitle> title = titleFromJson(QJsonDocument::fromJson(text.toUtf8()).object());
    return title && saysAllThatItHolds(*title) && canonicalName(*title) == name ? title
                                                                                : std::nullopt;
}

} // namespace core
