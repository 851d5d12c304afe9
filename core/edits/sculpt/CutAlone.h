// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/EngineEdit.h"

#include <cstdint>
#include <vector>

namespace core {

/// A complete edit, as submitWhole() takes it.
struct WholeCut {
    EngineEdit edit;
    std::vector<EngineExtension> extensions;
};

/// The cut of an edit by itself, into an empty layer. For an edit that restores, what it would
/// refill is cut. Errors: InvalidField.
[[nodiscard]] Result<WholeCut> cutAlone(
    const SculptEdit& edit, const Document& document, std::uint8_t layer);

} // namespace core
