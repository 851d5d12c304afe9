// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/frame/Panel.h"
#include "ui/panels/AxisSliders.h"

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace ui {

class VolumeView;
class Workspace;

/// Limits what the 3D view shows without carving anything: by a box and up to three planes, with a
/// choice of how cut faces look. Nothing here is a step of undo.
class ClippingPanel : public Panel {
    Q_OBJECT

public:
    /// @param view the 3D view whose camera a new plane faces
    ClippingPanel(Workspace& workspace, VolumeView& view, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }

private:
    struct PlaneRow {
        QCheckBox* on = nullptr;
        QSlider* offset = nullptr; ///< tenths of a millimetre from the volume's middle
        QLabel* text = nullptr;
        QToolButton* place = nullptr;
        QToolButton* flip = nullptr;
        QToolButton* look = nullptr;
    };

    void build();
    void showVolume();
    void showClip();
    void takeBox(bool on);
    void takeAxis(int axis, double lower, double upper);
    void takeOffset(std::size_t row, double offsetMm);
    /// Places a plane through the crosshair; it hides what lies in front of it.
    void place(std::size_t row);
    void change(std::size_t row, const core::ClipPlane& plane);
    void reset();
    [[nodiscard]] double offsetOf(const core::ClipPlane& plane) const; ///< mm

    Workspace& m_workspace;
    VolumeView& m_view;
    QCheckBox* m_box = nullptr;
    QToolButton* m_reset = nullptr;
    AxisSliders m_axes;
    std::array<QLabel*, 3> m_axisTexts{}; ///< from where to where, in mm
    std::array<PlaneRow, 3> m_planes;
    QComboBox* m_faces = nullptr;
};

} // namespace ui
