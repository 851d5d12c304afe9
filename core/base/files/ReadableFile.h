// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// Checks that reading a path will come to an end: it must be a regular file or a folder. Reading
/// pipes, sockets and devices could block for ever. A path that does not exist passes. Errors:
/// FileUnreadable with the reason.
[[nodiscard]] Result<void> checkReadsToAnEnd(const QString& path);

/// The same of a file that is to be there.
/// Errors: FileNotFound; FileUnreadable with the reason, of a folder too.
[[nodiscard]] Result<void> checkIsFile(const QString& path);

} // namespace core
