// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/PacsSource.h"
#include "ui/tasks/BackgroundJob.h"

#include <QDialog>
#include <QStringList>

#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

class StateLine;
/// Sends files to one of the sources, by C-STORE or STOW-RS, whichever the source uses.
class SendDialog : public QDialog {
    Q_OBJECT

public:
    explicit SendDialog(const QStringList& files, QWidget* parent = nullptr);

private:
    void fillSources();
    void send();
    void showRunning(bool running);
    void reject() override;

    QStringList m_files;
    std::vector<core::PacsSource> m_sources;
    QComboBox* m_source;
    StateLine* m_state;
    QProgressBar* m_progress;
    QPushButton* m_edit;
    QPushButton* m_send;
    QPushButton* m_close;
    BackgroundJob m_job;
};

} // namespace ui
