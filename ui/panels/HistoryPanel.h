// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/Panel.h"

class QListView;

namespace ui {

class HistoryModel;
class Workspace;

/// What was done, oldest first; a double click (or Return) walks there. The menu of a row also
/// undoes that step alone.
class HistoryPanel : public Panel {
    Q_OBJECT

public:
    explicit HistoryPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool stretches() const override { return true; }

private:
    void goTo(const QModelIndex& index);
    void undoOnly(const QModelIndex& index);
    void showMenu(const QPoint& position);

    Workspace& m_workspace;
    HistoryModel* m_model = nullptr;
    QListView* m_view = nullptr;
};

} // namespace ui
