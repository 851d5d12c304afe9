// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/DeltaStream.h"

#include <optional>

namespace core {

/// A difference as earlier Burins wrote it ("BDL1", "BDL2": core/session/README.md), for reading
/// only. The reader stands behind these four bytes.
/// @return none: it is cut short or garbled
[[nodiscard]] std::optional<std::vector<BrickImage>> readOldDelta(DeltaReader& reader);

} // namespace core
