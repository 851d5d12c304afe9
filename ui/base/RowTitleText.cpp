// SPDX-License-Identifier: Apache-2.0
#include "ui/base/RowTitleText.h"

#include "core/titles/TitleLanguage.h"
#include "ui/base/titles/FigureTitles.h"
#include "ui/base/titles/GrowthTitles.h"
#include "ui/base/titles/PlacedTitles.h"
#include "ui/base/titles/RevisionTitles.h"
#include "ui/base/titles/SculptTitles.h"
#include "ui/base/titles/SegmentTitles.h"
#include "ui/base/titles/SurfaceTitles.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace ui {

namespace {

class WindowLanguage : public core::TitleLanguage {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    [[nodiscard]] QString text(
        const core::RowTitle& title, const QStringList& arguments) const override
    {
        return core::filledIn(form(title), arguments);
    }
    [[nodiscard]] QString joiner(core::RowTitleCode code) const override
    {
        return code == core::RowTitleCode::Changes ? tr(" and ") : tr("; ");
    }
    [[nodiscard]] QString comma() const override { return tr(", "); }

private:
    [[nodiscard]] static QString form(const core::RowTitle& title);
};

/// The first argument where it is a count.
int countOf(const core::RowTitle& title)
{
    const auto* count =
        title.arguments.empty() ? nullptr : std::get_if<core::TitleCount>(&title.arguments.front());
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return count ? int(std::clamp<std::int64_t>(count->count, 0, most)) : 0;
}

constexpr std::size_t titleCount = 0
#define ROW_TITLE(...) +1
#include "core/titles/RowTitles.def"
#undef ROW_TITLE
    ;

/// By their codes, of all families.
constexpr std::array<TitleWords, titleCount> allWords()
{
    std::array<TitleWords, titleCount> all{};
    const auto take = [&all](const auto& family) {
        for (const TitleWords& words : family) {
            if (all[std::size_t(words.code)].text)
                throw std::logic_error("a title is worded twice");
            all[std::size_t(words.code)] = words;
        }
    };
    take(FigureTitles::words);
    take(GrowthTitles::words);
    take(SegmentTitles::words);
    take(SculptTitles::words);
    take(RevisionTitles::words);
    take(PlacedTitles::words);
    take(SurfaceTitles::words);
    return all;
}

constexpr std::array<TitleWords, titleCount> windowWords = allWords();

constexpr bool isWorded(core::RowTitleCode code)
{
    return windowWords[std::size_t(code)].text != nullptr;
}

#define ROW_TITLE(title, ...)                                                                      \
    static_assert(isWorded(core::RowTitleCode::title), "ui/base/titles words no title " #title);
#include "core/titles/RowTitles.def"
#undef ROW_TITLE

QString WindowLanguage::form(const core::RowTitle& title)
{
    const TitleWords& words = windowWords[std::size_t(title.code)];
    if (words.one && core::isOfOne(title))
        return tr(words.one);
    const QLatin1String text(words.text);
    if (text.isEmpty() || text == QLatin1String("%1"))
        return text;
    return tr(words.text, nullptr, words.isCounted ? countOf(title) : -1);
}

} // namespace

QString textOf(const core::RowTitle& title)
{
    return core::worded(title, WindowLanguage());
}

QString nameOf(const core::HistoryRow& row)
{
    return row.title ? textOf(*row.title) : row.name;
}

} // namespace ui
