// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/FillOutline.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/SlicePlane.h"
#include "core/sculpt/labels/LabelOutlined.h"

#include <algorithm>
#include <cmath>

namespace core {

using namespace rowWords;

namespace {

tl::unexpected<Error> outlineFailure(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField,
        QStringLiteral("fillOutline.%1").arg(QLatin1String(field)), reason);
}

/// Right, up and the normal, as matrix columns.
Result<glm::dmat3> sliceAxes(const FillOutline& edit)
{
    constexpr double shortest = 1e-3;
    if (!(glm::length(edit.rightLps) > shortest))
        return outlineFailure("rightLps", Clause::saying("is no direction"));
    if (!(glm::length(edit.upLps) > shortest))
        return outlineFailure("upLps", Clause::saying("is no direction"));
    const glm::dvec3 right = glm::normalize(edit.rightLps);
    const glm::dvec3 up = glm::normalize(edit.upLps);
    const glm::dvec3 across = up - glm::dot(up, right) * right;
    if (!(glm::length(across) > shortest))
        return outlineFailure("upLps", Clause::saying("is parallel to rightLps"));
    const glm::dvec3 straightUp = glm::normalize(across);
    return glm::dmat3(right, straightUp, glm::cross(right, straightUp));
}

bool meetsVolume(const SlicePlane& slice, const glm::dvec3& normal, const VolumeGeometry& geometry)
{
    double reachMm = slice.halfThicknessMm;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 step(geometry.indexToWorld[axis]);
        reachMm += std::abs(glm::dot(normal, step)) * (geometry.size[axis] - 1) / 2.0;
    }
    return std::abs(slice.heightMm) <= reachMm;
}

/// @param origin of the outline, relative to the middle of the volume, in the plane
Result<std::vector<glm::ivec2>> cornersOf(
    const std::vector<glm::dvec2>& polygonMm, const glm::dvec2& origin)
{
    if (polygonMm.size() < 3)
        return outlineFailure("polygonMm", Clause::saying("needs at least three points"));
    if (polygonMm.size() > LabelOutlined::mostCorners)
        return outlineFailure(
            "polygonMm", Clause::saying("has more than %1 points", LabelOutlined::mostCorners));
    constexpr double reachMm = LabelOutlined::reach / 65536.0 - 1.0;
    std::vector<glm::ivec2> corners;
    corners.reserve(polygonMm.size());
    for (const glm::dvec2& point : polygonMm) {
        const glm::dvec2 corner = origin + point;
        if (!(std::abs(corner.x) <= reachMm && std::abs(corner.y) <= reachMm))
            return outlineFailure("polygonMm", Clause::saying("lies far outside the volume"));
        corners.emplace_back(mm16(corner.x), mm16(corner.y));
    }
    return corners;
}

/// The outline in its plane, without what is to be done inside it. Errors: InvalidField.
Result<LabelOutlined> placed(const FillOutline& edit, const VolumeGeometry& geometry)
{
    const Result<glm::dmat3> axes = sliceAxes(edit);
    if (!axes)
        return tl::unexpected(axes.error());
    const glm::dvec3& normal = (*axes)[2];
    const SlicePlane slice = slicePlane(geometry, normal, edit.originLps);
    if (!meetsVolume(slice, normal, geometry))
        return outlineFailure("originLps", Clause::saying("lies on a plane outside the volume"));

    const glm::dmat3 toPlane = glm::transpose(*axes);
    const glm::dvec3 origin = toPlane * (edit.originLps - slice.middleLps);
    Result<std::vector<glm::ivec2>> corners =
        cornersOf(edit.polygonMm, glm::dvec2(origin.x, origin.y));
    if (!corners)
        return tl::unexpected(corners.error());
    LabelOutlined outlined{.corners = *std::move(corners)};
    const glm::dmat3 perVoxel = toPlane * glm::dmat3(geometry.indexToWorld);
    outlined.origin = toFixed30(
        toPlane * (geometry.originLps() - slice.middleLps) - glm::dvec3(0.0, 0.0, slice.heightMm));
    outlined.perI = toFixed30(perVoxel[0]);
    outlined.perJ = toFixed30(perVoxel[1]);
    outlined.perK = toFixed30(perVoxel[2]);
    outlined.halfThickness = mm16(slice.halfThicknessMm);
    return outlined;
}

} // namespace

Result<void> check(const FillOutline& edit, const Document& document)
{
    return discardValue(labelOutlined(edit, document));
}

Result<bool> apply(const FillOutline&, Document&)
{
    return false;
}

EditEffects effects(const FillOutline& edit)
{
    return {.task = engineTask<FillOutline>(),
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.erase ? std::nullopt : std::optional(edit.segment)},
        .boundToStudy = true};
}

Result<LabelOutlined> labelOutlined(const FillOutline& edit, const Document& document)
{
    const Result<const Segment*> segment =
        unlockedSegment("fillOutline.segment", edit.segment, document);
    if (!segment)
        return tl::unexpected(segment.error());
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(QStringLiteral("fillOutline"), edit.lower, edit.upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    Result<LabelOutlined> outlined = placed(edit, volume.geometry);
    if (!outlined)
        return outlined;
    outlined->target = {
        .plane = (*segment)->plane, .label = std::uint8_t((*segment)->label), .overwritable = {}};
    outlined->erase = edit.erase;
    if (edit.overwriteUnlocked)
        outlined->target.overwritable = document.unlockedLabels((*segment)->plane);
    outlined->lowCode = codes->low;
    outlined->highCode = codes->high;
    return keepingTo(edit.editable, document, "fillOutline", *std::move(outlined));
}

Result<EngineEdit> engineEdit(const FillOutline& edit, const Document& document)
{
    return engineEditFrom(labelOutlined(edit, document));
}

RowTitle rowTitle(const FillOutline& edit, const RowFacts& row)
{
    return {.code = edit.erase ? RowTitleCode::EraseOutline : RowTitleCode::FillOutline,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {voxelsOrSeedsLost(edit.erase, row)}};
}

/// The labels and seed words of the bricks in which the outline lies, whatever became of the
/// segment since.
EditDependencies dependencies(const FillOutline& edit, const DependencyFacts& row)
{
    const Result<LabelOutlined> outlined = placed(edit, row.geometry());
    if (!outlined)
        return row.whatWasWritten();
    const std::vector<std::uint32_t> near = bricksNear(*outlined, row.grid());
    return row.alsoReading(edit.editable,
        row.labelled(std::set<std::uint32_t>(near.begin(), near.end()), row.planeOf(edit.segment)));
}

} // namespace core
