// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace ui {

class Workspace;

/// The suggestions of the panel of chunks: a button with the suggested number of chunks, and a list
/// of the few chunks that are most likely wrong. A click on a chunk puts the crosshair there and
/// changes nothing. Hidden while there are no suggestions.
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
