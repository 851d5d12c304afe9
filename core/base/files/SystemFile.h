// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// What the system says of an errno, in words.
[[nodiscard]] QString systemReason(int error);

/// Has what was written to a file, or which names a folder holds, on the disk (fsync). @return
/// whether it is; errno says why not
bool syncToDisk(const QString& path);

} // namespace core
