// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/LaserStroke.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/CutParts.h"
#include "core/edits/kinds/sculpt/OpenPen.h"
#include "core/edits/kinds/sculpt/PressedTitle.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/sculpt/LaserCut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

namespace {

/// Beam coordinates are 64-bit products: farther corners would leave them.
constexpr double largestVolumeMm = 8000.0;

Result<void> checkLaserRange(const char* field, double value, double minimum, double maximum)
{
    if (value >= minimum && value <= maximum)
        return {};
    return failure(ErrorCode::InvalidField, QStringLiteral("laser.") + QLatin1String(field),
        Clause::saying("%1 is outside %2 … %3", value, minimum, maximum));
}

/// The surface is looked at over half the mask, so that the beam follows its shape rather than the
/// noise; over a centimetre at most, and never so that samples skip what is between them.
double normalReachMm(double maskReachMm, const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    return std::clamp(
        maskReachMm / 2.0, 2.0 * finest, std::clamp(10.0, 2.0 * finest, 32.0 * finest));
}

} // namespace

Result<void> check(const LaserStroke& edit, const Document& document)
{
    return checkCut(edit, "laser.layer", laserCut(edit, document), document);
}

Result<bool> apply(const LaserStroke&, Document&)
{
    return false;
}

EditEffects effects(const LaserStroke&)
{
    return {.task = engineTask<LaserStroke>(),
        .standsOpen = opens<LaserStroke>(),
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<LaserCut> laserCut(const LaserStroke& stroke, const Document& document)
{
    for (const Result<void>& check :
        {checkLaserRange("mask.softnessMm", stroke.mask.softnessMm, 0.0, 200.0),
            checkLaserRange("depthMm", stroke.depthMm, 0.0, 500.0),
            checkLaserRange("floorMm", stroke.floorMm, 0.0, 500.0),
            checkLaserRange("pressureExponent", stroke.pressureExponent, 1, 3),
            checkLaserRange("layer", stroke.layer, 1, 254)}) {
        if (!check)
            return tl::unexpected(check.error());
    }
    const double maskReachMm = reachMm(stroke.mask);
    const Result<CutFrame> frame =
        cutFrame({.view = stroke.view,
                     .surfaceThreshold = stroke.surfaceThreshold,
                     .maskReachMm = maskReachMm,
                     .maxDepthMm = stroke.mode == DrillMode::Rate ? stroke.floorMm : stroke.depthMm,
                     .throughGaps = stroke.throughGaps,
                     .restore = stroke.restore,
                     .hidden = stroke.hidden,
                     .protectedSegments = stroke.protectedSegments},
            document, QStringLiteral("laser"));
    if (!frame)
        return tl::unexpected(frame.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (glm::length(geometry.cornersLps().back() - geometry.cornersLps().front()) > largestVolumeMm)
        return failure(ErrorCode::InvalidField, QStringLiteral("laser"),
            Clause::saying("the volume is larger than 8 m"));
    Result<OutlineRaster> mask =
        maskUnderSample(stroke.mask, frame->pitch, QStringLiteral("laser.mask"));
    if (!mask)
        return tl::unexpected(mask.error());
    LaserCut cut{.layer = std::uint8_t(stroke.layer), .frame = *frame};
    cut.restore = std::exchange(cut.frame.restore, false);
    cut.frame.asWhole = cut.restore;
    cut.mask = *std::move(mask);
    cut.mode = stroke.mode;
    cut.normalStep =
        std::max(mm16(normalReachMm(maskReachMm, geometry) / LaserCut::normalReach), 1);
    // A concave surface rises above the mask towards its rim.
    cut.lift = std::max(mm16(maskReachMm / 2.0), frame->front);
    cut.laying = stroke.restore ? Laying::Refill : Laying::Carve;
    return cut;
}

double laserReachMm(const LaserCut& cut)
{
    const glm::ivec2 corner =
        glm::max(glm::abs(cut.mask.first), glm::abs(cut.mask.first + cut.mask.size));
    const double across =
        cut.frame.pitch * std::sqrt(double(corner.x) * corner.x + double(corner.y) * corner.y);
    return (across + cut.frame.maxDepth + cut.lift + double(cut.normalStep) * LaserCut::normalReach)
        / 65536.0;
}

Result<EngineEdit> engineEdit(const LaserStroke& edit, const Document& document)
{
    return engineEditFrom(laserCut(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(LaserStroke& edit)
{
    return std::make_unique<OpenPen>(edit.samples, [&edit](const EngineEdit& command) {
        return DrillPathSampler(edit, std::get<LaserCut>(command));
    });
}

RowTitle rowTitle(const LaserStroke& edit, const RowFacts& row)
{
    return pressedTitle(edit,
        {.carve = RowTitleCode::Laser,
            .carveByRate = RowTitleCode::LaserRate,
            .restore = RowTitleCode::RestoreLaser,
            .restoreByRate = RowTitleCode::RestoreLaserRate},
        row.statistics);
}

/// As of a drill, and as far as its beams reach sideways.
EditDependencies dependencies(const LaserStroke& edit, const DependencyFacts& row)
{
    const Result<LaserCut> cut = laserCut(edit, row.document);
    if (!cut)
        return reachesNothing();
    return swept(cut->frame, pathOf(edit.samples), laserReachMm(*cut),
        labelsReadBy(edit, row.document), row);
}

} // namespace core
