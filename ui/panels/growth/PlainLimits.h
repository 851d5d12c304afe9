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

/// The names of these two limits, wherever the panel speaks of them.
[[nodiscard]] QString smoothName();
[[nodiscard]] QString necksName();

/// Gives a field for the width of a passage the widths that are possible in a volume: a narrower
/// one would have no effect, a wider one is refused. The field says nothing of it.
void showPassageWidths(QDoubleSpinBox& field, const core::VolumeGeometry& geometry);

/// The two limits of growth that every user wants, in plain words, below its tolerance: how smooth
/// a segment grows (GrowSettings::majority in few steps), and how narrow a neck stops it
/// (GrowSettings::passage), with presets for kinds of structures. GrowCriteriaSection has the same
/// limits as numbers; both show what the settings say, whoever changes them.
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
    /// Its data are the numbers of 27 voxels; 0: off. A number that is none of the steps is one
    /// more line while it is set.
    QComboBox* m_smooth = nullptr;
    QToolButton* m_presets = nullptr;
    QCheckBox* m_necks = nullptr;
    QDoubleSpinBox* m_width = nullptr; ///< mm
};

} // namespace ui
