// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/GrowthForesight.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The compiled kernels of shrinking (shrink.comp, countGenerations.comp).
struct ShrinkPrograms {
    /// @param library outlives the programs
    explicit ShrinkPrograms(const ShaderLibrary& library);

    Program look;
    Program shrink;
    Program count;
    /// The kernel that also restores labels kept as overwritten; compiled when it is first needed.
    [[nodiscard]] Program& giveBack();

private:
    const ShaderLibrary& m_library;
    Program m_giveBack;
};

/// One shrinking of a growth while it is open (ShrinkGrowth, ShrinkTo in
/// core/growth/GrowthCommands.h). It finds out once which generations each brick holds, and saves
/// the bricks that have any. Going from one generation to another, in either direction, then writes
/// only bricks with generations in between. Engine thread only.
class ShrinkKernel {
public:
    /// Cost ∝ the bricks that hold seed words.
    ShrinkKernel(ShrinkPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::ShrinkGrowth& command);

    void shrinkTo(std::uint32_t keep, bool keepSeeds);

    [[nodiscard]] std::uint32_t openedAt() const { return m_command.generation; }
    /// The present generation counter.
    [[nodiscard]] std::uint32_t generation() const;
    /// The keys of all bricks that were ever written.
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const;

private:
    struct Brick {
        std::uint32_t brick = 0;
        std::uint32_t least = 0; ///< least generation that may be removed
        std::uint32_t greatest = 0;
        bool written = false;
    };
    void look();
    void save();

    ShrinkPrograms& m_programs;
    bool m_givesBack; ///< labels are kept as overwritten
    Program& m_shrink;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::ShrinkGrowth m_command;
    /// Bricks with members that may be removed, in the order in which they are saved.
    std::vector<Brick> m_bricks;
    Buffer m_words; ///< as they were when the shrinking began
    Buffer m_labels;
    Buffer m_overwritten;
    std::uint32_t m_keep = 0;
    bool m_keepSeeds = false;
    std::uint32_t m_greatestLocked = 0;
    bool m_anySeeds = false;
};

/// The number of members of each generation (core::CountGenerations; countGenerations.comp). Waits.
/// Engine thread only.
[[nodiscard]] std::vector<std::uint32_t> generationSizes(
    ShrinkPrograms& programs, VoxelFields& fields, std::uint8_t plane);

} // namespace gpu
