// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace ui {

class Workspace;

/// What the panel of chunks offers to begin with: the suggested number of chunks, and the few that
/// the user will most likely click on. A click on one leads the crosshair there and changes
/// nothing. Hides itself while there is neither.
class LikelySection : public QWidget {
    Q_OBJECT

public:
    explicit LikelySection(Workspace& workspace, QWidget* parent = nullptr);

private:
    void show();

    Workspace& m_workspace;
    QPushButton* m_suggested = nullptr;
    QLabel* m_title = nullptr;
    QListWidget* m_list = nullptr;
};

} // namespace ui
