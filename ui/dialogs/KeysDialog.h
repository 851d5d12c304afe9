// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace ui {

class Actions;

/// What mouse, pen and keys do: the pointer's bindings, and every action that has keys.
class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(const Actions& actions, QWidget* parent = nullptr);
};

} // namespace ui
