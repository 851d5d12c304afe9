// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/SegmentDoubts.h"

#include <QWidget>

#include <functional>

class QLabel;
class QListWidget;
class QPushButton;

namespace ui {

class Workspace;

/// Lists, on demand, the places of the active segment to look at first. A click on one leads the
/// crosshair there; its tick says that the user has seen it. Neither changes anything.
class LookFirstSection : public QWidget {
    Q_OBJECT

public:
    /// @param second the mask with which the segment is compared when a search begins, if any
    LookFirstSection(Workspace& workspace, std::function<SegmentDoubts::Mask()> second,
        QWidget* parent = nullptr);

    [[nodiscard]] SegmentDoubts& doubts() { return m_doubts; }
    /// Starts a search, unless one is under way or the present state has been searched.
    void lookOnce();

private:
    void lookOrAbort();
    void show();
    void fill(const SegmentDoubts::Found& found);
    [[nodiscard]] QString stateText() const;

    Workspace& m_workspace;
    SegmentDoubts m_doubts;
    std::function<SegmentDoubts::Mask()> m_second;
    QPushButton* m_look = nullptr;
    QLabel* m_state = nullptr;
    QListWidget* m_list = nullptr;
    bool m_ticked = false; ///< the click that comes is on a tick, which leads nowhere
};

} // namespace ui
