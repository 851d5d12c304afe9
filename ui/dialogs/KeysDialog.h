// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace ui {

class Actions;

/// Lists what mouse, pen and keys do: the bindings of the pointer, and every action that has a
/// shortcut.
class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(const Actions& actions, QWidget* parent = nullptr);
};

} // namespace ui
