// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

class QAction;
class QMenu;

namespace ui {

/// A button that says which voxels may be edited (the editable range) and has an EditableSection as
/// its menu. It is for tools whose options have no other menu for that section, for panels and for
/// dialogs.
class EditableButton : public QToolButton {
    Q_OBJECT

public:
    enum class In {
        Bar, ///< as narrow as the option bar of a tool needs it
        Column, ///< as wide as a panel or a dialog
    };
    explicit EditableButton(Workspace& workspace, QWidget* parent = nullptr, In place = In::Bar);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showState();

    Workspace& m_workspace;
    In m_place;
};

/// The same text as an entry of a menu of what is done to segments, which cannot be chosen. It is
/// hidden while the editable range is off, and follows it whenever the menu opens.
/// @param before the action before which it is inserted; null: at the end
void addEditableNote(QMenu& menu, QAction* before, Workspace& workspace);

} // namespace ui
