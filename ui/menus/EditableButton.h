// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QLabel>
#include <QToolButton>

namespace ui {

/// A button that says to which voxels editing is limited, and has an EditableSection as its menu,
/// for tools whose options have no other menu for it.
class EditableButton : public QToolButton {
    Q_OBJECT

public:
    explicit EditableButton(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showState();

    Workspace& m_workspace;
};

/// The same as a sentence, for dialogs; hidden while the range is off.
class EditableNote : public QLabel {
    Q_OBJECT

public:
    explicit EditableNote(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showState();

    Workspace& m_workspace;
};

} // namespace ui
