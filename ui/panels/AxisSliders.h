// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"

#include <array>

class QGridLayout;
class QLabel;
class QString;
class QWidget;

namespace ui {

class RangeSlider;

/// A box along the volume's axes, as panels show it: a slider for each axis, in mm from the
/// volume's low side, between the letters of where its ends lie in the patient.
class AxisSliders {
public:
    /// Takes the first three columns of the first three rows of a grid.
    /// @param name of the sliders, with the number of the axis behind
    void build(QWidget* parent, QGridLayout& grid, const QString& name);

    [[nodiscard]] RangeSlider* of(int axis) const { return m_rows[std::size_t(axis)].slider; }
    /// Its letters, and how long it is along each axis.
    void showVolume(const core::VolumeGeometry& geometry);
    void showBox(const core::ClipRegion::Box& box, const core::VolumeGeometry& geometry);

private:
    struct Row {
        QLabel* low = nullptr;
        QLabel* high = nullptr;
        RangeSlider* slider = nullptr;
    };
    std::array<Row, 3> m_rows;
};

} // namespace ui
