// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

#include <memory>
#include <vector>

namespace core {

/// Restores a session: the history from the file of @p state, and in the engine, which already has
/// the volume, the voxels of the row that is nearest to the file's position and can be reached
/// without carrying out an edit. Waits for the engine. Errors: SessionDamaged.
[[nodiscard]] Result<void> restoreSession(SessionState& state);

/// What remains to be done after that, in this order: rows without a second half are carried out
/// again, then the walk to the file's position.
[[nodiscard]] std::vector<std::unique_ptr<Operation>> unfinishedRows(const SessionState& state);

} // namespace core
