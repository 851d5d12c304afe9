// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/filling/BetweenPlanes.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace reference {

namespace {

__extension__ using Wide = __int128;

using Plane = core::PlaneSketch::Plane;
using Pixel = std::pair<int, int>; ///< right, up

constexpr Wide one30 = Wide(1) << 30;

/// Rounded down.
Wide floored(Wide value, Wide divisor)
{
    Wide result = value / divisor;
    while (result * divisor > value)
        --result;
    return result;
}

/// To the nearest, halves up.
Wide nearest(Wide value, Wide divisor)
{
    return floored(2 * value + divisor, 2 * divisor);
}

Wide rootOf(Wide value)
{
    Wide low = 0;
    Wide high = Wide(1) << 40;
    while (high - low > 1) {
        const Wide middle = (low + high) / 2;
        (middle * middle <= value ? low : high) = middle;
    }
    return low;
}

/// A plane with what was drawn on it.
struct Drawing {
    const Plane* plane = nullptr;
    std::set<Pixel> shape{};
    std::map<Pixel, Wide> distances{};
};

/// Where a voxel is, seen from one plane.
struct Sight {
    std::size_t number = 0;
    Wide right = 0;
    Wide up = 0;
    Wide height = 0;
    int side = 1;
};

class Oracle {
public:
    Oracle(std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label,
        const core::PlaneSketch& sketch)
        : m_labels(labels)
        , m_size(size)
        , m_label(label)
        , m_sketch(sketch)
    {
        for (std::size_t number = 0; number < sketch.planes.size(); ++number)
            m_drawings.push_back(drawingOn(number));
        for (Drawing& each : m_drawings)
            measure(each);
        for (std::size_t one = 0; one < m_drawings.size(); ++one) {
            for (std::size_t other = 0; other < m_drawings.size(); ++other) {
                m_beside.push_back(isDrawnBeside(one, other, -1));
                m_beside.push_back(isDrawnBeside(one, other, 1));
            }
        }
    }

    [[nodiscard]] bool lies(const glm::ivec3& voxel) const
    {
        std::vector<Sight> sights;
        for (std::size_t number = 0; number < m_drawings.size(); ++number) {
            const Drawing& drawing = m_drawings[number];
            if (drawing.shape.empty())
                continue;
            Sight sight{.number = number,
                .right = nearest(part(*drawing.plane, voxel, 0), 1 << 14),
                .up = nearest(part(*drawing.plane, voxel, 1), 1 << 14)};
            const Wide height = part(*drawing.plane, voxel, 2);
            if (takes(*drawing.plane, voxel) && distance(number, sight.right, sight.up) > -m_reach)
                return false;
            sight.side = height < 0 ? -1 : 1;
            sight.height = nearest(height, 1 << 14) * sight.side;
            sight.height = std::max<Wide>(sight.height, 1);
            sights.push_back(sight);
        }
        std::stable_sort(sights.begin(), sights.end(),
            [](const Sight& one, const Sight& other) { return one.height < other.height; });
        std::vector<Sight> open;
        for (const Sight& each : sights) {
            if (std::none_of(open.begin(), open.end(),
                    [&](const Sight& other) { return hides(other, each); }))
                open.push_back(each);
        }
        Wide sum = 0;
        bool isEnclosed = false;
        for (std::size_t one = 0; one < open.size(); ++one) {
            for (std::size_t other = 0; other < one; ++other)
                isEnclosed =
                    addPair(open[other], open[one], open.front().height, sum) || isEnclosed;
        }
        return isEnclosed && sum >= 0;
    }

private:
    static Wide part(const Plane& plane, const glm::ivec3& voxel, std::size_t number)
    {
        return Wide(plane.origin.at(number)) + Wide(voxel.x) * plane.perVoxel[0].at(number)
            + Wide(voxel.y) * plane.perVoxel[1].at(number)
            + Wide(voxel.z) * plane.perVoxel[2].at(number);
    }
    /// Of a column the plane takes the voxel that is nearest to it, of two equal ones the lower.
    [[nodiscard]] bool takes(const Plane& plane, const glm::ivec3& voxel) const
    {
        const Wide step = plane.perVoxel.at(std::size_t(plane.along))[2];
        const Wide height = part(plane, voxel, 2);
        return 2 * height >= -step && 2 * height < step;
    }
    [[nodiscard]] bool hasLabel(const glm::ivec3& voxel) const
    {
        return m_labels[(std::size_t(voxel.z) * std::size_t(m_size.y) + std::size_t(voxel.y))
                       * std::size_t(m_size.x)
                   + std::size_t(voxel.x)]
            == m_label;
    }
    /// Every pixel of the plane, with every voxel of its column.
    [[nodiscard]] Drawing drawingOn(std::size_t number)
    {
        const Plane& plane = m_sketch.planes[number];
        Drawing drawing{.plane = &plane};
        std::set<Pixel> own;
        const int first = plane.along == 0 ? 1 : 0;
        const int second = plane.along == 2 ? 1 : 2;
        for (int y = plane.begin.y + 1; y + 1 < plane.end.y; ++y) {
            for (int x = plane.begin.x + 1; x + 1 < plane.end.x; ++x) {
                glm::ivec3 voxel(0);
                voxel[first] = int(nearest(Wide(plane.column[0]) + Wide(x) * plane.columnPerRight[0]
                        + Wide(y) * plane.columnPerUp[0],
                    one30));
                voxel[second] = int(nearest(Wide(plane.column[1])
                        + Wide(x) * plane.columnPerRight[1] + Wide(y) * plane.columnPerUp[1],
                    one30));
                if (voxel[first] < 0 || voxel[first] >= m_size[first] || voxel[second] < 0
                    || voxel[second] >= m_size[second])
                    continue;
                for (int along = 0; along < m_size[plane.along]; ++along) {
                    voxel[plane.along] = along;
                    if (!takes(plane, voxel) || !hasLabel(voxel))
                        continue;
                    drawing.shape.insert({x, y});
                    bool isShared = false;
                    for (const Plane& other : m_sketch.planes)
                        isShared = isShared || (&other != &plane && takes(other, voxel));
                    if (!isShared)
                        own.insert({x, y});
                }
            }
        }
        keepOwn(drawing, own);
        return drawing;
    }
    /// Parts without a pixel of their own go; what remains says how far drawings reach.
    void keepOwn(Drawing& drawing, const std::set<Pixel>& own)
    {
        const glm::i64vec2& pitch = drawing.plane->pitch;
        std::set<Pixel> left = drawing.shape;
        while (!left.empty()) {
            std::vector<Pixel> part{*left.begin()};
            left.erase(left.begin());
            for (std::size_t at = 0; at < part.size(); ++at) {
                for (int x = -1; x <= 1; ++x) {
                    for (int y = -1; y <= 1; ++y) {
                        const Pixel beside(part[at].first + x, part[at].second + y);
                        if (left.erase(beside) > 0)
                            part.push_back(beside);
                    }
                }
            }
            if (std::none_of(part.begin(), part.end(),
                    [&](const Pixel& pixel) { return own.count(pixel) > 0; })) {
                for (const Pixel& pixel : part)
                    drawing.shape.erase(pixel);
                continue;
            }
            for (const Pixel& one : part) {
                for (const Pixel& other : part) {
                    m_reach = std::max<Wide>(m_reach, (one.first - other.first + 1) * pitch.x);
                    m_reach = std::max<Wide>(m_reach, (one.second - other.second + 1) * pitch.y);
                }
            }
        }
        if (!drawing.shape.empty())
            m_reach = std::max<Wide>(m_reach, 8 * std::max(pitch.x, pitch.y));
    }
    /// From every pixel to the nearest one on the other side of the border.
    static void measure(Drawing& drawing)
    {
        if (drawing.shape.empty())
            return;
        const Plane& plane = *drawing.plane;
        std::vector<Pixel> inner;
        std::vector<Pixel> outer;
        for (const Pixel& pixel : drawing.shape) {
            for (const auto& [x, y] : {Pixel(-1, 0), Pixel(1, 0), Pixel(0, -1), Pixel(0, 1)}) {
                const Pixel beside(pixel.first + x, pixel.second + y);
                if (drawing.shape.count(beside) > 0)
                    continue;
                inner.push_back(pixel);
                outer.push_back(beside);
            }
        }
        for (int y = plane.begin.y; y < plane.end.y; ++y) {
            for (int x = plane.begin.x; x < plane.end.x; ++x) {
                const bool isIn = drawing.shape.count({x, y}) > 0;
                Wide least = Wide(1) << 100;
                for (const Pixel& other : isIn ? outer : inner) {
                    const Wide right = Wide(other.first - x) * plane.pitch.x;
                    const Wide up = Wide(other.second - y) * plane.pitch.y;
                    least = std::min(least, right * right + up * up);
                }
                drawing.distances[{x, y}] = isIn ? rootOf(least) : -rootOf(least);
            }
        }
    }
    /// Between pixels in steps of 1/256.
    [[nodiscard]] Wide distance(std::size_t number, Wide right, Wide up) const
    {
        const Drawing& drawing = m_drawings[number];
        const Wide x = floored(256 * right, drawing.plane->pitch.x);
        const Wide y = floored(256 * up, drawing.plane->pitch.y);
        const Pixel corner(int(floored(x, 256)), int(floored(y, 256)));
        Wide sum = 0;
        for (int across = 0; across < 2; ++across) {
            for (int along = 0; along < 2; ++along) {
                const auto found =
                    drawing.distances.find({corner.first + across, corner.second + along});
                if (found == drawing.distances.end())
                    return -m_reach;
                const Wide beyondX = x - 256 * Wide(corner.first);
                const Wide beyondY = y - 256 * Wide(corner.second);
                sum += found->second * (across == 1 ? beyondX : 256 - beyondX)
                    * (along == 1 ? beyondY : 256 - beyondY);
            }
        }
        return std::max(-m_reach, floored(sum, 65536));
    }
    [[nodiscard]] bool hides(const Sight& one, const Sight& other) const
    {
        if (distance(one.number, one.right, one.up) <= -m_reach)
            return false;
        const Wide cosine = m_sketch.meeting(other.number, one.number).cosine;
        const Wide height = one.side * one.height;
        const Wide atFoot = height - nearest(other.side * other.height * cosine, one30);
        return (height > 0 && atFoot < 0) || (height < 0 && atFoot > 0);
    }
    /// How far a place in one plane is from the line in which it meets another one.
    [[nodiscard]] Wide fromLine(std::size_t one, std::size_t other, Wide right, Wide up) const
    {
        const auto& meeting = m_sketch.meeting(one, other);
        return nearest(right * meeting.away[0] + up * meeting.away[1], one30) + meeting.offset;
    }
    [[nodiscard]] bool isDrawnBeside(std::size_t one, std::size_t other, int side) const
    {
        const glm::i64vec2& pitch = m_drawings[one].plane->pitch;
        return std::any_of(
            m_drawings[one].shape.begin(), m_drawings[one].shape.end(), [&](const Pixel& pixel) {
                return side * fromLine(one, other, pixel.first * pitch.x, pixel.second * pitch.y)
                    >= std::max(pitch.x, pitch.y);
            });
    }
    [[nodiscard]] bool beside(const Sight& one, const Sight& other) const
    {
        return m_beside[2 * (one.number * m_drawings.size() + other.number)
            + (other.side > 0 ? 1 : 0)];
    }
    [[nodiscard]] Wide turned(const Sight& one, const Sight& other) const
    {
        const auto& meeting = m_sketch.meeting(one.number, other.number);
        const Wide foot = other.side * fromLine(one.number, other.number, one.right, one.up);
        const Wide way = other.side * (rootOf(foot * foot + one.height * one.height) - foot);
        return distance(one.number, one.right + nearest(way * meeting.away[0], one30),
            one.up + nearest(way * meeting.away[1], one30));
    }
    bool addPair(const Sight& one, const Sight& other, Wide least, Wide& sum) const
    {
        const auto& meeting = m_sketch.meeting(one.number, other.number);
        const Wide cosine = one.side * other.side * Wide(meeting.cosine);
        Wide distances[2] = {
            distance(one.number, one.right, one.up), distance(other.number, other.right, other.up)};
        if (meeting.crosses) {
            if (!beside(one, other) || !beside(other, one))
                return false;
            distances[0] = turned(one, other);
            distances[1] = turned(other, one);
        } else if (cosine > 0) {
            return false;
        }
        if (distances[0] <= -m_reach || distances[1] <= -m_reach)
            return false;
        const Wide blend = floored(
            distances[0] * other.height + distances[1] * one.height, one.height + other.height);
        const Wide share = floored(one30 - cosine, Wide(1) << 23);
        const Wide square = floored(share * share, 256);
        const Wide facing = 1 + floored(15 * floored(square * square, 256), 256);
        sum += blend * std::max<Wide>(1, floored(256 * least, one.height))
            * std::max<Wide>(1, floored(256 * least, other.height)) * facing;
        return true;
    }

    std::span<const std::uint8_t> m_labels;
    glm::ivec3 m_size;
    std::uint8_t m_label;
    const core::PlaneSketch& m_sketch;
    std::vector<Drawing> m_drawings;
    std::vector<bool> m_beside; ///< of each pair, below and above the other plane
    Wide m_reach = 0;
};

} // namespace

std::vector<bool> voxelsBetweenPlanes(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const core::PlaneSketch& sketch)
{
    const Oracle oracle(labels, size, label, sketch);
    std::vector<bool> between;
    between.reserve(labels.size());
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                between.push_back(oracle.lies({x, y, z}));
        }
    }
    return between;
}

} // namespace reference
