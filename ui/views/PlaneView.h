// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/views/SliceView.h"

namespace ui {

/// The cutting plane as a slice (seed B §3, the pen view): for drawing precisely on any plane. The
/// wheel moves it along its normal. Tri-cubic once nothing moves.
class PlaneView : public SliceView {
    Q_OBJECT

public:
    PlaneView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);

protected:
    [[nodiscard]] gpu::Scene scene() const override;
    [[nodiscard]] glm::dvec3 throughLps() const override;
    void passThrough(const glm::dvec3& placeLps) override;
    /// Only where the crosshair is.
    void paintCross(QPainter& painter, const ViewContext& shown) override;

private:
    void follow();
};

} // namespace ui
