// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowFromSeeds.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/open/OpenStroke.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <cmath>

namespace core {

using namespace rowWords;

namespace {

/// So that lengths along, across and askew can be told apart where values are all alike.
constexpr std::uint32_t costPerCode = 4;

/// The voxels between those nearest to two corners, inclusive; empty beyond the volume.
VoxelBox boxBetween(const GrowBox& box, const VolumeGeometry& geometry)
{
    const glm::ivec3 from(glm::floor(geometry.toIndex(box.fromLps) + 0.5));
    const glm::ivec3 to(glm::floor(geometry.toIndex(box.toLps) + 0.5));
    return {glm::max(glm::min(from, to), glm::ivec3(0)),
        glm::min(glm::max(from, to) + 1, geometry.size)};
}

/// What steps cost by their length, in quarters of a code.
std::array<std::uint32_t, 13> lengthCosts(double perMm, const Volume& volume)
{
    const VoxelEncoding& encoding = volume.encoding;
    const double valuePerCode =
        std::abs(encoding.value(VoxelEncoding::codeCount - 1) - encoding.value(0))
        / (VoxelEncoding::codeCount - 1);
    std::array<std::uint32_t, 13> costs{};
    for (std::size_t pair = 0; pair < costs.size(); ++pair) {
        const std::array<int, 3>& step = seedWord::offsets[2 * pair];
        const double mm = glm::length(
            glm::dmat3(volume.geometry.indexToWorld) * glm::dvec3(step[0], step[1], step[2]));
        const double cost = std::floor(double(costPerCode) * perMm * mm / valuePerCode + 0.5);
        costs[pair] = std::uint32_t(std::clamp(cost, 1.0, 65535.0));
    }
    return costs;
}

/// A preview, for the user to decide. The engine keeps what it computed for the next one, until it
/// is told to forget that (ForgetPreview).
class OpenSpread final : public OpenStroke {
public:
    [[nodiscard]] OpenManner manner() const override
    {
        return {.withoutPen = true, .endsIfRefused = true, .keepsForNext = true};
    }
    [[nodiscard]] Result<Told> extend(const StrokeExtension& extension, const Document&) override
    {
        Told told;
        if (std::holds_alternative<ForgetPreview>(extension))
            told.push_back(ForgetSpread{});
        return told;
    }
};

} // namespace

Result<void> check(const GrowFromSeeds& edit, const Document& document)
{
    return discardValue(spreadLabels(edit, document));
}

Result<bool> apply(const GrowFromSeeds&, Document&)
{
    return false;
}

EditEffects effects(const GrowFromSeeds& edit)
{
    return {.task = engineTask<GrowFromSeeds>(),
        .standsOpen = opens<GrowFromSeeds>(),
        .fills = fillsNothing,
        .boundToStudy = edit.box || namesPlaces(edit.editable)};
}

Result<SpreadLabels> spreadLabels(const GrowFromSeeds& edit, const Document& document)
{
    const auto wrong = [](const char* field, const Clause& reason) {
        return failure(ErrorCode::InvalidField,
            QStringLiteral("growFromSeeds.") + QLatin1String(field), reason);
    };
    const Result<std::uint8_t> named =
        growthPlane(edit.plane, document, QStringLiteral("growFromSeeds"));
    if (!named)
        return tl::unexpected(named.error());
    const std::uint8_t plane = *named;
    const Volume& volume = document.volumes.front();
    SpreadLabels spread{.plane = plane};
    spread.connectivity = edit.connectivity;
    spread.differenceWeight = costPerCode;
    spread.lengths =
        lengthCosts(edit.lengthCost.value_or((volume.maximum - volume.minimum) / 1000.0), volume);
    if (edit.segments) {
        for (const int label : *edit.segments) {
            const Segment* segment = document.segment(label);
            if (!segment)
                return failure(ErrorCode::UnknownSegment, QString::number(label),
                    Clause::saying("in field 'growFromSeeds.segments'"));
            if (segment->locked)
                return failure(ErrorCode::SegmentLocked, segment->name);
            if (const Result<void> there =
                    checkLiesOn(plane, *segment, QStringLiteral("growFromSeeds"));
                !there)
                return tl::unexpected(there.error());
            spread.seeds.set(std::size_t(label));
        }
    }
    const std::bitset<256> unlocked = document.unlockedLabels(plane);
    if (!edit.segments)
        spread.seeds = unlocked;
    if (edit.overwriteUnlocked)
        spread.overwritable = unlocked & ~spread.seeds;
    if (spread.seeds.count() < 2)
        return wrong(
            "segments", Clause::saying("at least two that are not locked are needed to compete"));
    if (edit.box) {
        spread.box = boxBetween(*edit.box, volume.geometry);
        if (spread.box->empty())
            return wrong("box", Clause::saying("it lies outside the volume"));
    }
    if (edit.editable) {
        const Result<GrowthRange> range =
            growthRange(*edit.editable, plane, document, QStringLiteral("growFromSeeds"));
        if (!range)
            return tl::unexpected(range.error());
        spread.range = *range;
        if (edit.editable->box) {
            spread.within = boxBetween(*edit.editable->box, volume.geometry);
            if (spread.within->empty())
                return wrong("editable.box", Clause::saying("it lies outside the volume"));
        }
    }
    return spread;
}

Result<EngineEdit> engineEdit(const GrowFromSeeds& edit, const Document& document)
{
    return engineEditFrom(spreadLabels(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(GrowFromSeeds&)
{
    return std::make_unique<OpenSpread>();
}

RowTitle rowTitle(const GrowFromSeeds&, const RowFacts& row)
{
    const GrownSegments grown = grownSegments(row.facts, row.document);
    RowTitle title{.code = RowTitleCode::GrowFromSeeds,
        .then = {figure(RowTitleCode::VoxelsGained, row.statistics.voxelsChanged)}};
    if (grown.count == 1) {
        title.code = RowTitleCode::GrowSegmentFromSeeds;
        title.arguments = {grown.name};
    } else if (grown.count > 1) {
        title.code = RowTitleCode::GrowSegmentsFromSeeds;
        title.arguments = {TitleCount{grown.count}};
    }
    return title;
}

EditDependencies dependencies(const GrowFromSeeds& edit, const DependencyFacts&)
{
    return dependsOn::Plane{growthPlaneOf(edit.plane)};
}

} // namespace core
