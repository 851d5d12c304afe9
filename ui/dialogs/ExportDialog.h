// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/ExportChoices.h"
#include "core/export/ExportMask.h"
#include "ui/dialogs/ExportJob.h"
#include "ui/dialogs/LabelFetch.h"

#include <QDialog>

#include <bitset>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// Export of chosen segments in one of core::exportFormats(): whose study it is, which segments
/// with their millilitres and remarks, codes where they are missing, the file; then what was
/// written and what the check of the file found.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Reading labels, writing or checking.
    [[nodiscard]] bool running() const { return m_fetch.running() || m_job.running(); }

Q_SIGNALS:
    void exported(const QString& file);

private:
    void build();
    QWidget* identityBlock();
    void fillFormats();
    void fillSegments();
    void showState();
    void showFormat();
    void chooseCode(QTreeWidgetItem* item);
    void browse();
    void start();
    void write(const std::vector<ExportJob::Plane>& planes);
    void showRunning(bool running);
    void showProgress(const QString& step, int done, int total);
    void showReport(const core::ExportReport& report);
    void showFailure(const core::Error& error);
    void reject() override;
    [[nodiscard]] core::ExportFormat format() const;
    [[nodiscard]] std::vector<core::Segment> chosen() const;

    Workspace& m_workspace;
    QTreeWidget* m_segments = nullptr;
    QComboBox* m_format = nullptr;
    QLabel* m_formatSays = nullptr;
    QComboBox* m_space = nullptr; ///< of surfaces
    QLabel* m_spaceName = nullptr;
    QLabel* m_obstacle = nullptr;
    QLineEdit* m_file = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_report = nullptr;
    QPushButton* m_browse = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_send = nullptr; ///< once there is a DICOM file
    QPushButton* m_close = nullptr;
    std::bitset<256> m_unticked; ///< labels the user took the tick from, or that began without
    bool m_filling = false;
    core::ExportRequest m_request; ///< under way; its segments are taken when it is written
    LabelFetch m_fetch;
    ExportJob m_job;
};

/// Segments whose growth may go on: it was seeded and has not been told to be at closure.
[[nodiscard]] std::bitset<256> growingLabels(core::EditSession& session);

} // namespace ui
