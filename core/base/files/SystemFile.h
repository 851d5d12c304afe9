// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// The system's message for an errno.
[[nodiscard]] QString systemReason(int error);

/// Writes the contents of a file, or the names in a folder, to the disk (fsync). @return whether
/// that succeeded; errno has the reason if not
bool syncToDisk(const QString& path);

} // namespace core
