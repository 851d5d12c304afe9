// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/sessionfile/records/SessionContents.h"

namespace core {

/// Reads all of a session file, differences too, and touches neither it nor its folder. Of a
/// damaged one everything before the damage is returned, and SessionContents::damage says what is
/// not; a difference that is lost alone is no damage yet (SessionContents::redo). Blocks; cost:
/// every byte is read and hashed once. Errors: those of SessionFile::open(), SessionDamaged
/// (nothing is sound), Cancelled.
[[nodiscard]] Result<SessionContents> checkSession(
    const QString& path, const Progress& progress = Progress());

/// A new session file with what checkSession() found sound in a damaged one, which stays as it is.
/// It appears under its name only once it is whole. Rows to redo are carried out again when it is
/// opened; whoever opens it compares their hashes. Blocks.
/// Errors: FileExists, FileUnwritable, SessionDamaged (it changed meanwhile).
[[nodiscard]] Result<void> salvageSession(
    const QString& damaged, const SessionContents& sound, const QString& target);

} // namespace core
