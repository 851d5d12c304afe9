// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/EditSession.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {
struct SessionContents;
}

namespace app {

/// How an existing session file is continued, so that nothing in it is lost.
struct SessionPlan {
    QString file; ///< the file to open; another one if the given file is damaged
    QString whyReadOnly; ///< why it is opened read-only; empty if it can be written
    std::optional<core::Error> damage; ///< to be reported: what is lost, and where work continues
    bool isNew = false; ///< the file was just made, and may be removed if nothing is done in it
    QString damaged; ///< present place of the damaged file; empty if none
    /// Rows that are carried out again when the file is opened, and their expected hashes. If a row
    /// does not reach its hash, withdraw() the plan and make another one without such rows.
    std::vector<std::pair<std::int64_t, QByteArray>> redo;
};

/// Makes a plan. A damaged file is not changed: its sound part goes into a new file beside it, or
/// in the folder of working sessions. A damaged working session is renamed to make room for the new
/// one and stays beside it. A file that is in use or cannot be written is opened read-only. Blocks
/// while a damaged file is read.
/// @param contents what core::checkSession() found
/// @param redo whether rows of which only the difference is lost may be carried out again
/// Errors: SessionDamaged if there is no place for the new file.
[[nodiscard]] core::Result<SessionPlan> planFor(
    const QString& file, core::SessionContents contents, bool redo = true);

/// Opens the file of a plan. Errors: those of EditSession::open(), and SessionDamaged, naming the
/// damaged file, if a row that was carried out again did not reach its hash.
[[nodiscard]] core::Result<std::unique_ptr<core::EditSession>> openPlanned(core::EditEngine& engine,
    core::LoadedVolume loaded, const SessionPlan& plan, const std::function<void()>& wakeUp = {});

/// Renames a closed session with what SQLite left beside it, which a new session of its name would
/// take for its own: all of it, or nothing. Errors: FileUnwritable, with the reason.
[[nodiscard]] core::Result<void> renameSession(const QString& from, const QString& to);

/// Undoes what planFor() has done about a damaged file.
/// @pre the plan's file is not in use
/// Errors: FileUnwritable, naming the damaged file where it is if it could not get its name back.
[[nodiscard]] core::Result<void> withdraw(const SessionPlan& plan, const QString& file);

} // namespace app
