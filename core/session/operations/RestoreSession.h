// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

#include <memory>
#include <vector>

namespace core {

/// Opening a session: the history of @p state's file, and on the engine (which has the volume) the
/// voxels of the farthest row towards the file's position that needs no edit to be carried out.
/// Waits for the engine. Errors: SessionDamaged.
[[nodiscard]] Result<void> restoreSession(SessionState& state);

/// What is left to do after that, in this order: rows that lack their second half are carried out
/// again, then the walk to the file's position.
[[nodiscard]] std::vector<std::unique_ptr<Operation>> unfinishedRows(const SessionState& state);

} // namespace core
