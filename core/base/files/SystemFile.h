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

/// Gives a file, or a folder, a name that is free; what has it is never replaced. It throws
/// nothing. @return whether it has it; errno has the reason if not (EEXIST: it is taken)
[[nodiscard]] bool renameToFreeName(const QByteArray& from, const QByteArray& to);
[[nodiscard]] bool renameToFreeName(const QString& from, const QString& to);

} // namespace core
