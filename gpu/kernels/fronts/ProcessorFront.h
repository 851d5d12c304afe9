// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/LeakGuard.h"
#include "core/growth/front/BrickFront.h"
#include "gpu/fields/VoxelFields.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gpu {

/// The front of a growth as bits in the program's own memory, advanced by the processor. With a
/// software driver this is several times as fast as the kernels, which are slowed down by a
/// dispatch for each generation and an image access for each voxel (ALGORITHMS 1.6.10). It serves
/// the same growths as FrontBits, and what it writes is the same, to the bit.
///
/// The fields are written once after each batch of generations, and only where it has claimed
/// voxels. Takes 1.7 KiB for each brick that the growth has looked at, and 36 to 40 KiB more for
/// each that the front reaches in one batch. Engine thread only.
class ProcessorFront {
public:
    struct Options {
        std::uint8_t label = 0;
        std::uint8_t plane = 0;
        int connectivity = 6; ///< 6, 18 or 26
        bool tellsHeld = false; ///< GrowBurst::tellsHeld
        bool keepsOverwritten = false; ///< whether Field::Overwritten is written where it has pages
    };
    /// @param fields must outlive this
    /// @param front the voxels from which the growth goes on
    /// @param generation of these voxels
    ProcessorFront(VoxelFields& fields, const Options& options,
        std::span<const core::LeakGuard::Voxel> front, std::uint32_t generation);
    ~ProcessorFront();

    /// Which of the listed bricks have open voxels that are not known yet.
    [[nodiscard]] std::vector<std::uint32_t> unknown(std::span<const std::uint32_t> bricks) const;
    /// Sets which voxels of these bricks may be claimed.
    void setOpen(
        std::span<const std::uint32_t> bricks, std::span<const core::VoxelBits> openVoxels);

    static constexpr int mostRings = core::BrickClaims::mostRings;
    /// Runs at most mostRings generations one after the other. The open voxels of all bricks that
    /// they may reach must be known. write() must follow before the next call.
    /// @param generation of the front
    /// @return the number of voxels that each generation claimed; the first that claims none is the
    /// last, and is left out
    std::vector<std::uint32_t> advance(std::uint32_t generation, int rings);
    /// The bricks in which advance() has claimed voxels, ascending.
    [[nodiscard]] std::vector<std::uint32_t> claimedBricks() const;
    /// Writes what advance() has claimed into the fields.
    /// @param bricks claimedBricks(), all of which have pages
    /// @param newPages those of them that had no page until now, ascending; what the pages hold
    /// does not matter
    void write(std::span<const std::uint32_t> bricks, std::span<const std::uint32_t> newPages);

    /// The bricks that hold the front, ascending.
    [[nodiscard]] std::vector<std::uint32_t> frontBricks() const;
    /// The voxels of the front, by brick, then by offset.
    [[nodiscard]] std::vector<core::LeakGuard::Voxel> voxels() const;

private:
    struct Brick;
    struct Images;

    Brick& known(std::uint32_t brick);
    void findReached(std::uint32_t generation);
    /// Claims the voxels of one more generation in all bricks of m_reached.
    /// @param ring the generation, counted from that before the batch
    void claim(int ring);
    int claimIn(Brick& brick, int ring) const;
    /// Gives a brick room for images, if it has none.
    void takeImages(Brick& brick);
    /// Reads them from the fields, if that was not done yet.
    void fetch(Brick& brick, std::span<const std::uint32_t> newPages);
    /// From a brick to one that its front may reach next.
    struct Way {
        std::size_t place = 0; ///< in core::FrontsAround
        unsigned sides = 0; ///< that the front must reach (core::sidesReached())
    };

    VoxelFields& m_fields;
    Options m_options;
    std::vector<Way> m_ways; ///< by connectivity
    std::vector<std::unique_ptr<Brick>> m_bricks; ///< by number; null: not reached yet
    std::vector<Brick*> m_front; ///< those that hold the front
    std::vector<Brick*> m_reached; ///< those that the next generation may change
    std::vector<int> m_claimed; ///< in each of them
    std::uint32_t m_generation = 0; ///< of the front
    std::size_t m_size = 0; ///< its voxels
    core::ClaimRule m_rule; ///< of the last advance()
    std::vector<Brick*> m_imaged; ///< those that have images
    std::vector<std::unique_ptr<Images>> m_spare; ///< for bricks that the front reaches next
};

} // namespace gpu
