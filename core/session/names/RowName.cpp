// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/RowName.h"

#include "core/edits/EditRows.h"
#include "core/edits/sculpt/SculptEdits.h"

namespace core {

namespace {

class PastRows : public Past {
public:
    explicit PastRows(const History& history)
        : m_history(history)
    {
    }

    [[nodiscard]] QString titleOf(std::int64_t row) const override
    {
        const QString& name = m_history.row(row).name;
        const qsizetype figures = name.lastIndexOf(QLatin1String(", "));
        return figures < 0 ? name : name.left(figures);
    }
    [[nodiscard]] StrokeParameters cutOf(std::int64_t row) const override
    {
        return parametersOf(*sculptEdit(m_history.row(row).edit));
    }

private:
    const History& m_history;
};

} // namespace

QString rowName(const Edit& edit, const EditStatistics& statistics, const ChangeFacts& facts,
    const Document& document, const History& history, const std::optional<SketchedSeeds>& sketched)
{
    const PastRows past(history);
    RowFacts row{.statistics = statistics, .facts = facts, .document = document, .past = past};
    if (sketched)
        row.sketched = SketchedWords{.text = sketchedText(*sketched, document),
            .whyNotTaken = whyNotTaken(*sketched, document)};
    return nameOf(edit, row);
}

} // namespace core
