// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/labels/EditableVoxels.h"
#include "gpu/fields/VoxelFields.h"

#include <cstdint>
#include <vector>

namespace gpu {

/// Finds out which voxels of some bricks an edit of labels may change (editable.comp), for kernels
/// that are compiled with EDITABLE. It is used only for edits with an editable range. Engine thread
/// only.
class EditableBits {
public:
    /// @param library outlives this
    explicit EditableBits(const ShaderLibrary& library)
        : m_library(library)
    {
    }

    /// Evaluates the range for the present labels. It changes bindings of textures and buffers, so
    /// call it before the kernel's own are bound.
    /// @return 128 words for each brick, in the order of @p bricks; bit o mod 32 of word o / 32
    /// belongs to the voxel with offset o in the brick
    [[nodiscard]] Buffer find(const core::EditableVoxels& editable, VoxelFields& fields,
        const std::vector<std::uint32_t>& bricks);

    /// The binding at which kernels with EDITABLE expect that buffer.
    static constexpr unsigned binding = 7;

private:
    enum class Join : unsigned { Set, Add, Keep, Remove }; // editable.comp
    void run(Program& program, Join how, const VoxelFields& fields, std::size_t bricks);

    const ShaderLibrary& m_library;
    Program m_values;
    Program m_labels;
};

} // namespace gpu
