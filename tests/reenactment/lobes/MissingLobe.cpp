// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/lobes/MissingLobe.h"

#include "tests/reenactment/lobes/PlaneOutlines.h"

#include <algorithm>
#include <cmath>

namespace reenact {

namespace {

constexpr double gridMm = 1.0;
/// How far beyond the cut an open contour begins.
constexpr double overlapMm = 3.0;
/// Over which the trembling is alike.
constexpr double trembleMm = 4.0;

/// Where the voxels that are missing lie along a direction, ascending.
std::vector<double> placesAlong(const MissingLobe& lobe, const glm::dvec3& direction)
{
    std::vector<double> places;
    std::size_t at = 0;
    for (int z = 0; z < lobe.truth.size.z; ++z) {
        for (int y = 0; y < lobe.truth.size.y; ++y) {
            for (int x = 0; x < lobe.truth.size.x; ++x, ++at) {
                if (lobe.truth.values[at] != lobe.left.values[at])
                    places.push_back(
                        glm::dot(lobe.geometry.toWorld(glm::dvec3(x, y, z)), direction));
            }
        }
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// The outlines of the organ on a plane.
std::vector<PlaneLine> organOn(
    const MissingLobe& lobe, const Field& soft, const glm::dvec3& normal, double atMm)
{
    const CuttingPlane plane = CuttingPlane::through(lobe.geometry, atMm * normal, normal);
    return outlinesOn(plane, gridMm, [&](const glm::dvec3& place) {
        const glm::dvec3 index = lobe.geometry.toIndex(place);
        // What lies off the grid is outside.
        for (int axis = 0; axis < 3; ++axis) {
            if (index[axis] < -0.5 || index[axis] > double(lobe.geometry.size[axis]) - 0.5)
                return -0.5;
        }
        return sampled(soft, index) - 0.5;
    });
}

/// The longest part of an outline that a hand would draw.
core::TemplateContour inLobe(const MissingLobe& lobe, const PlaneLine& line)
{
    const auto isThere = [&](std::size_t i) {
        return glm::dot(line[i % line.size()], lobe.normalLps) > lobe.atMm - overlapMm;
    };
    std::size_t outside = 0;
    while (outside < line.size() && isThere(outside))
        ++outside;
    if (outside == line.size())
        return {.pointsLps = line, .isClosed = true};
    core::TemplateContour longest;
    PlaneLine run;
    for (std::size_t i = outside; i <= outside + line.size(); ++i) {
        if (isThere(i)) {
            run.push_back(line[i % line.size()]);
            continue;
        }
        if (run.size() > longest.pointsLps.size())
            longest.pointsLps = run;
        run.clear();
    }
    return longest;
}

} // namespace

void tremble(core::TemplateContour& contour, const glm::dvec3& normal, double stepMm,
    double jitterMm, CounterRandom& random)
{
    const glm::dvec3 right = axisBeside(normal);
    const glm::dvec3 down = glm::cross(normal, right);
    const int count = int(contour.pointsLps.size());
    const int reach = int(3.0 * trembleMm / stepMm);
    std::vector<double> weights;
    double squares = 0.0;
    for (int off = -reach; off <= reach; ++off) {
        const double away = double(off) * stepMm / trembleMm;
        weights.push_back(std::exp(-0.5 * away * away));
        squares += weights.back() * weights.back();
    }
    std::vector<glm::dvec2> noise(std::size_t(count + 2 * reach));
    for (glm::dvec2& each : noise)
        each = {random.normal(), random.normal()};
    for (int i = 0; i < count; ++i) {
        glm::dvec2 sum(0.0);
        for (int off = -reach; off <= reach; ++off) {
            // A closed one closes after it trembled, too.
            const int from = contour.isClosed ? (i + off + reach * count) % count : i + off + reach;
            sum += weights[std::size_t(off + reach)] * noise[std::size_t(from)];
        }
        sum *= jitterMm / std::sqrt(squares);
        contour.pointsLps[std::size_t(i)] += sum.x * right + sum.y * down;
    }
}

MissingLobe withoutLobe(const core::VolumeGeometry& geometry, const Mask& truth,
    const glm::dvec3& normalLps, double share)
{
    MissingLobe lobe{.geometry = geometry,
        .truth = truth,
        .left = {truth.size, std::vector<std::uint8_t>(truth.values.size(), 0)},
        .normalLps = glm::normalize(normalLps)};
    const std::vector<double> places = placesAlong(lobe, lobe.normalLps);
    lobe.atMm = places[std::size_t((1.0 - share) * double(places.size()))];
    std::size_t at = 0;
    for (int z = 0; z < truth.size.z; ++z) {
        for (int y = 0; y < truth.size.y; ++y) {
            for (int x = 0; x < truth.size.x; ++x, ++at) {
                if (glm::dot(geometry.toWorld(glm::dvec3(x, y, z)), lobe.normalLps) < lobe.atMm)
                    lobe.left.values[at] = truth.values[at];
            }
        }
    }
    return lobe;
}

std::vector<core::TemplateContour> drawn(
    const MissingLobe& lobe, const LobeDrawing& drawing, double jitterMm, std::uint64_t seed)
{
    const Field soft = smoothed(lobe.truth);
    const glm::dvec3 upright = axisBeside(lobe.normalLps);
    const glm::dvec3 beside = glm::cross(lobe.normalLps, upright);
    CounterRandom random(seed, 34);
    std::vector<core::TemplateContour> contours;
    for (const auto& [normal, count] : {std::pair(lobe.normalLps, drawing.across),
             std::pair(upright, drawing.upright), std::pair(beside, drawing.beside)}) {
        const std::vector<double> places = placesAlong(lobe, normal);
        for (int i = 0; i < count; ++i) {
            const double share = (double(i) + 0.5) / double(count);
            const double atMm = places[std::size_t(share * double(places.size()))];
            core::TemplateContour chosen;
            for (const PlaneLine& line : organOn(lobe, soft, normal, atMm)) {
                core::TemplateContour contour = inLobe(lobe, line);
                if (contour.pointsLps.size() > chosen.pointsLps.size())
                    chosen = std::move(contour);
            }
            if (chosen.pointsLps.size() < 6)
                continue;
            if (jitterMm > 0.0)
                tremble(chosen, normal, gridMm, jitterMm, random);
            contours.push_back(std::move(chosen));
        }
    }
    return contours;
}

} // namespace reenact
