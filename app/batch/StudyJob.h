// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/batch/StudyAttempt.h"
#include "app/batch/StudyList.h"
#include "app/batch/StudyResults.h"

#include <QDateTime>
#include <QElapsedTimer>
#include <QProcess>
#include <QStringList>

#include <memory>

namespace app {

/// One study of a batch and what is to be done with it.
struct StudyTask {
    BatchStudy study;
    QString folder; ///< of its results, absolute
    QByteArray recipe; ///< filled
    QString recipePath; ///< of the recipe that it was filled from
    QStringList options; ///< of `burin run` besides
    int retries = 0;
};

/// A study that a child process (`burin run`) works on: a crash of it costs this study only. The
/// child ends with this process, however that ends. The record is written when it begins and when
/// it ends.
class StudyJob {
public:
    /// @pre @p results has its turn
    StudyJob(StudyTask task, StudyResults results);

    /// Removes what an earlier attempt left unfinished, writes recipe and record, and starts the
    /// child. Errors: FileUnwritable, also if a result's name is taken by what no attempt at this
    /// study made.
    core::Result<void> begin();
    /// Looks whether the child has ended, and starts it again where a retry is due.
    /// @return whether the job is over; its record is on disk
    [[nodiscard]] bool isOver();
    /// Tells the child to end. A study that is told so is not finished, and not tried again.
    void stop();

    [[nodiscard]] const StudyTask& task() const { return m_task; }
    [[nodiscard]] bool succeeded() const { return m_succeeded; }
    /// Why not, for people.
    [[nodiscard]] const QString& failure() const { return m_failure; }

private:
    void start();
    void conclude();
    void readOutput();
    void takeResults();
    [[nodiscard]] core::Result<void> writeRecord();

    StudyTask m_task;
    StudyResults m_results;
    StudyAttempt m_attempt;
    std::unique_ptr<QProcess> m_process;
    QJsonObject m_record;
    QElapsedTimer m_clock;
    int m_attempts = 0;
    bool m_stopped = false;
    bool m_mayBeTransient = false;
    bool m_succeeded = false;
    QString m_failure;
};

} // namespace app
