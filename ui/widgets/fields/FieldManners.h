// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace ui {

/// An event filter for the behaviour of all number fields, lists and sliders of the program. The
/// wheel changes a field only while it has the focus, and does not give it the focus; it never
/// changes a closed combo box. Over a panel the wheel scrolls the panel. Keys without use in a
/// number field (letters, undo and redo) go to the window.
///
/// One object is installed on the application.
class FieldManners : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace ui
