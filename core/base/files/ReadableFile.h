// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// Whether what a path leads to can be read to an end: a plain file or a folder. Pipes, sockets and
/// devices would be waited for without end. What is not there passes.
/// Errors: FileUnreadable with the reason.
[[nodiscard]] Result<void> checkReadsToAnEnd(const QString& path);

/// The same of a file that is to be there.
/// Errors: FileNotFound; FileUnreadable with the reason, of a folder too.
[[nodiscard]] Result<void> checkIsFile(const QString& path);

} // namespace core
