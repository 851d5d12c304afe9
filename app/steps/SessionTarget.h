// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace app {

// The file that a command leaves its session in. With --force a new session is made beside the old
// one, and takes its place when it is whole.

/// Whether a session can be written to @p file. It can be asked without loading anything, and is to
/// be asked once more when it is known which files the study is made of. A session that was left
/// open is closed first, as opening it would. Errors: FileNotFound (nothing to append to),
/// FileExists, FileUnwritable.
[[nodiscard]] core::Result<void> checkSessionTarget(const QString& file, bool force, bool append);

/// Why a session that was closed is not one file, in words; empty: it is.
[[nodiscard]] QString whyNotOneFile(const QString& file);

/// An error that names the file as the user did, not the place beside it where the session is.
[[nodiscard]] core::Error ofTarget(core::Error error, const QString& place, const QString& file);

/// Keeps the session at @p place, which was to replace @p file, under a free name beside it, and
/// says so on stderr.
void keepUnfinished(const QString& place, const QString& file);

} // namespace app
