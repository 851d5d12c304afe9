// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowthParts.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/engine/BoxVoxels.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/engine/ChangeFacts.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>

namespace core {

using namespace rowWords;

namespace {

constexpr int voxelsOfOld = 60;
constexpr int generationsOfOld = 20;

/// Listed segments, which must lie in the plane that grows: a growth knows no other one.
Result<std::bitset<256>> labelsIn(std::uint8_t plane, const std::vector<int>& segments,
    const Document& document, const QString& field)
{
    std::bitset<256> labels;
    for (const int label : segments) {
        const Segment* segment = document.segment(label);
        if (!segment)
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                Clause::saying("in field '%1'", field));
        if (segment->plane != plane)
            return failure(ErrorCode::InvalidField, field,
                Clause::saying("'%1' lies on label plane %2, and what grows on plane %3: growth "
                               "keeps to segments of its own plane",
                    segment->name, int(segment->plane) + 1, int(plane) + 1));
        labels.set(std::size_t(label));
    }
    return labels;
}

} // namespace

bool nothingMayChange(const Document& document, int plane)
{
    return document.lockedLabels(plane).any() && document.unlockedLabels(plane).none();
}

Result<std::uint8_t> growthPlane(
    const std::optional<int>& plane, const Document& document, const QString& edit)
{
    const std::uint8_t named = growthPlaneOf(plane);
    const std::vector<std::uint8_t> planes = document.labelPlanes();
    if (!std::binary_search(planes.begin(), planes.end(), named))
        return failure(ErrorCode::InvalidField, edit + QStringLiteral(".plane"),
            Clause::saying("no segment lies on label plane %1", int(named) + 1));
    return named;
}

Result<void> checkLiesOn(std::uint8_t plane, const Segment& segment, const QString& edit)
{
    if (segment.plane == plane)
        return {};
    return failure(ErrorCode::InvalidField, edit + QStringLiteral(".segments"),
        Clause::saying("'%1' lies on label plane %2; field 'plane' must be %3 for it to grow",
            segment.name, int(segment.plane) + 1, int(segment.plane)));
}

Result<GrowBurst> burstOf(
    const GrowCriteria& criteria, const Document& document, const QString& edit)
{
    const auto wrong = [&edit](const char* field, const Clause& reason) {
        return failure(
            ErrorCode::InvalidField, edit + QLatin1Char('.') + QLatin1String(field), reason);
    };
    if (const Clause reason = editFields::Connectivity().check(criteria.connectivity);
        !reason.isEmpty())
        return wrong("connectivity", reason);
    if (!(criteria.lower <= criteria.upper))
        return wrong(
            "upper", Clause::saying("%1 is below lower, %2", criteria.upper, criteria.lower));

    const Volume& volume = document.volumes.front();
    Result<GrowLimits> limits = growLimits(criteria, volume, edit);
    if (!limits)
        return tl::unexpected(limits.error());

    const Result<std::uint8_t> named = growthPlane(criteria.plane, document, edit);
    if (!named)
        return tl::unexpected(named.error());
    const std::uint8_t plane = *named;
    GrowBurst burst{.plane = plane,
        .lowCode = volume.encoding.lowestCodeAtLeast(criteria.lower),
        .highCode = volume.encoding.highestCodeAtMost(criteria.upper),
        .connectivity = criteria.connectivity,
        .limits = *limits};
    if (const Growth* growth = document.growth(plane))
        burst.generation = growth->generation;
    if (criteria.overwriteUnlocked)
        burst.overwritable = document.unlockedLabels(plane);
    if (criteria.editable) {
        const Result<GrowthRange> range = growthRange(*criteria.editable, plane, document, edit);
        if (!range)
            return tl::unexpected(range.error());
        if (*range != GrowthRange())
            burst.range = *range;
    }
    burst.lockedLabels = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    if (!criteria.segments)
        return burst;
    std::bitset<256> resting;
    resting.set();
    resting.reset(0);
    for (const int label : *criteria.segments) {
        const Segment* segment = document.segment(label);
        if (!segment)
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                Clause::saying("in field '%1.segments'", edit));
        if (segment->locked)
            return failure(ErrorCode::SegmentLocked, segment->name);
        if (const Result<void> there = checkLiesOn(plane, *segment, edit); !there)
            return tl::unexpected(there.error());
        resting.reset(std::size_t(label));
    }
    burst.lockedLabels |= resting;
    return burst;
}

bool namesPlaces(const GrowCriteria& criteria)
{
    return criteria.box || namesPlaces(criteria.editable);
}

Result<GrowthRange> growthRange(
    const EditableRange& range, std::uint8_t plane, const Document& document, const QString& edit)
{
    const QString field = edit + QStringLiteral(".editable");
    const Result<CodeInterval> codes =
        codesBetween(field, range.lower, range.upper, document.volumes.front().encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    GrowthRange found{.lowCode = codes->low, .highCode = codes->high};
    if (range.inside) {
        const Result<std::bitset<256>> inside =
            labelsIn(plane, *range.inside, document, field + QStringLiteral(".inside"));
        if (!inside)
            return tl::unexpected(inside.error());
        found.closed = ~*inside;
    }
    if (range.outside) {
        const Result<std::bitset<256>> outside =
            labelsIn(plane, *range.outside, document, field + QStringLiteral(".outside"));
        if (!outside)
            return tl::unexpected(outside.error());
        found.closed |= *outside;
    }
    return found;
}

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

Result<CutGrowth> cutAt(const CutPlaces& places, CutGrowth::How how, const Document& document)
{
    const QString field = places.edit + QLatin1Char('.') + places.pointsField;
    const Result<std::uint8_t> named = growthPlane(places.plane, document, places.edit);
    if (!named)
        return tl::unexpected(named.error());
    const std::uint8_t plane = *named;
    CutGrowth command{.plane = plane, .how = how};
    if (places.pointsLps.empty())
        return failure(ErrorCode::InvalidField, field, Clause::saying("has no point"));
    for (const glm::dvec3& point : places.pointsLps) {
        const std::optional<glm::ivec3> voxel =
            voxelNearest(point, document.volumes.front().geometry);
        if (!voxel)
            return failure(ErrorCode::InvalidField, field,
                Clause::saying("%1 lies outside the volume", pointText(point)));
        command.voxels.push_back(*voxel);
    }
    if (const Growth* growth = document.growth(plane))
        command.generation = growth->generation;
    command.lockedLabels = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    return command;
}

GrownSegments grownSegments(const ChangeFacts& facts, const Document& document)
{
    std::bitset<256> grew;
    for (const LabelFlow& flow : facts.flows) {
        if (flow.gained > 0)
            grew.set(flow.label);
    }
    GrownSegments grown{.count = std::int64_t(grew.count())};
    if (grown.count != 1)
        return grown;
    int label = 1;
    while (!grew.test(std::size_t(label)))
        ++label;
    grown.name = segmentName(label, document);
    return grown;
}

RowTitle intervalTitle(const GrowCriteria& criteria, const Document& document)
{
    RowTitle title{.code = RowTitleCode::Range,
        .arguments = {TitleDigits{criteria.lower}, TitleDigits{criteria.upper}}};
    if (const QString& unit = document.volumes.front().unit; !unit.isEmpty()) {
        title.code = RowTitleCode::RangeInUnit;
        title.arguments.push_back(unit);
    }
    return title;
}

EditDependencies growthDependencies(const GrowCriteria& criteria, const DependencyFacts& row)
{
    const std::uint8_t plane = growthPlaneOf(criteria.plane);
    // The segments of its editable range lie in the same plane, and are asked where it looks
    // anyway.
    if (row.trace.grownBeside)
        return dependsOn::SeedWords{
            .plane = plane, .coverage = criteria.onlyVisible, .beside = *row.trace.grownBeside};
    if (!criteria.onlyVisible)
        return dependsOn::Plane{plane};
    dependsOn::Fields fields{.plane = plane, .layers = {}};
    fields.layers.set();
    return fields;
}

} // namespace core
