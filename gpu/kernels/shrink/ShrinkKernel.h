// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
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
    /// Shrinks where something lies beneath; compiled when it is first needed.
    [[nodiscard]] Program& giveBack();

private:
    const ShaderLibrary& m_library;
    Program m_giveBack;
};

/// One shrinking of a growth while it is open (ShrinkGrowth, ShrinkTo in
/// core/growth/GrowthCommands.h). Which generations each brick has is looked for once, and the
/// bricks that have any are saved; going from one generation to another then writes only bricks
/// with generations in between, either way. Engine thread only.
class ShrinkKernel {
public:
    /// Cost ∝ the bricks that hold seed words.
    ShrinkKernel(ShrinkPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::ShrinkGrowth& command);

    void shrinkTo(std::uint32_t keep, bool keepSeeds);

    [[nodiscard]] std::uint32_t openedAt() const { return m_command.generation; }
    /// The counter now.
    [[nodiscard]] std::uint32_t generation() const;
    /// All that was ever written.
    [[nodiscard]] std::vector<core::BrickKey> touchedKeys() const;

private:
    struct Brick {
        std::uint32_t brick = 0;
        std::uint32_t least = 0; ///< generation that may go
        std::uint32_t greatest = 0;
        bool written = false;
    };
    void look();
    void save();

    ShrinkPrograms& m_programs;
    bool m_givesBack; ///< something lies beneath
    Program& m_shrink;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::ShrinkGrowth m_command;
    std::vector<Brick> m_bricks; ///< that have members that may go; in this order they are saved
    Buffer m_words; ///< as they were at the opening
    Buffer m_labels;
    Buffer m_beneath;
    std::uint32_t m_keep = 0;
    bool m_keepSeeds = false;
    std::uint32_t m_greatestFrozen = 0;
    bool m_anySeeds = false;
};

/// Members of each generation (core::CountGenerations; countGenerations.comp).
[[nodiscard]] std::vector<std::uint32_t> generationSizes(
    ShrinkPrograms& programs, VoxelFields& fields, std::uint8_t plane);

} // namespace gpu
