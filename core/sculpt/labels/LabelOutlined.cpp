// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/LabelOutlined.h"

#include <algorithm>
#include <array>
#include <utility>

namespace core {

namespace {

/// An outline whose edges are sorted into strips of the plane, so that a place is compared with the
/// few edges that run past it.
class StrippedOutline {
public:
    explicit StrippedOutline(const std::vector<glm::ivec2>& corners)
        : m_corners(corners)
        , m_low(corners.front())
        , m_high(corners.front())
    {
        for (const glm::ivec2& corner : corners) {
            m_low = glm::min(m_low, corner);
            m_high = glm::max(m_high, corner);
        }
        // An edge stands in each strip that it crosses. Together that must not be too many.
        constexpr std::size_t mostEntries = std::size_t(1) << 22;
        const std::size_t count =
            std::max<std::size_t>(std::min(corners.size(), mostEntries / corners.size()), 1);
        m_height = (m_high.y - m_low.y) / int(count) + 1;
        m_strips.resize(count);
        for (std::size_t edge = 0; edge < corners.size(); ++edge) {
            const auto [a, b] = std::minmax(corners[edge].y, corners[nextOf(edge)].y);
            for (std::size_t strip = stripOf(a); strip <= stripOf(b); ++strip)
                m_strips[strip].push_back(edge);
        }
    }

    [[nodiscard]] const glm::ivec2& low() const { return m_low; }
    [[nodiscard]] const glm::ivec2& high() const { return m_high; }

    /// Rule 2 of LabelOutlined.h. @pre the place lies between low() and high()
    [[nodiscard]] bool holds(const glm::ivec2& place) const
    {
        int winding = 0;
        for (const std::size_t edge : m_strips[stripOf(place.y)]) {
            const glm::ivec2& from = m_corners[edge];
            const glm::ivec2& to = m_corners[nextOf(edge)];
            const auto [lowest, highest] = std::minmax(from.y, to.y);
            if (place.y < lowest || place.y > highest)
                continue;
            const glm::ivec2 along = to - from;
            const glm::ivec2 away = place - from;
            const std::int64_t side =
                std::int64_t(along.x) * away.y - std::int64_t(away.x) * along.y;
            const auto [leftmost, rightmost] = std::minmax(from.x, to.x);
            if (side == 0 && place.x >= leftmost && place.x <= rightmost)
                return true;
            // Each edge has its lower end and not its upper one, so that a corner counts once.
            if (from.y <= place.y && to.y > place.y && side > 0)
                ++winding;
            else if (from.y > place.y && to.y <= place.y && side < 0)
                --winding;
        }
        return winding != 0;
    }

private:
    [[nodiscard]] std::size_t nextOf(std::size_t edge) const
    {
        return edge + 1 == m_corners.size() ? 0 : edge + 1;
    }
    [[nodiscard]] std::size_t stripOf(int y) const { return std::size_t((y - m_low.y) / m_height); }

    const std::vector<glm::ivec2>& m_corners;
    glm::ivec2 m_low;
    glm::ivec2 m_high;
    int m_height = 1; ///< of a strip
    std::vector<std::vector<std::size_t>> m_strips; ///< numbers of edges; each begins at a corner
};

/// Rule 1 of LabelOutlined.h, before it is rounded.
std::int64_t exactPlace(const LabelOutlined& edit, std::size_t component, const glm::ivec3& voxel)
{
    return edit.origin[component] + voxel.x * edit.perI[component] + voxel.y * edit.perJ[component]
        + voxel.z * edit.perK[component];
}

/// What a box must meet so that a voxel of it may be chosen: mm · 2³⁰, a little wider than that.
struct OutlineBounds {
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};

    explicit OutlineBounds(const LabelOutlined& edit)
    {
        glm::ivec2 lowest = edit.corners.front();
        glm::ivec2 highest = lowest;
        for (const glm::ivec2& corner : edit.corners) {
            lowest = glm::min(lowest, corner);
            highest = glm::max(highest, corner);
        }
        const std::array<std::int64_t, 3> least{
            lowest.x, lowest.y, -std::int64_t(edit.halfThickness)};
        const std::array<std::int64_t, 3> most{highest.x, highest.y, edit.halfThickness};
        for (std::size_t component = 0; component < 3; ++component) {
            low[component] = (least[component] - 1) * 16384;
            high[component] = (most[component] + 1) * 16384;
        }
    }

    [[nodiscard]] bool meets(const LabelOutlined& edit, const VoxelBox& box) const
    {
        const glm::ivec3 last = box.maximum - 1;
        for (std::size_t component = 0; component < 3; ++component) {
            std::int64_t least = edit.origin[component];
            std::int64_t most = least;
            int axis = 0;
            for (const Fixed3* const step : {&edit.perI, &edit.perJ, &edit.perK}) {
                const auto [nearest, farthest] = std::minmax(
                    {box.minimum[axis] * (*step)[component], last[axis] * (*step)[component]});
                least += nearest;
                most += farthest;
                ++axis;
            }
            if (most < low[component] || least > high[component])
                return false;
        }
        return true;
    }
};

/// Whether so many steps stay within 2⁵⁸ on each axis, so that the sum of rule 1 does not overflow.
bool staysInReach(const Fixed3& step, int count)
{
    const std::int64_t most = (std::int64_t(1) << 58) / std::max(count, 1);
    return std::all_of(step.begin(), step.end(),
        [most](std::int64_t each) { return each > -most && each < most; });
}

} // namespace

Result<void> checkSound(const LabelOutlined& edit, const BrickGrid& grid)
{
    if (edit.target.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    const auto inReach = [](int each) {
        return each >= -LabelOutlined::reach && each <= LabelOutlined::reach;
    };
    if (edit.corners.size() < 3 || edit.corners.size() > LabelOutlined::mostCorners
        || !std::all_of(edit.corners.begin(), edit.corners.end(),
            [&inReach](const glm::ivec2& each) { return inReach(each.x) && inReach(each.y); }))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("corners"), Clause::saying("are not sound"));
    const glm::ivec3& size = grid.volumeSize;
    if (edit.halfThickness < 0 || !staysInReach(edit.origin, 1) || !staysInReach(edit.perI, size.x)
        || !staysInReach(edit.perJ, size.y) || !staysInReach(edit.perK, size.z))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("plane"), Clause::saying("is not sound"));
    return checkSound(edit.editable);
}

std::vector<std::uint32_t> bricksNear(const LabelOutlined& edit, const BrickGrid& grid)
{
    const OutlineBounds bounds(edit);
    const glm::ivec3 bricks = grid.bricks();
    std::vector<std::uint32_t> near;
    for (int z = 0; z < bricks.z; ++z) {
        for (int y = 0; y < bricks.y; ++y) {
            const int first = (z * bricks.y + y) * bricks.x;
            if (!bounds.meets(edit, grid.boxOf(first).united(grid.boxOf(first + bricks.x - 1))))
                continue;
            for (int brick = first; brick < first + bricks.x; ++brick) {
                if (bounds.meets(edit, grid.boxOf(brick)))
                    near.push_back(std::uint32_t(brick));
            }
        }
    }
    return near;
}

std::vector<RelabelListed::Brick> voxelsWithin(const LabelOutlined& edit, const BrickGrid& grid)
{
    const StrippedOutline outline(edit.corners);
    const std::uint8_t asked = edit.erase ? RelabelListed::take : RelabelListed::give;
    const auto place = [&edit](std::size_t component, const glm::ivec3& voxel) {
        return fixedPoint::round14(exactPlace(edit, component, voxel));
    };
    const auto between = [](std::int64_t value, int low, int high) {
        return value >= low && value <= high;
    };
    std::vector<RelabelListed::Brick> bricks;
    for (const std::uint32_t brick : bricksNear(edit, grid)) {
        const VoxelBox box = grid.boxOf(int(brick));
        std::vector<std::uint8_t> voxels;
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                // Most rows lie beside the slice.
                std::int64_t across = exactPlace(edit, 2, {box.minimum.x, y, z});
                const std::int64_t atEnd =
                    across + edit.perI[2] * (box.maximum.x - 1 - box.minimum.x);
                if (fixedPoint::round14(std::max(across, atEnd)) < -edit.halfThickness
                    || fixedPoint::round14(std::min(across, atEnd)) > edit.halfThickness)
                    continue;
                across -= edit.perI[2];
                for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                    const glm::ivec3 voxel(x, y, z);
                    across += edit.perI[2];
                    if (!between(
                            fixedPoint::round14(across), -edit.halfThickness, edit.halfThickness))
                        continue;
                    const std::int64_t a = place(0, voxel);
                    const std::int64_t b = place(1, voxel);
                    if (!between(a, outline.low().x, outline.high().x)
                        || !between(b, outline.low().y, outline.high().y)
                        || !outline.holds({int(a), int(b)}))
                        continue;
                    if (voxels.empty())
                        voxels.assign(BrickGrid::voxelsPerBrick, std::uint8_t(0));
                    voxels[std::size_t(BrickGrid::offsetInBrick(voxel))] = asked;
                }
            }
        }
        if (!voxels.empty())
            bricks.push_back({brick, std::move(voxels)});
    }
    return bricks;
}

} // namespace core
