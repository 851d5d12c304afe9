// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

/// Signed distances in millimetres, negative inside, as usual in implicit modelling; exact for
/// spheres and capsules, first order for ellipsoids.
namespace core::demo {

using glm::vec3;

/// Mirrors x to the left side, for shapes that are symmetric.
inline vec3 folded(const vec3& p)
{
    return {std::abs(p.x), p.y, p.z};
}

inline float sphere(const vec3& p, const vec3& centre, float radius)
{
    return glm::length(p - centre) - radius;
}

inline float ellipsoid(const vec3& p, const vec3& centre, const vec3& radii)
{
    const vec3 q = (p - centre) / radii;
    const float k = glm::length(q);
    const float slope = glm::length(q / radii);
    return slope > 1e-6F ? k * (k - 1.0F) / slope : -std::min({radii.x, radii.y, radii.z});
}

/// A round cone: radius changes linearly from @p a to @p b.
inline float capsule(const vec3& p, const vec3& a, const vec3& b, float radiusA, float radiusB)
{
    const vec3 pa = p - a;
    const vec3 ba = b - a;
    const float t = std::clamp(glm::dot(pa, ba) / glm::dot(ba, ba), 0.0F, 1.0F);
    return glm::length(pa - ba * t) - (radiusA + (radiusB - radiusA) * t);
}

inline float capsule(const vec3& p, const vec3& a, const vec3& b, float radius)
{
    return capsule(p, a, b, radius, radius);
}

/// A box with rounded edges; @p half includes the rounding.
inline float roundBox(const vec3& p, const vec3& centre, const vec3& half, float rounding)
{
    const vec3 q = glm::abs(p - centre) - half + rounding;
    return glm::length(glm::max(q, 0.0F)) + std::min(std::max({q.x, q.y, q.z}), 0.0F) - rounding;
}

/// Union that rounds the crease over about @p width millimetres.
inline float join(float a, float b, float width)
{
    const float h = std::max(width - std::abs(a - b), 0.0F) / width;
    return std::min(a, b) - h * h * width * 0.25F;
}

/// The part of @p a that lies outside @p b, with a rounded edge.
inline float carve(float a, float b, float width)
{
    return -join(-a, b, width);
}

/// Share of a voxel that lies inside, for an edge @p width millimetres wide.
inline float coverage(float distance, float width = 2.0F)
{
    const float t = std::clamp(0.5F - distance / width, 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

inline float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

} // namespace core::demo
