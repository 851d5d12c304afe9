// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/labels/EditableVoxels.h"
#include "gpu/fields/VoxelFields.h"

#include <cstdint>
#include <vector>

namespace gpu {

/// Finds which voxels of some bricks an edit of labels may change (editable.comp), for kernels that
/// are compiled with EDITABLE. Edits without such a range neither compile nor run any of it.
/// Engine thread only.
class EditableBits {
public:
    /// @param library outlives this
    explicit EditableBits(const ShaderLibrary& library)
        : m_library(library)
    {
    }

    /// As labels are now. Leaves textures and buffers of its own bound, so it comes first.
    /// @return 128 words for each brick, in their order; of offset o bit o mod 32 of word o / 32
    [[nodiscard]] Buffer find(const core::EditableVoxels& editable, VoxelFields& fields,
        const std::vector<std::uint32_t>& bricks);

    /// Where kernels with EDITABLE expect that buffer.
    static constexpr unsigned binding = 7;

private:
    enum class Join : unsigned { Set, Add, Keep, Remove }; // editable.comp
    void run(Program& program, Join how, const VoxelFields& fields, std::size_t bricks);

    const ShaderLibrary& m_library;
    Program m_values;
    Program m_labels;
};

} // namespace gpu
