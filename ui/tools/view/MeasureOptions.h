// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QToolButton;

namespace ui {

class MeasureTool;
class Workspace;

/// The options of the measuring tool in the option bar: the kind of measurement, the text of an
/// arrow or note, and a menu that removes measurements.
class MeasureOptions : public QWidget {
    Q_OBJECT

public:
    MeasureOptions(Workspace& workspace, MeasureTool& tool, QWidget* parent);

private:
    void showTool();
    void showCount();
    void fillMenu();

    Workspace& m_workspace;
    MeasureTool& m_tool;
    QComboBox* m_kinds = nullptr;
    QLineEdit* m_text = nullptr;
    QToolButton* m_list = nullptr;
};

/// Removes a measurement, as a step that can be undone.
void removeMeasurement(Workspace& workspace, int measurement);

} // namespace ui
