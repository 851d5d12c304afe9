// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/volume/Volume.h"
#include "tests/support/scenes/TestVolumes.h"

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace test {

/// A ball of tissue in the corner of an otherwise empty volume of 1 mm voxels; values rise towards
/// its centre. Work on it must cost the same in a large volume as in a small one.
struct GradedBall {
    static constexpr glm::dvec3 middle{48.0}; ///< voxels and mm
    static constexpr double radius = 24.0;
    static constexpr double risePerMm = 20.0; ///< starting from tissueCode at the surface
    /// Of a surface that shows the ball and nothing else.
    static constexpr double threshold = 500.0;

    /// Returns a place by its distance from the middle along each axis.
    [[nodiscard]] static glm::dvec3 at(double x, double y, double z)
    {
        return middle + glm::dvec3(x, y, z);
    }
    /// Returns the study. @p side of the volume in voxels; at least 96
    [[nodiscard]] static core::LoadedVolume in(int side)
    {
        core::LoadedVolume study;
        Codes codes = constantVolume(glm::ivec3(side), 0);
        const glm::ivec3 low(middle - radius);
        const glm::ivec3 high(middle + radius);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) {
                    const double deep = radius - glm::distance(glm::dvec3(x, y, z), middle);
                    if (deep >= 0.0)
                        codes.at({x, y, z}) =
                            std::uint16_t(tissueCode + std::lround(risePerMm * deep));
                }
            }
        }
        study.codes = std::move(codes.values);
        study.volume.geometry.size = glm::ivec3(side);
        study.volume.maximum = 65535.0;
        study.volume.voxelsSha256 = "not looked at here";
        return study;
    }
    /// Returns the lowest value within a concentric ball of this radius.
    [[nodiscard]] static double valueAt(double radiusMm)
    {
        return tissueCode + risePerMm * (radius - radiusMm);
    }
    [[nodiscard]] static core::OrthographicView front()
    {
        return {.eyeLps = middle - glm::dvec3(0.0, 200.0, 0.0),
            .targetLps = middle,
            .up = {0.0, 0.0, 1.0},
            .heightMm = 80.0};
    }
    /// Returns a square in that view's plane.
    [[nodiscard]] static std::vector<glm::dvec2> squareAround(
        const glm::dvec2& place, double halfMm)
    {
        return {place + glm::dvec2(-halfMm, -halfMm), place + glm::dvec2(halfMm, -halfMm),
            place + glm::dvec2(halfMm, halfMm), place + glm::dvec2(-halfMm, halfMm)};
    }
};

} // namespace test
