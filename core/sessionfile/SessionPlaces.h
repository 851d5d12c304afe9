// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QString>

namespace core {

/// An empty file for a new session, readable by its owner only. Errors: FileExists,
/// FileUnwritable.
[[nodiscard]] Result<void> makeEmptySession(const QString& path);

/// Whether there is a file that can be opened so, whatever it holds. Errors: FileNotFound,
/// FileUnreadable, FileTruncated (empty), FileUnwritable.
[[nodiscard]] Result<void> checkSessionToOpen(const QString& path, SessionAccess access);

/// Whether a session that is there, and not the one at hand, may be replaced. Errors:
/// FileUnwritable.
[[nodiscard]] Result<void> checkOtherSessionAt(const QString& target);

/// Whether a path is to be opened as a session, by name (.burin) or content: it may still be
/// damaged, or not be one.
[[nodiscard]] bool isSessionNamedAt(const QString& path);

} // namespace core
