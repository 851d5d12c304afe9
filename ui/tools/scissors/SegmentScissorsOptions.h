// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace ui {

class SeedOptions;
class SegmentScissorsTool;
class Workspace;

/// The options of the segment scissors in the option bar. They always show the tool's settings.
class SegmentScissorsOptions : public QWidget {
    Q_OBJECT

public:
    SegmentScissorsOptions(
        Workspace& workspace, SegmentScissorsTool& tool, QWidget* parent = nullptr);

private:
    void nameChoices();
    void setUpDepth();
    void showSettings();
    void takeSettings();

    SegmentScissorsTool& m_tool;
    SeedOptions* m_seeds; ///< declared first, so that the tab key visits it first
    QComboBox* m_does;
    QComboBox* m_shape;
    QDoubleSpinBox* m_depth;
    QToolButton* m_pressure;
    QCheckBox* m_allShown;
};

} // namespace ui
