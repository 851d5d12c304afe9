// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/Scene.h"

namespace test {

/// What a pixel of a 3D view looks along.
struct PixelRay {
    glm::dvec3 origin; ///< LPS, in the target's plane
    glm::dvec3 direction; ///< unit
    [[nodiscard]] glm::dvec3 at(double mm) const { return origin + direction * mm; }
};

/// @param x, y frame pixels; centres at + 0.5
[[nodiscard]] PixelRay rayOf(
    const gpu::VolumeScene& view, const glm::ivec2& frame, double x, double y);

/// Millimetres along a ray to a plane; infinite where it runs along it.
[[nodiscard]] double mmToPlane(
    const PixelRay& ray, const glm::dvec3& pointLps, const glm::dvec3& normalLps);
/// By how far a ray misses a sphere; negative: it meets it.
[[nodiscard]] double gapToSphere(const PixelRay& ray, const glm::dvec3& centreLps, double radiusMm);
/// Millimetres along a ray to where it enters a sphere that it meets.
[[nodiscard]] double mmToSphere(const PixelRay& ray, const glm::dvec3& centreLps, double radiusMm);

/// Where frame pixels are sampled in refined pictures, from the middle of a pixel.
[[nodiscard]] glm::dvec2 samplingPoint(int picture);
inline constexpr int samplingPoints = 8;

/// The greatest difference of a channel.
[[nodiscard]] int apart(const glm::ivec3& one, const glm::ivec3& other);
[[nodiscard]] int mostApart(const gpu::Frame& one, const gpu::Frame& other);
/// Anything but black.
[[nodiscard]] bool isLit(const gpu::Frame& frame, int x, int y);

} // namespace test
