// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/SurfaceDoubts.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace ui {

/// Where the surface deserves a second look, on demand: a list beside that of errors. Nothing of it
/// is marked by itself.
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
    bool m_looked = false;
};

} // namespace ui
