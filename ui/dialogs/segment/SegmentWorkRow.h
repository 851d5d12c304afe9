// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include <optional>

class QProgressBar;
class QPushButton;

namespace ui {

class Workspace;

/// The last row of a dialog that starts an edit of a whole segment and stays open while that is
/// computed (core/session/SegmentWork.h): a progress bar and the buttons Abort, Apply and Close.
class SegmentWorkRow : public QWidget {
    Q_OBJECT

public:
    /// @param name part of the object names of its widgets: "Reshape" gives "reshapeProgress",
    /// "abortReshape" and "applyReshape"
    /// @param text of the apply button, which is the dialog's default button
    SegmentWorkRow(Workspace& workspace, const QString& name, const QString& text, QWidget* dialog);

    /// Enables the apply button if @p why is empty and nothing is being computed but a preview;
    /// otherwise shows @p why as its tool tip.
    void showWhyNot(const QString& why);
    /// Starts to show the progress. Call it right after the edit or its preview was started.
    void follow();
    /// Gives the apply button the keyboard focus.
    void focusApply();

Q_SIGNALS:
    void asked(); ///< the apply button was pressed
    /// The close button was pressed.
    void closed();
    void looked(); ///< several times a second while an edit is computed, and once when it has ended

private:
    void look();
    [[nodiscard]] std::optional<int> percentDone() const; ///< none: nothing is being computed

    Workspace& m_workspace;
    QProgressBar* m_progress;
    QPushButton* m_abort;
    QPushButton* m_apply;
    QTimer m_watching; ///< runs while an edit is computed
};

} // namespace ui
