// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthProgress.h"
#include "core/growth/LeakGuard.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/SoftwareDriver.h"
#include "gpu/kernels/criterion/GrowCriterion.h"
#include "gpu/kernels/fronts/FrontBits.h"
#include "gpu/kernels/fronts/ProcessorFront.h"
#include "gpu/kernels/passage/PassageField.h"
#include "gpu/kernels/shrink/ShrinkKernel.h"
#include "gpu/shaders/RecentPrograms.h"

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace core {
class IntervalOpener;
struct GrowthChange;
struct OpenedInterval;
} // namespace core

namespace gpu {

/// The variant for which growth kernels are compiled.
struct GrowthKind {
    int connectivity = 6; ///< 6, 18 or 26
    core::GrowLimits limits{};
    bool overwritten = false; ///< labels taken from other segments are kept and restored
    bool ranged = false; ///< the burst has a core::GrowthRange

    [[nodiscard]] ShaderDefines defines() const;
};

/// The compiled kernels of growing (grow*.comp, placeSeeds.comp).
struct GrowthPrograms {
    /// @param shaders outlives them
    /// @param by whether kernels or the processor advance simple fronts (ProcessorFront)
    GrowthPrograms(const ShaderLibrary& shaders, WorkBy by);

    [[nodiscard]] bool growsOnProcessor() const { return m_growsOnProcessor; }

    /// The kernels that depend on connectivity and limits.
    struct Rings {
        /// @param back whether this is the backward flood by which narrowing finds out which voxels
        /// stay; it admits no seeds
        Rings(const ShaderLibrary& shaders, const GrowthKind& kind, bool back);

        Program admit;
        Program label;
        Program front;
        Program ring;
        Program severalRings;
    };
    /// Compiled when needed, and kept while among the last used (RecentPrograms); so are the
    /// following.
    [[nodiscard]] std::shared_ptr<Rings> rings(const GrowthKind& kind);

    /// The additional kernels for narrowing a growth.
    struct Narrowing {
        Narrowing(const ShaderLibrary& shaders, const GrowthKind& kind);

        Program doubt;
        Rings back;
        Program sweep;
    };
    [[nodiscard]] std::shared_ptr<Narrowing> narrowing(const GrowthKind& kind);

    [[nodiscard]] std::shared_ptr<FrontBitsPrograms> frontBits(const GrowthKind& kind);
    /// The one kernel that ProcessorFront needs.
    [[nodiscard]] std::shared_ptr<Program> openBits(const GrowthKind& kind);
    /// The kernel that writes the voxels that a change of the interval has changed
    /// (GrowthKernel::open(IntervalOpener&)).
    [[nodiscard]] std::shared_ptr<Program> change(bool overwritten);

    Program placeSeeds;
    SeedStatisticsPrograms seedStatistics;
    ShrinkPrograms shrink;
    PassagePrograms passage;

private:
    const ShaderLibrary& m_shaders;
    bool m_growsOnProcessor;
    using Kind = std::array<unsigned, 3>; ///< neighbours, kindOf(limits), what else there is
    [[nodiscard]] static Kind keyOf(const GrowthKind& kind);
    RecentPrograms<Kind, Rings> m_rings;
    RecentPrograms<Kind, Narrowing> m_narrowings;
    RecentPrograms<Kind, FrontBitsPrograms> m_frontBits;
    RecentPrograms<Kind, Program> m_openBits;
    RecentPrograms<bool, Program> m_changes;
};

/// Writes pending seeds into the seed words, after capturing their bricks. Returns the bricks that
/// were written.
std::vector<std::uint32_t> placeSeeds(GrowthPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::SeedPlacement& placement);

/// Whether a burst should be opened from what a change of its interval changes, computed on the
/// CPU. That is faster with a software driver only; a GPU examines all grown voxels in less time
/// than it takes to read them back.
[[nodiscard]] bool opensByChange(const core::GrowBurst& burst);
/// Reads the growth of a plane for GrowthKernel::open(IntervalOpener&).
/// @return null if the growth is too large or more than one label grows
[[nodiscard]] std::unique_ptr<core::IntervalOpener> readGrowth(
    VoxelFields& fields, const core::GrowBurst& burst);

/// One burst of breadth-first growth while it is open (seed A §5.3; GrowBurst in GrowthCommands.h).
///
/// Generations run in batches of up to sixteen without a readback in between: within sixteen steps
/// a front stays in its bricks and their neighbours, which get pages and are captured before the
/// batch. The front is stored as a queue of voxels or, while it is wide and simple enough, as bits
/// (FrontBits). With a software driver the processor advances a simple front, however wide it is
/// (ProcessorFront); then only bricks in which a batch has claimed voxels are captured and get
/// pages, before they are written. Engine thread only.
class GrowthKernel {
public:
    static constexpr int ringsPerBatch = 16;

    GrowthKernel(GrowthPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::GrowBurst& burst);

    /// Removes voxels that the changed criteria exclude, admits pending seeds and finds the front.
    /// Call one of the two open() once, before anything else.
    void open();
    /// The same from a prepared opener, at a cost proportional to what the interval changes.
    /// @param opener prepared from the fields as they are now, for this burst
    void open(core::IntervalOpener& opener);
    /// Runs up to @p rings (at most ringsPerBatch) generations. Returns how many of them added
    /// voxels; fewer than requested means closure or a leak alarm. A growth with leak guard runs
    /// one generation at a time, and every front is read back.
    int advance(int rings);

    [[nodiscard]] std::uint32_t generation() const { return m_generation; }
    [[nodiscard]] bool atClosure() const { return m_atClosure; }
    [[nodiscard]] const std::vector<std::uint32_t>& frontSizes() const { return m_frontSizes; }
    [[nodiscard]] std::int64_t members() const { return m_members; }
    [[nodiscard]] const std::optional<core::LeakAlarm>& alarm() const { return m_alarm; }
    /// Bricks that held a front since open(): nothing was claimed elsewhere.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;
    /// Frees the pages of bricks that were prepared and not reached, except those listed
    /// (ascending).
    void releaseUnused(std::span<const std::uint32_t> reachable = {});
    /// Whether it may change the kept labels of overwritten voxels (core::Field::Overwritten).
    /// touchedKeys() includes their bricks then.
    [[nodiscard]] bool keepsOverwritten() const { return m_kind.overwritten; }
    /// Frees pages of Field::Overwritten that were allocated for this burst and have stayed empty
    /// in @p changes.
    void releaseOverwritten(std::span<const core::BrickChange> changes);

private:
    struct State {
        /// Number of voxels in the front from which each generation starts, and after the last.
        std::array<std::uint32_t, ringsPerBatch + 1> counts{};
        std::uint32_t admitted = 0;
        std::uint32_t nextRing = 0;
        std::uint32_t greatest = 0;
        // The greatest label of the front's voxels, and 255 − the least label.
        std::uint32_t greatestLabel = 0;
        std::uint32_t leastLabelDown = 0;
    };

    void bind();
    void setUniforms(Program& program) const;
    /// Captures label plane, seed words and Field::Overwritten, and allocates pages for labels that
    /// may be overwritten.
    void capture(std::span<const std::uint32_t> bricks);
    void admitSeeds(const std::vector<std::uint32_t>& held);
    // Removing voxels in open() (GrowthNarrowing.cpp).
    // @param held bricks with seed words, already captured
    void narrow(const std::vector<std::uint32_t>& held);
    void floodBack();
    void restart();
    void setOpenGeneration();
    void writeChanges(const std::vector<core::GrowthChange>& changes);
    void takeFront(const core::OpenedInterval& opened);
    /// Runs a kernel over the listed bricks.
    State runOver(Program& program, const std::vector<std::uint32_t>& bricks);

    /// @param bricks where to look for the front
    void findFront(const std::vector<std::uint32_t>& bricks);
    /// The bricks that a batch may reach, with pages and captured.
    std::vector<std::uint32_t> prepareBricks();
    /// Captures bricks that are not yet, and gives them pages.
    /// @return those that had none, in the order in which they were listed
    std::vector<std::uint32_t> prepare(
        std::vector<std::uint32_t> bricks, BrickField::NewPages pages);
    void preparePassages();
    void start(const State& state);
    /// Reads the counters and the list of bricks reached since start().
    State takeBatch();
    void setQueues(std::uint32_t capacity);
    void runRings(int count);
    /// Chooses bits or queue, whichever suits the front.
    /// @param bricks in reach
    void chooseForm(const std::vector<std::uint32_t>& bricks);
    int advanceBatch(int rings);
    // The same if the processor advances the front (GrowthOnProcessor.cpp).
    [[nodiscard]] bool isOnProcessor() const;
    int advanceOnProcessor(int rings);
    /// Those of the bricks in which seeds wait; with kernels they are found on the way.
    [[nodiscard]] std::vector<std::uint32_t> withPendingSeeds(
        const std::vector<std::uint32_t>& bricks);
    /// Finds the front if only one label grows and codes alone decide.
    /// @param bricks where to look for it
    /// @return false: kernels have to find it
    bool findFrontOnProcessor(const std::vector<std::uint32_t>& bricks);
    void beginOnProcessor(std::span<const core::LeakGuard::Voxel> front);
    [[nodiscard]] std::vector<core::VoxelBits> openVoxelsIn(std::span<const std::uint32_t> bricks);
    /// Notes how many voxels each generation of a batch added.
    void count(std::span<const std::uint32_t> sizes);
    /// The voxels that the last generation added, for the leak guard: from the queue or, if that is
    /// incomplete, from the seed words of the bricks reached.
    [[nodiscard]] std::vector<core::LeakGuard::Voxel> listedFront() const;
    [[nodiscard]] std::vector<core::LeakGuard::Voxel> frontInWords();
    void watch(const std::vector<core::LeakGuard::Voxel>& added);

    GrowthPrograms& m_programs;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::GrowBurst m_burst;
    /// Whether it may take voxels from other labels, and gives them back when it shrinks.
    bool m_mayTake;
    GrowthKind m_kind;
    std::shared_ptr<GrowthPrograms::Rings> m_growing;
    GrowthPrograms::Rings* m_rings; ///< m_growing, or the kernels of the backward flood
    std::shared_ptr<FrontBitsPrograms> m_bitPrograms; ///< for a front that is stored as bits
    GrowCriterion m_criterion;
    std::optional<PassageField> m_passage; ///< none without a passage width
    Buffer m_state;
    Buffer m_queues; ///< two queues, one behind the other
    Buffer m_reached;
    std::uint32_t m_queueCapacity = 1u << 18;
    bool m_floodsBack = false; ///< only while narrowing: m_rings are those of the backward flood
    std::uint32_t m_openGeneration = 0; ///< after open() has removed what leaves
    std::uint32_t m_generation = 0;
    bool m_atClosure = false;
    unsigned m_frontQueue = 0; ///< which of the queues holds the front
    std::uint32_t m_frontCount = 0;
    std::optional<std::uint8_t> m_onlyLabel; ///< the label of the front, if it has only one
    FrontBits m_frontBits;
    std::optional<ProcessorFront> m_processorFront;
    std::vector<std::uint32_t> m_frontSizes;
    std::int64_t m_members = 0;
    std::vector<std::uint32_t> m_frontBricks; ///< bricks that hold the front
    std::vector<bool> m_prepared; ///< bricks that are captured and have a page
    std::set<std::uint32_t> m_allTouched;
    std::set<std::uint32_t> m_newPages;
    std::set<std::uint32_t> m_newOverwritten;
    std::vector<std::uint32_t> m_lastTouched; ///< bricks of the last batch
    std::optional<core::LeakGuard> m_guard;
    std::optional<core::LeakAlarm> m_alarm;
};

} // namespace gpu
