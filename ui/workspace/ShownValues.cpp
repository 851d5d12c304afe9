// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ShownValues.h"

#include <QObject>

#include <algorithm>

namespace ui {

namespace {

ShownValues opaqueValues(const gpu::TransferFunction& function)
{
    double greatest = 0.0;
    for (const gpu::TransferFunction::Point& point : function.points)
        greatest = std::max(greatest, point.opacity);
    if (greatest <= 0.0)
        return {
            .lower = {}, .upper = {}, .why = QObject::tr("The transfer function shows nothing")};
    const double half = greatest / 2.0;
    // Where the line through the points crosses half; before the first and after the last it is
    // flat.
    std::vector<std::pair<std::optional<double>, std::optional<double>>> intervals;
    bool inside = function.points.front().opacity >= half;
    if (inside)
        intervals.emplace_back();
    for (std::size_t i = 1; i < function.points.size(); ++i) {
        const gpu::TransferFunction::Point& a = function.points[i - 1];
        const gpu::TransferFunction::Point& b = function.points[i];
        if ((b.opacity >= half) == inside)
            continue;
        const double value =
            a.value + (b.value - a.value) * (half - a.opacity) / (b.opacity - a.opacity);
        inside = !inside;
        if (inside)
            intervals.emplace_back(value, std::nullopt);
        else
            intervals.back().second = value;
    }
    if (intervals.size() > 1)
        return {.lower = {},
            .upper = {},
            .why = QObject::tr("The transfer function shows several ranges of values; show one of "
                               "them, or a surface")};
    return {.lower = intervals.front().first, .upper = intervals.front().second, .why = {}};
}

} // namespace

ShownValues shownValues(const Workspace::VolumeDisplay& display)
{
    switch (display.mode) {
    case gpu::RenderMode::Surface:
        return {.lower = display.surfaceThreshold, .upper = {}, .why = {}};
    case gpu::RenderMode::Dvr:
        return opaqueValues(display.transferFunction);
    case gpu::RenderMode::Mip:
    case gpu::RenderMode::Xray:
        break;
    }
    return {.lower = {},
        .upper = {},
        .why = QObject::tr("Show an isosurface or volume rendering first: this one has no threshold")};
}

} // namespace ui
