// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/texts/ReportTexts.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QScrollArea;

namespace ui {

class StateLine;

/// The lower part of the export dialogs. It shows what is still missing, then the progress, and in
/// the end the report: what was written, what the check found, what a reader must know, and the
/// checksum.
class ExportRun : public QWidget {
    Q_OBJECT

public:
    /// @param name prefix of the object names of its labels: "NAMEState", "NAMEReport"
    explicit ExportRun(const QString& name, QWidget* parent = nullptr);

    /// Shows one sentence in place of the last one; an empty one takes no room.
    void say(const QString& sentence, const char* role = "secondary");
    void setRunning(bool running);
    void showProgress(const QString& step, int done, int total);
    void showReport(const WordedReport& report);
    /// Removes a report that no longer belongs to what the dialog shows.
    void clearReport();
    void showFailure(const core::Error& error);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitReport();
    void growDialog();

    StateLine* m_state;
    QProgressBar* m_progress;
    QLabel* m_report;
    QScrollArea* m_scroll; ///< for a report longer than the dialog
};

/// Asks the user whether an existing file may be replaced. Waits for the answer.
[[nodiscard]] bool mayReplace(const QString& file, QWidget* parent);

} // namespace ui
