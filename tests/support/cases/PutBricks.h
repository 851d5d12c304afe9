// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QString>

namespace test {

// Tests of the contract of SwapBricks and XorBricks with their guards, of ReadSeedWords and
// of ReadBarriers, one row each, for any engine.

/// Adds the rows; for a data function, with a column "name".
void addPutBricksRows();
/// Runs one test.
/// @return empty, or the failure
[[nodiscard]] QString tryPutBricks(core::EditEngine& engine, const QString& name);

} // namespace test
