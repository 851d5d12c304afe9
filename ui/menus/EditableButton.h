// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QLabel>
#include <QToolButton>

namespace ui {

/// A button that says which voxels may be edited (the editable range) and has an EditableSection as
/// its menu. It is for tools whose options have no other menu for that section.
class EditableButton : public QToolButton {
    Q_OBJECT

public:
    explicit EditableButton(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showState();

    Workspace& m_workspace;
};

/// The same text as a label for dialogs. It is hidden while the editable range is off.
class EditableNote : public QLabel {
    Q_OBJECT

public:
    explicit EditableNote(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showState();

    Workspace& m_workspace;
};

} // namespace ui
