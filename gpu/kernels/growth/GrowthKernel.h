// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "core/growth/LeakGuard.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/criterion/GrowCriterion.h"
#include "gpu/kernels/fronts/FrontBits.h"
#include "gpu/kernels/passage/PassageField.h"
#include "gpu/kernels/shrink/ShrinkKernel.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace gpu {

/// What kernels of growing are compiled for.
struct GrowthKind {
    int connectivity = 6; ///< 6, 18 or 26
    core::GrowLimits limits{};
    bool beneath = false; ///< what lies beneath members is read and written

    [[nodiscard]] ShaderDefines defines() const;
};

/// The compiled kernels of growing (grow*.comp, placeSeeds.comp).
struct GrowthPrograms {
    /// @param shaders outlives them
    explicit GrowthPrograms(const ShaderLibrary& shaders);

    /// What depends on how many neighbours a voxel has and what is asked of it.
    struct Rings {
        /// @param back the flood by which a growth that is narrowed finds out who stays; it admits
        /// no seeds
        Rings(const ShaderLibrary& shaders, const GrowthKind& kind, bool back);

        Program admit;
        Program label;
        Program front;
        Program ring;
        Program severalRings;
    };
    /// Compiled when first needed, but for a growth over faces (6) without limits.
    [[nodiscard]] Rings& rings(const GrowthKind& kind);

    /// The further kernels of narrowing.
    struct Narrowing {
        Narrowing(const ShaderLibrary& shaders, const GrowthKind& kind);

        Program doubt;
        Rings back;
        Program sweep;
    };
    /// Compiled when first needed.
    [[nodiscard]] Narrowing& narrowing(const GrowthKind& kind);

    /// Compiled when first needed.
    [[nodiscard]] FrontBitsPrograms& frontBits(const GrowthKind& kind);

    Program placeSeeds;
    SeedStatisticsPrograms seedStatistics;
    ShrinkPrograms shrink;
    PassagePrograms passage;

private:
    const ShaderLibrary& m_shaders;
    using Kind = std::array<unsigned, 3>; ///< neighbours, kindOf(limits), beneath
    [[nodiscard]] static Kind keyOf(const GrowthKind& kind);
    std::map<Kind, Rings> m_rings;
    std::map<Kind, Narrowing> m_narrowings;
    std::map<Kind, FrontBitsPrograms> m_frontBits;
};

/// Marks pending seeds; their bricks are captured first. Returns the bricks touched.
std::vector<std::uint32_t> placeSeeds(GrowthPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::SeedPlacement& placement);

/// One burst of breadth-first growth while it is open (seed A §5.3; GrowBurst in EngineCommands.h).
///
/// Rings run in batches of up to sixteen without readback in between: within sixteen steps a front
/// stays in its bricks and their neighbours, which get pages and are captured before the batch. A
/// front is a queue of voxels, or, while it is wide and simple enough, bits (FrontBits). Engine
/// thread only.
class GrowthKernel {
public:
    static constexpr int ringsPerBatch = 16;

    GrowthKernel(GrowthPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::GrowBurst& burst);

    /// Takes back what has to leave, admits pending seeds and finds the front. Call it once, first.
    void open();
    /// Up to @p rings (at most ringsPerBatch) generations. Returns how many added something; fewer
    /// than asked means closure, or an alarm. A guarded growth goes ring by ring, and every front
    /// is read back.
    int advance(int rings);

    [[nodiscard]] std::uint32_t generation() const { return m_generation; }
    [[nodiscard]] bool atClosure() const { return m_atClosure; }
    [[nodiscard]] const std::vector<std::uint32_t>& frontSizes() const { return m_frontSizes; }
    [[nodiscard]] std::int64_t members() const { return m_members; }
    [[nodiscard]] const std::optional<core::LeakAlarm>& alarm() const { return m_alarm; }
    /// Bricks that held a front since the opening: nothing was claimed elsewhere.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;
    /// Gives back the pages of bricks that were prepared and not reached, but for those listed
    /// (ascending).
    void releaseUnused(std::span<const std::uint32_t> reachable = {});
    /// Whether it may change what lies beneath members; if so, in the bricks touched.
    [[nodiscard]] bool keepsBeneath() const { return m_kind.beneath; }
    /// Gives back the pages that were taken for it and that these changes put nothing in.
    void releaseBeneath(std::span<const core::BrickChange> changes);

private:
    struct State {
        /// Voxels in the front that each ring starts from, and after the last.
        std::array<std::uint32_t, ringsPerBatch + 1> counts{};
        std::uint32_t admitted = 0;
        std::uint32_t nextRing = 0;
        std::uint32_t greatest = 0;
        // Of the voxels where a front was found: the greatest label, and 255 - the least.
        std::uint32_t greatestLabel = 0;
        std::uint32_t leastLabelDown = 0;
    };

    void bind();
    void setUniforms(Program& program) const;
    /// Of label plane, seed words and what lies beneath: saved, and ready for what may be taken.
    void capture(std::span<const std::uint32_t> bricks);
    void admitSeeds(const std::vector<std::uint32_t>& held);
    // What leaves at the opening (GrowthNarrowing.cpp). @param held bricks with words, captured
    void narrow(const std::vector<std::uint32_t>& held);
    void floodBack();
    void restart();
    /// Runs a kernel over listed bricks.
    State runOver(Program& program, const std::vector<std::uint32_t>& bricks);

    /// @param bricks where to look
    void findFront(const std::vector<std::uint32_t>& bricks);
    /// Bricks that a batch may reach, ready for it.
    std::vector<std::uint32_t> prepareBricks();
    void preparePassages();
    void start(const State& state);
    /// Reads the counters and the bricks reached since start().
    State takeBatch();
    void setQueues(std::uint32_t capacity);
    void runRings(int count);
    /// Bits or queue, whichever suits the front. @param bricks in reach
    void chooseForm(const std::vector<std::uint32_t>& bricks);
    int advanceBatch(int rings);
    /// What the last generation added, for the guard: as its queue lists it, or, where that is not
    /// whole, as the words of the bricks reached tell.
    [[nodiscard]] std::vector<core::LeakGuard::Voxel> listedFront() const;
    [[nodiscard]] std::vector<core::LeakGuard::Voxel> frontInWords();
    void watch(const std::vector<core::LeakGuard::Voxel>& added);

    GrowthPrograms& m_programs;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::GrowBurst m_burst;
    bool m_mayTake; ///< from other labels, and will give it back
    GrowthKind m_kind;
    GrowthPrograms::Rings* m_rings;
    GrowCriterion m_criterion;
    std::optional<PassageField> m_passage; ///< none where growth goes through everything
    Buffer m_state;
    Buffer m_queues; ///< two, one behind the other
    Buffer m_reached;
    std::uint32_t m_queueCapacity = 1u << 18;
    bool m_floodsBack = false; ///< only while it is narrowed: m_rings are those of the flood
    std::uint32_t m_openGeneration = 0; ///< after what leaves at the opening has left
    std::uint32_t m_generation = 0;
    bool m_atClosure = false;
    unsigned m_frontQueue = 0; ///< which of the queues holds the front
    std::uint32_t m_frontCount = 0;
    std::optional<std::uint8_t> m_onlyLabel; ///< in the front, if it is one
    FrontBits m_frontBits;
    std::vector<std::uint32_t> m_frontSizes;
    std::int64_t m_members = 0;
    std::vector<std::uint32_t> m_frontBricks; ///< that hold the front
    std::vector<bool> m_prepared; ///< bricks that are captured and have a page
    std::set<std::uint32_t> m_allTouched;
    std::set<std::uint32_t> m_newPages;
    std::set<std::uint32_t> m_newBeneath;
    std::vector<std::uint32_t> m_lastTouched; ///< bricks of the last batch
    std::optional<core::LeakGuard> m_guard;
    std::optional<core::LeakAlarm> m_alarm;
};

} // namespace gpu
