// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

class QShortcut;

namespace ui {

class LoadingBar;
class Workspace;

/// Shows in a bar the progress of an edit of a whole segment that is being computed or carried out
/// (core/session/SegmentWork.h), wherever it was requested, and aborts it when the bar's Abort is
/// pressed, or Esc while no stroke is open. Edits that take less than about half a second show no
/// bar, and neither do previews: their dialogs do.
class SegmentWorkWatch : public QObject {
    Q_OBJECT

public:
    /// @param bar becomes its parent
    SegmentWorkWatch(Workspace& workspace, LoadingBar& bar);

private:
    void look();
    void abort();

    Workspace& m_workspace;
    LoadingBar& m_bar;
    QShortcut* m_escape; ///< on while there is work to abort and no stroke is open
    QTimer m_looks; ///< runs while a session is open
    bool m_works = false;
};

} // namespace ui
