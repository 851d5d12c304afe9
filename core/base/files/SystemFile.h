// SPDX-License-Identifier: Apache-2.0
#pragma once

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

} // namespace core
