// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowGuard.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/schema/SchemaParts.h"
#include "core/growth/SeedWord.h"

namespace core::editSchema {

inline constexpr editFields::Number valueDifference{"modality units", 0.0, quantum::unbounded, 0.0};
inline constexpr editFields::Number valuePerMillimetre{
    "modality units / mm", 0.0, quantum::unbounded, 0.0};

inline constexpr editFields::Number passageWidth{"mm", 0.0, quantum::reachMm, 0.0};

template <> inline constexpr const char* editName<SeedStroke> = "seed";
template <>
inline constexpr const char* editMeaning<SeedStroke> =
    "Marks the voxels nearest to some points as seeds of a segment; the next growth starts there.";
template <class Visitor> void visitFields(Visitor& visit, SeedStroke& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("pointsLps", Presence::Required, edit.pointsLps,
        editFields::PointList{positionLps, true},
        "patient coordinates (LPS), inside the volume; none where seeds are only taken away");
    visit.maybe("takenLps", edit.takenLps, editFields::PointList{positionLps},
        "seeds of the segment that are taken away first, as far as no growth has accepted them",
        "none");
}

/// A box along the volume's axes.
template <class Visitor>
void visitBox(Visitor& visit, std::optional<GrowBox>& box, const char* meaning, const char* absent)
{
    visit.maybe("box", box, editFields::CornerPair{positionLps}, meaning, absent);
}

/// All criteria except the interval.
template <class Visitor> void visitOtherCriteria(Visitor& visit, GrowCriteria& criteria)
{
    visit.field("connectivity", Presence::Optional, criteria.connectivity,
        editFields::Connectivity{},
        "neighbours of a voxel: those that share a face, a face or an edge, or a corner too");
    visit.maybe("sigmas", criteria.sigmas, editFields::Number{"", 1.0 / 256.0, 100.0, 256.0},
        "narrows the interval, for each segment by itself, to mean ± so many standard deviations "
        "around its seeds",
        "the interval as it is");
    visit.maybe("perStroke", criteria.perStroke, editFields::Flag{},
        "whether sigmas narrows it for each stroke of seeds by itself: a voxel joins a segment "
        "where "
        "one of its strokes takes it; painted seeds are one stroke",
        "all seeds of a segment together");
    visit.maybe("difference", criteria.difference, valueDifference,
        "from the voxel it is reached from, at most", "any");
    visit.maybe("gradient", criteria.gradient, valuePerMillimetre,
        "magnitude of the gradient, at most", "any");
    visit.maybe("gradientDifference", criteria.gradientDifference, valuePerMillimetre,
        "of the gradient's magnitude, from the voxel it is reached from, at most", "any");
    visit.maybe("majority", criteria.majority, editFields::WholeNumber{1, 27},
        "of the 27 voxels around and at it at least so many lie in the interval", "any number");
    visit.maybe("smoothing", criteria.smoothing, editFields::Flag{},
        "whether the weighted median of the 27 voxels around and at it is compared with the "
        "interval, instead of its own value: no holes by noise; threads are left out",
        "its own value");
    visit.maybe("passage", criteria.passage, passageWidth,
        "growth goes only where a ball of this diameter can roll to from a seed; at most 31 times "
        "the volume's finest spacing, and nothing is asked below twice that",
        "any width");
    visit.field("onlyVisible", Presence::Optional, criteria.onlyVisible, editFields::Flag{},
        "whether what is carved is closed to growth");
    visitBox(visit, criteria.box, "two opposite corners: growth stays between them",
        "everywhere in the volume");
    visit.field("overwriteUnlocked", Presence::Optional, criteria.overwriteUnlocked,
        editFields::Flag{}, "whether growth takes voxels of other segments that are not locked");
    visit.maybe("segments", criteria.segments, editFields::SegmentList{},
        "those that grow; all others stay as they are", "all that are not locked");
}

template <class Visitor> void visitInterval(Visitor& visit, GrowCriteria& criteria)
{
    visit.field(
        "lower", Presence::Required, criteria.lower, modalityValue, "smallest value, inclusive");
    visit.field(
        "upper", Presence::Required, criteria.upper, modalityValue, "greatest value, inclusive");
}

template <class Visitor> void visitGuard(Visitor& visit, GrowGuard& guard)
{
    visit.maybe("guardFactor", guard.factor, editFields::Number{"", 1.0, 1000.0, 256.0},
        "the growth stops where a front that came out of a narrow place is so many times as wide "
        "as that",
        "no leak guard");
    visit.when(guard.factor.has_value(), [&] {
        visit.maybe("guardVoxels", guard.voxels, editFields::WholeNumber{0, 1000000},
            "of old: instead of guardAreaMm2, so many voxels wider, whatever their size",
            "areas are measured");
        visit.maybe("guardGenerations", guard.generations, editFields::WholeNumber{1, 1000},
            "of old: instead of guardBackMm, so many generations back", "lengths are measured");
        visit.when(!guard.countsVoxels(), [&] {
            visit.field("guardAreaMm2", Presence::Optional, guard.areaMm2,
                editFields::Number{"mm²", 0.0, 1000000.0, 1000.0},
                "and so much wider: the front's area");
            visit.field("guardBackMm", Presence::Optional, guard.backMm,
                editFields::Number{"mm", 0.001, 1000.0, 1000.0},
                "how far back a narrow place lies at most, along the growth");
        });
    });
}

template <> inline constexpr const char* editName<GrowSteps> = "grow";
template <>
inline constexpr const char* editMeaning<GrowSteps> =
    "Grows all seeded segments breadth-first through voxels whose value lies in an interval.";
template <class Visitor> void visitFields(Visitor& visit, GrowSteps& edit)
{
    visitInterval(visit, edit.criteria);
    visitOtherCriteria(visit, edit.criteria);
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{},
        "rings to add after the seeds, or until nothing is left to add");
    visit.field("tellsHeld", Presence::Optional, edit.tellsHeld, editFields::Flag{},
        "whether shrinking leaves what the segment held before; false in sessions of old");
    visitGuard(visit, edit.guard);
}

template <> inline constexpr const char* editName<ChangeInterval> = "interval";
template <>
inline constexpr const char* editMeaning<ChangeInterval> =
    "Gives the growth another interval: recovers what qualifies now, takes back what does not any "
    "more and what hung on it.";
template <class Visitor> void visitFields(Visitor& visit, ChangeInterval& edit)
{
    visitInterval(visit, edit.criteria);
    visit.field("asBefore", Presence::Optional, edit.asBefore, editFields::Flag{},
        "whether all other criteria are those of the growth before; false once it is carried out");
    visit.when(!edit.asBefore, [&] { visitOtherCriteria(visit, edit.criteria); });
    visit.maybe("fromSeeds", edit.fromSeeds, editFields::Flag{},
        "whether it is taken back to the seeds and grown anew; told once it is carried out",
        "where several segments grow, or sigmas or a passage are asked for");
    visit.field("steps", Presence::Optional, edit.steps, editFields::StepCount{},
        "rings to add after the change, or until nothing is left to add; where fromSeeds is true, "
        "rings after the seeds");
    visitGuard(visit, edit.guard);
}

template <> inline constexpr const char* editName<ResumeGrowth> = "resume";
template <>
inline constexpr const char* editMeaning<ResumeGrowth> =
    "Goes on with the growth before, by its own criteria; new seeds take part.";
template <class Visitor> void visitFields(Visitor& visit, ResumeGrowth& edit)
{
    visit.field("steps", Presence::Optional, edit.steps, editFields::StepCount{},
        "rings to add after the seeds, or until nothing is left to add");
}

template <> inline constexpr const char* editName<ShrinkSteps> = "shrink";
template <>
inline constexpr const char* editMeaning<ShrinkSteps> =
    "Takes back what growth added last, ring by ring; what was painted or there before stays.";
template <class Visitor> void visitFields(Visitor& visit, ShrinkSteps& edit)
{
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{"toSeeds"},
        "rings to take back, or all but the accepted seeds");
}

template <> inline constexpr const char* editName<ShrinkAt> = "shrinkAt";
template <>
inline constexpr const char* editMeaning<ShrinkAt> =
    "Takes back some places of a growth and what grew through them, cut off where it is narrowest; "
    "what is nearer to the seeds stays, and over seeds it is refused.";
template <class Visitor> void visitFields(Visitor& visit, ShrinkAt& edit)
{
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "patient coordinates (LPS), inside the volume");
    visit.field("onlyHere", Presence::Optional, edit.onlyHere, editFields::Flag{},
        "whether only the voxels at the points are taken back");
    visit.field("barrier", Presence::Optional, edit.barrier, editFields::Flag{},
        "whether the cut is shut to growth");
    visit.maybe("steps", edit.steps, editFields::WholeNumber{1, int(seedWord::maxGeneration)},
        "goes backwards instead: the first step takes the places and what descends from them, each "
        "further one a generation of their parents; what would take everything is refused",
        "all at once, up to where it is narrowest");
}

template <> inline constexpr const char* editName<PlugLeak> = "plug";
template <>
inline constexpr const char* editMeaning<PlugLeak> =
    "Shuts the neck through which growth came to a place, and takes back what lies beyond.";
template <class Visitor> void visitFields(Visitor& visit, PlugLeak& edit)
{
    visit.field("pointLps", Presence::Required, edit.pointLps, positionLps,
        "a place in the leak, patient coordinates (LPS)");
}

template <> inline constexpr const char* editName<BarrierStroke> = "barrier";
template <>
inline constexpr const char* editMeaning<BarrierStroke> =
    "Shuts places to growth along a path, or opens them again.";
template <class Visitor> void visitFields(Visitor& visit, BarrierStroke& edit)
{
    visitPath(visit, edit.path);
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether barriers are taken away instead");
}

template <> inline constexpr const char* editName<GrowFromSeeds> = "growFromSeeds";
template <>
inline constexpr const char* editMeaning<GrowFromSeeds> =
    "Gives every voxel of a box to the segment that is nearest by a way on which values change "
    "little; seeds are the voxels that segments hold, and those that are sketched.";
template <class Visitor> void visitFields(Visitor& visit, GrowFromSeeds& edit)
{
    visit.maybe("segments", edit.segments, editFields::SegmentList{}, "those that compete",
        "all that are not locked");
    visitBox(visit, edit.box, "two opposite corners: what lies between is given away",
        "around the seeds with a margin of a twentieth");
    visit.field("connectivity", Presence::Optional, edit.connectivity, editFields::Connectivity{},
        "neighbours of a voxel: those that share a face, a face or an edge, or a corner too");
    visit.maybe("lengthCost", edit.lengthCost, valuePerMillimetre,
        "what a millimetre of a way costs, besides the difference of values along it",
        "a thousandth of the volume's range of values");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of segments that do not compete and are not locked are taken");
}

} // namespace core::editSchema
