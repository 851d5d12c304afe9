// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"
#include "ui/tasks/ExportJob.h"
#include "ui/tasks/LabelFetch.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace ui {

class ExportOptions;
class ExportRun;
class ExportSegments;
class TargetRow;
class Workspace;

/// Exports chosen segments in one of core::exportFormats(). It shows whose study it is, the
/// segments with millilitres and remarks, missing codes and the target file; afterwards it reports
/// what was written and what the check of the file found.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Chooses a format, as the user may do afterwards too.
    void choose(core::ExportFormat format);
    /// Whether it is reading labels, writing or checking.
    [[nodiscard]] bool running() const
    {
        return m_fetch.running() || m_coverageFetch.running() || m_job.running();
    }

Q_SIGNALS:
    void exported(const QString& file);

private:
    /// A segment, and the sculpt layer from which it was made.
    struct MadeOf {
        std::uint8_t label = 0;
        std::uint8_t layer = 0;
        QString name;
    };
    void build();
    void suggestName();
    void showState();
    void showChange();
    void showFormat();
    void start();
    void takeLabels(const LabelFetch::Planes& planes);
    void write(const LabelFetch::Planes& coverages);
    void showRunning(bool running);
    void showReport(const core::ExportReport& report);
    void showFailure(const core::Error& error);
    void reject() override;

    Workspace& m_workspace;
    ExportSegments* m_segments = nullptr;
    ExportOptions* m_options = nullptr;
    QLabel* m_ticked = nullptr; ///< how many segments, and their volume
    std::vector<QPushButton*> m_tickers;
    TargetRow* m_target = nullptr;
    QString m_suggested; ///< the file as it was last named here
    ExportRun* m_run = nullptr;
    QPushButton* m_send = nullptr; ///< shown once a DICOM file was written
    /// The export under way; its segments are filled in when it is written.
    core::ExportRequest m_request;
    LabelFetch::Planes m_planes; ///< null until they are read
    std::vector<MadeOf> m_layers; ///< for a fractional SEG
    LabelFetch m_fetch;
    LabelFetch m_coverageFetch;
    ExportJob m_job;
};

} // namespace ui
