// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/planes/BetweenPlanes.h"

#include "core/base/FixedPoint.h"
#include "core/base/ParallelFor.h"
#include "core/morphology/StageCounter.h"
#include "core/morphology/planes/SketchedShape.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace core {

namespace {

using fixedPoint::floorDivide;
using fixedPoint::round14;
using fixedPoint::round30;
using Plane = PlaneSketch::Plane;
using Meeting = PlaneSketch::Meeting;

/// The least and the greatest distance of a shape from the line in which its plane meets another
/// one, in the direction of Meeting::away.
struct Extent {
    std::int64_t least = 0;
    std::int64_t greatest = 0;
};

std::int64_t fromLine(const Meeting& meeting, std::int64_t right, std::int64_t up)
{
    return round30(right * meeting.away[0] + up * meeting.away[1]) + meeting.offset;
}

/// All that was drawn, and how its planes lie to each other.
class Shapes {
public:
    Shapes(std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label,
        const PlaneSketch& sketch, const Progress& progress)
        : m_sketch(sketch)
        , m_shapes(sketch.planes.size())
        , m_extents(sketch.meetings.size())
    {
        parallelFor(int(m_shapes.size()), [&](int number) {
            const auto at = std::size_t(number);
            if (!progress.cancelled())
                m_shapes[at] = sketchedShape(sketch, at, labels, size, label);
        });
        for (std::size_t one = 0; one < m_shapes.size(); ++one) {
            if (m_shapes[one].rows.empty())
                continue;
            constexpr std::int64_t leastPixels = 8;
            const glm::i64vec2& pitch = sketch.planes[one].pitch;
            m_reach =
                std::max({m_reach, m_shapes[one].extent, leastPixels * std::max(pitch.x, pitch.y)});
            m_drawn.push_back(one);
            for (std::size_t other = 0; other < m_shapes.size(); ++other)
                m_extents[one * m_shapes.size() + other] = extentOf(one, other);
        }
    }

    [[nodiscard]] const std::vector<std::size_t>& drawn() const { return m_drawn; }
    [[nodiscard]] std::int64_t reach() const { return m_reach; }
    [[nodiscard]] const SketchedShape& shape(std::size_t plane) const { return m_shapes[plane]; }
    [[nodiscard]] const Plane& plane(std::size_t plane) const { return m_sketch.planes[plane]; }
    [[nodiscard]] const Meeting& meeting(std::size_t one, std::size_t other) const
    {
        return m_sketch.meeting(one, other);
    }
    [[nodiscard]] const Extent& extent(std::size_t one, std::size_t other) const
    {
        return m_extents[one * m_shapes.size() + other];
    }
    /// Whether something was drawn on a plane on that side of another one that it meets.
    /// @param side 1 or -1
    [[nodiscard]] bool isDrawnBeside(std::size_t one, std::size_t other, int side) const
    {
        const glm::i64vec2& pitch = plane(one).pitch;
        const std::int64_t least = std::max(pitch.x, pitch.y);
        const Extent& its = extent(one, other);
        return side > 0 ? its.greatest >= least : its.least <= -least;
    }
    /// Limited to what counts.
    [[nodiscard]] std::int64_t distanceAt(
        std::size_t plane, std::int64_t right, std::int64_t up) const
    {
        return std::max(-m_reach, m_shapes[plane].at(m_sketch.planes[plane], right, up, -m_reach));
    }

private:
    [[nodiscard]] Extent extentOf(std::size_t one, std::size_t other) const
    {
        Extent extent;
        const Meeting& meeting = m_sketch.meeting(one, other);
        bool isFirst = true;
        for (const SketchedShape::Row& row : m_shapes[one].rows) {
            for (const int x : {row.first, row.last}) {
                const glm::i64vec2 place = glm::i64vec2(x, row.y) * plane(one).pitch;
                const std::int64_t distance = fromLine(meeting, place.x, place.y);
                extent.least = isFirst ? distance : std::min(extent.least, distance);
                extent.greatest = isFirst ? distance : std::max(extent.greatest, distance);
                isFirst = false;
            }
        }
        return extent;
    }

    const PlaneSketch& m_sketch;
    std::vector<SketchedShape> m_shapes;
    std::vector<Extent> m_extents; ///< as the sketch's meetings
    std::vector<std::size_t> m_drawn;
    std::int64_t m_reach = 0;
};

/// A plane as a voxel sees it.
struct Seen {
    std::size_t at = 0; ///< its place among those that were drawn on
    std::size_t plane = 0;
    std::int64_t right = 0; ///< of the foot
    std::int64_t up = 0;
    std::int64_t height = 0; ///< without its sign, at least 1
    int side = 1;
    std::int64_t distance = 0; ///< at the foot
    std::int64_t nearness = 0; ///< n
};

/// Decides about voxels, one after the other.
class Between {
public:
    explicit Between(const Shapes& shapes)
        : m_shapes(shapes)
    {
        for (std::size_t at = 0; at < shapes.drawn().size(); ++at)
            m_order.push_back({.at = at, .plane = shapes.drawn()[at]});
    }

    /// @param places coordinates relative to the planes that were drawn on, in their order
    [[nodiscard]] bool receives(const std::vector<PlaneSketch::Fixed3>& places)
    {
        if (isDrawn(places))
            return false;
        look();
        std::int64_t sum = 0;
        bool isEnclosed = false;
        for (std::size_t one = 0; one < m_seen.size(); ++one) {
            for (std::size_t other = one + 1; other < m_seen.size(); ++other)
                isEnclosed = addPair(m_seen[one], m_seen[other], sum) || isEnclosed;
        }
        return isEnclosed && sum >= 0;
    }

private:
    /// Also finds the heights. They keep their order from voxel to voxel, so that little is left to
    /// be sorted.
    [[nodiscard]] bool isDrawn(const std::vector<PlaneSketch::Fixed3>& places)
    {
        for (Seen& each : m_order) {
            const PlaneSketch::Fixed3& place = places[each.at];
            each.right = round14(place[0]);
            each.up = round14(place[1]);
            each.height = std::max<std::int64_t>(1, std::abs(round14(place[2])));
            each.side = place[2] < 0 ? -1 : 1;
            if (isOn(m_shapes.plane(each.plane), place[2]) && isNear(distanceAtFoot(each)))
                return true;
        }
        return false;
    }
    [[nodiscard]] std::int64_t distanceAtFoot(const Seen& seen) const
    {
        return m_shapes.distanceAt(seen.plane, seen.right, seen.up);
    }
    [[nodiscard]] bool isNear(std::int64_t distance) const { return distance > -m_shapes.reach(); }
    void look()
    {
        constexpr std::int64_t whole = 256;
        for (std::size_t at = 1; at < m_order.size(); ++at) {
            for (std::size_t to = at; to > 0 && isBefore(m_order[to], m_order[to - 1]); --to)
                std::swap(m_order[to], m_order[to - 1]);
        }
        m_seen.clear();
        for (Seen& each : m_order) {
            if (isHidden(each))
                continue;
            each.distance = distanceAtFoot(each);
            const std::int64_t least = m_seen.empty() ? each.height : m_seen.front().height;
            each.nearness = std::max<std::int64_t>(1, whole * least / each.height);
            m_seen.push_back(each);
        }
    }
    static bool isBefore(const Seen& one, const Seen& other)
    {
        return one.height != other.height ? one.height < other.height : one.at < other.at;
    }
    /// Whether one that is nearer lies between the voxel and its foot.
    [[nodiscard]] bool isHidden(const Seen& seen) const
    {
        return std::any_of(m_seen.begin(), m_seen.end(), [&](const Seen& other) {
            if (!isNear(other.distance))
                return false;
            const std::int64_t cosine = m_shapes.meeting(seen.plane, other.plane).cosine;
            const std::int64_t atFoot =
                other.side * other.height - round30(seen.side * seen.height * cosine);
            return other.side > 0 ? atFoot < 0 : atFoot > 0;
        });
    }
    /// Returns whether the two enclose the voxel.
    bool addPair(const Seen& one, const Seen& other, std::int64_t& sum) const
    {
        const Meeting& meeting = m_shapes.meeting(one.plane, other.plane);
        const std::int64_t cosine = one.side * other.side * meeting.cosine;
        std::int64_t distance = one.distance;
        std::int64_t others = other.distance;
        if (meeting.crosses) {
            if (!m_shapes.isDrawnBeside(one.plane, other.plane, other.side)
                || !m_shapes.isDrawnBeside(other.plane, one.plane, one.side))
                return false;
            distance = turned(one, other);
            others = turned(other, one);
        } else if (cosine > 0) {
            return false;
        }
        if (!isNear(distance) || !isNear(others))
            return false;
        const std::int64_t blend =
            floorDivide(distance * other.height + others * one.height, one.height + other.height);
        sum += blend * one.nearness * other.nearness * facing(cosine);
        return true;
    }
    /// The distance on the one plane, where the voxel comes to if it is turned about the line in
    /// which the two meet.
    [[nodiscard]] std::int64_t turned(const Seen& one, const Seen& other) const
    {
        const Meeting& meeting = m_shapes.meeting(one.plane, other.plane);
        const std::int64_t foot = other.side * fromLine(meeting, one.right, one.up);
        const std::int64_t radius =
            fixedPoint::squareRoot(foot * foot + one.height * one.height);
        const std::int64_t way = other.side * (radius - foot);
        return m_shapes.distanceAt(one.plane, one.right + round30(way * meeting.away[0]),
            one.up + round30(way * meeting.away[1]));
    }
    /// How much a pair counts by how its planes lie to each other.
    static std::int64_t facing(std::int64_t cosine)
    {
        const std::int64_t share = ((std::int64_t(1) << 30) - cosine) >> 23; // 0 … 256
        const std::int64_t squared = share * share >> 8;
        return 1 + (15 * (squared * squared >> 8) >> 8);
    }

    const Shapes& m_shapes;
    std::vector<Seen> m_order; ///< all planes, nearest first
    std::vector<Seen> m_seen; ///< those that are not hidden, nearest first
};

/// The box in which pairs of planes may give voxels. It only says where to look, with a margin for
/// the rounding of its doubles; what a voxel receives follows from integers alone.
class LookedAt {
public:
    LookedAt(const Shapes& shapes, const glm::ivec3& size)
        : m_shapes(shapes)
        , m_size(size)
    {
        for (const std::size_t one : shapes.drawn()) {
            for (const std::size_t other : shapes.drawn()) {
                if (one != other)
                    take(one, other);
            }
        }
    }
    [[nodiscard]] glm::ivec3 begin() const
    {
        return glm::ivec3(
            glm::clamp(glm::floor(m_least) - 1.0, glm::dvec3(0.0), glm::dvec3(m_size)));
    }
    [[nodiscard]] glm::ivec3 end() const
    {
        return glm::ivec3(
            glm::clamp(glm::ceil(m_greatest) + 2.0, glm::dvec3(0.0), glm::dvec3(m_size)));
    }

private:
    /// Coordinates of a plane in units, and index coordinates.
    struct Places {
        glm::dmat3 perVoxel{0.0};
        glm::dvec3 origin{0.0};
    };
    static Places placesOf(const Plane& plane)
    {
        constexpr double perUnit = 16384.0;
        Places places;
        for (int part = 0; part < 3; ++part) {
            places.origin[part] = double(plane.origin.at(std::size_t(part))) / perUnit;
            for (int axis = 0; axis < 3; ++axis)
                places.perVoxel[axis][part] =
                    double(plane.perVoxel.at(std::size_t(axis)).at(std::size_t(part))) / perUnit;
        }
        return places;
    }
    void add(const glm::dvec3& index)
    {
        m_least = glm::min(m_least, index);
        m_greatest = glm::max(m_greatest, index);
    }
    /// @param visit called with the corners of each row, a pixel beyond what was drawn
    template <class Visit> void atCorners(std::size_t plane, const Visit& visit) const
    {
        const glm::dvec2 pitch(m_shapes.plane(plane).pitch);
        for (const SketchedShape::Row& row : m_shapes.shape(plane).rows) {
            for (const int x : {row.first - 1, row.last + 1}) {
                visit(glm::dvec3(x * pitch.x, (row.y - 1) * pitch.y, 0.0));
                visit(glm::dvec3(x * pitch.x, (row.y + 1) * pitch.y, 0.0));
            }
        }
    }
    void take(std::size_t one, std::size_t other)
    {
        const Meeting& meeting = m_shapes.meeting(one, other);
        const Places places = placesOf(m_shapes.plane(one));
        const glm::dmat3 toIndex = glm::inverse(places.perVoxel);
        if (!meeting.crosses) {
            const Places others = placesOf(m_shapes.plane(other));
            const double slope = (others.perVoxel * toIndex[2]).z; // close to 1 or -1
            atCorners(one, [&](const glm::dvec3& corner) {
                const glm::dvec3 index = toIndex * (corner - places.origin);
                const double height = (others.origin + others.perVoxel * index).z;
                constexpr double tilted = 1.01;
                add(index);
                add(index - toIndex[2] * (height / slope * tilted));
            });
            return;
        }
        for (const int side : {1, -1}) {
            for (const int others : {1, -1}) {
                if (m_shapes.isDrawnBeside(one, other, others)
                    && m_shapes.isDrawnBeside(other, one, side))
                    takeWedge(meeting, places.origin, toIndex, side, others,
                        [&](const auto& visit) { atCorners(one, visit); });
            }
        }
    }
    /// A place at r from the line moves by r·((cos - 1)·away + sin·up) when it is turned by an
    /// angle from 0 to that between the planes.
    template <class Corners>
    void takeWedge(const Meeting& meeting, const glm::dvec3& origin, const glm::dmat3& toIndex,
        int side, int others, const Corners& atEach)
    {
        constexpr double one30 = 1073741824.0;
        const glm::dvec2 along(double(meeting.away[0]) / one30, double(meeting.away[1]) / one30);
        const glm::dvec3 away = toIndex * glm::dvec3(double(others) * along, 0.0);
        const glm::dvec3 up = toIndex * glm::dvec3(0.0, 0.0, double(side));
        const double cosine = -double(side * others) * double(meeting.cosine) / one30;
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        glm::dvec3 most = glm::max(glm::dvec3(0.0), (cosine - 1.0) * away + sine * up);
        glm::dvec3 least = glm::min(glm::dvec3(0.0), (cosine - 1.0) * away + sine * up);
        for (int axis = 0; axis < 3; ++axis) {
            // Where the way turns round in between.
            const double slope = sine * -away[axis] + cosine * up[axis];
            const double round = std::hypot(away[axis], up[axis]);
            if (up[axis] > 0.0 && slope < 0.0)
                most[axis] = round - away[axis];
            if (up[axis] < 0.0 && slope > 0.0)
                least[axis] = -round - away[axis];
        }
        atEach([&](const glm::dvec3& corner) {
            const double radius = std::max(0.0,
                double(others) * (glm::dot(along, glm::dvec2(corner)) + double(meeting.offset)));
            const glm::dvec3 index = toIndex * (corner - origin);
            add(index + radius * most);
            add(index + radius * least);
        });
    }

    const Shapes& m_shapes;
    glm::ivec3 m_size;
    glm::dvec3 m_least{1e9};
    glm::dvec3 m_greatest{-1e9};
};

std::vector<PlaneSketch::Fixed3> placesAt(const Shapes& shapes, const glm::ivec3& voxel)
{
    std::vector<PlaneSketch::Fixed3> places;
    for (const std::size_t plane : shapes.drawn())
        places.push_back(placeOf(shapes.plane(plane), voxel));
    return places;
}

VoxelRuns givenIn(const Shapes& shapes, std::span<const std::uint8_t> labels,
    const glm::ivec3& size, int slice, const LookedAt& box)
{
    VoxelRuns runs;
    Between between(shapes);
    const std::size_t planes = shapes.drawn().size();
    std::vector<PlaneSketch::Fixed3> steps;
    for (const std::size_t plane : shapes.drawn())
        steps.push_back(shapes.plane(plane).perVoxel.front());
    for (int y = box.begin().y; y < box.end().y; ++y) {
        glm::ivec3 voxel(box.begin().x, y, slice);
        std::vector<PlaneSketch::Fixed3> places = placesAt(shapes, voxel);
        const std::size_t row =
            (std::size_t(slice) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
        for (; voxel.x < box.end().x; ++voxel.x) {
            const std::size_t at = row + std::size_t(voxel.x);
            if (labels[at] == 0 && between.receives(places))
                runs.append(at, 1);
            for (std::size_t each = 0; each < planes; ++each) {
                for (std::size_t part = 0; part < 3; ++part)
                    places[each][part] += steps[each][part];
            }
        }
    }
    return runs;
}

/// What the distances of all planes take, and what one of them takes while they are made.
double bytesFor(const PlaneSketch& sketch)
{
    constexpr double kept = 4.0;
    constexpr double meanwhile = 24.0;
    double pixels = 0.0;
    double most = 0.0;
    for (const Plane& each : sketch.planes) {
        const glm::dvec2 size(each.end - each.begin);
        pixels += size.x * size.y;
        most = std::max(most, size.x * size.y);
    }
    return kept * pixels + meanwhile * most;
}

} // namespace

Result<VoxelRuns> voxelsBetweenPlanes(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const PlaneSketch& sketch, const Progress& progress)
{
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    if (const Result<void> enough =
            checkBytes(bytesFor(sketch), Clause::saying("what lies between the drawn planes"));
        !enough)
        return tl::unexpected(enough.error());
    const Shapes shapes(labels, size, label, sketch, progress);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    if (shapes.drawn().size() < 2)
        return VoxelRuns();
    const LookedAt box(shapes, size);
    const int slices = box.end().z - box.begin().z;
    if (slices <= 0)
        return VoxelRuns();
    std::vector<VoxelRuns> given{std::size_t(slices)};
    const FilterStage stage{progress};
    StageCounter counter(stage, slices);
    parallelFor(slices, [&](int number) {
        if (counter.cancelled())
            return;
        given[std::size_t(number)] = givenIn(shapes, labels, size, box.begin().z + number, box);
        counter.stepDone();
    });
    if (counter.cancelled())
        return failure(ErrorCode::Cancelled);
    VoxelRuns runs;
    for (const VoxelRuns& each : given)
        runs.append(each);
    return runs;
}

std::vector<bool> drawnAsWhole(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const PlaneSketch& sketch)
{
    constexpr std::int64_t sharedPerOwn = 4;
    std::vector<std::uint8_t> whole(sketch.planes.size(), 0); // a byte each, for several threads
    parallelFor(int(whole.size()), [&](int number) {
        const auto at = std::size_t(number);
        const SketchedShape shape = sketchedShape(sketch, at, labels, size, label);
        whole[at] = !shape.rows.empty() && sharedPerOwn * shape.ownPixels >= shape.sharedPixels;
    });
    return {whole.begin(), whole.end()};
}

} // namespace core
