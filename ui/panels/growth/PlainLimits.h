// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace core {
struct VolumeGeometry;
}

namespace ui {

class Workspace;

/// The names of the two limits of PlainLimits, for every text that speaks of them.
[[nodiscard]] QString smoothName();
[[nodiscard]] QString necksName();

/// Sets range, step and unit of a field for the width of a passage (mm) to what is possible in a
/// volume: a narrower width would have no effect, and a wider one is refused. The field emits no
/// signal.
void showPassageWidths(QDoubleSpinBox& field, const core::VolumeGeometry& geometry);

/// The two limits of growth that most users need, in plain words: how smoothly a segment grows
/// (GrowSettings::majority in a few steps), and how narrow a neck stops it (GrowSettings::passage);
/// besides presets for kinds of structures. GrowCriteriaSection shows the same limits as numbers.
/// Both always show the workspace's settings.
class PlainLimits : public QWidget {
    Q_OBJECT

public:
    explicit PlainLimits(Workspace& workspace, QWidget* parent = nullptr);

private:
    void build();
    void buildPresets();
    void showVolume();
    void showSettings();
    void showSmooth();
    void showPresets();
    void takeSmooth();
    void takeNecks();

    Workspace& m_workspace;
    /// Item data: how many of 27 voxels must lie in the interval; 0: off. A number that is none of
    /// the steps has an item of its own while it is set.
    QComboBox* m_smooth = nullptr;
    QToolButton* m_presets = nullptr;
    QCheckBox* m_necks = nullptr;
    QDoubleSpinBox* m_width = nullptr; ///< mm
};

} // namespace ui
