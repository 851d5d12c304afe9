// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QScrollArea;

namespace ui {

class StateLine;

/// The lower part of the export dialogs: what is missing yet, how far the work is, and the verdict:
/// what was written, what the check of it found, what its reader must know, its checksum.
class ExportRun : public QWidget {
    Q_OBJECT

public:
    /// @param name begins the object names of its labels: "NAMEState", "NAMEReport"
    explicit ExportRun(const QString& name, QWidget* parent = nullptr);

    /// One sentence in place of the last one; empty takes no room.
    void say(const QString& sentence, const char* role = "secondary");
    void setRunning(bool running);
    void showProgress(const QString& step, int done, int total);
    void showReport(const core::ExportReport& report);
    /// Of a report that no longer belongs to what the dialog shows.
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
    QScrollArea* m_scroll; ///< of a report that has more lines than a dialog has room for
};

/// Asks whether a file that is there may go. Waits for the answer.
[[nodiscard]] bool mayReplace(const QString& file, QWidget* parent);

} // namespace ui
