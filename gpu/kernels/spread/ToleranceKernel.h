// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/Tolerance.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/criterion/GrowCriterion.h"
#include "gpu/shaders/RecentPrograms.h"

#include <map>
#include <memory>
#include <utility>

namespace gpu {

/// The compiled kernels that trace tolerances (tolerance*.comp), each compiled when it is first
/// needed.
class TolerancePrograms {
public:
    /// @param shaders outlives them
    explicit TolerancePrograms(const ShaderLibrary& shaders)
        : m_shaders(shaders)
    {
    }

    [[nodiscard]] Program& seeds();
    [[nodiscard]] std::shared_ptr<Program> init(const core::GrowLimits& limits, bool overwritten);
    [[nodiscard]] Program& relax(int connectivity);
    [[nodiscard]] Program& count();

private:
    const ShaderLibrary& m_shaders;
    Program m_seeds;
    RecentPrograms<std::pair<unsigned, bool>, Program> m_init; ///< by kindOf(), and overwritten
    std::map<int, Program> m_relax;
    Program m_count;
};

/// Computes VoxelFields::tolerance() (core/growth/Tolerance.h). First every voxel gets its initial
/// value; then bricks that neighbours may change are relaxed until each is stable, those with the
/// least tolerance first; then voxels are counted. If the field was computed by the same rule
/// before, and seeds and walls prove to be the same, it becomes valid again at once. Engine thread
/// only.
class ToleranceKernel {
public:
    /// Errors: InvalidField (an invalid rule, or a label without seeds); in that case there is no
    /// field. Throws GlFailure.
    static core::Result<std::unique_ptr<ToleranceKernel>> begin(
        TolerancePrograms& programs, VoxelFields& fields, const core::ToleranceRule& rule);

    /// Does a part of the work.
    /// @param bricks about how many bricks to process
    void advance(std::size_t bricks);
    [[nodiscard]] bool done() const { return m_phase == Phase::Done; }
    [[nodiscard]] const core::ToleranceRule& rule() const { return m_field.rule; }
    /// How many times bricks were processed so far.
    [[nodiscard]] std::size_t visits() const { return m_visits; }

private:
    enum class Phase : std::uint8_t { Compare, Init, Relax, Count, Done };

    ToleranceKernel(TolerancePrograms& programs, VoxelFields& fields,
        const core::ToleranceRule& rule, int centre);
    void look(std::size_t bricks);
    void relax(std::size_t bricks);
    void count(std::size_t bricks);
    void take(Phase phase);

    TolerancePrograms& m_programs;
    VoxelFields& m_fields;
    ToleranceField& m_field;
    bool m_overwritten; ///< growth has taken voxels from other segments
    std::shared_ptr<Program> m_init;
    Program& m_relax;
    GrowCriterion m_criterion;
    Phase m_phase = Phase::Init;
    std::size_t m_next = 0; ///< brick
    Buffer m_digest;
    Buffer m_pending;
    Buffer m_sizes;
    Buffer m_ranges;
    std::size_t m_visits = 0;
};

} // namespace gpu
