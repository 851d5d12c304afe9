// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/SurfaceDoubts.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace ui {

/// Lists places of the surface that deserve a second look, on demand, beside the list of errors.
/// Nothing is marked automatically.
class DoubtsSection : public QWidget {
    Q_OBJECT

public:
    explicit DoubtsSection(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] SurfaceDoubts& doubts() { return m_doubts; }

private:
    void show();

    Workspace& m_workspace;
    SurfaceDoubts m_doubts;
    QPushButton* m_look = nullptr;
    QLabel* m_found = nullptr;
    QListWidget* m_list = nullptr;
};

} // namespace ui
