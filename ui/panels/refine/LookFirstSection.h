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

/// Lists, when the user asks for it, the places of the active segment that should be looked at
/// first. A click on a place puts the crosshair there; ticking it notes that the user has seen it.
/// Neither changes the segment.
class LookFirstSection : public QWidget {
    Q_OBJECT

public:
    /// @param second returns the mask with which the segment is compared; asked when a search
    /// begins; null: none
    LookFirstSection(Workspace& workspace, std::function<SegmentDoubts::Mask()> second,
        QWidget* parent = nullptr);

    [[nodiscard]] SegmentDoubts& doubts() { return m_doubts; }
    /// Starts a search unless one is running or the present state was searched already.
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
    bool m_ticked = false; ///< the next click only ends ticking, so it moves no crosshair
};

} // namespace ui
