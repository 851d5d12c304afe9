// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RecentGrowth.h"

#include "core/edits/EditJson.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/growth/SeedWord.h"
#include "core/session/past/SeedStrokes.h"

#include <algorithm>
#include <bitset>
#include <utility>

namespace core {

namespace {

std::bitset<256> segmentsWithSeeds(const History& history)
{
    std::bitset<256> growing;
    for (const RowId id : history.standing()) {
        const Edit& edit = history.row(id).edit;
        const auto* paint = edit.as<PaintStroke>();
        if (const std::optional<int> segment = segmentOfSeeds(edit);
            segment && !(paint && paint->erase))
            growing.set(std::size_t(*segment));
    }
    return growing;
}

/// Whether more than one segment has seeds and may grow: then the order in which they come decides
/// who gets a voxel, and only growing anew gives what would have been.
bool segmentsCompete(const GrowCriteria& criteria, const History& history, const Document& document)
{
    const std::bitset<256> growing =
        growingSegments(history, document, growthPlaneOf(criteria.plane));
    if (!criteria.segments)
        return growing.count() > 1;
    return std::count_if(criteria.segments->begin(), criteria.segments->end(),
               [&growing](int label) { return growing.test(std::size_t(label)); })
        > 1;
}

/// Whether a kind of growth may set or remove barriers. Each has to be named here.
struct BarrierSetting {
    bool operator()(const ShrinkAt& shrink) const { return shrink.barrier; }
    template <class E>
    requires isOneOf<E, BarrierStroke, PlugLeak>
    bool operator()(const E&) const { return true; }
    template <class E>
    requires isOneOf<E, SeedStroke, GrowSteps, ResumeGrowth, ChangeInterval, ShrinkSteps,
        GrowFromSeeds>
    bool operator()(const E&) const { return false; }
};

bool setsBarriers(const Edit& edit)
{
    bool sets = edit.is<SurfaceBarrier>();
    visitAmong([&sets](const auto& known) { sets = BarrierSetting()(known); }, edit, GrowthKinds());
    return sets;
}

bool asksPassage(const GrowCriteria& criteria, const Document& document)
{
    return criteria.passage
        && isAsked(passageOf(*criteria.passage, document.volumes.front().geometry));
}

/// What a growth goes by.
struct Rules {
    GrowCriteria criteria;
    GrowGuard guard;
};

std::optional<Rules> rulesOf(const Edit& edit)
{
    const GrowCriteria* criteria = growCriteriaOf(edit);
    return criteria ? std::optional(Rules{*criteria, *growGuardOf(edit)}) : std::nullopt;
}

/// @param plane of the growth; none: any
std::optional<Rules> recentRules(const History& history, const std::optional<int>& plane)
{
    const std::vector<RowId> rows = history.standing();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        std::optional<Rules> rules = rulesOf(history.row(*row).edit);
        if (rules && (!plane || growthPlaneOf(rules->criteria.plane) == *plane))
            return rules;
    }
    return std::nullopt;
}

} // namespace

std::bitset<256> growingSegments(
    const History& history, const Document& document, std::uint8_t plane)
{
    return segmentsWithSeeds(history) & document.unlockedLabels(plane);
}

std::optional<GrowCriteria> recentCriteria(const History& history, std::uint8_t plane)
{
    const std::optional<Rules> rules = recentRules(history, plane);
    return rules ? std::optional(rules->criteria) : std::nullopt;
}

RowId lastBarrierRow(const History& history)
{
    RowId last = 0;
    for (RowId id = history.position(); id != 0; id = history.row(id).parent) {
        const Edit& edit = history.row(id).edit;
        if (last == 0 && (setsBarriers(edit) || edit.is<RevertRows>()))
            last = id;
        if (setsBarriers(edit))
            return last;
    }
    return 0; // whatever was taken back, it was no barrier
}

std::bitset<256> grownIn(const History& history, std::uint8_t plane)
{
    std::bitset<256> seeded;
    std::bitset<256> grown;
    for (const RowId id : history.standing()) {
        const Edit& edit = history.row(id).edit;
        if (const std::optional<int> segment = segmentOfSeeds(edit))
            seeded.set(std::size_t(*segment));
        const GrowCriteria* criteria = growCriteriaOf(edit);
        if (!criteria || growthPlaneOf(criteria->plane) != plane)
            continue;
        if (!criteria->segments) {
            grown |= seeded;
            continue;
        }
        for (const int label : *criteria->segments) {
            // A file may name any number.
            if (std::size_t(label) < seeded.size() && seeded.test(std::size_t(label)))
                grown.set(std::size_t(label));
        }
    }
    return grown;
}

bool hasGrown(const History& history, const Segment& segment)
{
    return grownIn(history, segment.plane).test(std::size_t(segment.label));
}

bool bringsNewCriteria(const Edit& edit, const History& history, const Document& document)
{
    const std::optional<Rules> rules = rulesOf(edit);
    if (!rules)
        return false;
    const std::uint8_t plane = growthPlaneOf(rules->criteria.plane);
    std::bitset<256> seeded = segmentsWithSeeds(history);
    for (const Segment& segment : document.segments) {
        if (segment.plane != plane)
            seeded.reset(segment.label);
    }
    return seeded.any() && recentCriteria(history, plane) != rules->criteria;
}

namespace {

void eraseGone(std::optional<std::vector<int>>& segments, const Document& document)
{
    if (segments)
        std::erase_if(*segments, [&document](int label) { return !document.segment(label); });
}

/// Of the segments that a growth named, those that are gone or locked by now rest; nothing lies
/// inside those that are gone. Errors: that of the first one, if none is left.
Result<void> dropGone(GrowCriteria& criteria, const Document& document)
{
    dropGoneFromRange(criteria, document);
    if (!criteria.segments)
        return {};
    std::vector<int> left;
    for (const int label : *criteria.segments) {
        const Segment* segment = document.segment(label);
        if (segment && !segment->locked)
            left.push_back(label);
    }
    if (!left.empty()) {
        criteria.segments = std::move(left);
        return {};
    }
    const int first = criteria.segments->front();
    const Segment* segment = document.segment(first);
    return segment ? failure(ErrorCode::SegmentLocked, segment->name)
                   : failure(ErrorCode::UnknownSegment, QString::number(first));
}

} // namespace

void dropGoneFromRange(GrowCriteria& criteria, const Document& document)
{
    if (!criteria.editable)
        return;
    eraseGone(criteria.editable->inside, document);
    eraseGone(criteria.editable->outside, document);
}

namespace {

/// The first plane is not named, so that criteria that mean the same are the same.
void nameAlike(GrowCriteria& criteria)
{
    criteria.plane = namedPlane(growthPlaneOf(criteria.plane));
}

/// What an edit of growth is once it names all that it would otherwise read in the history; none:
/// it reads nothing there. Each kind of growth has to be named here.
struct NamedGrowth {
    using Answer = Result<std::optional<Edit>>;

    const Edit& edit;
    const History& history;
    const Document& document;

    Answer operator()(const GrowSteps& grow) const
    {
        GrowSteps named = grow;
        nameAlike(named.criteria);
        return Edit(std::move(named));
    }
    Answer operator()(const ResumeGrowth& resume) const
    {
        Result<Rules> rules = rulesOfLast(resume.plane);
        if (!rules)
            return tl::unexpected(rules.error());
        return Edit(GrowSteps{
            .criteria = std::move(rules->criteria), .steps = resume.steps, .guard = rules->guard});
    }
    Answer operator()(const ChangeInterval& change) const
    {
        ChangeInterval named = change;
        if (change.asBefore) {
            Result<Rules> rules = rulesOfLast(change.criteria.plane);
            if (!rules)
                return tl::unexpected(rules.error());
            rules->criteria.lower = change.criteria.lower;
            rules->criteria.upper = change.criteria.upper;
            named.criteria = std::move(rules->criteria);
            named.asBefore = false;
        }
        nameAlike(named.criteria);
        if (!named.fromSeeds)
            nameSeeds(named);
        return Edit(std::move(named));
    }
    template <class E>
    requires isOneOf<E, SeedStroke, BarrierStroke, ShrinkSteps, ShrinkAt, PlugLeak, GrowFromSeeds>
        Answer operator()(const E&) const
    {
        return std::nullopt;
    }

private:
    /// The rules of the last growth in a plane, or in any if none is named.
    [[nodiscard]] Result<Rules> rulesOfLast(std::optional<int> plane) const
    {
        std::optional<Rules> rules = recentRules(history, plane);
        if (!rules)
            return failure(ErrorCode::InvalidField, editName(edit),
                plane && document.labelPlanes().size() > 1
                    ? Clause::saying("nothing has grown on label plane %1 before", *plane + 1)
                    : Clause::saying("nothing has grown before"));
        if (const Result<void> left = dropGone(rules->criteria, document); !left)
            return tl::unexpected(left.error());
        return *std::move(rules);
    }
    void nameSeeds(ChangeInterval& change) const
    {
        change.fromSeeds = change.criteria.sigmas || asksPassage(change.criteria, document)
            || segmentsCompete(change.criteria, history, document);
        // As many generations again as there are, of which the seeds are the first, and those asked
        // for.
        const auto generation = int(document.generation(growthPlaneOf(change.criteria.plane)));
        if (*change.fromSeeds && change.steps && generation > 0)
            *change.steps = std::min(*change.steps + generation - 1, int(seedWord::maxGeneration));
    }
};

} // namespace

Result<void> nameWhatGrowthReads(Edit& edit, const History& history, const Document& document)
{
    NamedGrowth::Answer named = std::nullopt;
    visitAmong(
        [&](const auto& known) {
            named = NamedGrowth{edit, history, document}(known);
        },
        std::as_const(edit), GrowthKinds());
    if (!named)
        return tl::unexpected(named.error());
    if (*named)
        edit = **std::move(named);
    return {};
}

} // namespace core
