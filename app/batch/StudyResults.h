// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QFile>
#include <QJsonObject>
#include <QString>

#include <memory>

namespace app {

/// The folder with the results of one study of a batch. The holder of an object of this class is
/// the only one who works there, among all processes of this machine and, where the file system
/// locks across machines, of all machines. The lock ends with the last process that inherited it.
///
/// The file `lock` marks the folder as a batch's; nothing in a folder without it is ever replaced.
class StudyResults {
public:
    enum class Turn { Mine, Another };

    /// Makes the folder if it is missing, and tries to lock it. Errors: FileUnwritable, also for a
    /// folder with files that no batch has made.
    /// @return Mine: this object holds the lock now; Another: somebody else works there
    [[nodiscard]] core::Result<Turn> begin(const QString& folder);
    /// The file descriptor that holds the lock; −1: it is not held.
    [[nodiscard]] int lock() const { return m_lock ? m_lock->handle() : -1; }
    /// Releases the lock.
    void end();

    /// Writes a file in the folder, whole or not at all. An existing file of that name is replaced.
    static core::Result<void> write(
        const QString& folder, const char* name, const QByteArray& content);
    /// Returns the content of record.json; empty if there is none or it is invalid.
    [[nodiscard]] static QJsonObject record(const QString& folder);
    /// Whether the record says that the study is finished and all files that it names exist.
    [[nodiscard]] static bool isDone(const QString& folder);

private:
    std::unique_ptr<QFile> m_lock;
};

} // namespace app
