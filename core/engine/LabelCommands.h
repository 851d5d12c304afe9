// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/sculpt/CapsuleSweep.h"
#include "core/sculpt/EdgeRegion.h"
#include "core/sculpt/labels/EditableVoxels.h"

#include <bitset>
#include <cstdint>
#include <optional>

namespace core {

// Edits of one label, as an engine receives them: plain data, every number an integer, with
// everything that they read. Further ones are in sculpt/labels/LayerWrites.h.

/// Remove a label from its plane: every voxel that holds it becomes 0, and every seed word that has
/// it, of a member or a pending seed, becomes seedWord::unvisited. So no growth continues from it;
/// members of other labels keep their generations. Where the label is stored as overwritten
/// (GrowthCommands.h), it is replaced by 0.
struct EraseLabel {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
};

/// Paint a label along a path, or erase it. It changes voxels inside (CapsuleSweep.h, rule 4) with
/// lowCode ≤ code ≤ highCode. The words that "have" a label are those of members and of pending
/// seeds.
///
/// Paint: a voxel at which the plane holds 0, the label or a label in `overwritable` receives the
/// label. The seed words of these voxels change too: with `seeds`, each word that is no member of
/// the label becomes member(0, label, 31); otherwise each word that has another label becomes
/// unvisited. Generation 0 precedes any growth, so a growth continues from there, while shrinking,
/// which removes later generations, leaves what was painted, and no burst treats it as its own.
/// Barriers stay. Erase: a voxel at which the plane holds the label becomes 0, and a seed word that
/// has the label becomes unvisited, so growth may enter it.
///
/// With `edges` it changes only the members of EdgeRegion.h, rule 3, where it could change them
/// without; the codes that the edit may change at all are lowCode … highCode.
struct PaintLabel {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::bitset<256> overwritable{};
    bool erase = false;
    bool seeds = false;
    int lowCode = 0;
    int highCode = 65535;
    CapsuleFrame frame;
    std::optional<EdgeRule> edges{};
    std::optional<EditableVoxels> editable{}; ///< none: any
};

[[nodiscard]] Result<void> checkSound(const EraseLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const PaintLabel& edit, const BrickGrid& grid);

} // namespace core
