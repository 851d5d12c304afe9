// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedSpread.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/fields/bricks/SpreadField.h"

#include <map>
#include <memory>
#include <vector>

namespace gpu {

/// The compiled kernels of growing from seeds (spread*.comp), each when it is first needed.
class SpreadPrograms {
public:
    /// @param shaders outlives them
    explicit SpreadPrograms(const ShaderLibrary& shaders)
        : m_shaders(shaders)
    {
    }

    /// What depends on how many neighbours a voxel has.
    struct Steps {
        Steps(const ShaderLibrary& shaders, int connectivity);

        Program init;
        Program doubt;
        Program relax;
        Program label;
    };
    [[nodiscard]] Steps& steps(int connectivity);
    [[nodiscard]] Program& find();

private:
    const ShaderLibrary& m_shaders;
    std::map<int, Steps> m_steps;
    Program m_find;
};

/// Growing from seeds while it is open (core/growth/SeedSpread.h): bricks in which something is to
/// be done are worked on until each is at rest, those with the least cost first; then the label
/// plane shows the result. Engine thread only.
///
/// What was worked out stays in VoxelFields::spread() beyond a rollback: the next one with the same
/// costs begins from it, and works only where seeds, walls or the box are others now. The result is
/// the same to the bit.
class SpreadKernel {
public:
    /// Errors: InvalidField (seeds of fewer than two labels); then nothing was changed.
    static core::Result<std::unique_ptr<SpreadKernel>> begin(SpreadPrograms& programs,
        VoxelFields& fields, BeforeImages& before, const core::SpreadLabels& spread);

    /// Does some of the work. @param bricks about how many to look at
    void advance(std::size_t bricks);
    [[nodiscard]] bool done() const { return m_phase == Phase::Done; }
    /// Nothing of it is kept for the next one.
    void forget() { m_keep = false; }
    /// The end: gives back what is not kept.
    /// @param committed then the labels have changed all over, so nothing is
    void close(bool committed);

    /// What the label plane and the seed words were written in.
    [[nodiscard]] const std::vector<core::BrickKey>& touchedKeys() const { return m_keys; }
    /// How often bricks were worked on.
    [[nodiscard]] std::size_t visits() const { return m_visits; }

private:
    enum class Phase : std::uint8_t { Init, Doubt, Relax, Label, Done };

    SpreadKernel(SpreadPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::SpreadLabels& spread, const core::VoxelBox& box);
    void bind();
    void init(std::size_t bricks);
    /// @return whether anything was to be done
    bool settle(Program& program, Buffer& waiting, std::size_t bricks);
    void label(std::size_t bricks);

    SpreadPrograms::Steps& m_steps;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::SpreadLabels m_spread;
    SpreadField& m_field;
    bool m_update = false; ///< the field holds what an earlier one worked out
    Phase m_phase = Phase::Init;
    std::size_t m_next = 0; ///< brick of the box
    Buffer m_pending;
    Buffer m_doubtful;
    std::vector<core::BrickKey> m_keys;
    std::size_t m_visits = 0;
    bool m_keep = true;
};

} // namespace gpu
