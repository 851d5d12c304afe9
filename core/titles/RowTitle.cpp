// SPDX-License-Identifier: Apache-2.0
#include "core/titles/RowTitle.h"

#include "core/titles/TitleForms.h"
#include "core/titles/TitleLanguage.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// Of stored names.
class CanonicalEnglish : public TitleLanguage {
public:
    [[nodiscard]] QString text(const RowTitle& title, const QStringList& arguments) const override
    {
        const TitleForm form = formOf(title.code);
        const QString text = QString::fromUtf8(form.one && isOfOne(title) ? form.one : form.text);
        // These two were put together argument by argument from the start: what looks like the
        // place of an argument in a name is taken for it. The second one is a short number: a
        // stranger's text there could make the name as long as it likes.
        if ((title.code == RowTitleCode::MoveSegment || title.code == RowTitleCode::MoveLayer)
            && arguments.size() == 2 && std::holds_alternative<TitleNumber>(title.arguments[1]))
            return text.arg(arguments[0]).arg(arguments[1]);
        return filledIn(text, arguments);
    }
    [[nodiscard]] QString joiner(RowTitleCode code) const override
    {
        return QLatin1String(joinerOf(code));
    }
    [[nodiscard]] QString comma() const override { return QStringLiteral(", "); }
};

int deepestOf(const std::vector<RowTitle>& titles)
{
    int deepest = 0;
    for (const RowTitle& title : titles)
        deepest = std::max(deepest, depthOf(title));
    return deepest;
}

} // namespace

bool RowTitle::operator==(const RowTitle& other) const
{
    return code == other.code && arguments == other.arguments && then == other.then;
}

QString canonicalName(const RowTitle& title)
{
    return worded(title, CanonicalEnglish());
}

RowTitle headlineOf(RowTitle title)
{
    if (!title.then.empty())
        title.then.pop_back();
    return title;
}

int depthOf(const RowTitle& title)
{
    int deepest = deepestOf(title.then);
    for (const TitleArgument& argument : title.arguments) {
        if (const auto* titles = std::get_if<std::vector<RowTitle>>(&argument))
            deepest = std::max(deepest, deepestOf(*titles));
    }
    return 1 + deepest;
}

} // namespace core
