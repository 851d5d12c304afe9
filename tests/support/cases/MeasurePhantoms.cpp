// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/MeasurePhantoms.h"

#include <glm/gtc/matrix_transform.hpp>

namespace test {

namespace {

/// Its middle lies at the origin.
MeasurePhantom phantomOf(const char* name, const glm::ivec3& size, const glm::dmat3& steps)
{
    MeasurePhantom phantom{.name = name, .volume = {}};
    core::VolumeGeometry& geometry = phantom.volume.geometry;
    geometry.size = size;
    for (int axis = 0; axis < 3; ++axis)
        geometry.indexToWorld[axis] = glm::dvec4(steps[axis], 0.0);
    const glm::dvec3 middle = steps * (glm::dvec3(size - 1) / 2.0);
    geometry.indexToWorld[3] = glm::dvec4(-middle, 1.0);
    return phantom;
}

glm::dmat3 scaled(const glm::dmat3& directions, const glm::dvec3& spacing)
{
    return {directions[0] * spacing.x, directions[1] * spacing.y, directions[2] * spacing.z};
}

} // namespace

glm::dvec3 MeasurePhantom::shown(const glm::dvec3& trueLps) const
{
    const core::VolumeGeometry& geometry = volume.geometry;
    if (geometry.slicePositions.empty())
        return trueLps;
    // Slices lie across z here, one over the other.
    const std::vector<glm::dvec3>& slices = geometry.slicePositions;
    std::size_t k = 0;
    while (k + 2 < slices.size() && slices[k + 1].z <= trueLps.z)
        ++k;
    const double share = (trueLps.z - slices[k].z) / (slices[k + 1].z - slices[k].z);
    return {trueLps.x, trueLps.y, geometry.toWorld({0.0, 0.0, double(k) + share}).z};
}

std::vector<MeasurePhantom> measurePhantoms()
{
    const glm::dmat3 straight(1.0);
    const glm::dmat3 turned(
        glm::rotate(glm::dmat4(1.0), glm::radians(37.0), glm::normalize(glm::dvec3(1, 2, 3))));
    std::vector<MeasurePhantom> phantoms;
    phantoms.push_back(phantomOf("isotropic", {64, 64, 64}, straight));
    phantoms.push_back(phantomOf("8:1", {128, 128, 17}, scaled(straight, {0.5, 0.5, 4.0})));
    glm::dmat3 tilted = scaled(straight, {0.75, 0.75, 2.5});
    tilted[2].y += 2.5 * std::tan(glm::radians(20.0));
    phantoms.push_back(phantomOf("tilted", {90, 120, 26}, tilted));
    MeasurePhantom uneven = phantomOf("uneven", {64, 64, 25}, scaled(straight, {1.0, 1.0, 2.5}));
    core::VolumeGeometry& geometry = uneven.volume.geometry;
    double z = -33.0;
    for (int k = 0; k < 25; ++k) {
        geometry.slicePositions.emplace_back(-31.5, -31.5, z);
        z += k < 10 ? 1.5 : (k % 2 == 0 ? 3.0 : 5.0); // up to z = 38
    }
    phantoms.push_back(uneven);
    phantoms.push_back(phantomOf("oblique", {96, 96, 48}, scaled(turned, {0.7, 0.9, 2.0})));
    return phantoms;
}

} // namespace test
