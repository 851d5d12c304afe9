// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/VoxelFields.h"

#include <map>
#include <vector>

namespace gpu {

/// The bricks that an open transaction has saved before it wrote them: each brick once, on first
/// touch, kept on the GPU until the transaction ends (DESIGN §3.3). Engine thread only.
class BeforeImages {
public:
    explicit BeforeImages(VoxelFields& fields)
        : m_fields(fields)
    {
    }

    /// Saves those of the bricks that were not saved yet. Call it before writing them. Throws
    /// GlFailure; in that case none of them was saved.
    void capture(core::Field field, std::uint8_t plane, std::span<const std::uint32_t> bricks);
    /// Compares the saved images of the listed keys, all of which must have been captured, with
    /// what is there now. Bricks that did not change are left out. Sorted by key. Waits for the
    /// GPU.
    [[nodiscard]] std::vector<core::BrickChange> changes(std::vector<core::BrickKey> keys);
    /// Divides keys into parts of some size for changes(), which together cost little more than all
    /// keys at once: what was saved at one time stays together. No part is empty.
    [[nodiscard]] std::vector<std::vector<core::BrickKey>> inParts(
        std::vector<core::BrickKey> keys) const;
    /// Whether so much was saved that inParts() may come to more than one part.
    [[nodiscard]] bool isMuch() const { return m_places.size() > bricksOfPart; }
    /// Restores the saved images of the listed keys.
    void restore(std::vector<core::BrickKey> keys);
    /// Restores everything that was saved, after a failure (putBackImages()). Throws FieldsLost.
    void restoreAll();

private:
    struct Batch {
        core::Field field = core::Field::Coverage;
        std::uint8_t plane = 0;
        std::vector<std::uint32_t> bricks;
        Buffer packed;
    };
    static constexpr std::size_t bricksOfPart = 2048; ///< at least
    static constexpr std::size_t wasEmpty = std::size_t(-1);
    struct Place {
        std::size_t batch = wasEmpty;
        std::size_t slot = 0;
    };
    void restoreOnGpu(const Batch& batch, const std::vector<std::uint32_t>& asked);
    [[nodiscard]] std::vector<core::BrickKey> keys() const;
    [[nodiscard]] std::vector<core::BrickImage> saved(std::vector<core::BrickKey> keys) const;
    /// The saved image of each key; no key may occur twice.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> images(
        std::span<const core::BrickKey> keys) const;

    VoxelFields& m_fields;
    std::map<core::BrickKey, Place> m_places;
    std::vector<Batch> m_batches;
};

} // namespace gpu
