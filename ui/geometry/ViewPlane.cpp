// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/ViewPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

SliceAxes sliceAxes(SliceOrientation orientation)
{
    const glm::dvec3 left(1.0, 0.0, 0.0);
    const glm::dvec3 back(0.0, 1.0, 0.0);
    const glm::dvec3 feet(0.0, 0.0, -1.0);
    const auto axes = [](const glm::dvec3& right, const glm::dvec3& down) {
        return SliceAxes{right, down, glm::cross(right, down)};
    };
    switch (orientation) {
    case SliceOrientation::Axial:
        return axes(left, back);
    case SliceOrientation::Sagittal:
        return axes(back, feet);
    case SliceOrientation::Coronal:
        break;
    }
    return axes(left, feet);
}

core::SliceAxis axisAlong(const core::VolumeGeometry& geometry, const glm::dvec3& normalLps)
{
    auto nearest = core::SliceAxis::I;
    double greatest = -1.0;
    for (const core::SliceAxis axis :
        {core::SliceAxis::I, core::SliceAxis::J, core::SliceAxis::K}) {
        const glm::dvec3 step(geometry.indexToWorld[alongOf(axis)]);
        const double cosine = std::abs(glm::dot(step, normalLps)) / glm::length(step);
        if (cosine > greatest) {
            greatest = cosine;
            nearest = axis;
        }
    }
    return nearest;
}

int SliceStack::numberAt(const glm::dvec3& lps) const
{
    // Halves go up, with a grain of tolerance: positions come from sums of millimetres.
    const double number = (glm::dot(lps, normalLps) - firstMm) / stepMm;
    return std::clamp(int(std::floor(number + 0.5 + 1e-6)), 0, std::max(count - 1, 0));
}

glm::dvec3 SliceStack::movedTo(const glm::dvec3& lps, int number) const
{
    const double target = firstMm + std::clamp(number, 0, std::max(count - 1, 0)) * stepMm;
    return lps + (target - glm::dot(lps, normalLps)) * normalLps;
}

SliceStack sliceStack(const core::VolumeGeometry& geometry, const glm::dvec3& normalLps)
{
    SliceStack stack;
    stack.normalLps = normalLps;
    const glm::dvec3 step(geometry.indexToWorld[alongOf(axisAlong(geometry, normalLps))]);
    stack.stepMm = std::abs(glm::dot(step, normalLps));

    double lowest = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& corner : geometry.cornersLps()) {
        lowest = std::min(lowest, glm::dot(corner, stack.normalLps));
        highest = std::max(highest, glm::dot(corner, stack.normalLps));
    }
    // The cells of the outermost voxels reach half a step beyond their centres.
    stack.count = std::max(1, int(std::lround((highest - lowest) / stack.stepMm)));
    stack.firstMm = 0.5 * (lowest + highest) - 0.5 * (stack.count - 1) * stack.stepMm;
    return stack;
}

int samplesPerSlice(const core::VolumeGeometry& geometry, const SliceStack& stack)
{
    constexpr double alongAnAxis = 0.05; // voxels
    constexpr double mostApart = 0.5 + 1e-6; // voxels
    const glm::dvec3 apart =
        glm::abs(glm::dmat3(geometry.worldToIndex()) * (stack.normalLps * stack.stepMm));
    const double most = std::max({apart.x, apart.y, apart.z});
    if (apart.x + apart.y + apart.z - most < alongAnAxis)
        return 1;
    int samples = 1;
    while (most / samples > mostApart)
        samples += 2;
    return samples;
}

} // namespace ui
