// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace ui {

class Workspace;

/// The list of what was measured and noted. A click leads the crosshair there; Del removes what is
/// selected, as a step of undo.
class MeasurementsPanel : public Panel {
    Q_OBJECT

public:
    explicit MeasurementsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;

private:
    void refresh();
    void lead(const QListWidgetItem* item);
    void removeSelected();

    Workspace& m_workspace;
    QListWidget* m_list = nullptr;
    QPushButton* m_remove = nullptr;
    bool m_hadSomething = false;
};

} // namespace ui
