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

/// A study of a batch and how to work on it.
struct StudyTask {
    BatchStudy study;
    QString folder; ///< for its results, absolute
    QByteArray recipe; ///< filled
    QString recipePath; ///< the recipe with placeholders
    QStringList options; ///< further options of `burin run`
    int retries = 0;
};

/// Returns as a sentence in what the finished results in the task's folder differ from what this
/// task asks for: another study, recipe, series, repair, spacing, session file or option (another
/// author's name changes nothing). Empty: they do not differ. What the record of an older batch
/// does not contain counts as the same.
[[nodiscard]] QString whyOther(const StudyTask& task, const QJsonObject& record);

/// Works on one study in a child process (`burin run`), so a crash costs this study only. The child
/// also ends when this process ends in any way. The record is written at the beginning of each
/// attempt and at the end.
class StudyJob {
public:
    /// @pre @p results holds the lock of the study's folder (Turn::Mine)
    StudyJob(StudyTask task, StudyResults results);

    /// Removes unfinished files of an earlier attempt, writes recipe and record, and starts the
    /// child. Errors: FileUnwritable, also if the name of a result is taken by a file that no
    /// attempt at this study made.
    core::Result<void> begin();
    /// Checks whether the child has ended, and starts it again if a retry is due.
    /// @return whether the job is over; its record is on disk then
    [[nodiscard]] bool isOver();
    /// Tells the child to end. The study then counts as not finished and is not tried again.
    void stop();

    [[nodiscard]] const StudyTask& task() const { return m_task; }
    [[nodiscard]] bool succeeded() const { return m_succeeded; }
    /// Why it has not succeeded, as a sentence.
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
    int m_attemptsBefore = 0; ///< of earlier jobs, since the study was last done
    bool m_stopped = false;
    bool m_mayBeTransient = false;
    bool m_succeeded = false;
    /// The folder holds finished results of an earlier job, which stay until new ones are complete.
    bool m_keepsDone = false;
    QString m_failure;
};

} // namespace app
