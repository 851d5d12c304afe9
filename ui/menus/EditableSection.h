// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace ui {

/// The controls of the editable range, which limits the voxels that tools may change
/// (EditableSettings), for a menu of a tool's options. They always show the workspace's settings.
class EditableSection : public QWidget {
    Q_OBJECT

public:
    explicit EditableSection(Workspace& workspace, QWidget* parent = nullptr);

protected:
    /// Lists the segments anew, since some may have been added or removed.
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
