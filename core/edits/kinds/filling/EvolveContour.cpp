// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/EvolveContour.h"

#include "core/brick/LabelBox.h"
#include "core/contour/ContourEvolution.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/morphology/BallFilters.h"
#include "core/morphology/MillimetreBall.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <cmath>

namespace core {

using namespace rowWords;

namespace {

tl::unexpected<Error> contourFieldError(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField,
        QStringLiteral("evolveContour.%1").arg(QLatin1String(field)), reason);
}

/// The voxels of bubbles, by those in their middles.
struct Bubbles {
    std::vector<glm::ivec3> middles{};
    MillimetreBall ball{};

    [[nodiscard]] VoxelBox boxIn(const glm::ivec3& size) const
    {
        VoxelBox box;
        for (const glm::ivec3& middle : middles) {
            const VoxelBox one{.minimum = glm::max(middle - ball.extent, glm::ivec3(0)),
                .maximum = glm::min(middle + ball.extent + 1, size)};
            box = box.empty() ? one : box.united(one);
        }
        return box;
    }
};

/// None: there is no bubble.
Result<std::optional<Bubbles>> bubblesOf(const EvolveContour& edit, const VolumeGeometry& geometry)
{
    if (!edit.bubbleLps && edit.furtherBubblesLps)
        return contourFieldError("furtherBubblesLps", Clause::saying("there is no first bubble"));
    if (!edit.bubbleLps)
        return std::nullopt;
    Bubbles bubbles;
    const auto add = [&](const char* field, const glm::dvec3& placeLps) -> Result<void> {
        const std::optional<glm::ivec3> middle = voxelNearest(placeLps, geometry);
        if (!middle)
            return contourFieldError(
                field, Clause::saying("%1 lies outside the volume", pointText(placeLps)));
        bubbles.middles.push_back(*middle);
        return {};
    };
    if (const Result<void> added = add("bubbleLps", *edit.bubbleLps); !added)
        return tl::unexpected(added.error());
    if (edit.furtherBubblesLps) {
        for (const glm::dvec3& placeLps : *edit.furtherBubblesLps) {
            if (const Result<void> added = add("furtherBubblesLps", placeLps); !added)
                return tl::unexpected(added.error());
        }
    }
    if (!(edit.bubbleMm > 0.0))
        return contourFieldError("bubbleMm", Clause::saying("is no length"));
    if (ballVoxels(geometry, edit.bubbleMm) > mostBallVoxels)
        return contourFieldError("bubbleMm",
            Clause::saying("%1 mm are more than %2 voxels here", edit.bubbleMm, mostBallVoxels));
    bubbles.ball = ballOf(geometry, edit.bubbleMm);
    return bubbles;
}

/// Bubbles, voxel by voxel.
struct BlownBubbles {
    VoxelBox box{};
    ByteMask mask{}; ///< of the box

    [[nodiscard]] bool hold(const glm::ivec3& voxel) const
    {
        return glm::all(glm::greaterThanEqual(voxel, box.minimum))
            && glm::all(glm::lessThan(voxel, box.maximum)) && mask.voxels[indexOf(voxel)] != 0;
    }
    [[nodiscard]] std::size_t indexOf(const glm::ivec3& voxel) const
    {
        const glm::ivec3 in = voxel - box.minimum;
        return (std::size_t(in.z) * std::size_t(mask.size.y) + std::size_t(in.y))
            * std::size_t(mask.size.x)
            + std::size_t(in.x);
    }
};

/// However many there are, the cost is that of their box, on a grid that is not sheared.
Result<BlownBubbles> blownBubbles(
    const std::optional<Bubbles>& bubbles, const glm::ivec3& size, const Progress& progress)
{
    BlownBubbles blown;
    if (!bubbles)
        return blown;
    blown.box = bubbles->boxIn(size);
    blown.mask.size = blown.box.maximum - blown.box.minimum;
    if (const Result<void> fits = checkBytes(
            filterBytes(blown.mask.size), Clause::saying("the box in which the contour evolves"));
        !fits)
        return tl::unexpected(fits.error());
    const glm::dvec3 extent(blown.mask.size);
    blown.mask.voxels.assign(std::size_t(extent.x * extent.y * extent.z), 0);
    for (const glm::ivec3& middle : bubbles->middles)
        blown.mask.voxels[blown.indexOf(middle)] = 1;
    if (const Result<void> spread = dilate(blown.mask, bubbles->ball, {.progress = progress});
        !spread)
        return tl::unexpected(spread.error());
    return blown;
}

bool erases(const EvolveContour& edit)
{
    return edit.erase.value_or(false);
}

RowTitleCode contourTitle(const EvolveContour& edit)
{
    if (erases(edit))
        return edit.bubbleLps ? RowTitleCode::ContourErasedFromBubble : RowTitleCode::ContourErased;
    return edit.bubbleLps ? RowTitleCode::ContourFromBubble : RowTitleCode::ContourEvolved;
}

RowTitleCode titleOfSeveral(const EvolveContour& edit)
{
    return erases(edit) ? RowTitleCode::ContourErasedFromBubbles : RowTitleCode::ContourFromBubbles;
}

/// With what a contour begins, voxel by voxel.
struct ContourStart {
    bool erases = false;
    const LabelTarget& target;
    const std::optional<Bubbles>& bubbles;

    /// The box in which it evolves; empty: it has nothing to begin with.
    /// @param own that of the segment
    [[nodiscard]] VoxelBox boxOfGround(const VoxelBox& own, int generations,
        const ContourKernel& kernel, const glm::ivec3& size) const
    {
        if (erases) // it does not leave the segment
            return own.empty() ? own : contourBox(own, 0, kernel, size);
        VoxelBox start = own;
        if (bubbles) {
            const VoxelBox blown = bubbles->boxIn(size);
            start = start.empty() ? blown : start.united(blown);
        }
        return start.empty() ? start : contourBox(start, generations, kernel, size);
    }
    /// Flags of a ground, before there is a bubble.
    [[nodiscard]] std::uint8_t flagsOf(std::uint8_t label) const
    {
        if (label == target.label)
            return ContourGround::open | ContourGround::own | ContourGround::inside;
        if (erases)
            return bubbles ? ContourGround::absent : std::uint8_t(0);
        return label == 0 || target.overwritable[label] ? ContourGround::open : std::uint8_t(0);
    }
    /// @param voxel flags of a voxel that is open
    void takeBubble(std::uint8_t& voxel) const
    {
        if (erases)
            voxel &= std::uint8_t(~ContourGround::inside);
        else
            voxel |= ContourGround::inside;
    }
};

} // namespace

Result<void> check(const EvolveContour& edit, const Document& document)
{
    const Result<ContourRule> rule = contourRule(edit, document);
    if (!rule)
        return tl::unexpected(rule.error());
    return checkEditable(edit.segment, edit.editable, document, "evolveContour");
}

Result<bool> apply(const EvolveContour&, Document&)
{
    return false;
}

EditEffects effects(const EvolveContour& edit)
{
    EditEffects found =
        workedOutEffects(edit.segment, edit.bubbleLps.has_value() || namesPlaces(edit.editable));
    if (erases(edit))
        found.fills.label.reset();
    return found;
}

RowTitle rowTitle(const EvolveContour& edit, const RowFacts& row)
{
    if (!edit.bubbleLps || !edit.furtherBubblesLps)
        return segmentChanged(contourTitle(edit), edit.segment, row);
    RowTitle title = segmentChanged(titleOfSeveral(edit), edit.segment, row);
    title.arguments.push_back(TitleCount{std::int64_t(edit.furtherBubblesLps->size() + 1)});
    return title;
}

/// How far the contour would have come with other labels is unknown, so it depends on the whole
/// plane.
EditDependencies dependencies(const EvolveContour& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<ContourRule> contourRule(const EvolveContour& edit, const Document& document)
{
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(QStringLiteral("evolveContour"), edit.lower, edit.upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    if (!(edit.softness >= 0.0))
        return contourFieldError("softness", Clause::saying("is less than nothing"));
    if (edit.edge > 0 && !(edit.edgeGradient > 0.0))
        return contourFieldError("edgeGradient", Clause::saying("is no edge"));
    if (const auto bubbles = bubblesOf(edit, volume.geometry); !bubbles)
        return tl::unexpected(bubbles.error());
    ContourRule rule{.region = edit.region,
        .edge = edit.edge,
        .smoothness = edit.smoothness,
        .round = edit.round.value_or(false),
        .erase = erases(edit),
        .kernel = contourKernel(volume.geometry)};
    rule.lowCode = edit.lower ? codes->low : -noContourBound;
    rule.highCode = edit.upper ? codes->high : noContourBound;
    rule.softness = std::max(greatestDifference(volume.encoding, edit.softness), 0);
    if (edit.edge > 0) {
        constexpr double most = 65535.0;
        const GradientScale scale = gradientScale(volume);
        rule.gradientWeights = scale.weights;
        rule.halfGradient =
            int(std::clamp(std::floor(edit.edgeGradient * scale.perUnit), 1.0, most));
    }
    return rule;
}

Result<ContourGround> contourGround(const EvolveContour& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    const Result<LabelTarget> target =
        segmentTarget(edit.segment, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    const Result<ContourRule> rule = contourRule(edit, document);
    if (!rule)
        return tl::unexpected(rule.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const glm::ivec3 size = geometry.size;
    const Result<std::optional<Bubbles>> bubbles = bubblesOf(edit, geometry);
    if (!bubbles)
        return tl::unexpected(bubbles.error());

    const ContourStart start{.erases = erases(edit), .target = *target, .bubbles = *bubbles};
    ContourGround ground{.volumeSize = size};
    ground.box = start.boxOfGround(
        boxOfLabel(labels, size, target->label), edit.generations, rule->kernel, size);
    if (ground.box.empty())
        return ground;
    if (const Result<void> fits = checkContourMemory(ground.box); !fits)
        return tl::unexpected(fits.error());
    const Result<BlownBubbles> blown = blownBubbles(*bubbles, size, progress);
    if (!blown)
        return tl::unexpected(blown.error());
    const glm::ivec3 extent = ground.box.maximum - ground.box.minimum;
    ground.voxels.reserve(std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(extent.z));
    bool meetsBubble = false;
    for (int z = ground.box.minimum.z; z < ground.box.maximum.z; ++z) {
        for (int y = ground.box.minimum.y; y < ground.box.maximum.y; ++y) {
            const std::size_t row =
                (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
            for (int x = ground.box.minimum.x; x < ground.box.maximum.x; ++x) {
                std::uint8_t voxel = start.flagsOf(labels[row + std::size_t(x)]);
                if ((voxel & ContourGround::open) && blown->hold({x, y, z})) {
                    start.takeBubble(voxel);
                    meetsBubble = true;
                }
                ground.voxels.push_back(voxel);
            }
        }
    }
    if (start.erases && start.bubbles && !meetsBubble)
        return ContourGround{.volumeSize = size};
    return ground;
}

Result<RelabelListed> relabelListed(
    const EvolveContour& edit, const Document& document, const ContourEvolution& evolution)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    const ShapeChange change = evolution.change();
    ListedRuns listed(document.volumes.front().geometry.size);
    listed.add(change.given, RelabelListed::give);
    listed.add(change.taken, RelabelListed::take);
    return keepingTo(edit.editable, document, "evolveContour", listed.relabel(*std::move(target)));
}

} // namespace core
