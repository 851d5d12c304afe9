// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/StrokeSpace.h"
#include "core/edits/kinds/parts/BrushPath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core {

namespace {

/// Errors: InvalidField below @p name where a shape lacks a direction that it needs.
Result<void> checkDirections(const BrushPath& path, const QString& name)
{
    if (path.shape == BrushPath::Shape::Ball)
        return {};
    const auto wrong = [&name](const char* field, const Clause& why) {
        return failure(ErrorCode::InvalidField, name + QLatin1String(field), why);
    };
    const Clause none = Clause::saying("is no direction");
    const bool square = isSquare(path.shape);
    if (!path.normalLps)
        return wrong(".normalLps",
            square ? Clause::saying("missing: a square or cube needs the direction of a side")
                   : Clause::saying("missing: a disc needs the direction across its plane"));
    if (!(glm::length(*path.normalLps) > 1e-3))
        return wrong(".normalLps", none);
    if (!square)
        return {};
    if (!path.sideLps)
        return wrong(".sideLps",
            Clause::saying("missing: a square or cube needs the direction of another side"));
    if (!(glm::length(*path.sideLps) > 1e-3))
        return wrong(".sideLps", none);
    const glm::dvec3 across =
        glm::cross(glm::normalize(*path.normalLps), glm::normalize(*path.sideLps));
    if (!(glm::length(across) > 1e-3))
        return wrong(".sideLps", Clause::saying("runs along normalLps"));
    return {};
}

/// How far from its middle a brush reaches.
double reachMm(const BrushPath& path)
{
    return (isSquare(path.shape) ? std::sqrt(3.0) : 1.0) * path.radiusMm;
}

/// No capsule is longer: short enough that 14 bits resolve it, long enough that there are few.
std::int32_t longestCapsule(const BrushPath& path, const VolumeGeometry& geometry)
{
    return std::max(mm16(path.radiusMm), mm16(8.0 * finestSpacing(geometry)));
}

Capsule capsuleBetween(const glm::dvec3& from, const glm::dvec3& to)
{
    Capsule capsule;
    capsule.from = glm::ivec3(mm16(from.x), mm16(from.y), mm16(from.z));
    const double length = glm::length(to - from);
    if (length == 0.0)
        return capsule;
    const glm::dvec3 direction = (to - from) / length * 16384.0;
    capsule.direction = glm::ivec3(int(std::llround(direction.x)), int(std::llround(direction.y)),
        int(std::llround(direction.z)));
    capsule.length = mm16(length);
    return capsule;
}

} // namespace

Result<CapsuleFrame> capsuleFrame(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name)
{
    if (path.pointsLps.empty())
        return failure(ErrorCode::InvalidField, name + QStringLiteral(".pointsLps"),
            Clause::saying("needs at least one entry"));
    if (!(path.radiusMm >= 0.01 && path.radiusMm <= 200.0))
        return failure(ErrorCode::InvalidField, name + QStringLiteral(".radiusMm"),
            Clause::saying("%1 is outside 0.01 … 200", path.radiusMm));
    if (const Result<void> pressed = checkPressures(path.pressures, path.pointsLps.size(), name);
        !pressed)
        return tl::unexpected(pressed.error());
    if (const Result<void> directed = checkDirections(path, name); !directed)
        return tl::unexpected(directed.error());
    const StrokeSpace space = strokeSpace(path, geometry);
    CapsuleFrame frame;
    frame.origin = toFixed30(space.turned(geometry.originLps()));
    const glm::dmat3 perVoxel = space.toStroke * glm::dmat3(geometry.indexToWorld);
    frame.perI = toFixed30(perVoxel[0]);
    frame.perJ = toFixed30(perVoxel[1]);
    frame.perK = toFixed30(perVoxel[2]);
    frame.isFlat = isFlat(path.shape);
    frame.isSquare = isSquare(path.shape);
    frame.halfThickness = mm16(space.halfThicknessMm);
    frame.radius = mm16(path.radiusMm);
    frame.rampHalfWidth = std::max(mm16(finestSpacing(geometry) / 2.0), 1);
    frame.reach = frame.radius + frame.rampHalfWidth + longestCapsule(path, geometry) + 16;
    while (frame.reach >> frame.shift >= 1 << 14)
        ++frame.shift;
    return frame;
}

std::vector<Capsule> capsules(const BrushPath& path, const VolumeGeometry& geometry,
    const glm::dvec3* from, const std::vector<glm::dvec3>& points, const PartPressures& pressures)
{
    const StrokeSpace space = strokeSpace(path, geometry);
    const double longestMm = longestCapsule(path, geometry) / 65536.0;
    const double nearMm = space.volumeRadiusMm + reachMm(path) + longestMm;
    const auto turned = [&](const glm::dvec3& point) {
        const glm::dvec3 at = space.turned(point);
        return isFlat(path.shape) ? glm::dvec3(at.x, at.y, 0.0) : at;
    };
    const std::int32_t whole = mm16(path.radiusMm);
    const double mostMm = 0.25 * finestSpacing(geometry); // from one radius to the next
    constexpr double mostShare = 0.125; // of the tolerance, likewise
    double before = pressures.before;
    std::vector<Capsule> made;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 end = turned(points[i]);
        const glm::dvec3 start = from ? turned(*from) : end;
        glm::dvec3 along = end - start;
        const double pressure = i < pressures.atPoints.size() ? pressures.atPoints[i] : 1.0;
        // Where the pen rests, what it covered before is covered.
        double pressedFrom = along == glm::dvec3(0.0) ? pressure : before;
        double pressedTo = pressure;
        const double change = std::abs(pressedTo - pressedFrom);
        double changeMm = pressures.ofTolerance ? 0.0 : change * path.radiusMm;
        glm::dvec3 begin = start;
        // The larger end holds all the smaller ones where the radius changes by more than the way.
        if (changeMm > 0.0 && changeMm >= glm::length(along)) {
            begin = pressedTo > pressedFrom ? end : start;
            pressedFrom = pressedTo = std::max(pressedFrom, pressedTo);
            along = glm::dvec3(0.0);
            changeMm = 0.0;
        }
        const auto pieces =
            std::max<std::int64_t>({1, std::int64_t(std::ceil(glm::length(along) / longestMm)),
                std::int64_t(std::ceil(changeMm / mostMm)),
                pressures.ofTolerance ? std::int64_t(std::ceil(change / mostShare)) : 1});
        const auto [first, last] = piecesNear(begin, along, pieces, nearMm);
        for (std::int64_t piece = first; piece < last; ++piece) {
            Capsule capsule = capsuleBetween(begin + along * (double(piece) / double(pieces)),
                begin + along * (double(piece + 1) / double(pieces)));
            const double share =
                pressedFrom + (pressedTo - pressedFrom) * ((double(piece) + 0.5) / double(pieces));
            if (pressures.ofTolerance)
                capsule.strength = std::clamp(int(std::lround(share * 255.0)), 0, 255);
            else
                capsule.less = std::clamp(whole - mm16(path.radiusMm * share), 0, whole);
            made.push_back(capsule);
        }
        from = &points[i];
        before = pressure;
    }
    return made;
}

std::vector<Capsule> capsules(
    const BrushPath& path, const VolumeGeometry& geometry, bool ofTolerance)
{
    std::vector<Capsule> made;
    auto lift = path.lifts.begin();
    for (std::size_t first = 0; first < path.pointsLps.size();) {
        while (lift != path.lifts.end() && *lift <= std::int64_t(first))
            ++lift;
        const std::size_t last = lift == path.lifts.end()
            ? path.pointsLps.size()
            : std::min(std::size_t(*lift), path.pointsLps.size());
        PartPressures pressures{.ofTolerance = ofTolerance};
        // A path of which that was not checked may have fewer.
        for (std::size_t i = first; path.pressures && i < last && i < path.pressures->size(); ++i)
            pressures.atPoints.push_back((*path.pressures)[i]);
        const std::vector<Capsule> part = capsules(path, geometry, nullptr,
            {path.pointsLps.begin() + std::ptrdiff_t(first),
                path.pointsLps.begin() + std::ptrdiff_t(last)},
            pressures);
        made.insert(made.end(), part.begin(), part.end());
        first = last;
    }
    return made;
}

} // namespace core
