// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/texts/ReportTexts.h"

#include <QWidget>

class QDialog;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;

namespace ui {

class StateLine;

/// The lower part of the export dialogs. It shows what is still missing, then the progress, and in
/// the end the report: what was written, what the check found, what a reader must know, and the
/// checksum. Below it stand the buttons that close the dialog and that begin.
class ExportRun : public QWidget {
    Q_OBJECT

public:
    /// @param name prefix of the object names of its labels: "NAMEState", "NAMEReport"
    /// @param start the dialog's button that begins; Enter presses it until there is a report
    ExportRun(const QString& name, QPushButton* start, QDialog* dialog);

    /// The lowest row of the dialog.
    /// @param other between the button that closes and the one that begins; null: none
    [[nodiscard]] QHBoxLayout* makeButtons(QPushButton* other = nullptr);

    /// Shows one sentence in place of the last one; an empty one takes no room.
    void say(const QString& sentence, const char* role = "secondary");
    /// Shows what is still missing; while something is, it cannot begin.
    void sayMissing(const QString& sentence);
    /// Shows the progress while it runs.
    void setBusy(bool busy);
    /// The same; it cannot begin then, and the other button aborts.
    void setRunning(bool running);
    void showProgress(const QString& step, int done, int total);
    void showReport(const WordedReport& report);
    /// Removes a report that no longer belongs to what the dialog shows.
    void clearReport();
    /// The same; Enter begins again.
    void expectStart();
    void showFailure(const core::Error& error);

Q_SIGNALS:
    void startRequested();
    /// The button that closes, or aborts, was pressed.
    void closeRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitReport();
    void growDialog();

    QPushButton* m_start;
    QPushButton* m_close;
    StateLine* m_state;
    QProgressBar* m_progress;
    QLabel* m_report;
    QScrollArea* m_scroll; ///< for a report longer than the dialog
};

/// Asks the user whether an existing file may be replaced. Waits for the answer.
[[nodiscard]] bool mayReplace(const QString& file, QWidget* parent);

} // namespace ui
