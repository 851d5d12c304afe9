// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/ToolPlans.h"

#include "tests/reenactment/UserHand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace reenact {

namespace {

/// The organ's border where the mask misses it, as seen around a region: places on it and where it
/// looks.
struct BorderPatch {
    std::vector<glm::dvec3> places;
    glm::dvec3 middle{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0}; ///< outwards, in the mean
    double reach = 0.0; ///< of the farthest place from the middle, across the normal
};

template <class Visit> void forEachNear(const glm::ivec3& voxel, const Visit& visit)
{
    for (int side = 0; side < 6; ++side) {
        glm::ivec3 near = voxel;
        near[side / 2] += side % 2 == 0 ? 1 : -1;
        visit(near);
    }
}

BorderPatch patchOf(const UserEye& eye, const UserEye::Region& region)
{
    BorderPatch patch;
    glm::dvec3 sum(0.0);
    glm::dvec3 normals(0.0);
    for (const glm::ivec3& voxel : region.part.voxels) {
        // Of what is too much the organ's voxels beside it, of what is missing its own outer ones.
        bool isBeside = false;
        forEachNear(voxel, [&](const glm::ivec3& near) {
            if (!eye.organ().contains(near))
                return;
            const bool isOrgan = eye.organ().at(near) != 0;
            isBeside = isBeside || (region.isMissing ? !isOrgan : isOrgan);
        });
        if (!isBeside)
            continue;
        const glm::dvec3 place(voxel);
        const glm::dvec3 way = eye.outwards(place);
        patch.places.push_back(place - eye.offBorder(place) * way);
        sum += patch.places.back();
        normals += way;
    }
    if (patch.places.empty())
        return patch;
    const glm::dvec3 mean = sum / double(patch.places.size());
    patch.middle = *std::min_element(
        patch.places.begin(), patch.places.end(), [&](const auto& one, const auto& other) {
            return glm::distance(one, mean) < glm::distance(other, mean);
        });
    if (glm::length(normals) > 1e-6)
        patch.normal = glm::normalize(normals);
    for (const glm::dvec3& place : patch.places) {
        const glm::dvec3 off = place - patch.middle;
        patch.reach =
            std::max(patch.reach, glm::length(off - glm::dot(off, patch.normal) * patch.normal));
    }
    return patch;
}

/// Two unit vectors across a third; the first the way a patch is longest.
std::array<glm::dvec3, 2> acrossOf(const BorderPatch& patch)
{
    const glm::dvec3 slant = glm::abs(patch.normal);
    const glm::dvec3 axis = slant.x <= slant.y && slant.x <= slant.z ? glm::dvec3(1, 0, 0)
        : slant.y <= slant.z                                         ? glm::dvec3(0, 1, 0)
                                                                     : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, patch.normal));
    const glm::dvec3 v = glm::cross(patch.normal, u);
    double uu = 0.0;
    double uv = 0.0;
    double vv = 0.0;
    for (const glm::dvec3& place : patch.places) {
        const double along = glm::dot(place - patch.middle, u);
        const double beside = glm::dot(place - patch.middle, v);
        uu += along * along;
        uv += along * beside;
        vv += beside * beside;
    }
    const double turn = 0.5 * std::atan2(2.0 * uv, uu - vv);
    return {std::cos(turn) * u + std::sin(turn) * v, std::cos(turn) * v - std::sin(turn) * u};
}

/// All voxels of a box around a region.
template <class Visit>
void forEachAround(
    const UserEye& eye, const UserEye::Region& region, double margin, const Visit& visit)
{
    glm::ivec3 least = eye.seen().size;
    glm::ivec3 most(-1);
    for (const glm::ivec3& voxel : region.part.voxels) {
        least = glm::min(least, voxel);
        most = glm::max(most, voxel);
    }
    const int more = int(std::ceil(margin));
    least = glm::max(least - more, glm::ivec3(0));
    most = glm::min(most + more, eye.seen().size - 1);
    for (int z = least.z; z <= most.z; ++z) {
        for (int y = least.y; y <= most.y; ++y) {
            std::size_t at = eye.seen().offset({least.x, y, z});
            for (int x = least.x; x <= most.x; ++x)
                visit(glm::ivec3(x, y, z), at++);
        }
    }
}

} // namespace

ScrapePlan bestScrape(const UserEye& eye, const UserEye::Region& region)
{
    ScrapePlan best;
    if (region.isMissing)
        return best;
    const BorderPatch patch = patchOf(eye, region);
    if (patch.places.empty())
        return best;
    for (const double factor : {1.0, 1.3, 1.8, 2.5}) {
        const double radius = std::max(3.0, factor * patch.reach);
        // What a plane through each height would take off and spoil, in one go.
        constexpr int steps = 20;
        constexpr double step = 0.5;
        std::array<double, 2 * steps + 1> gains{};
        forEachAround(eye, region, radius, [&](const glm::ivec3& voxel, std::size_t at) {
            const int worth = eye.worth(at, false);
            if (worth == 0)
                return;
            const glm::dvec3 off = glm::dvec3(voxel) - patch.middle;
            const double height = glm::dot(off, patch.normal);
            if (glm::length(off - height * patch.normal) > radius)
                return;
            for (int i = -steps; i <= steps; ++i) {
                const double above = height - step * i;
                if (above > 2.0 * radius)
                    continue;
                // As a hand puts it, half a voxel and more above or below.
                for (const double aside : {-UserHand::jitterVoxels, 0.0, UserHand::jitterVoxels})
                    gains[std::size_t(i + steps)] += above > aside ? worth / 3.0 : 0.0;
            }
        });
        for (int i = -steps; i <= steps; ++i) {
            if (gains[std::size_t(i + steps)] <= best.gain + 0.5)
                continue;
            best = {.place = patch.middle + step * i * patch.normal,
                .normal = patch.normal,
                .radius = radius,
                .gain = int(gains[std::size_t(i + steps)])};
        }
    }
    return best;
}

DragPlan bestDrag(const UserEye& eye, const UserEye::Region& region)
{
    DragPlan best;
    const BorderPatch patch = patchOf(eye, region);
    if (patch.places.empty())
        return best;
    // From the seen surface to the organ's border, about along the normal.
    const double side = region.isMissing ? -1.0 : 1.0;
    glm::dvec3 sum(0.0);
    for (const glm::ivec3& voxel : region.part.voxels)
        sum += glm::dvec3(voxel);
    const glm::dvec3 mean = sum / double(region.part.voxels.size());
    for (const glm::dvec3& target :
        {patch.middle, mean - glm::dot(mean - patch.middle, patch.normal) * patch.normal}) {
        double thick = 0.0;
        while (thick < 60.0) {
            const glm::ivec3 voxel(glm::round(target + side * (thick + 0.75) * patch.normal));
            if (!eye.seen().contains(voxel) || (eye.seen().at(voxel) == 0) != region.isMissing)
                break;
            thick += 0.5;
        }
        if (thick < 1.0)
            continue;
        const glm::dvec3 from = target + side * thick * patch.normal;
        for (const double wide : {0.8, 1.1, 1.5, 2.0}) {
            const double radius = std::max({3.0, wide * patch.reach, 1.2 * thick});
            for (const double share : {0.8, 1.0, 1.2}) {
                const glm::dvec3 shift = share * (target - from);
                int gain = 0;
                forEachAround(
                    eye, region, 0.3 * radius, [&](const glm::ivec3& voxel, std::size_t at) {
                        const glm::dvec3 place(voxel);
                        glm::dvec3 origin = place;
                        for (int i = 0; i < 4; ++i) {
                            const glm::dvec3 off = origin - from;
                            const double near =
                                std::max(0.0, 1.0 - glm::dot(off, off) / (radius * radius));
                            origin = place - near * near * shift;
                        }
                        const glm::ivec3 was(glm::round(origin));
                        const bool isIn = eye.seen().contains(was) && eye.seen().at(was) != 0;
                        if (isIn != (eye.seen().values[at] != 0))
                            gain += eye.worth(at, isIn);
                    });
                if (gain > best.gain)
                    best = {.from = from, .to = from + shift, .radius = radius, .gain = gain};
            }
        }
    }
    return best;
}

namespace {

/// Where the organ's border runs on a plane, from a place on it to both sides, as far as the region
/// goes.
class BorderLine {
public:
    BorderLine(const UserEye& eye, const Field& offRegion, const glm::dvec3& normal)
        : m_eye(eye)
        , m_offRegion(offRegion)
        , m_normal(normal)
    {
    }

    [[nodiscard]] std::vector<glm::dvec3> from(const glm::dvec3& place) const
    {
        const auto begin = onBorder(place);
        if (!begin)
            return {};
        std::vector<glm::dvec3> back = walked(*begin, -1.0);
        std::reverse(back.begin(), back.end());
        back.push_back(*begin);
        const std::vector<glm::dvec3> on = walked(*begin, 1.0);
        back.insert(back.end(), on.begin(), on.end());
        return back;
    }

private:
    static constexpr double step = 1.0;
    static constexpr double besideRegion = 2.2; ///< voxels
    static constexpr int mostSteps = 160;

    [[nodiscard]] glm::dvec3 flat(const glm::dvec3& way) const
    {
        return way - glm::dot(way, m_normal) * m_normal;
    }
    [[nodiscard]] std::optional<glm::dvec3> onBorder(glm::dvec3 place) const
    {
        for (int i = 0; i < 6; ++i) {
            const glm::dvec3 way = flat(m_eye.outwards(place));
            const double length = glm::length(way);
            if (length < 0.2)
                return std::nullopt;
            place -= m_eye.offBorder(place) / length * (way / length);
        }
        if (std::abs(m_eye.offBorder(place)) > 1.0)
            return std::nullopt;
        return place;
    }
    [[nodiscard]] std::vector<glm::dvec3> walked(glm::dvec3 place, double side) const
    {
        std::vector<glm::dvec3> line;
        glm::dvec3 last(0.0);
        for (int i = 0; i < mostSteps; ++i) {
            const glm::dvec3 along = glm::cross(m_normal, flat(m_eye.outwards(place)));
            const double length = glm::length(along);
            if (length < 0.2)
                break;
            glm::dvec3 way = side / length * along;
            if (last != glm::dvec3(0.0))
                way = glm::normalize(0.5 * way + 0.5 * last);
            const auto next = onBorder(place + step * way);
            if (!next || glm::distance(*next, place) < 0.2)
                break;
            last = glm::normalize(*next - place);
            place = *next;
            line.push_back(place);
            if (sampled(m_offRegion, place) > besideRegion)
                break;
        }
        return line;
    }

    const UserEye& m_eye;
    const Field& m_offRegion;
    glm::dvec3 m_normal;
};

/// Every so many voxels, and the ends.
std::vector<glm::dvec3> thinned(const std::vector<glm::dvec3>& line, std::size_t stride)
{
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < line.size(); i += stride)
        points.push_back(line[i]);
    if (!line.empty() && points.back() != line.back())
        points.push_back(line.back());
    return points;
}

} // namespace

namespace {

double extentOf(const std::vector<glm::dvec3>& places)
{
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& place : places)
        sum += place;
    const glm::dvec3 mean = sum / double(places.size());
    double extent = 0.0;
    for (const glm::dvec3& place : places)
        extent = std::max(extent, glm::distance(place, mean));
    return extent;
}

/// A way for a brush of some radius over places: one after the other the farthest that is not
/// painted yet, then in an order for a pen.
std::vector<glm::dvec3> covered(const std::vector<glm::dvec3>& places, double radius)
{
    constexpr std::size_t mostDabs = 80;
    std::vector<glm::dvec3> dabs;
    std::vector<double> off(places.size(), 1e9);
    std::size_t next = 0;
    while (dabs.size() < mostDabs) {
        dabs.push_back(places[next]);
        for (std::size_t i = 0; i < places.size(); ++i)
            off[i] = std::min(off[i], glm::distance(places[i], dabs.back()));
        next = std::size_t(std::max_element(off.begin(), off.end()) - off.begin());
        if (off[next] < 0.85 * radius)
            break;
    }
    std::vector<glm::dvec3> way{dabs.front()};
    dabs.erase(dabs.begin());
    while (!dabs.empty()) {
        const auto nearest =
            std::min_element(dabs.begin(), dabs.end(), [&](const auto& one, const auto& other) {
                return glm::distance(one, way.back()) < glm::distance(other, way.back());
            });
        way.push_back(*nearest);
        dabs.erase(nearest);
    }
    return way;
}

} // namespace

SweepPlan sweepOver(const UserEye& eye, const UserEye::Region& region,
    const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry, double most,
    double leastRadius)
{
    SweepPlan plan;
    Mask wrongNear{eye.seen().size, std::vector<std::uint8_t>(eye.seen().values.size(), 0)};
    const glm::dvec3 middle(region.part.deepest);
    forEachAround(eye, region, most, [&](const glm::ivec3& voxel, std::size_t at) {
        if (eye.seen().values[at] == eye.organ().values[at]
            || glm::distance(glm::dvec3(voxel), middle) > most)
            return;
        wrongNear.values[at] = 1;
        ++plan.wrong;
        if (std::abs(eye.offBorder(glm::dvec3(voxel))) > 1.0)
            ++plan.deep;
    });
    std::vector<glm::dvec3> wrong;
    for (const core::VertexId id : mesh.vertexIds()) {
        const glm::dvec3 place = geometry.toIndex(mesh.position(id));
        if (std::abs(eye.offBorder(place)) < 0.5 || glm::distance(place, middle) > most)
            continue;
        const glm::ivec3 voxel(glm::round(place));
        bool isNear = false;
        for (int side = 0; side < 27; ++side) {
            const glm::ivec3 near =
                voxel + glm::ivec3(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
            isNear = isNear || (wrongNear.contains(near) && wrongNear.at(near) != 0);
        }
        if (isNear)
            wrong.push_back(place);
    }
    if (wrong.size() < 6)
        return {};
    plan.radius = std::max(leastRadius, std::min(6.0, 0.35 * extentOf(wrong)));
    plan.points = covered(wrong, plan.radius);
    return plan;
}

TemplatePlan templateFor(const UserEye& eye, const UserEye::Region& region,
    const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry)
{
    TemplatePlan plan;
    const BorderPatch patch = patchOf(eye, region);
    if (patch.places.size() < 12)
        return plan;
    Mask taken{eye.seen().size, std::vector<std::uint8_t>(eye.seen().values.size(), 0)};
    for (const glm::ivec3& voxel : region.part.voxels)
        taken.at(voxel) = 1;
    const Field offRegion = distanceTo(taken);
    std::vector<glm::dvec3> wrong;
    for (const core::VertexId id : mesh.vertexIds()) {
        const glm::dvec3 place = geometry.toIndex(mesh.position(id));
        if (sampled(offRegion, place) < 1.8 && std::abs(eye.offBorder(place)) > 0.7)
            wrong.push_back(place);
    }
    if (wrong.size() < 6)
        return plan;
    plan.paintRadius = std::clamp(0.35 * extentOf(wrong), 2.0, 7.0);
    plan.paint = covered(wrong, plan.paintRadius);
    const auto [along, beside] = acrossOf(patch);
    constexpr int planes = 3;
    for (int i = 0; i < planes; ++i) {
        const double turn = std::numbers::pi * i / planes;
        const glm::dvec3 normal = std::cos(turn) * beside + std::sin(turn) * along;
        const std::vector<glm::dvec3> line = BorderLine(eye, offRegion, normal).from(patch.middle);
        const std::vector<glm::dvec3> points = thinned(line, 4);
        if (points.size() >= 3)
            plan.contours.push_back({.points = points, .normal = normal});
    }
    if (plan.contours.size() >= 2)
        plan.gain = int(0.8 * double(region.part.voxels.size()));
    return plan;
}

} // namespace reenact
