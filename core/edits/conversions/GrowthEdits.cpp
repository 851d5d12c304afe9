// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowGuard.h"
#include "core/edits/kinds/growth/GrowLimits.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/growth/ToleranceEdits.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace core {

namespace {

/// Whether a plane holds segments, all of them locked.
bool nothingMayChange(const Document& document, int plane)
{
    return document.lockedLabels(plane).any() && document.unlockedLabels(plane).none();
}

} // namespace

Result<SeedPlacement> seedPlacement(const SeedStroke& stroke, const Document& document)
{
    const Segment* segment = document.segment(stroke.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(stroke.segment),
            QStringLiteral("in field 'seed.segment'"));
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);

    if (stroke.pointsLps.empty() && !stroke.takenLps)
        return failure(ErrorCode::InvalidField, QStringLiteral("seed.pointsLps"),
            QStringLiteral("needs at least one entry where no seed is taken away"));
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    Result<std::vector<glm::ivec3>> voxels = seedVoxels(stroke.pointsLps, geometry, "pointsLps");
    if (!voxels)
        return tl::unexpected(voxels.error());
    Result<std::vector<glm::ivec3>> taken =
        seedVoxels(stroke.takenLps.value_or(std::vector<glm::dvec3>()), geometry, "takenLps");
    if (!taken)
        return tl::unexpected(taken.error());
    return SeedPlacement{.plane = segment->plane,
        .label = segment->label,
        .voxels = *std::move(voxels),
        .taken = *std::move(taken)};
}

namespace {

/// @param edit its name, for messages
Result<GrowBurst> burstOf(
    const GrowCriteria& criteria, const Document& document, const QString& edit)
{
    const auto wrong = [&edit](const char* field, const QString& reason) {
        return failure(
            ErrorCode::InvalidField, edit + QLatin1Char('.') + QLatin1String(field), reason);
    };
    if (const QString reason = editFields::Connectivity().check(criteria.connectivity);
        !reason.isEmpty())
        return wrong("connectivity", reason);
    if (!(criteria.lower <= criteria.upper))
        return wrong("upper",
            QStringLiteral("%1 is below lower, %2").arg(criteria.upper).arg(criteria.lower));

    const Volume& volume = document.volumes.front();
    Result<GrowLimits> limits = growLimits(criteria, volume, edit);
    if (!limits)
        return tl::unexpected(limits.error());

    constexpr std::uint8_t plane = 0;
    GrowBurst burst{.plane = plane,
        .lowCode = volume.encoding.lowestCodeAtLeast(criteria.lower),
        .highCode = volume.encoding.highestCodeAtMost(criteria.upper),
        .connectivity = criteria.connectivity,
        .limits = *limits};
    if (const Growth* growth = document.growth(plane))
        burst.generation = growth->generation;
    if (criteria.overwriteUnlocked)
        burst.overwritable = document.unlockedLabels(plane);
    burst.frozen = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    return burst;
}

} // namespace

namespace {

constexpr int voxelsOfOld = 60;
constexpr int generationsOfOld = 20;

} // namespace

std::optional<GuardRule> guardRule(const GrowGuard& guard, const VolumeGeometry& geometry)
{
    if (!guard.factor)
        return std::nullopt;
    GuardRule rule{.factor256 = int(std::lround(*guard.factor * 256.0))};
    if (guard.countsVoxels()) {
        rule.excess = guard.voxels.value_or(voxelsOfOld);
        rule.window = guard.generations.value_or(generationsOfOld);
    } else {
        rule.excess = std::llround(guard.areaMm2 * 1.0e6);
        rule.window = std::max(std::llround(guard.backMm * 1.0e3), 1LL);
        rule.measure = frontMeasure(geometry.spacingMm());
    }
    return rule;
}

Result<GrowBurst> growBurst(const GrowSteps& grow, const Document& document)
{
    Result<GrowBurst> burst = burstOf(grow.criteria, document, QStringLiteral("grow"));
    if (!burst)
        return burst;
    if (!grow.tellsHeld && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("grow.tellsHeld"),
            QStringLiteral("must be true with a passage width"));
    burst->tellsHeld = grow.tellsHeld;
    burst->guard = guardRule(grow.guard, document.volumes.front().geometry);
    return burst;
}

Result<GrowBurst> growBurst(const ChangeInterval& change, const Document& document)
{
    Result<GrowBurst> burst = burstOf(change.criteria, document, QStringLiteral("interval"));
    if (!burst)
        return burst;
    burst->opening = change.fromSeeds.value_or(false) ? GrowOpening::Restart : GrowOpening::Narrow;
    if (burst->opening == GrowOpening::Narrow && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("interval.fromSeeds"),
            QStringLiteral("must be true with a passage width"));
    burst->guard = guardRule(change.guard, document.volumes.front().geometry);
    return burst;
}

Result<ToleranceRule> toleranceRule(
    int segment, const GrowCriteria& criteria, const Document& document)
{
    const Segment* growing = document.segment(segment);
    if (!growing)
        return failure(ErrorCode::UnknownSegment, QString::number(segment));
    if (growing->locked)
        return failure(ErrorCode::SegmentLocked, growing->name);
    // A majority of one voxel of 27 and a passage of one voxel ask for nothing.
    const std::array<std::pair<const char*, bool>, 5> unknown{
        {{"sigmas", criteria.sigmas.has_value()}, {"difference", criteria.difference.has_value()},
            {"gradientDifference", criteria.gradientDifference.has_value()},
            {"majority", criteria.majority.value_or(0) > 1},
            {"passage",
                criteria.passage
                    && isAsked(passageOf(*criteria.passage, document.volumes.front().geometry))}}};
    for (const auto& [name, asked] : unknown) {
        if (asked)
            return failure(ErrorCode::InvalidField,
                QStringLiteral("tolerance.") + QLatin1String(name),
                QStringLiteral("knows no least tolerance"));
    }
    GrowCriteria anyValue = criteria;
    anyValue.lower = anyValue.upper = 0.0;
    const Result<GrowBurst> burst = burstOf(anyValue, document, QStringLiteral("tolerance"));
    if (!burst)
        return tl::unexpected(burst.error());
    return ToleranceRule{.plane = growing->plane,
        .label = growing->label,
        .connectivity = burst->connectivity,
        .limits = burst->limits,
        .overwritable = burst->overwritable};
}

Result<ShrinkGrowth> shrinkGrowth(const ShrinkSteps& shrink, const Document& document)
{
    constexpr std::uint8_t plane = 0;
    ShrinkGrowth command{.plane = plane};
    if (const Growth* growth = document.growth(plane))
        command.generation = growth->generation;
    // The accepted seeds are the first generation.
    const std::uint32_t steps = std::uint32_t(shrink.steps.value_or(int(seedWord::maxGeneration)));
    command.keepSeeds = steps >= command.generation;
    command.keep = command.keepSeeds ? 0 : command.generation - steps;
    command.frozen = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    return command;
}

namespace {

/// @param field of the points, for messages
Result<CutGrowth> cutAt(const std::vector<glm::dvec3>& pointsLps, CutGrowth::How how,
    const Document& document, const QString& field)
{
    constexpr std::uint8_t plane = 0;
    CutGrowth command{.plane = plane, .how = how};
    if (pointsLps.empty())
        return failure(ErrorCode::InvalidField, field, QStringLiteral("has no point"));
    for (const glm::dvec3& point : pointsLps) {
        const std::optional<glm::ivec3> voxel =
            voxelNearest(point, document.volumes.front().geometry);
        if (!voxel)
            return failure(ErrorCode::InvalidField, field,
                QStringLiteral("%1 lies outside the volume").arg(pointText(point)));
        command.voxels.push_back(*voxel);
    }
    if (const Growth* growth = document.growth(plane))
        command.generation = growth->generation;
    command.frozen = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    return command;
}

} // namespace

Result<CutGrowth> cutGrowth(const ShrinkAt& shrink, const Document& document)
{
    Result<CutGrowth> command =
        cutAt(shrink.pointsLps, shrink.onlyHere ? CutGrowth::How::Here : CutGrowth::How::Subtree,
            document, QStringLiteral("shrinkAt.pointsLps"));
    if (command)
        command->barrier = shrink.barrier;
    return command;
}

Result<CutGrowth> cutGrowth(const PlugLeak& plug, const Document& document)
{
    return cutAt({plug.pointLps}, CutGrowth::How::Neck, document, QStringLiteral("plug.pointLps"));
}

} // namespace core
