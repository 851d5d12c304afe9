// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/session/EditSession.h"

#include <QString>

#include <memory>

namespace app {

// The file into which a command writes its session. With --force a new session is made beside the
// old one and takes its place when it is complete.

/// Checks whether a session can be written to @p file. This needs no loaded study; check again when
/// the files of the study are known. A session that was left open is closed first, as opening it
/// would. Errors: FileNotFound (nothing to append to), FileExists, FileUnwritable.
[[nodiscard]] core::Result<void> checkSessionTarget(const QString& file, bool force, bool append);

/// Begins a session in a new file, which holds the study's images if that is wanted. If that fails,
/// no file is left. Errors: those of EditSession::create() and core::stageImages().
[[nodiscard]] core::Result<std::unique_ptr<core::EditSession>> beginSession(
    core::EditEngine& engine, core::LoadedVolume loaded, const QString& file, bool withImages);

/// Why a closed session does not consist of a single file, in words; empty if it does.
[[nodiscard]] QString whyNotOneFile(const QString& file);

/// An error that names the file as the user has given it, not the temporary place beside it.
[[nodiscard]] core::Error ofTarget(core::Error error, const QString& place, const QString& file);

/// Keeps the session at @p place, which was meant to replace @p file, under a free name beside it,
/// and reports that on stderr.
void keepUnfinished(const QString& place, const QString& file);

} // namespace app
