// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/DownloadCache.h"
#include "ui/tasks/BackgroundJob.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QSpinBox;

namespace ui {

/// Shows how much disk space the downloaded copies take and may take, with a button that removes
/// them.
class CopiesRow : public QWidget {
    Q_OBJECT

public:
    explicit CopiesRow(const core::DownloadCache& cache, QWidget* parent = nullptr);

    /// Counts the copies again, on another thread.
    void count();
    void setClearable(bool clearable);

Q_SIGNALS:
    /// @param someStay whether copies that are in use were kept
    void cleared(int removed, bool someStay);

private:
    void clear();

    core::DownloadCache m_cache;
    QLabel* m_copies;
    QSpinBox* m_limit;
    QPushButton* m_clear;
    BackgroundJob m_job;
};

} // namespace ui
