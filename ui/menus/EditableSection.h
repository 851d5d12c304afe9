// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace ui {

/// Which voxels all tools that write labels may change (EditableSettings), for the menu of a button
/// of a tool's options; always in step with the workspace.
class EditableSection : public QWidget {
    Q_OBJECT

public:
    explicit EditableSection(Workspace& workspace, QWidget* parent = nullptr);

protected:
    /// Segments may have come or gone since.
    void showEvent(QShowEvent* event) override;

private:
    void showSettings();
    void listPlaces();
    void take();
    void takeValues();

    Workspace& m_workspace;
    QCheckBox* m_on;
    QCheckBox* m_byValue;
    QDoubleSpinBox* m_lower;
    QDoubleSpinBox* m_upper;
    QComboBox* m_where;
    QCheckBox* m_boxed;
};

} // namespace ui
