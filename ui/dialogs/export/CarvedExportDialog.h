// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/ExportJob.h"
#include "ui/tasks/LabelFetch.h"

#include <QDialog>

class QDoubleSpinBox;
class QLabel;
class QRadioButton;

namespace ui {

class DeidentifyBox;
class ExportRun;
class TargetRow;
class Workspace;

/// Exports the study without its carved voxels, as a new DICOM series or NIfTI, or the coverage of
/// the active sculpt layer. Afterwards it reports what was written and what the check of the file
/// found. Nothing is sent anywhere.
class CarvedExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit CarvedExportDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Whether it is reading coverage, writing or checking.
    [[nodiscard]] bool running() const { return m_fetch.running() || m_job.running(); }

Q_SIGNALS:
    void exported(const QString& target);

private:
    void build();
    void suggestTarget();
    void suggestName();
    [[nodiscard]] QString nameOfTarget() const;
    void showState();
    void start();
    void write(const LabelFetch::Planes& layers);
    void showRunning(bool running);
    void showReport(const core::ExportReport& report);
    void showFailure(const core::Error& error);
    void reject() override;

    Workspace& m_workspace;
    QRadioButton* m_series = nullptr;
    QRadioButton* m_nifti = nullptr;
    QRadioButton* m_coverage = nullptr;
    QDoubleSpinBox* m_fill = nullptr;
    double m_least = 0.0; ///< the study's least value, as the field shows it
    QLabel* m_fillLabel = nullptr;
    TargetRow* m_target = nullptr;
    QString m_suggested; ///< the target as it was last named here
    DeidentifyBox* m_deidentify = nullptr; ///< for the DICOM series only
    ExportRun* m_run = nullptr;
    bool m_force = false;
    LabelFetch m_fetch;
    ExportJob m_job;
};

} // namespace ui
