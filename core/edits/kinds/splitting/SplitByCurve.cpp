// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitByCurve.h"

#include "core/brick/LabelBox.h"
#include "core/brick/LabelRuns.h"
#include "core/brick/VoxelRunSets.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/OutlinedPlane.h"
#include "core/edits/kinds/splitting/LineAcross.h"
#include "core/sculpt/labels/LabelScissors.h"
#include "core/sculpt/labels/ScissorsVoxels.h"

#include <utility>

namespace core {

using namespace rowWords;

namespace {

using Side = SplitByCurve::Side;

/// How far a line goes on beyond a box, so that the smooth edge of a mask lies outside of it; more
/// than two elements of any mask.
constexpr double beyondMm = 8.0;

tl::unexpected<Error> curveFailure(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField,
        QStringLiteral("splitByCurve.%1").arg(QLatin1String(field)), reason);
}

/// The closed curve of an open one around what lies on its left of a box of voxels. Errors:
/// InvalidField.
Result<std::vector<glm::dvec2>> closedCurve(
    const SplitByCurve& edit, const VolumeGeometry& geometry, const VoxelBox& box)
{
    const Result<glm::dmat3> axes = viewAxes(edit.view, QStringLiteral("splitByCurve.view"));
    if (!axes)
        return tl::unexpected(axes.error());
    const glm::dmat3 worldToPlane = glm::transpose(*axes);
    glm::dvec2 low = edit.curveMm.front();
    glm::dvec2 high = low;
    const auto reach = [&low, &high](const glm::dvec2& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    };
    for (const glm::dvec2& point : edit.curveMm)
        reach(point);
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 index(box.minimum);
        for (int axis = 0; axis < 3; ++axis) {
            if (corner & (1 << axis))
                index[axis] = box.maximum[axis] - 1;
        }
        reach(glm::dvec2(worldToPlane * (geometry.toWorld(index) - edit.view.targetLps)));
    }
    std::vector<glm::dvec2> curve = leftOfLine(edit.curveMm, low - beyondMm, high + beyondMm);
    if (curve.empty())
        return curveFailure("curveMm", Clause::saying("has no direction at one of its ends"));
    return curve;
}

/// The side that is not the outside, and how deep; for voxels that lie in a box. Errors:
/// InvalidField.
Result<LabelScissors> underCurve(
    const SplitByCurve& edit, const Document& document, const VoxelBox& box)
{
    if (edit.curveMm.size() < 2)
        return curveFailure("curveMm", Clause::saying("has fewer than two points"));
    if (edit.depthMm && edit.side != Side::Inside)
        return curveFailure("depthMm", Clause::saying("has a meaning inside of the curve only"));
    Result<std::vector<glm::dvec2>> curve = edit.curveMm;
    if (edit.open)
        curve = closedCurve(edit, document.volumes.front().geometry, box);
    if (!curve)
        return tl::unexpected(curve.error());
    Result<OutlinedPlane> plane = outlinedPlane(*curve,
        {.view = edit.view, .maxDepthMm = edit.depthMm.value_or(0.0), .hidden = edit.hidden},
        document, QStringLiteral("splitByCurve"), "curveMm");
    if (!plane)
        return tl::unexpected(plane.error());
    LabelScissors scissors{
        .fromSurface = edit.depthMm.has_value(), .frame = std::move(plane->frame)};
    scissors.mask = std::move(plane->mask);
    return scissors;
}

} // namespace

Result<void> check(const SplitByCurve& edit, const Document& document)
{
    if (const auto segment = unlockedSegment("splitByCurve.segment", edit.segment, document);
        !segment)
        return tl::unexpected(segment.error());
    const VoxelBox whole{glm::ivec3(0), document.volumes.front().geometry.size};
    if (const auto scissors = underCurve(edit, document, whole); !scissors)
        return tl::unexpected(scissors.error());
    if (const auto editable = editableVoxels(edit.editable, document, "splitByCurve"); !editable)
        return tl::unexpected(editable.error());
    return checkApplied(edit, document);
}

Result<bool> apply(const SplitByCurve& edit, Document& document)
{
    return addParts("splitByCurve.segment", edit.segment, "splitByCurve", {edit.into}, document);
}

EditEffects effects(const SplitByCurve& edit)
{
    return splitEffects(edit.segment, true);
}

/// "Split 'Liver' by a curve, 12.0 mm deep, −3 210 voxels"
RowTitle rowTitle(const SplitByCurve& edit, const RowFacts& row)
{
    RowTitle title = segmentChanged(
        edit.open ? RowTitleCode::SplitByLine : RowTitleCode::SplitByCurve, edit.segment, row);
    if (edit.depthMm)
        title.then.insert(title.then.begin(),
            {.code = RowTitleCode::MillimetresDeep, .arguments = {inMm(*edit.depthMm)}});
    return title;
}

/// Whether any voxel stays decides, too, wherever it lies, and how many there are on each side.
EditDependencies dependencies(const SplitByCurve& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<SplitSides> sidesOf(const SplitByCurve& edit, const Document& document,
    const VoxelRuns& voxels, const Progress& progress)
{
    const glm::ivec3& size = document.volumes.front().geometry.size;
    Result<LabelScissors> scissors = underCurve(edit, document, boxOfRuns(voxels, size));
    if (!scissors)
        return tl::unexpected(scissors.error());
    const auto chosen = [&](bool outside) {
        scissors->outside = outside;
        return chosenOf(*scissors, voxels, size, progress);
    };
    bool isInside = edit.side != Side::Outside;
    Result<VoxelRuns> beyond = chosen(!isInside);
    if (beyond && (edit.side == Side::Smaller || edit.side == Side::Larger)) {
        Result<VoxelRuns> outside = edit.hidden ? chosen(true) : differing(voxels, *beyond);
        const bool isInsideSmaller = outside && beyond->voxelCount() <= outside->voxelCount();
        isInside = isInsideSmaller == (edit.side == Side::Smaller);
        if (!outside || !isInside)
            beyond = std::move(outside);
    }
    if (!beyond)
        return tl::unexpected(beyond.error());
    const std::uint64_t staying = voxels.voxelCount() - beyond->voxelCount();
    return SplitSides{*std::move(beyond), staying, isInside};
}

Result<RelabelListed> relabelListed(const SplitByCurve& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    const std::uint8_t label = document.segment(edit.segment)->label;
    const Result<SplitSides> sides = sidesOf(edit, document, labelRuns(labels, label), progress);
    if (!sides)
        return tl::unexpected(sides.error());
    return keepingTo(
        edit.editable, document, "splitByCurve", givenBeyond(*sides, edit.segment, document));
}

} // namespace core
