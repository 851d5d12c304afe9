// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QFile>
#include <QJsonObject>
#include <QString>

#include <memory>

namespace app {

/// The folder with the results of one study of a batch. Whoever holds an object of this class is
/// the only one who works there, in this process or another, on this machine or (where the file
/// system locks across machines) on any; the lock ends with the last process that inherited it.
///
/// The file `lock` says that the folder is a batch's: only then is anything in it replaced.
class StudyResults {
public:
    enum class Turn { Mine, Another };

    /// Makes the folder if it is missing.
    /// @return whose turn it is; Another: somebody else works there
    /// Errors: FileExists (a folder with files that no batch made), FileUnwritable.
    [[nodiscard]] core::Result<Turn> begin(const QString& folder);
    /// The descriptor that holds the lock.
    [[nodiscard]] int lock() const { return m_lock ? m_lock->handle() : -1; }
    void end();

    /// Writes a file in the folder, whole or not at all; it may replace its like.
    static core::Result<void> write(
        const QString& folder, const char* name, const QByteArray& content);
    /// What record.json holds; empty: there is none, or it is no record.
    [[nodiscard]] static QJsonObject record(const QString& folder);
    /// Whether the record says that this was done, and all files are there that it names.
    [[nodiscard]] static bool isDone(const QString& folder);

private:
    std::unique_ptr<QFile> m_lock;
};

} // namespace app
