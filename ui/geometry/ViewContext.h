// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QPointF>
#include <QSizeF>

namespace ui {

/// What a tool needs to know about the view that the pointer is in: what it shows, and how pixels
/// correspond to millimetres.
struct ViewContext {
    gpu::ViewId view = 0;
    gpu::Scene scene; ///< what the view shows at present
    QSizeF sizePixels; ///< logical pixels

    [[nodiscard]] bool isSlice() const { return std::holds_alternative<gpu::SliceScene>(scene); }
    /// Logical pixel → LPS mm, on the plane of a slice, or on the target's plane of a 3D view.
    [[nodiscard]] glm::dvec3 toLps(const QPointF& pixel) const;
    [[nodiscard]] QPointF toPixel(const glm::dvec3& lps) const;
    [[nodiscard]] double mmPerPixel() const;
    /// For a 3D view: millimetres to the right of and above the target, in the view plane.
    [[nodiscard]] glm::dvec2 toViewPlaneMm(const QPointF& pixel) const;
};

} // namespace ui
