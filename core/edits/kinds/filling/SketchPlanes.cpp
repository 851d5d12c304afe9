// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/SketchPlanes.h"

#include "core/base/words/Clause.h"
#include "core/edits/engine/SlicePlane.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace core {

namespace {

/// A plane in millimetres.
struct Placed {
    glm::dvec3 right{0.0};
    glm::dvec3 up{0.0};
    glm::dvec3 normal{0.0};
    double heightMm = 0.0; ///< of voxel (0, 0, 0)
    int along = 2;
    std::array<int, 2> across{0, 1};
};

std::int64_t whole(double value)
{
    return std::int64_t(std::floor(value + 0.5));
}

std::int64_t fixed(double value, int bits)
{
    return whole(std::ldexp(value, bits));
}

Placed placed(
    const glm::dvec3& direction, const glm::dvec3& placeLps, const VolumeGeometry& geometry)
{
    const glm::dmat3 steps(geometry.indexToWorld);
    Placed plane{.normal = direction};
    const auto across = [&](int axis) { return glm::dot(plane.normal, steps[axis]); };
    for (const int axis : {1, 0}) {
        if (std::abs(across(axis)) > std::abs(across(plane.along)))
            plane.along = axis;
    }
    if (across(plane.along) < 0.0)
        plane.normal = -plane.normal;
    plane.across = {plane.along == 0 ? 1 : 0, plane.along == 2 ? 1 : 2};
    const glm::dvec3 first = steps[plane.across[0]];
    plane.right = glm::normalize(first - glm::dot(first, plane.normal) * plane.normal);
    plane.up = glm::cross(plane.normal, plane.right);
    if (glm::dot(plane.up, steps[plane.across[1]]) < 0.0)
        plane.up = -plane.up;
    const SlicePlane slice = slicePlane(geometry, plane.normal, placeLps);
    plane.heightMm =
        glm::dot(plane.normal, geometry.originLps() - slice.middleLps) - slice.heightMm;
    return plane;
}

bool meetsVolume(const Placed& plane, const VolumeGeometry& geometry)
{
    double least = plane.heightMm;
    double greatest = plane.heightMm;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = glm::dot(plane.normal, glm::dvec3(geometry.indexToWorld[axis]))
            * (geometry.size[axis] - 1);
        (way < 0.0 ? least : greatest) += way;
    }
    const double half =
        glm::dot(plane.normal, glm::dvec3(geometry.indexToWorld[plane.along])) / 2.0;
    return least <= half && greatest >= -half;
}

/// The pixels around the polygon in which a plane cuts the volume with a voxel around it.
void setPixels(const Placed& plane, const glm::dmat3& inPlane, const glm::dvec2& pitchMm,
    const VolumeGeometry& geometry, PlaneSketch::Plane& to)
{
    glm::dvec2 least(1e9);
    glm::dvec2 greatest(-1e9);
    const auto take = [&](const glm::dvec3& voxel) {
        const glm::dvec2 pixel = glm::dvec2(inPlane * voxel) / pitchMm;
        least = glm::min(least, pixel);
        greatest = glm::max(greatest, pixel);
    };
    const auto heightAt = [&](const glm::dvec3& voxel) {
        return (inPlane * voxel).z + plane.heightMm;
    };
    for (int axis = 0; axis < 3; ++axis) { // its edges
        for (int side = 0; side < 4; ++side) {
            glm::dvec3 begin(-1.0);
            begin[(axis + 1) % 3] = side % 2 == 0 ? -1.0 : geometry.size[(axis + 1) % 3];
            begin[(axis + 2) % 3] = side / 2 == 0 ? -1.0 : geometry.size[(axis + 2) % 3];
            glm::dvec3 end = begin;
            end[axis] = geometry.size[axis];
            const double from = heightAt(begin);
            const double beyond = heightAt(end);
            if ((from <= 0.0) != (beyond <= 0.0))
                take(begin + (end - begin) * (from / (from - beyond)));
        }
    }
    to.begin = glm::ivec2(glm::floor(least)) - 1;
    to.end = glm::ivec2(glm::ceil(greatest)) + 2;
}

PlaneSketch::Plane inUnits(const Placed& plane, const VolumeGeometry& geometry, double perMm)
{
    constexpr int lengthBits = 14;
    constexpr int columnBits = 30;
    const glm::dmat3 steps(geometry.indexToWorld);
    const glm::dmat3 inPlane =
        glm::transpose(glm::dmat3(plane.right, plane.up, plane.normal)) * steps;
    PlaneSketch::Plane to;
    to.along = plane.along;
    to.origin = {0, 0, fixed(plane.heightMm * perMm, lengthBits)};
    for (int axis = 0; axis < 3; ++axis) {
        for (int part = 0; part < 3; ++part)
            to.perVoxel.at(std::size_t(axis)).at(std::size_t(part)) =
                fixed(inPlane[axis][part] * perMm, lengthBits);
    }
    const glm::dvec2 pitchMm(inPlane[plane.across[0]].x, std::abs(inPlane[plane.across[1]].y));
    to.pitch =
        glm::max(glm::i64vec2(1), glm::i64vec2(whole(pitchMm.x * perMm), whole(pitchMm.y * perMm)));
    const glm::dmat3 toIndex = glm::inverse(steps);
    const glm::dvec3 foot = toIndex * (-plane.heightMm * plane.normal);
    const glm::dvec3 perRight = toIndex * (plane.right * (double(to.pitch.x) / perMm));
    const glm::dvec3 perUp = toIndex * (plane.up * (double(to.pitch.y) / perMm));
    for (std::size_t each = 0; each < 2; ++each) {
        const int axis = plane.across.at(each);
        to.column.at(each) = fixed(foot[axis], columnBits);
        to.columnPerRight.at(each) = fixed(perRight[axis], columnBits);
        to.columnPerUp.at(each) = fixed(perUp[axis], columnBits);
    }
    setPixels(plane, inPlane, glm::dvec2(to.pitch) / perMm, geometry, to);
    return to;
}

/// Whether two planes take the same slice, or nearly so.
bool isSameSlice(const Placed& one, const Placed& other, const VolumeGeometry& geometry)
{
    constexpr double share = 0.25;
    const glm::dmat3 steps(geometry.indexToWorld);
    const double most = share * glm::dot(one.normal, steps[one.along]);
    double least = one.heightMm - other.heightMm;
    double greatest = least;
    for (int axis = 0; axis < 3; ++axis) {
        const double way =
            glm::dot(one.normal - other.normal, steps[axis]) * (geometry.size[axis] - 1);
        (way < 0.0 ? least : greatest) += way;
    }
    return one.along == other.along && least >= -most && greatest <= most;
}

PlaneSketch::Meeting meetingOf(const Placed& one, const Placed& other, double perMm)
{
    constexpr int bits = 30;
    constexpr double least = 1.0 / 16.0; // below, the line is so far away that turning is moving
    const double cosine = glm::dot(one.normal, other.normal);
    const double sine = glm::length(glm::cross(one.normal, other.normal));
    PlaneSketch::Meeting meeting{.cosine = fixed(cosine, bits), .crosses = sine >= least};
    if (meeting.crosses) {
        meeting.away = {fixed(glm::dot(other.normal, one.right) / sine, bits),
            fixed(glm::dot(other.normal, one.up) / sine, bits)};
        meeting.offset = whole((other.heightMm - one.heightMm * cosine) / sine * perMm);
    }
    return meeting;
}

Placed placed(const DrawnPlane& plane, const VolumeGeometry& geometry)
{
    return placed(glm::normalize(plane.normalLps), plane.placeLps, geometry);
}

} // namespace

Result<PlaneSketch> planeSketch(
    const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry, const QString& name)
{
    constexpr double shortest = 1e-3;
    const auto refused = [&](const Clause& reason) {
        return failure(ErrorCode::InvalidField, name + QStringLiteral(".planes"), reason);
    };
    if (planes.size() < 2 || planes.size() > PlaneSketch::mostPlanes)
        return refused(Clause::saying("needs 2 to %1 entries", PlaneSketch::mostPlanes));
    std::vector<Placed> all;
    for (const DrawnPlane& each : planes) {
        if (!(glm::length(each.normalLps) > shortest))
            return refused(Clause::saying("has a normal that is no direction"));
        const Placed plane = placed(each, geometry);
        if (!meetsVolume(plane, geometry))
            return refused(Clause::saying("has a plane outside the volume"));
        if (std::none_of(all.begin(), all.end(),
                [&](const Placed& other) { return isSameSlice(other, plane, geometry); }))
            all.push_back(plane);
    }
    double longestMm = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        longestMm += glm::length(glm::dvec3(geometry.indexToWorld[axis])) * geometry.size[axis];
    int exponent = 0;
    static_cast<void>(std::frexp(longestMm, &exponent));
    const double perMm = std::ldexp(1.0, PlaneSketch::unitBits - exponent);
    PlaneSketch sketch;
    for (const Placed& each : all) {
        sketch.planes.push_back(inUnits(each, geometry, perMm));
        for (const Placed& other : all)
            sketch.meetings.push_back(meetingOf(each, other, perMm));
    }
    return sketch;
}

std::vector<DrawnPlane> distinctPlanes(
    const std::vector<DrawnPlane>& planes, const VolumeGeometry& geometry)
{
    std::vector<DrawnPlane> distinct;
    for (const DrawnPlane& plane : planes) {
        const Placed its = placed(plane, geometry);
        if (meetsVolume(its, geometry)
            && std::none_of(distinct.begin(), distinct.end(), [&](const DrawnPlane& other) {
                   return isSameSlice(placed(other, geometry), its, geometry);
               }))
            distinct.push_back(plane);
    }
    return distinct;
}

} // namespace core
