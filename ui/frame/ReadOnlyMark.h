// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

class Workspace;

/// In the window's header while the open session is only looked at: that it is, and why.
class ReadOnlyMark : public QLabel {
    Q_OBJECT

public:
    explicit ReadOnlyMark(Workspace& workspace, QWidget* parent = nullptr);

private:
    void follow();

    Workspace& m_workspace;
};

} // namespace ui
