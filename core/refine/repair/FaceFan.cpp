// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/FaceFan.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace core {

namespace {

/// Products of three differences of so many bits, and sums of three such, have room in 64 bits.
constexpr int nearBits = 20;

glm::i64vec3 between(const glm::ivec3& from, const glm::ivec3& to)
{
    return glm::i64vec3(to) - glm::i64vec3(from);
}

std::int64_t longestOf(const glm::i64vec3& way)
{
    const glm::i64vec3 size = glm::abs(way);
    return std::max({size.x, size.y, size.z});
}

/// About the same direction, with components of few enough bits.
glm::i64vec3 shortened(const glm::i64vec3& way)
{
    const int bits = int(std::bit_width(std::uint64_t(longestOf(way))));
    return bits < nearBits ? way : way / (std::int64_t(1) << (bits - nearBits + 1));
}

/// Whether all differences within the box are of few enough bits.
bool isNear(const glm::ivec3& low, const glm::ivec3& high)
{
    return longestOf(glm::i64vec3(high) - glm::i64vec3(low)) < (std::int64_t(1) << nearBits);
}

/// The corners that two faces have in common.
struct SharedCorners {
    std::array<VertexId, 2> ids{noId, noId};
    int count = 0; ///< may be more than two
    [[nodiscard]] bool has(VertexId id) const { return id == ids[0] || id == ids[1]; }
};

SharedCorners sharedCorners(const FaceFan& one, const FaceFan& other)
{
    SharedCorners shared;
    for (const VertexId a : one.ring) {
        for (const VertexId b : other.ring) {
            if (a != b)
                continue;
            if (shared.count < 2)
                shared.ids[std::size_t(shared.count)] = a;
            ++shared.count;
        }
    }
    return shared;
}

/// Whether a plane has the one face on one side and the other on the other, and on it no more than
/// the edge that they share.
bool areDivided(const FaceFan& one, const FaceFan& other)
{
    if (!isNear(glm::min(one.box.low, other.box.low), glm::max(one.box.high, other.box.high)))
        return false;
    const SharedCorners shared = sharedCorners(one, other);
    if (shared.count == 1 || shared.count > 2)
        return false;
    const bool isEdge = shared.count == 2;
    const glm::i64vec3 way = between(one.middle.place, other.middle.place);
    const glm::ivec3 origin = isEdge ? one.points[shared.ids[0]] : one.middle.place;
    glm::i64vec3 normal = way;
    if (isEdge) {
        const glm::i64vec3 edge = between(origin, one.points[shared.ids[1]]);
        normal = wholeCross(edge, shortened(wholeCross(edge, way)));
        if (wholeDot(normal, way) < 0)
            normal = -normal;
    }
    const auto heightOf = [&](const glm::ivec3& place) {
        return wholeDot(normal, between(origin, place));
    };
    std::int64_t mostOfOne = heightOf(one.middle.place);
    std::int64_t leastOfOther = heightOf(other.middle.place);
    const auto areOnTheirSides = [&] {
        return isEdge ? mostOfOne < 0 && leastOfOther > 0 : mostOfOne < leastOfOther;
    };
    for (const VertexId id : one.ring) {
        if (!shared.has(id))
            mostOfOne = std::max(mostOfOne, heightOf(one.points[id]));
    }
    if (!areOnTheirSides())
        return false;
    for (const VertexId id : other.ring) {
        if (!shared.has(id))
            leastOfOther = std::min(leastOfOther, heightOf(other.points[id]));
    }
    return areOnTheirSides();
}

/// Whether a face is seen whole along some direction: its triangles then lie side by side, once
/// around its middle.
bool isSeenWhole(const FaceFan& fan)
{
    if (!isNear(fan.box.low, fan.box.high))
        return false;
    const auto wayTo = [&fan](std::size_t i) {
        return between(fan.middle.place, fan.corner(i).place);
    };
    const std::size_t count = fan.ring.size();
    glm::i64vec3 area(0);
    for (std::size_t i = 0; i < count; ++i)
        area += wholeCross(wayTo(i), wayTo(i + 1));
    const glm::i64vec3 normal = shortened(area);
    const glm::i64vec3 first = wayTo(0);
    // Each triangle turns by less than half a turn, so the ring ends a turn each time that it comes
    // back to the first half.
    int turns = 0;
    bool isFirstHalf = true;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::i64vec3 to = wayTo(i + 1);
        if (wholeDot(normal, wholeCross(wayTo(i), to)) <= 0)
            return false;
        const bool wasFirstHalf = isFirstHalf;
        isFirstHalf = i + 1 == count || wholeDot(normal, wholeCross(first, to)) > 0;
        turns += isFirstHalf && !wasFirstHalf ? 1 : 0;
    }
    return turns == 1;
}

FaceBox boxOf(const LatticeTriangle& triangle)
{
    const glm::ivec3& a = triangle[0].place;
    const glm::ivec3& b = triangle[1].place;
    const glm::ivec3& c = triangle[2].place;
    return {.low = glm::min(glm::min(a, b), c), .high = glm::max(glm::max(a, b), c)};
}

} // namespace

bool passThroughEachOther(const FaceFan& one, const FaceFan& other)
{
    if (areDivided(one, other))
        return false;
    for (std::size_t i = 0; i < one.ring.size(); ++i) {
        const LatticeTriangle a = one.triangle(i);
        const FaceBox box = boxOf(a);
        if (!box.meets(other.box))
            continue;
        for (std::size_t j = 0; j < other.ring.size(); ++j) {
            const LatticeTriangle b = other.triangle(j);
            if (box.meets(boxOf(b)) && passThroughEachOther(a, b))
                return true;
        }
    }
    return false;
}

bool passesThroughItself(const FaceFan& fan)
{
    if (isSeenWhole(fan))
        return false;
    for (std::size_t i = 0; i < fan.ring.size(); ++i) {
        for (std::size_t j = i + 1; j < fan.ring.size(); ++j) {
            if (passThroughEachOther(fan.triangle(i), fan.triangle(j)))
                return true;
        }
    }
    return false;
}

} // namespace core
