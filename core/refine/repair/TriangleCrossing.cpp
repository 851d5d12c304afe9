// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/TriangleCrossing.h"

namespace core {

namespace {

__extension__ using Wide = __int128;

/// Whether a way passes through a triangle, its edges included, from one side to the other.
/// @param fromSide, toSide of the triangle's plane
bool passes(const glm::ivec3& from, int fromSide, const glm::ivec3& to, int toSide,
    const LatticeTriangle& triangle)
{
    if (fromSide * toSide >= 0)
        return false;
    const int ab = sideOf(from, to, triangle[0].place, triangle[1].place);
    const int bc = sideOf(from, to, triangle[1].place, triangle[2].place);
    if (ab * bc < 0)
        return false;
    const int ca = sideOf(from, to, triangle[2].place, triangle[0].place);
    return ab * ca >= 0 && bc * ca >= 0;
}

/// Whether an edge of @p one passes through @p other, apart from those at a shared corner.
bool anEdgePasses(
    const LatticeTriangle& one, const std::array<bool, 3>& isShared, const LatticeTriangle& other)
{
    std::array<int, 3> sides{};
    int least = 1;
    int most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] =
            isShared[i] ? 0 : sideOf(other[0].place, other[1].place, other[2].place, one[i].place);
        least = sides[i] < least ? sides[i] : least;
        most = sides[i] > most ? sides[i] : most;
    }
    if (least >= 0 || most <= 0)
        return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (!isShared[i] && !isShared[next]
            && passes(one[i].place, sides[i], one[next].place, sides[next], other))
            return true;
    }
    return false;
}

} // namespace

int sideOf(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c, const glm::ivec3& place)
{
    const glm::i64vec3 u = glm::i64vec3(b) - glm::i64vec3(a);
    const glm::i64vec3 v = glm::i64vec3(c) - glm::i64vec3(a);
    const glm::i64vec3 w = glm::i64vec3(place) - glm::i64vec3(a);
    // Of corners this near all of it has room in 64 bits, as three times a product of 2⁶¹.
    constexpr std::int64_t nearby = std::int64_t(1) << 20;
    const glm::i64vec3 size = glm::max(glm::max(glm::abs(u), glm::abs(v)), glm::abs(w));
    if (size.x < nearby && size.y < nearby && size.z < nearby) {
        const std::int64_t product = wholeDot(wholeCross(u, v), w);
        return product > 0 ? 1 : product < 0 ? -1 : 0;
    }
    const Wide volume = Wide(u.y * v.z - u.z * v.y) * w.x + Wide(u.z * v.x - u.x * v.z) * w.y
        + Wide(u.x * v.y - u.y * v.x) * w.z;
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

bool passThroughEachOther(const LatticeTriangle& one, const LatticeTriangle& other)
{
    std::array<bool, 3> sharedOfOne{};
    std::array<bool, 3> sharedOfOther{};
    int shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (one[i].point != other[j].point)
                continue;
            sharedOfOne[i] = sharedOfOther[j] = true;
            ++shared;
        }
    }
    return shared < 2
        && (anEdgePasses(one, sharedOfOne, other) || anEdgePasses(other, sharedOfOther, one));
}

} // namespace core
