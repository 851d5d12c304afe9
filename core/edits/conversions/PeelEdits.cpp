// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/engine/MaskFrames.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"

#include <algorithm>

namespace core {

namespace {

/// No peel reaches farther than this along the view, however steep the surface.
constexpr double farthestPeelMm = 64.0;
constexpr double wholeVolumeMm = 10000.0;

/// Half of what an outline spans: what decides how fine the elements are.
double halfSpanMm(const std::vector<glm::dvec2>& outline)
{
    glm::dvec2 low(0.0);
    glm::dvec2 high(0.0);
    if (!outline.empty())
        low = high = outline.front();
    for (const glm::dvec2& point : outline) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return std::max(high.x - low.x, high.y - low.y) / 2.0;
}

struct OutlinedPlane {
    MaskFrame frame;
    MaskRaster mask;
};

Result<OutlinedPlane> outlinedPlane(const std::vector<glm::dvec2>& outline,
    MaskFrameOptions options, const Document& document, const QString& edit)
{
    options.maskReachMm = halfSpanMm(outline);
    const Result<MaskFrame> frame = maskFrame(options, document, edit);
    if (!frame)
        return tl::unexpected(frame.error());
    Result<MaskRaster> mask =
        maskOf(outline, frame->pitch, glm::dvec2(0.0), edit + QStringLiteral(".polygonMm"));
    if (!mask)
        return tl::unexpected(mask.error());
    return OutlinedPlane{*frame, *std::move(mask)};
}

} // namespace

Result<MaskPeel> maskPeel(const PeelCut& peel, const Document& document)
{
    Result<OutlinedPlane> plane = outlinedPlane(peel.polygonMm,
        {.view = peel.view,
            .surfaceThreshold = peel.surfaceThreshold,
            .maxDepthMm = farthestPeelMm,
            .throughGaps = peel.throughGaps,
            .restore = peel.restore,
            .hidden = peel.hidden,
            .spared = peel.spared},
        document, QStringLiteral("peel"));
    if (!plane)
        return tl::unexpected(plane.error());
    MaskPeel made{.layer = std::uint8_t(peel.layer), .frame = plane->frame};
    made.mask = std::move(plane->mask);
    if (peel.jumpMm > 0.0)
        made.jump = mm16(peel.jumpMm);
    made.laying = peel.restore ? Laying::Refill : Laying::Carve;
    return made;
}

PeelDepth peelDepth(const PeelCut& peel)
{
    return {mm16(peel.depthMm)};
}

Result<MaskScissors> maskScissors(const ScissorsCut& cut, const Document& document)
{
    if (cut.restore && cut.firstLayerOnly)
        return failure(ErrorCode::InvalidField, QStringLiteral("scissors.firstLayerOnly"),
            QStringLiteral("has no meaning while restoring"));
    Result<OutlinedPlane> plane = outlinedPlane(cut.polygonMm,
        {.view = cut.view,
            .surfaceThreshold = cut.surfaceThreshold,
            .maxDepthMm = std::min(cut.depthMm.value_or(wholeVolumeMm), wholeVolumeMm),
            .throughGaps = !cut.firstLayerOnly,
            .restore = cut.restore,
            .hidden = cut.hidden,
            .spared = cut.spared},
        document, QStringLiteral("scissors"));
    if (!plane)
        return tl::unexpected(plane.error());
    MaskScissors made{.layer = std::uint8_t(cut.layer), .frame = plane->frame};
    made.mask = std::move(plane->mask);
    made.fromSurface = cut.depthMm || cut.firstLayerOnly;
    made.laying = cut.restore ? Laying::Refill : Laying::Carve;
    return made;
}

} // namespace core
