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

/// The compiled kernels of growing from seeds (spread*.comp), each compiled when it is first
/// needed.
class SpreadPrograms {
public:
    /// @param shaders outlives them
    explicit SpreadPrograms(const ShaderLibrary& shaders)
        : m_shaders(shaders)
    {
    }

    /// The kernels that depend on the connectivity.
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

/// One growing from seeds while it is open (core/growth/SeedSpread.h). Bricks with work left are
/// relaxed until each is stable, those with the least cost first; then the result is written to the
/// label plane. Engine thread only.
///
/// The computed field stays in VoxelFields::spread() even after a rollback: the next run with the
/// same costs starts from it and works only where seeds, walls or the box have changed. The result
/// is the same to the bit.
class SpreadKernel {
public:
    /// Errors: InvalidField (seeds of fewer than two labels); in that case nothing was changed.
    static core::Result<std::unique_ptr<SpreadKernel>> begin(SpreadPrograms& programs,
        VoxelFields& fields, BeforeImages& before, const core::SpreadLabels& spread);

    /// Does a part of the work.
    /// @param bricks about how many bricks to process
    void advance(std::size_t bricks);
    [[nodiscard]] bool done() const { return m_phase == Phase::Done; }
    /// Keeps nothing for the next run.
    void forget() { m_keep = false; }
    /// Ends the run: frees what is not kept.
    /// @param committed the labels have changed everywhere, so nothing is kept
    void close(bool committed);

    /// The keys of the bricks whose labels and seed words were written.
    [[nodiscard]] const std::vector<core::BrickKey>& touchedKeys() const { return m_keys; }
    /// How many times bricks were processed so far.
    [[nodiscard]] std::size_t visits() const { return m_visits; }

private:
    enum class Phase : std::uint8_t { Init, Doubt, Relax, Label, Done };

    SpreadKernel(SpreadPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::SpreadLabels& spread, const core::VoxelBox& box);
    void bind();
    void init(std::size_t bricks);
    /// @return whether there was anything to do
    bool settle(Program& program, Buffer& waiting, std::size_t bricks);
    void label(std::size_t bricks);

    SpreadPrograms::Steps& m_steps;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::SpreadLabels m_spread;
    SpreadField& m_field;
    bool m_update = false; ///< the field holds the result of an earlier run
    Phase m_phase = Phase::Init;
    std::size_t m_next = 0; ///< brick of the box
    Buffer m_pending;
    Buffer m_doubtful;
    std::vector<core::BrickKey> m_keys;
    std::size_t m_visits = 0;
    bool m_keep = true;
};

} // namespace gpu
