// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/VoxelFields.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/kernels/criterion/GrowCriterion.h"
#include "gpu/shaders/RecentPrograms.h"

#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace gpu {

/// The compiled kernels that find out where a ball fits (passage*.comp), each compiled when it is
/// first needed.
class PassagePrograms {
public:
    /// @param shaders outlives them
    explicit PassagePrograms(const ShaderLibrary& shaders)
        : m_shaders(shaders)
    {
    }

    [[nodiscard]] Program& labels();
    [[nodiscard]] std::shared_ptr<Program> free(
        const core::GrowLimits& limits, bool overwritten, bool ranged);
    [[nodiscard]] Program& centres();
    [[nodiscard]] Program& room();

private:
    const ShaderLibrary& m_shaders;
    Program m_labels;
    using FreeKind = std::tuple<unsigned, bool, bool>; ///< kindOf(), and what else there is
    RecentPrograms<FreeKind, Program> m_free;
    Program m_centres;
    Program m_room;
};

/// Where growth with a passage width may go (core/growth/Passage.h). For each voxel it computes the
/// room around it and the way in, brick by brick as fronts come near, and separately for each label
/// that does. The values depend on nothing that a burst changes, so it does not matter when they
/// are computed. It lives as long as a burst. Engine thread only.
class PassageField {
public:
    PassageField(PassagePrograms& programs, VoxelFields& fields, const core::GrowBurst& burst);

    /// Computes what a batch needs whose fronts start in these bricks and stay in them and their
    /// neighbours.
    /// @param criterion that of the burst
    void prepare(const GrowCriterion& criterion, const std::vector<std::uint32_t>& frontBricks);
    /// Sets the uniforms of a program that includes passage.glsl; they change with the first
    /// prepare().
    void setUniforms(Program& program) const;
    /// Binds the textures of such a program.
    void bind();

private:
    struct Job { // passageBits.glsl
        std::uint32_t brick = 0;
        std::uint32_t slot = 0;
        std::uint32_t label = 0;
        std::uint32_t page = 0;
    };
    /// Which bits of a brick are computed.
    enum class Known : std::uint8_t { Nothing, Free, Centres };
    using LabelBits = std::array<std::uint32_t, 8>;

    void setGrowthUniforms(Program& program, const GrowCriterion& criterion) const;
    [[nodiscard]] bool looksBelow() const;
    /// For each of these bricks the set of growing labels that it holds.
    [[nodiscard]] std::vector<LabelBits> labelsIn(
        const GrowCriterion& criterion, const std::vector<std::uint32_t>& bricks);
    void giveSlots(const GrowCriterion& criterion);
    void workOut(const GrowCriterion& criterion, std::uint32_t slot,
        const std::vector<std::uint32_t>& bricks);
    void takePages(std::uint32_t slot, const std::vector<std::uint32_t>& bricks);
    void forgetBits();
    void run(Program& program, const std::vector<Job>& jobs);
    /// Jobs for those of the bricks whose bits are not computed as far as @p wanted; afterwards
    /// they count as computed.
    [[nodiscard]] std::vector<Job> jobsFor(
        std::uint32_t slot, const std::vector<std::uint32_t>& bricks, Known wanted);
    [[nodiscard]] std::size_t place(std::uint32_t slot, std::uint32_t brick) const;
    /// The same in the grid of rooms.
    [[nodiscard]] std::uint32_t roomBrick(std::uint32_t slot, std::uint32_t brick) const;

    PassagePrograms& m_programs;
    VoxelFields& m_fields;
    core::GrowBurst m_burst;
    std::vector<std::uint32_t> m_labels; ///< by slot
    int m_slotsAcross = 1; ///< passageSlots.glsl
    core::BrickGrid m_roomGrid;
    BrickField m_rooms;
    std::vector<Known> m_known;
    std::vector<std::uint32_t> m_pages; ///< page of the bits + 1, by place()
    std::uint32_t m_pagesTaken = 0;
    Buffer m_bits;
    Buffer m_pageTable;
};

} // namespace gpu
