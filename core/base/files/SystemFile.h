// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace core {

/// The system's message for an errno.
[[nodiscard]] QString systemReason(int error);

/// Writes the contents of a file, or the names in a folder, to the disk (fsync). @return whether
/// that succeeded; errno has the reason if not
bool syncToDisk(const QString& path);
/// The same for many paths, several at a time, so that the disk's journal writes them together.
/// syncfs() is not used, because it would also wait for what other programs write. @return 0, or
/// the errno of one that failed
[[nodiscard]] int syncAllToDisk(const QStringList& paths);

/// Renames a file or folder; an existing target is never replaced. Throws nothing. @return whether
/// it has the new name; errno has the reason if not (EEXIST: the name is taken)
[[nodiscard]] bool renameToFreeName(const QByteArray& from, const QByteArray& to);
/// The same for names as Qt has them, which are encoded first.
[[nodiscard]] bool renameToFreeName(const QString& from, const QString& to);

} // namespace core
