// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/Panel.h"

class QListView;

namespace ui {

class HistoryModel;
class Workspace;

/// What was done, oldest first; a double click (or Return) walks there.
class HistoryPanel : public Panel {
    Q_OBJECT

public:
    explicit HistoryPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool stretches() const override { return true; }

private:
    void goTo(const QModelIndex& index);

    Workspace& m_workspace;
    HistoryModel* m_model = nullptr;
    QListView* m_view = nullptr;
};

} // namespace ui
