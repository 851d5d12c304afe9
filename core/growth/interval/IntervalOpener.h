// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/LeakGuard.h"
#include "core/growth/interval/GrowthBricks.h"
#include "core/growth/interval/SuspendedSeeds.h"

#include <memory>
#include <vector>

namespace core {

/// The state of a growth after a burst with another interval was opened, before its first step.
struct OpenedInterval {
    std::uint8_t label = 0; ///< the one that grows
    std::uint32_t kept = 0; ///< the greatest generation of a member that stayed
    /// Seeds that became members at the opening, with generation kept + 1.
    std::vector<LeakGuard::Voxel> admitted{};
    /// All members that can claim a neighbour in the first step, ascending.
    std::vector<LeakGuard::Voxel> front{};
    std::size_t withdrawn = 0; ///< number of members that left
};

/// Opens a growth again and again under different intervals (GrowOpening::Narrow in
/// GrowthCommands.h), each time from the same initial state. The result equals that of opening a
/// burst, word for word. But the cost is ∝ the voxels that leave or are let in, not ∝ all that has
/// grown:
/// - Members that the interval excludes leave; then, repeatedly, members that have lost their last
///   supporting neighbour. Support leads from earlier to later generations only, so the order does
///   not matter, and no other members need to be examined.
/// - Voxels that can be claimed next are suspended voxels or voxels that have just left. Suspended
///   voxels are kept in a list sorted by value (SuspendedSeeds).
///
/// It works for growths of a single label whose criterion at a voxel depends on that voxel's code
/// alone.
class IntervalOpener {
public:
    using Voxel = GrowthBricks::Voxel;

    /// Whether it can be used for a burst: the opening is Narrow, and only codes, a box and the
    /// label plane decide; there is no GrowthRange. (Whether a single label grows is found out by
    /// prepare().)
    [[nodiscard]] static bool suits(const GrowBurst& burst);
    /// Reads the growth and removes members that do not qualify under any interval. Only this step
    /// costs ∝ all that has grown. It uses all cores.
    /// @param held all bricks of the plane with seed words
    /// @return null if more than one label grows, or none
    [[nodiscard]] static std::unique_ptr<IntervalOpener> prepare(const GrowBurst& burst,
        const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read);

    /// Whether a burst of the same growth differs from that of prepare() at most in its interval
    /// and leak guard.
    [[nodiscard]] bool serves(const GrowBurst& burst) const;
    [[nodiscard]] OpenedInterval open(int lowCode, int highCode);

    [[nodiscard]] const SuspendedSeeds& suspended() const { return m_suspended; }
    /// The growth in the state in which the last open() left it.
    [[nodiscard]] const GrowthBricks& bricks() const { return m_bricks; }

private:
    IntervalOpener(const GrowBurst& burst, const BrickGrid& grid,
        std::span<const std::uint32_t> held, const ReadGrowthBricks& read);

    [[nodiscard]] bool findLabel();
    void dropUnsupported();
    void listSuspended();
    void measureBrick(std::size_t place);

    /// Removes members, and all that depend on them.
    void withdraw(std::vector<Voxel> leaving);
    void leave(Voxel voxel);
    [[nodiscard]] std::vector<Voxel> excluded() const;
    [[nodiscard]] std::vector<Voxel> admitSeeds(std::uint32_t generation);
    [[nodiscard]] std::vector<Voxel> frontFrom(std::span<const Voxel> admitted) const;
    void write(Voxel voxel, const GrowthBricks::State& state);
    void countMember(std::uint32_t word, int change);
    void countMembers(const std::vector<std::uint32_t>& perGeneration);
    void revert();

    [[nodiscard]] bool isInside(int code) const { return m_low <= code && code <= m_high; }
    [[nodiscard]] bool mayHold(std::uint8_t label) const;
    [[nodiscard]] bool isInBox(Voxel voxel) const;
    /// Whether a word is a member of the label that grows; members of locked labels do not grow.
    [[nodiscard]] bool grows(std::uint32_t word) const;
    /// Whether a word is a member that may leave under another interval.
    [[nodiscard]] bool mayLeave(std::uint32_t word) const;
    /// Whether everything except its code admits the label to a voxel that is no member.
    [[nodiscard]] bool isOpen(Voxel voxel) const;
    [[nodiscard]] bool qualifies(Voxel member) const;
    /// The lowest direction from a growing neighbour of an earlier generation, or noParent.
    [[nodiscard]] std::uint32_t parentDirection(Voxel voxel) const;
    [[nodiscard]] std::vector<LeakGuard::Voxel> inVolume(std::span<const Voxel> voxels) const;

    static constexpr std::uint32_t noParent = seedWord::directions;
    struct CodeRange {
        int least = 65536;
        int greatest = -1;
    };

    GrowBurst m_burst;
    GrowthBricks m_bricks;
    std::uint32_t m_neighbours;
    std::uint32_t m_label = 0;
    int m_low = 0;
    int m_high = -1;
    /// Number of members by generation, those of locked labels included.
    std::vector<std::uint32_t> m_perGeneration;
    std::vector<Voxel> m_pending; ///< pending seeds of the label
    SuspendedSeeds m_suspended;
    /// For each brick, the range of codes of members that may leave.
    std::vector<CodeRange> m_ranges;
    std::vector<Voxel> m_left; ///< voxels that left by the last withdraw()
};

} // namespace core
