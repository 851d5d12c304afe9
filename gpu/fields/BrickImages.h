// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

// Bricks of any field as bytes, in and out; an image that is all empty has no bytes. Engine thread
// only.

/// What the bricks hold, in this order. Few dispatches where keys of one field and plane stand
/// together; none for bricks without data. Waits for the GPU.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> readImages(
    VoxelFields& fields, std::span<const core::BrickKey> keys);

/// Puts the images in place of what the bricks hold: gives and takes pages, tells VoxelFields what
/// changed. Voxels outside the volume stay empty.
void writeImages(VoxelFields& fields, std::vector<core::BrickImage> images);

/// The same after something failed in between: with patience, and brick by brick where there is no
/// memory for all at once. Throws FieldsLost.
void putBackImages(VoxelFields& fields, const std::vector<core::BrickImage>& images);

/// What the bricks hold, with their keys.
[[nodiscard]] std::vector<core::BrickImage> imagesNow(
    VoxelFields& fields, const std::vector<core::BrickKey>& keys);

/// As writeImages(), and reads before what is there: bricks that hold their image already are left
/// alone, and what follows from a brick is worked out anew only around the voxels that differ.
/// Throws GlFailure with everything as it was, or FieldsLost.
/// @param images no key twice
/// @return the bricks that differ, sorted by key
[[nodiscard]] std::vector<core::BrickChange> swapImages(
    VoxelFields& fields, std::vector<core::BrickImage> images);
/// The same where it has been read already.
/// @param now sorted by key, these bricks among them
[[nodiscard]] std::vector<core::BrickChange> exchangeImages(VoxelFields& fields,
    const std::vector<core::BrickImage>& now, std::vector<core::BrickImage> images);

/// Calls @p visit(field, plane, run) for runs of what has keys, sorted by key.
template <class Keyed, class Visit> void forEachField(std::span<Keyed> keyed, const Visit& visit)
{
    for (std::size_t first = 0; first < keyed.size();) {
        std::size_t last = first;
        while (last < keyed.size() && keyed[last].key.field == keyed[first].key.field
            && keyed[last].key.plane == keyed[first].key.plane)
            ++last;
        visit(keyed[first].key.field, keyed[first].key.plane, keyed.subspan(first, last - first));
        first = last;
    }
}

template <class Keyed> std::vector<std::uint32_t> bricksOf(std::span<Keyed> keyed)
{
    std::vector<std::uint32_t> bricks;
    bricks.reserve(keyed.size());
    for (const auto& each : keyed)
        bricks.push_back(each.key.brick);
    return bricks;
}

} // namespace gpu
