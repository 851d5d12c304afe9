// SPDX-License-Identifier: Apache-2.0
#include "core/session/RecentGrowth.h"

#include "core/edits/EditJson.h"
#include "core/edits/GrowLimits.h"

#include <bitset>

namespace core {

namespace {

/// Whether more than one segment has seeds and may grow: then the order in which they come decides
/// who gets a voxel, and only growing anew gives what would have been.
bool segmentsCompete(const History& history, const Document& document)
{
    std::bitset<256> growing;
    for (const RowId id : history.standing()) {
        const Edit& edit = history.row(id).edit;
        if (const auto* seeds = std::get_if<SeedStroke>(&edit))
            growing.set(std::size_t(seeds->segment));
        const auto* paint = std::get_if<PaintStroke>(&edit);
        if (paint && paint->seeds && !paint->erase)
            growing.set(std::size_t(paint->segment));
    }
    for (std::size_t label = 0; label < growing.size(); ++label) {
        const Segment* segment = growing[label] ? document.segment(int(label)) : nullptr;
        growing[label] = segment && !segment->locked;
    }
    return growing.count() > 1;
}

bool asksPassage(const GrowCriteria& criteria, const Document& document)
{
    return criteria.passage
        && isAsked(passageOf(*criteria.passage, document.volumes.front().geometry));
}

/// The growth before, with its guard.
GrowSteps recentSteps(const History& history)
{
    const std::vector<RowId> rows = history.standing();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        if (const auto* grow = std::get_if<GrowSteps>(&history.row(*row).edit))
            return *grow;
    }
    return {};
}

} // namespace

std::optional<GrowCriteria> recentCriteria(const History& history)
{
    const std::vector<RowId> rows = history.standing();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        const Edit& edit = history.row(*row).edit;
        if (const auto* grow = std::get_if<GrowSteps>(&edit))
            return grow->criteria;
        if (const auto* change = std::get_if<ChangeInterval>(&edit))
            return change->criteria;
    }
    return std::nullopt;
}

Result<void> nameWhatGrowthReads(Edit& edit, const History& history, const Document& document)
{
    const auto* resume = std::get_if<ResumeGrowth>(&edit);
    auto* change = std::get_if<ChangeInterval>(&edit);
    if (!resume && !change)
        return {};
    if (resume || change->asBefore) {
        std::optional<GrowCriteria> criteria = recentCriteria(history);
        if (!criteria)
            return failure(ErrorCode::InvalidField, editName(edit),
                QStringLiteral("nothing has grown before"));
        if (resume) {
            GrowSteps again = recentSteps(history);
            again.criteria = *criteria;
            again.steps = resume->steps;
            again.tellsHeld = true;
            edit = again;
            return {};
        }
        criteria->lower = change->criteria.lower;
        criteria->upper = change->criteria.upper;
        change->criteria = *criteria;
        change->asBefore = false;
    }
    if (!change->fromSeeds)
        change->fromSeeds = change->criteria.sigmas || asksPassage(change->criteria, document)
            || segmentsCompete(history, document);
    return {};
}

} // namespace core
