// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/OutlinedPlane.h"

#include "core/edits/kinds/sculpt/ToolMasks.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

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

} // namespace

Result<OutlinedPlane> outlinedPlane(const std::vector<glm::dvec2>& outline, CutFrameOptions options,
    const Document& document, const QString& edit, const char* field)
{
    options.maskReachMm = halfSpanMm(outline);
    const Result<CutFrame> frame = cutFrame(options, document, edit);
    if (!frame)
        return tl::unexpected(frame.error());
    Result<OutlineRaster> mask =
        maskOf(outline, frame->pitch, glm::dvec2(0.0), edit + u'.' + QLatin1String(field));
    if (!mask)
        return tl::unexpected(mask.error());
    return OutlinedPlane{*frame, *std::move(mask)};
}

} // namespace core
