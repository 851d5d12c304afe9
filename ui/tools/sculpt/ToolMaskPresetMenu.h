// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

class QMenu;

namespace ui {

class Workspace;

/// The menu of saved masks: choose one, save the present one, delete one.
class ToolMaskPresetMenu : public QToolButton {
    Q_OBJECT

public:
    explicit ToolMaskPresetMenu(Workspace& workspace, QWidget* parent = nullptr);

    /// Saves the present mask under a name, replacing one of the same name. A blank name is
    /// ignored.
    void save(const QString& name);

private:
    void fill();
    void ask();

    Workspace& m_workspace;
    QMenu* m_menu = nullptr;
};

} // namespace ui
