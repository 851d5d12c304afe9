// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace ui {

/// How every number field, list and slider of the program behaves. The wheel changes one only while
/// it has the focus, and gives it none; a list that is folded up it never changes. Over a panel it
/// scrolls the panel. In a number field the
/// keys that are of no use there (letters, undo and redo) are the window's.
///
/// One, installed on the application.
class FieldManners : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace ui
