// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/Reader.h"

#include "tests/reenactment/CounterRandom.h"

#include <algorithm>
#include <cmath>

namespace reenact {

namespace {

constexpr double stepMm = 1.0;

/// Linear between the centres of voxels, positive inside; what lies off the grid is outside.
double insideAt(const Mask& mask, const glm::dvec3& index)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (index[axis] < -0.5 || index[axis] > double(mask.size[axis]) - 0.5)
            return -0.5;
    }
    const glm::dvec3 place = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(mask.size - 1) - 1e-9);
    const glm::ivec3 cell(glm::floor(place));
    const glm::dvec3 part = place - glm::dvec3(cell);
    double sum = -0.5;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis)
            weight *= step[axis] == 1 ? part[axis] : 1.0 - part[axis];
        // A plane through centres meets the next slice with the weight of a rounding error.
        if (weight > 1e-7 && mask.at(cell + step) != 0)
            sum += weight;
    }
    return sum;
}

/// What a plane's error is drawn by: its pose, by hundredths of a millimetre.
std::uint64_t streamOf(const CuttingPlane& plane)
{
    const glm::dvec3 normal = plane.normalLps();
    std::uint64_t stream = 17;
    for (const double part : {normal.x, normal.y, normal.z, glm::dot(normal, plane.middleLps)})
        stream = stream * 1'000'003U + std::uint64_t(std::llround(100.0 * part) + (1LL << 40));
    return stream;
}

} // namespace

Reader::Reader(const core::LoadedVolume& study, Mask reference, std::uint64_t seed)
    : m_study(study)
    , m_toIndex(study.volume.geometry.worldToIndex())
    , m_reference(std::move(reference))
    , m_seed(seed)
{
}

SeenPlane Reader::look(const CuttingPlane& plane, const Mask& seen)
{
    ++m_looks;
    SeenPlane view{.plane = plane};
    const auto indexOf = [this](const glm::dvec3& place) {
        return glm::dvec3(m_toIndex * glm::dvec4(place, 1.0));
    };
    const auto linesOf = [&](const Mask& mask) {
        return outlinesOn(
            plane, stepMm, [&](const glm::dvec3& place) { return insideAt(mask, indexOf(place)); });
    };
    view.contours = linesOf(seen);
    view.readings = linesOf(m_reference);
    const std::uint64_t stream = streamOf(plane);
    const SmoothNoise rightwards(m_seed, 2 * stream, errorWidthMm);
    const SmoothNoise downwards(m_seed, 2 * stream + 1, errorWidthMm);
    for (PlaneLine& line : view.readings) {
        for (glm::dvec3& place : line) {
            const glm::dvec3 there = place;
            place += errorMm * rightwards.at(there) * plane.rightLps
                + errorMm * downwards.at(there) * plane.downLps;
        }
    }
    view.greyHalf = int(plane.halfMm / view.greyStepMm) + 1;
    const core::Volume& volume = m_study.volume;
    const glm::ivec3 last = volume.geometry.size - 1;
    for (int j = -view.greyHalf; j <= view.greyHalf; ++j) {
        for (int i = -view.greyHalf; i <= view.greyHalf; ++i) {
            const glm::dvec3 place = plane.middleLps
                + view.greyStepMm * (double(i) * plane.rightLps + double(j) * plane.downLps);
            const glm::ivec3 voxel =
                glm::clamp(glm::ivec3(glm::round(indexOf(place))), glm::ivec3(0), last);
            view.grey.push_back(float(volume.encoding.value(m_study.codes[seen.offset(voxel)])));
        }
    }
    return view;
}

} // namespace reenact
