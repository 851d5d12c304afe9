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
/// Many of them, several at a time, which the disk's journal takes together; not by syncfs(), which
/// waits for whatever all others write. @return 0, or the errno of one that failed
[[nodiscard]] int syncAllToDisk(const QStringList& paths);

/// Gives a file, or a folder, a name that is free; what has that name is never replaced. Throws
/// nothing. @return whether it has the name; errno has the reason if not (EEXIST: it is taken)
[[nodiscard]] bool renameToFreeName(const QByteArray& from, const QByteArray& to);
/// The same for names as Qt has them, which are encoded first.
[[nodiscard]] bool renameToFreeName(const QString& from, const QString& to);

} // namespace core
