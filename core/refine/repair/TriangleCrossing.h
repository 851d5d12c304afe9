// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace core {

// Decides exactly whether two triangles of a surface pass through each other. Corners are integers
// below 2²⁹ (SurfaceFill.h), so no product reaches 2⁹⁶. Triangles that only touch do not count.

/// A corner of a triangle: the number of its point, by which shared corners are recognised, and its
/// position.
struct LatticeCorner {
    std::uint32_t point = 0;
    glm::ivec3 place{0};
};
using LatticeTriangle = std::array<LatticeCorner, 3>;

[[nodiscard]] inline glm::i64vec3 wholeCross(const glm::i64vec3& u, const glm::i64vec3& v)
{
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
[[nodiscard]] inline std::int64_t wholeDot(const glm::i64vec3& u, const glm::i64vec3& v)
{
    return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// On which side of the plane through a, b and c a place lies: −1, 0 (on it) or 1.
[[nodiscard]] int sideOf(
    const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c, const glm::ivec3& place);

/// Whether two triangles pass through each other. Two that share an edge never do. For two that
/// share a corner, what lies beyond that corner decides.
[[nodiscard]] bool passThroughEachOther(const LatticeTriangle& one, const LatticeTriangle& other);

} // namespace core
