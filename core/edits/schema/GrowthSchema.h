// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
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
        "the points, in patient coordinates (LPS), inside the volume; none if seeds are only taken "
        "away");
    visit.maybe("takenLps", edit.takenLps, editFields::PointList{positionLps},
        "seeds of the segment that are taken away first, unless a growth has already accepted them",
        "none");
}

/// A box along the volume's axes.
template <class Visitor>
void visitBox(Visitor& visit, std::optional<GrowBox>& box, const char* meaning, const char* absent)
{
    visit.maybe("box", box, editFields::CornerPair{positionLps}, meaning, absent);
}

/// The label plane of a growth. It stands only where it is not the first one or was named, so that
/// text of sessions that know no other growths stays as it is.
template <class Visitor>
void visitPlane(Visitor& visit, std::optional<int>& plane, const char* absent = "the first one, 0")
{
    visit.maybe("plane", plane, labelPlane,
        "the label plane whose growth is meant: only segments that may share voxels with others "
        "(importMask, addSegment, copySegment) lie in a plane beyond 0",
        absent);
}

/// All criteria except the interval and the plane.
template <class Visitor> void visitOtherCriteria(Visitor& visit, GrowCriteria& criteria)
{
    visit.field("connectivity", Presence::Optional, criteria.connectivity,
        editFields::Connectivity{},
        "which voxels are neighbours: 6 are those that share a face, 18 also those that share an "
        "edge, 26 also those that share a corner");
    visit.maybe("sigmas", criteria.sigmas, editFields::Number{"", 1.0 / 256.0, 100.0, 256.0},
        "narrows the interval, for each segment by itself, to the mean ± this many standard "
        "deviations of the values around its seeds",
        "the interval as it is");
    visit.maybe("perStroke", criteria.perStroke, editFields::Flag{},
        "whether sigmas narrows the interval for each stroke of seeds by itself: a voxel joins a "
        "segment if it suits one of the strokes; painted seeds are one stroke",
        "all seeds of a segment together");
    visit.maybe("difference", criteria.difference, valueDifference,
        "the greatest difference between a voxel's value and that of the voxel from which growth "
        "reaches it",
        "any");
    visit.maybe("gradient", criteria.gradient, valuePerMillimetre,
        "the greatest magnitude of the gradient at a voxel", "any");
    visit.maybe("gradientDifference", criteria.gradientDifference, valuePerMillimetre,
        "the greatest difference between the gradient's magnitude at a voxel and at the voxel from "
        "which growth reaches it",
        "any");
    visit.maybe("majority", criteria.majority, editFields::WholeNumber{1, 27},
        "how many of the 27 voxels around a voxel, itself included, must lie in the interval",
        "any number");
    visit.maybe("smoothing", criteria.smoothing, editFields::Flag{},
        "whether the interval is compared with the weighted median of the 27 voxels around a "
        "voxel, itself included, instead of its own value: noise leaves no holes, but threads are "
        "left out",
        "its own value");
    visit.maybe("passage", criteria.passage, passageWidth,
        "growth goes only where a ball of this diameter can roll from a seed; it may be at most 31 "
        "times the volume's finest spacing, and below twice that spacing it has no effect",
        "any width");
    visit.field("onlyVisible", Presence::Optional, criteria.onlyVisible, editFields::Flag{},
        "whether growth stays out of what is carved away");
    visitBox(visit, criteria.box, "two opposite corners of a box that growth does not leave",
        "everywhere in the volume");
    visit.field("overwriteUnlocked", Presence::Optional, criteria.overwriteUnlocked,
        editFields::Flag{}, "whether growth takes voxels of other segments that are not locked");
    visit.maybe("segments", criteria.segments, editFields::SegmentList{},
        "the segments that grow; all others stay as they are", "all that are not locked");
    visitEditable(visit, criteria.editable);
}

template <class Visitor> void visitInterval(Visitor& visit, GrowCriteria& criteria)
{
    visit.field("lower", Presence::Required, criteria.lower, modalityValue,
        "the smallest value of the interval, inclusive");
    visit.field("upper", Presence::Required, criteria.upper, modalityValue,
        "the greatest value of the interval, inclusive");
}

template <class Visitor> void visitGuard(Visitor& visit, GrowGuard& guard)
{
    visit.maybe("guardFactor", guard.factor, editFields::Number{"", 1.0, 1000.0, 256.0},
        "growth stops when a front that has come out of a narrow place is this many times as wide "
        "as it was there",
        "no leak guard");
    visit.when(guard.factor.has_value(), [&] {
        visit.maybe("guardVoxels", guard.voxels, editFields::WholeNumber{0, 1000000},
            "as in older sessions, instead of guardAreaMm2: by how many voxels the front must be "
            "wider, whatever their size",
            "guardAreaMm2 counts");
        visit.maybe("guardGenerations", guard.generations, editFields::WholeNumber{1, 1000},
            "as in older sessions, instead of guardBackMm: how many generations back the narrow "
            "place may lie",
            "guardBackMm counts");
        visit.when(!guard.countsVoxels(), [&] {
            visit.field("guardAreaMm2", Presence::Optional, guard.areaMm2,
                editFields::Number{"mm²", 0.0, 1000000.0, 1000.0},
                "by how much the front's area must also be larger than at the narrow place");
            visit.field("guardBackMm", Presence::Optional, guard.backMm,
                editFields::Number{"mm", 0.001, 1000.0, 1000.0},
                "how far back the narrow place may lie, measured along the growth");
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
        "how many rings to add after the seeds, or \"toClosure\" to go on until nothing is left to "
        "add");
    visit.field("tellsHeld", Presence::Optional, edit.tellsHeld, editFields::Flag{},
        "whether shrinking leaves what the segment held before it grew; false in older sessions");
    visitGuard(visit, edit.guard);
    visitPlane(visit, edit.criteria.plane);
}

template <> inline constexpr const char* editName<ChangeInterval> = "interval";
template <>
inline constexpr const char* editMeaning<ChangeInterval> =
    "Gives the growth another interval: voxels that qualify now come back; those that no longer do "
    "are taken back, with all that grew through them.";
template <class Visitor> void visitFields(Visitor& visit, ChangeInterval& edit)
{
    visitInterval(visit, edit.criteria);
    visit.field("asBefore", Presence::Optional, edit.asBefore, editFields::Flag{},
        "whether all other criteria are those of the last growth; false once the edit is carried "
        "out");
    visit.when(!edit.asBefore, [&] { visitOtherCriteria(visit, edit.criteria); });
    visit.maybe("fromSeeds", edit.fromSeeds, editFields::Flag{},
        "whether the growth is taken back to its seeds and grown anew; always given once the edit "
        "is carried out",
        "true if several segments grow, or if sigmas or a passage is given");
    visit.field("steps", Presence::Optional, edit.steps, editFields::StepCount{},
        "how many rings to add after the change (after the seeds if fromSeeds is true), or "
        "\"toClosure\" to go on until nothing is left to add");
    visitGuard(visit, edit.guard);
    visitPlane(visit, edit.criteria.plane,
        "that of the last growth; the first one, 0, once the edit is carried out");
}

template <> inline constexpr const char* editName<ResumeGrowth> = "resume";
template <>
inline constexpr const char* editMeaning<ResumeGrowth> =
    "Continues the last growth by its own criteria; new seeds take part.";
template <class Visitor> void visitFields(Visitor& visit, ResumeGrowth& edit)
{
    visit.field("steps", Presence::Optional, edit.steps, editFields::StepCount{},
        "how many rings to add after the seeds, or \"toClosure\" to go on until nothing is left to "
        "add");
    visitPlane(visit, edit.plane, "that of the last growth");
}

template <> inline constexpr const char* editName<ShrinkSteps> = "shrink";
template <>
inline constexpr const char* editMeaning<ShrinkSteps> =
    "Takes back what growth added last, ring by ring; what was painted or there before stays.";
template <class Visitor> void visitFields(Visitor& visit, ShrinkSteps& edit)
{
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{"toSeeds"},
        "how many rings to take back, or \"toSeeds\" to leave only the accepted seeds");
    visitPlane(visit, edit.plane);
}

template <> inline constexpr const char* editName<ShrinkAt> = "shrinkAt";
template <>
inline constexpr const char* editMeaning<ShrinkAt> =
    "Takes back some places of a growth and what grew through them, cut off where it is narrowest; "
    "what is nearer to the seeds stays, and over seeds it is refused.";
template <class Visitor> void visitFields(Visitor& visit, ShrinkAt& edit)
{
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "the places, in patient coordinates (LPS), inside the volume");
    visit.field("onlyHere", Presence::Optional, edit.onlyHere, editFields::Flag{},
        "whether only the voxels at the points are taken back");
    visit.field("barrier", Presence::Optional, edit.barrier, editFields::Flag{},
        "whether a barrier shuts the cut to growth");
    visit.maybe("steps", edit.steps, editFields::WholeNumber{1, int(seedWord::maxGeneration)},
        "how many steps to go backwards instead: the first takes the places and what descends from "
        "them, each further one a generation of their parents; taking everything is refused",
        "all at once, up to where it is narrowest");
    visitPlane(visit, edit.plane);
}

template <> inline constexpr const char* editName<PlugLeak> = "plug";
template <>
inline constexpr const char* editMeaning<PlugLeak> =
    "Shuts the neck through which growth came to a place, and takes back what lies beyond.";
template <class Visitor> void visitFields(Visitor& visit, PlugLeak& edit)
{
    visit.field("pointLps", Presence::Required, edit.pointLps, positionLps,
        "a place in the leak, in patient coordinates (LPS)");
    visitPlane(visit, edit.plane);
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
    visitPlane(visit, edit.plane);
}

template <> inline constexpr const char* editName<GrowFromSeeds> = "growFromSeeds";
template <>
inline constexpr const char* editMeaning<GrowFromSeeds> =
    "Gives every voxel of a box to the segment that is nearest along a path on which values change "
    "little; seeds are the voxels of segments and the sketched seeds.";
template <class Visitor> void visitFields(Visitor& visit, GrowFromSeeds& edit)
{
    visit.maybe("segments", edit.segments, editFields::SegmentList{}, "the segments that compete",
        "all that are not locked");
    visitBox(visit, edit.box,
        "two opposite corners of the box whose voxels are given to the segments",
        "around the seeds with a margin of a twentieth");
    visit.field("connectivity", Presence::Optional, edit.connectivity, editFields::Connectivity{},
        "which voxels are neighbours: 6 are those that share a face, 18 also those that share an "
        "edge, 26 also those that share a corner");
    visit.maybe("lengthCost", edit.lengthCost, valuePerMillimetre,
        "how much each millimetre of a path costs, in addition to the differences of values along "
        "it",
        "a thousandth of the volume's range of values");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of segments that do not compete and are not locked are taken");
    visitEditable(visit, edit.editable);
    visitPlane(visit, edit.plane);
}

} // namespace core::editSchema
