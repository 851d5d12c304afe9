// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/DrillStroke.h"

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

#include <algorithm>

namespace core {

namespace {

Result<void> checkDrillRange(const char* field, double value, double minimum, double maximum)
{
    if (value >= minimum && value <= maximum)
        return {};
    return failure(ErrorCode::InvalidField, QStringLiteral("drill.") + QLatin1String(field),
        Clause::saying("%1 is outside %2 … %3", value, minimum, maximum));
}

/// How far a drill's mask lies from the sample at most.
double drillReachMm(const DrillCut& cut)
{
    const glm::ivec2 corner =
        glm::max(glm::abs(cut.mask.first), glm::abs(cut.mask.first + cut.mask.size));
    return std::max(double(cut.maskRadius), cut.frame.pitch * glm::length(glm::dvec2(corner)))
        / 65536.0;
}

} // namespace

Result<void> check(const DrillStroke& edit, const Document& document)
{
    return checkCut(edit, "drill.layer", drillCut(edit, document), document);
}

Result<bool> apply(const DrillStroke&, Document&)
{
    return false;
}

EditEffects effects(const DrillStroke&)
{
    return {.task = engineTask<DrillStroke>(),
        .standsOpen = opens<DrillStroke>(),
        .fills = fillsNothing,
        .boundToStudy = true};
}

Result<DrillCut> drillCut(const DrillStroke& stroke, const Document& document)
{
    const bool rate = stroke.mode == DrillMode::Rate;
    for (const Result<void>& check :
        {checkDrillRange("mask.radiusMm", stroke.mask.radiusMm, 0.01, 200.0),
            checkDrillRange("mask.softnessMm", stroke.mask.softnessMm, 0.0, 200.0),
            checkDrillRange("depthMm", stroke.depthMm, 0.0, 500.0),
            checkDrillRange("floorMm", stroke.floorMm, 0.0, 500.0),
            checkDrillRange("guardMm", stroke.guardMm, 0.0, 500.0),
            checkDrillRange("pressureExponent", stroke.pressureExponent, 1, 3),
            checkDrillRange("layer", stroke.layer, 1, 254)}) {
        if (!check)
            return tl::unexpected(check.error());
    }
    const Result<CutFrame> frame =
        cutFrame({.view = stroke.view,
                     .surfaceThreshold = stroke.surfaceThreshold,
                     .maskReachMm = reachMm(stroke.mask),
                     .maxDepthMm = rate ? stroke.floorMm : stroke.depthMm,
                     .throughGaps = stroke.throughGaps,
                     .restore = stroke.restore,
                     .hidden = stroke.hidden,
                     .protectedSegments = stroke.protectedSegments},
            document, QStringLiteral("drill"));
    if (!frame)
        return tl::unexpected(frame.error());
    DrillCut cut{.layer = std::uint8_t(stroke.layer), .frame = *frame};
    cut.mode = stroke.mode;
    cut.laying = stroke.restore ? Laying::Refill : Laying::Carve;
    if (stroke.guardMm > 0.0 && !stroke.throughGaps && !stroke.restore)
        cut.guard = frame->maxDepth + mm16(stroke.guardMm);
    if (isRound(stroke.mask) && stroke.mask.softnessMm == 0.0) {
        cut.maskRadius = mm16(stroke.mask.radiusMm);
        return cut;
    }
    Result<OutlineRaster> mask =
        maskUnderSample(stroke.mask, frame->pitch, QStringLiteral("drill.mask"));
    if (!mask)
        return tl::unexpected(mask.error());
    cut.mask = *std::move(mask);
    return cut;
}

Result<EngineEdit> engineEdit(const DrillStroke& edit, const Document& document)
{
    return engineEditFrom(drillCut(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(DrillStroke& edit)
{
    return std::make_unique<OpenPen>(edit.samples, [&edit](const EngineEdit& command) {
        return DrillPathSampler(edit, std::get<DrillCut>(command));
    });
}

RowTitle rowTitle(const DrillStroke& edit, const RowFacts& row)
{
    return pressedTitle(edit,
        {.carve = RowTitleCode::Drill,
            .carveByRate = RowTitleCode::DrillRate,
            .restore = RowTitleCode::RestoreDrill,
            .restoreByRate = RowTitleCode::RestoreDrillRate},
        row.statistics);
}

EditDependencies dependencies(const DrillStroke& edit, const DependencyFacts& row)
{
    const Result<DrillCut> cut = drillCut(edit, row.document);
    if (!cut)
        return reachesNothing();
    return swept(cut->frame, pathOf(edit.samples), drillReachMm(*cut),
        labelsReadBy(edit, row.document), row);
}

} // namespace core
