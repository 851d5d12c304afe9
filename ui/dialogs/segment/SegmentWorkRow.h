// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include <optional>

class QProgressBar;
class QPushButton;

namespace ui {

class Workspace;

/// The last row of a dialog that has an edit of a whole segment worked out and stays open meanwhile
/// (core/session/SegmentWork.h): how far it is, aborting it, having it done, closing the dialog.
class SegmentWorkRow : public QWidget {
    Q_OBJECT

public:
    /// @param name with which its widgets are found: "Reshape" for "reshapeProgress",
    /// "abortReshape" and "applyReshape"
    /// @param text of the button that has it done, which is the dialog's default
    SegmentWorkRow(Workspace& workspace, const QString& name, const QString& text, QWidget* dialog);

    /// @param why it cannot be done; empty: it can, unless something is being worked out
    void showWhyNot(const QString& why);
    /// Watches what has just been begun.
    void follow();
    void focusApply();

Q_SIGNALS:
    void asked(); ///< to have it done
    void closed();
    void looked(); ///< again and again, while something is being worked out, and when it ended

private:
    void look();
    [[nodiscard]] std::optional<int> percentDone() const; ///< none: nothing is being worked out

    Workspace& m_workspace;
    QProgressBar* m_progress;
    QPushButton* m_abort;
    QPushButton* m_apply;
    QTimer m_watching; ///< while it is being worked out
};

} // namespace ui
