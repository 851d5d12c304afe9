// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/views/SliceView.h"

namespace ui {

/// Shows the cutting plane as a slice (the pen view, seed B §3), for precise drawing on any plane.
/// The wheel moves the plane along its normal. If the user has not chosen an interpolation it is
/// tri-cubic once nothing moves.
class PlaneView : public SliceView {
    Q_OBJECT

public:
    PlaneView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);

protected:
    [[nodiscard]] gpu::Scene scene() const override;
    [[nodiscard]] glm::dvec3 throughLps() const override;
    void passThrough(const glm::dvec3& placeLps) override;
    /// Draws only where the crosshair is.
    void paintCross(QPainter& painter, const ViewContext& shown) override;

private:
    void follow();
};

} // namespace ui
