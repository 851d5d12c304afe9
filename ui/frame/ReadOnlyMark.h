// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

class Workspace;

/// A mark in the window's header which says that the open session is read-only, and why.
class ReadOnlyMark : public QLabel {
    Q_OBJECT

public:
    explicit ReadOnlyMark(Workspace& workspace, QWidget* parent = nullptr);

private:
    void follow();

    Workspace& m_workspace;
};

} // namespace ui
