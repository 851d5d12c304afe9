// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/SidedMargins.h"

#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/morphology/SidedBall.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/ItkMorphology.h"

#include <array>
#include <utility>
#include <vector>

namespace peer {

namespace {

using State = RealSegment::State;

constexpr double radiusMm = 3.0;

core::Edit sidedEdit(bool grows)
{
    return core::ReshapeSegment{.segment = RealSegment::label,
        .operation = grows ? core::ShapeOperation::Grow : core::ShapeOperation::Shrink,
        .mm = radiusMm,
        .sides = {
            .leftMm = 0.0, .anteriorMm = 0.5 * radiusMm, .posteriorMm = 0.0, .inferiorMm = 0.0}};
}

/// How far it reaches along the axes of the grid.
std::array<AxisReach, 3> sidedReach(const core::VolumeGeometry& geometry)
{
    // LPS: to the left, back and head of the patient.
    const std::array<AxisReach, 3> ofPatient{AxisReach{.backwardsMm = radiusMm},
        AxisReach{.backwardsMm = 0.5 * radiusMm}, AxisReach{.forwardsMm = radiusMm}};
    const std::array<int, 3> axes = core::axesOfPatient(geometry);
    std::array<AxisReach, 3> reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int along = axes.at(axis);
        AxisReach its = ofPatient.at(axis);
        if (geometry.direction()[along][int(axis)] < 0.0)
            std::swap(its.backwardsMm, its.forwardsMm);
        reach.at(std::size_t(along)) = its;
    }
    return reach;
}

PeerMask grown(const RealSegment& segment)
{
    ItkMask mask =
        itkDilatedBySides(segment.mask(State::Thresholded), sidedReach(segment.geometry()));
    return {.voxels = std::move(mask.voxels), .milliseconds = mask.milliseconds};
}

/// All else grows towards the opposite sides.
PeerMask shrunk(const RealSegment& segment)
{
    std::array<AxisReach, 3> reach = sidedReach(segment.geometry());
    for (AxisReach& each : reach)
        std::swap(each.backwardsMm, each.forwardsMm);
    GridMask mask = segment.mask(State::Thresholded);
    std::vector<std::uint8_t> rest(mask.voxels.begin(), mask.voxels.end());
    for (std::uint8_t& voxel : rest)
        voxel = voxel == 0 ? 1 : 0;
    mask.voxels = rest;
    ItkMask made = itkDilatedBySides(mask, reach);
    for (std::uint8_t& voxel : made.voxels)
        voxel = voxel == 0 ? 1 : 0;
    return {.voxels = std::move(made.voxels), .milliseconds = made.milliseconds};
}

} // namespace

WholeSegment sidedMargin(bool grows)
{
    return {.name = grows ? "margin.sides" : "margin.sides.shrink",
        .peer = "ITK BinaryDilate",
        .before = State::Thresholded,
        .edit = [grows](const RealSegment&) { return sidedEdit(grows); },
        .theirs =
            [grows](
                const RealSegment& segment) { return grows ? grown(segment) : shrunk(segment); }};
}

} // namespace peer
