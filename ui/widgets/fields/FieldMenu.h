// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>

namespace ui {

/// A menu that holds a form (boxes, lists and number fields) instead of actions. The tab key goes
/// from field to field, as in a dialog. In other menus it goes from action to action, and a field
/// keeps it. A click beside the fields, or on a greyed one, leaves the menu open.
class FieldMenu : public QMenu {
public:
    /// @param form taken over; all that the menu holds
    FieldMenu(QWidget* form, QWidget* parent);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;
};

} // namespace ui
