// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/TitleOfRow.h"

#include "core/edits/EditRows.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/titles/TitleJson.h"

#include <utility>

namespace core {

namespace {

class PastRows : public Past {
public:
    explicit PastRows(const History& history)
        : m_history(history)
    {
    }

    [[nodiscard]] RowTitle headlineOf(std::int64_t row) const override
    {
        const HistoryRow& quoted = m_history.row(row);
        const qsizetype figures = quoted.name.lastIndexOf(QLatin1String(", "));
        const QString name = figures < 0 ? quoted.name : quoted.name.left(figures);
        // Names are what is quoted: of a row of before, of one with a comma in the name of what it
        // changed, and where rows that quote rows stand too deep in each other, as it stands there.
        if (quoted.title) {
            RowTitle headline = core::headlineOf(*quoted.title);
            if (canonicalName(headline) == name && depthOf(headline) < deepestQuoted)
                return headline;
        }
        return {.code = RowTitleCode::StoredName, .arguments = {name}};
    }
    [[nodiscard]] StrokeParameters cutOf(std::int64_t row) const override
    {
        return parametersOf(*sculptEdit(m_history.row(row).edit));
    }

private:
    /// With the row that quotes it, a title is within the limits of files.
    static constexpr int deepestQuoted = TitleLimits::depth - 1;

    const History& m_history;
};

} // namespace

RowTitle titleOfRow(const Edit& edit, const EditStatistics& statistics, const ChangeFacts& facts,
    const Document& document, const History& history, const std::optional<SketchedSeeds>& sketched)
{
    const PastRows past(history);
    RowFacts row{.statistics = statistics, .facts = facts, .document = document, .past = past};
    if (sketched)
        row.sketched = SketchedTitle{
            .became = sketchedTitle(*sketched, document), .isPlain = sketched->isPlain()};
    return titleOf(edit, row);
}

} // namespace core
