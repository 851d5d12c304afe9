// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/LeakGuard.h"
#include "core/growth/interval/GrowthBricks.h"
#include "core/growth/interval/SuspendedSeeds.h"

#include <memory>
#include <vector>

namespace core {

/// A growth as it is when a burst with another interval has opened, before its first step.
struct OpenedInterval {
    std::uint8_t label = 0; ///< the one that grows
    std::uint32_t kept = 0; ///< the greatest generation of a member that stayed
    /// Seeds that were admitted; they are of generation kept + 1.
    std::vector<LeakGuard::Voxel> admitted{};
    /// All members that can claim a neighbour in the first step, ascending.
    std::vector<LeakGuard::Voxel> front{};
    std::size_t withdrawn = 0; ///< members that left
};

/// Opens one growth under one interval after the other (GrowOpening::Narrow in GrowthCommands.h),
/// each time from the same beginning, word for word as opening a burst does, at a cost that follows
/// what leaves and what is let in instead of all that has grown:
/// - What an interval excludes leaves, and then, over and over, whatever has no neighbour left that
///   it followed. Support leads from earlier to later generations only, so the order does not
///   matter, and nothing else need be asked.
/// - What can be claimed next is what suspended voxels or voxels that have left touch. Suspended
///   voxels lie in a list by value (SuspendedSeeds).
///
/// It serves growths of a single label whose criterion at a voxel is that voxel's code alone.
class IntervalOpener {
public:
    using Voxel = GrowthBricks::Voxel;

    /// Whether a burst may be opened by it: it narrows, and only codes, a box and the label plane
    /// decide. Whether a single label grows, prepare() finds out.
    [[nodiscard]] static bool suits(const GrowBurst& burst);
    /// Reads the growth and drops, whatever the interval, what no longer qualifies: the only work
    /// that grows with all that has grown. All cores take part.
    /// @param held all bricks of the plane with seed words
    /// @return null where more than one label grows, or none
    [[nodiscard]] static std::unique_ptr<IntervalOpener> prepare(const GrowBurst& burst,
        const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read);

    /// Whether a burst of the same growth differs from that of prepare() at most in its interval
    /// and leak guard.
    [[nodiscard]] bool serves(const GrowBurst& burst) const;
    [[nodiscard]] OpenedInterval open(int lowCode, int highCode);

    [[nodiscard]] const SuspendedSeeds& suspended() const { return m_suspended; }
    /// The growth as open() has made it.
    [[nodiscard]] const GrowthBricks& bricks() const { return m_bricks; }

private:
    IntervalOpener(const GrowBurst& burst, const BrickGrid& grid,
        std::span<const std::uint32_t> held, const ReadGrowthBricks& read);

    [[nodiscard]] bool findLabel();
    void dropUnsupported();
    void listSuspended();
    void measureBrick(std::size_t place);

    /// Takes members out, and all that depends on them.
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
    /// Whether a word is a member that grows; those of locked labels stand still.
    [[nodiscard]] bool grows(std::uint32_t word) const;
    /// Whether a word is a member that another interval may take out.
    [[nodiscard]] bool mayLeave(std::uint32_t word) const;
    /// Whether all but its code lets the label into a voxel that is no member.
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
    std::vector<std::uint32_t> m_perGeneration; ///< members, those of locked labels included
    std::vector<Voxel> m_pending; ///< seeds that wait
    SuspendedSeeds m_suspended;
    std::vector<CodeRange> m_ranges; ///< by brick: codes of members that may leave
    std::vector<Voxel> m_left; ///< by the last withdraw()
};

} // namespace core
