// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

class QMenu;

namespace ui {

class Workspace;

/// The masks that the user has saved: choose one, save the present one, forget one.
class MaskPresetMenu : public QToolButton {
    Q_OBJECT

public:
    explicit MaskPresetMenu(Workspace& workspace, QWidget* parent = nullptr);

    /// Saves the present mask. A name of blanks is none; one that is there is replaced.
    void save(const QString& name);

private:
    void fill();
    void ask();

    Workspace& m_workspace;
    QMenu* m_menu = nullptr;
};

} // namespace ui
