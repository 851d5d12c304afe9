// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/planes/SketchedShape.h"

#include "core/base/FixedPoint.h"
#include "core/morphology/SliceDistances.h"
#include "core/morphology/SliceParts.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace core {

namespace {

/// The index axes across a plane's columns, ascending.
std::array<int, 2> axesAcross(const PlaneSketch::Plane& plane)
{
    return {plane.along == 0 ? 1 : 0, plane.along == 2 ? 1 : 2};
}

bool isOnAnother(const PlaneSketch& sketch, std::size_t plane, const glm::ivec3& voxel)
{
    for (std::size_t other = 0; other < sketch.planes.size(); ++other) {
        const PlaneSketch::Plane& each = sketch.planes[other];
        if (other != plane && isOn(each, placeOf(each, voxel)[2]))
            return true;
    }
    return false;
}

/// The pixels of a plane under which the label is, without the parts that are left out.
class Drawn {
public:
    Drawn(const PlaneSketch& sketch, std::size_t number, std::span<const std::uint8_t> labels,
        const glm::ivec3& size, std::uint8_t label)
        : m_plane(sketch.planes[number])
        , m_steps{.xx = m_plane.pitch.x * m_plane.pitch.x, .yy = m_plane.pitch.y * m_plane.pitch.y}
        , m_mask{.size = m_plane.end - m_plane.begin}
    {
        m_mask.pixels.assign(std::size_t(m_mask.size.x) * std::size_t(m_mask.size.y), 0);
        std::vector<std::uint8_t> own(m_mask.pixels.size(), 0);
        for (int y = 1; y + 1 < m_mask.size.y; ++y) {
            for (int x = 1; x + 1 < m_mask.size.x; ++x) {
                const std::optional<glm::ivec3> voxel =
                    voxelUnder(m_plane, m_plane.begin + glm::ivec2(x, y), size);
                if (!voxel || labels[indexOf(*voxel, size)] != label)
                    continue;
                m_any = true;
                m_mask.pixels[m_mask.indexOf({x, y})] = 1;
                const bool isShared = isOnAnother(sketch, number, *voxel);
                own[m_mask.indexOf({x, y})] = isShared ? 0 : 1;
                ++(isShared ? m_sharedPixels : m_ownPixels);
            }
        }
        if (m_any)
            keepOwn(own);
    }
    /// Whether anything was drawn.
    [[nodiscard]] bool any() const { return m_any; }
    [[nodiscard]] std::int64_t extent() const { return m_extent; }
    [[nodiscard]] std::int64_t ownPixels() const { return m_ownPixels; }
    [[nodiscard]] std::int64_t sharedPixels() const { return m_sharedPixels; }
    [[nodiscard]] const glm::ivec2& size() const { return m_mask.size; }
    [[nodiscard]] std::vector<SketchedShape::Row> rows() const
    {
        std::vector<SketchedShape::Row> rows;
        for (int y = 0; y < m_mask.size.y; ++y) {
            const auto begin = m_mask.pixels.begin() + std::ptrdiff_t(m_mask.indexOf({0, y}));
            const auto end = begin + m_mask.size.x;
            const auto first = std::find(begin, end, 1);
            if (first == end)
                continue;
            const auto last =
                std::find(std::reverse_iterator(end), std::reverse_iterator(first), 1);
            rows.push_back({.y = m_plane.begin.y + y,
                .first = m_plane.begin.x + int(first - begin),
                .last = m_plane.begin.x + int(last.base() - begin) - 1});
        }
        return rows;
    }
    [[nodiscard]] std::vector<std::int32_t> distances() const
    {
        std::vector<std::int32_t> distances;
        distances.reserve(m_mask.pixels.size());
        for (const std::int64_t square : signedSquares(m_mask, m_steps)) {
            const auto root = std::int32_t(fixedPoint::squareRoot(std::abs(square)));
            distances.push_back(square > 0 ? root : -root);
        }
        return distances;
    }

private:
    static std::size_t indexOf(const glm::ivec3& voxel, const glm::ivec3& size)
    {
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    void keepOwn(const std::vector<std::uint8_t>& own)
    {
        const SliceParts slice = sliceParts(m_mask, m_steps);
        std::vector<bool> isOwn(slice.parts.size(), false);
        for (std::size_t at = 0; at < own.size(); ++at) {
            if (own[at] != 0)
                isOwn[std::size_t(slice.partAt[at])] = true;
        }
        m_any = false;
        for (std::size_t part = 0; part < slice.parts.size(); ++part) {
            if (!isOwn[part])
                continue;
            m_any = true;
            const glm::ivec2 sides = slice.parts[part].end - slice.parts[part].begin;
            m_extent = std::max({m_extent, sides.x * m_plane.pitch.x, sides.y * m_plane.pitch.y});
        }
        for (std::size_t at = 0; at < own.size(); ++at) {
            const int part = slice.partAt[at];
            m_mask.pixels[at] = part >= 0 && isOwn[std::size_t(part)] ? 1 : 0;
        }
    }

    const PlaneSketch::Plane& m_plane;
    SliceSteps m_steps;
    SliceMask m_mask;
    bool m_any = false;
    std::int64_t m_extent = 0;
    std::int64_t m_ownPixels = 0;
    std::int64_t m_sharedPixels = 0;
};

} // namespace

PlaneSketch::Fixed3 placeOf(const PlaneSketch::Plane& plane, const glm::ivec3& voxel)
{
    PlaneSketch::Fixed3 place = plane.origin;
    for (std::size_t part = 0; part < 3; ++part) {
        for (int axis = 0; axis < 3; ++axis)
            place.at(part) += voxel[axis] * plane.perVoxel.at(std::size_t(axis)).at(part);
    }
    return place;
}

std::optional<glm::ivec3> voxelUnder(
    const PlaneSketch::Plane& plane, const glm::ivec2& pixel, const glm::ivec3& size)
{
    using fixedPoint::floorDivide;
    glm::ivec3 voxel(0);
    const std::array<int, 2> across = axesAcross(plane);
    for (std::size_t each = 0; each < 2; ++each) {
        const std::int64_t index = fixedPoint::round30(plane.column.at(each)
            + pixel.x * plane.columnPerRight.at(each) + pixel.y * plane.columnPerUp.at(each));
        if (index < 0 || index >= size[across.at(each)])
            return std::nullopt;
        voxel[across.at(each)] = int(index);
    }
    // The first one whose height is not less than minus half a step.
    const std::int64_t step = plane.perVoxel.at(std::size_t(plane.along))[2];
    const std::int64_t height = placeOf(plane, voxel)[2];
    const std::int64_t index = -floorDivide(step + 2 * height, 2 * step);
    if (index < 0 || index >= size[plane.along])
        return std::nullopt;
    voxel[plane.along] = int(index);
    return voxel;
}

std::int64_t SketchedShape::at(const PlaneSketch::Plane& plane, std::int64_t right, std::int64_t up,
    std::int64_t outside) const
{
    constexpr int bits = 8;
    constexpr std::int64_t whole = std::int64_t(1) << bits;
    const std::int64_t x = fixedPoint::floorDivide(right * whole, plane.pitch.x);
    const std::int64_t y = fixedPoint::floorDivide(up * whole, plane.pitch.y);
    const std::int64_t column = (x >> bits) - begin.x;
    const std::int64_t row = (y >> bits) - begin.y;
    if (column < 0 || row < 0 || column + 1 >= size.x || row + 1 >= size.y)
        return outside;
    const std::int64_t beyondX = x & (whole - 1);
    const std::int64_t beyondY = y & (whole - 1);
    const std::int32_t* lower =
        &distances[std::size_t(row) * std::size_t(size.x) + std::size_t(column)];
    const std::int32_t* upper = lower + size.x;
    const std::int64_t below = lower[0] * (whole - beyondX) + lower[1] * beyondX;
    const std::int64_t above = upper[0] * (whole - beyondX) + upper[1] * beyondX;
    return (below * (whole - beyondY) + above * beyondY) >> (2 * bits);
}

SketchedShape sketchedShape(const PlaneSketch& sketch, std::size_t plane,
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label)
{
    const Drawn drawn(sketch, plane, labels, size, label);
    SketchedShape shape{.begin = sketch.planes[plane].begin,
        .size = drawn.size(),
        .ownPixels = drawn.ownPixels(),
        .sharedPixels = drawn.sharedPixels()};
    if (!drawn.any())
        return shape;
    shape.rows = drawn.rows();
    shape.extent = drawn.extent();
    shape.distances = drawn.distances();
    return shape;
}

} // namespace core
