// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QString>

namespace test {

// What every engine promises of SwapBricks, XorBricks with their guards, and ReadSeedWords: a row
// each, for whichever engine is given.

/// Of a data function: a column "name".
void addPutBricksRows();
/// @return empty, or what was wrong
[[nodiscard]] QString tryPutBricks(core::EditEngine& engine, const QString& name);

} // namespace test
