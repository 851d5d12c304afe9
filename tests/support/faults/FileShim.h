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

/// One action of a program on the file system, as tests/preload/fileShim.c reports it.
struct FileEvent {
    /// "open" (for writing), "unnamed" (a file without a name), "rename", "exchange", "link",
    /// "symlink", "remove", "make" (a folder), "truncate"; of a FileFault "counts" and "fails".
    QByteArray what;
    QString path;
    /// The new name; for files that were opened or made, their permissions (octal); for a fault,
    /// the kind of call.
    QString more;
};

/// The calls of a program that are made to fail.
struct FileFault {
    QString under; ///< the folder in which they fail
    QByteArray calls = "open,write,sync,rename";
    int first = 0; ///< the first call that fails, from 1; 0: none fails, they are only counted
    int last = 0; ///< the last call that fails
    int error = 0; ///< errno; 0: only half of the bytes are written
    /// The command of the processes in which they fail, each of which counts for itself; empty: any
    QByteArray of{};
};

/// A home folder of its own for the program burin, empty at first; every action of the program on
/// the file system there is recorded.
class WatchedHome {
public:
    WatchedHome();

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    /// The folders that XDG_CACHE_HOME and similar variables name: "cache", "config", "state",
    /// "data", "run", "tmp".
    [[nodiscard]] static QStringList folders();
    /// The environment for a program whose actions are recorded in events().
    [[nodiscard]] QProcessEnvironment environment(const FileFault& fault = {}) const;
    [[nodiscard]] Outcome burin(const QStringList& arguments, const FileFault& fault = {}) const;
    /// The actions since the last call.
    [[nodiscard]] std::vector<FileEvent> events() const;

private:
    QTemporaryDir m_folder;
};

} // namespace test
