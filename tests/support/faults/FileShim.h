// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/servers/BurinProgram.h"

#include <QByteArray>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <vector>

namespace test {

/// One thing that a program did to the file system, as tests/preload/fileShim.c tells it.
struct FileEvent {
    /// "open" (for writing), "unnamed" (a file without a name), "rename", "exchange", "link",
    /// "symlink", "remove", "make" (a folder), "truncate"; of a FileFault "counts" and "fails".
    QByteArray what;
    QString path;
    /// The new name; where something was opened or made, who may use it (octal); of a fault, the
    /// kind of call.
    QString more;
};

/// Calls of a program that fail.
struct FileFault {
    QString under; ///< the folder in which they do
    QByteArray calls = "open,write,sync,rename";
    int first = 0; ///< the first of these calls that fails, from 1; 0: none, they are counted
    int last = 0; ///< the last one
    int error = 0; ///< errno; 0: half of what is to be written is written
};

/// A home of its own for the program burin, empty at first, in which all that it does to the file
/// system is told.
class WatchedHome {
public:
    WatchedHome();

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    /// What XDG_CACHE_HOME and the like name: "cache", "config", "state", "data", "run", "tmp".
    [[nodiscard]] static QStringList folders();
    /// Where a program runs that is to be told of; it tells in events().
    [[nodiscard]] QProcessEnvironment environment(const FileFault& fault = {}) const;
    [[nodiscard]] Outcome burin(const QStringList& arguments, const FileFault& fault = {}) const;
    /// What was told since the last call.
    [[nodiscard]] std::vector<FileEvent> events() const;

private:
    QTemporaryDir m_folder;
};

} // namespace test
