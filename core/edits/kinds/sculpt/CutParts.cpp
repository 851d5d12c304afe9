// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/CutParts.h"

#include "core/sculpt/CutFrame.h"

#include <limits>
#include <utility>

namespace core {

namespace {

glm::dvec3 millimetres(const Fixed3& fixed30)
{
    return glm::dvec3(double(fixed30[0]), double(fixed30[1]), double(fixed30[2])) / 1073741824.0;
}

dependsOn::SweptToolMask sweptMask(const CutFrame& frame, const BrickGrid& grid,
    std::vector<glm::dvec2> path, double maskReachMm, const RowTrace& trace)
{
    dependsOn::SweptToolMask mask;
    mask.grid = grid;
    mask.origin = millimetres(frame.planeOrigin);
    mask.perVoxel = glm::dmat3(
        millimetres(frame.planePerI), millimetres(frame.planePerJ), millimetres(frame.planePerK));
    mask.path = std::move(path);
    // Samples lie anywhere in their element, a mask's edge is smoothed across one more, and a voxel
    // belongs to the element that its middle lies in.
    const double pitchMm = frame.pitch / 65536.0;
    mask.reachMm = maskReachMm + 4.0 * pitchMm;
    // The first material ends the search; from there a cut, and what it asks about gaps, goes no
    // deeper than maxDepth. A laser's beam leans and looks around: no farther than it reaches.
    mask.endMm = trace.searchedTo && !frame.restore
        ? (double(*trace.searchedTo) + frame.maxDepth + 2.0 * frame.zPerSample
              + 2.0 * frame.rampHalfWidth)
                / 65536.0
            + mask.reachMm
        : std::numeric_limits<double>::infinity();
    return mask;
}

} // namespace

EditDependencies reachesNothing()
{
    return dependsOn::Bricks();
}

EditDependencies swept(const CutFrame& frame, std::vector<glm::dvec2> path, double maskReachMm,
    const std::bitset<256>& labels, const DependencyFacts& row)
{
    dependsOn::SweptToolMask mask =
        sweptMask(frame, row.grid(), std::move(path), maskReachMm, row.trace);
    mask.labels = labels;
    return mask;
}

EditDependencies sweptOutline(const CutFrame& frame, const std::vector<glm::dvec2>& outline,
    const std::bitset<256>& labels, const DependencyFacts& row)
{
    glm::dvec2 low = outline.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& point : outline) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return swept(frame, {(low + high) / 2.0}, glm::length(high - low) / 2.0, labels, row);
}

std::vector<glm::dvec2> pathOf(const std::vector<PenSample>& samples)
{
    std::vector<glm::dvec2> path;
    for (const PenSample& sample : samples)
        path.emplace_back(sample.xMm, sample.yMm);
    return path;
}

} // namespace core
