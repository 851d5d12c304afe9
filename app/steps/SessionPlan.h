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

/// How an existing session file is gone on with, so that nothing in it is lost.
struct SessionPlan {
    QString file; ///< the one to open: another one if that is damaged
    QString whyReadOnly; ///< empty: it can be written
    std::optional<core::Error> damage; ///< to be told: what is lost, and where work goes on
    bool isNew = false; ///< the file was made now and may go again if nothing is done
    QString damaged; ///< where the damaged file lies now; empty: none
    /// Rows that opening the file carries out again, and the hashes that they must come to. Where
    /// they do not, withdraw() the plan and make another without.
    std::vector<std::pair<std::int64_t, QByteArray>> redo;
};

/// A damaged file keeps its bytes: what is sound goes into a new one beside it, or into the folder
/// of working sessions. A damaged working session makes way for the new one and stays beside it.
/// One that is in use or cannot be written is only looked at. Blocks while a damaged file is read.
/// @param contents what core::checkSession() found
/// @param redo whether rows may be carried out again whose difference alone is lost
/// Errors: SessionDamaged where no place is left for the new file.
[[nodiscard]] core::Result<SessionPlan> planFor(
    const QString& file, core::SessionContents contents, bool redo = true);

/// Opens what a plan names. Errors: those of EditSession::open(), and SessionDamaged naming the
/// damaged file where a row that was carried out again did not come to its hash.
[[nodiscard]] core::Result<std::unique_ptr<core::EditSession>> openPlanned(core::EditEngine& engine,
    core::LoadedVolume loaded, const SessionPlan& plan, const std::function<void()>& wakeUp = {});

/// Everything as it was before a plan around damage was made. @pre its file is not in use
void withdraw(const SessionPlan& plan, const QString& file);

} // namespace app
