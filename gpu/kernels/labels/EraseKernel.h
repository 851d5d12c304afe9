// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/LabelCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The compiled kernels that erase a label (eraseLabel.comp).
struct ErasePrograms {
    /// @param library outlives the programs
    explicit ErasePrograms(const ShaderLibrary& library);

    Program labels;
    Program seedWords;
    /// Compiled when it is first needed.
    [[nodiscard]] Program& overwritten();

private:
    const ShaderLibrary& m_library;
    Program m_overwritten;
};

/// The bricks in which a label plane holds a label. Waits for the GPU. Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> labelHolders(
    ErasePrograms& programs, VoxelFields& fields, std::uint8_t plane, std::uint8_t label);

/// Erases a label from its plane and its seed map (EraseLabel in core/engine/LabelCommands.h). It
/// first finds the bricks that hold the label; only those are captured and written. Returns their
/// keys. Cost ∝ the bricks that have ever held a label or hold seed words. Engine thread only.
std::vector<core::BrickKey> eraseLabel(ErasePrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::EraseLabel& erase);

} // namespace gpu
