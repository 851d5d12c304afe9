// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/DoubtfulVertices.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double faintEdge = 0.25; // of the median
constexpr int evenings = 3;

/// Each the mean of itself and its neighbours.
std::vector<double> evened(const SurfaceMirror& surface, const std::vector<double>& values)
{
    std::vector<double> sums = values;
    std::vector<int> counts(values.size(), 1);
    surface.forEachEdge([&](VertexId one, VertexId other) {
        sums[one] += values[other];
        sums[other] += values[one];
        ++counts[one];
        ++counts[other];
    });
    for (std::size_t id = 0; id < sums.size(); ++id)
        sums[id] /= counts[id];
    return sums;
}

} // namespace

std::vector<bool> offTheMask(
    const SurfaceMirror& surface, const BoundaryForce& boundary, double toleranceMm)
{
    std::vector<bool> isOff(surface.vertexSlots(), false);
    surface.forEachVertex([&](VertexId id, const SurfaceUpdate::Vertex& vertex) {
        if (vertex.mark == SurfaceMark::Yellow)
            return;
        const std::optional<double> apart =
            boundary.alongNormalMm(vertex.positionLps, vertex.normalLps);
        isOff[id] = !apart || std::abs(*apart) > toleranceMm;
    });
    return isOff;
}

std::vector<bool> withoutAnEdge(const SurfaceMirror& surface, const GreyBox& grey, double reachMm)
{
    std::vector<double> changes(surface.vertexSlots(), 0.0);
    surface.forEachVertex([&](VertexId id, const SurfaceUpdate::Vertex& vertex) {
        const glm::dvec3 way = reachMm * glm::dvec3(vertex.normalLps);
        changes[id] =
            std::abs(grey.at(vertex.positionLps + way) - grey.at(vertex.positionLps - way));
    });
    for (int i = 0; i < evenings; ++i)
        changes = evened(surface, changes);
    std::vector<double> sorted;
    surface.forEachVertex(
        [&](VertexId id, const SurfaceUpdate::Vertex&) { sorted.push_back(changes[id]); });
    std::vector<bool> isFaint(surface.vertexSlots(), false);
    if (sorted.empty())
        return isFaint;
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    surface.forEachVertex([&](VertexId id, const SurfaceUpdate::Vertex& vertex) {
        isFaint[id] = vertex.mark == SurfaceMark::Yellow && changes[id] < faintEdge * *middle;
    });
    return isFaint;
}

} // namespace core
