// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

// Reading and writing bricks of any field as bytes. A brick whose voxels are all empty is an image
// without bytes. Engine thread only.

/// The voxels of the bricks, in the order of the keys. Takes few dispatches if keys of one field
/// and plane are adjacent, and none for bricks without data. Waits for the GPU.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> readImages(
    VoxelFields& fields, std::span<const core::BrickKey> keys);

/// Replaces the voxels of the bricks by the images: gives bricks pages or takes pages away, and
/// tells VoxelFields what changed. Voxels outside the volume stay empty.
void writeImages(VoxelFields& fields, std::vector<core::BrickImage> images);

/// The same after a failure: it tries several times, and goes brick by brick if there is no memory
/// for all at once. Throws FieldsLost.
void putBackImages(VoxelFields& fields, const std::vector<core::BrickImage>& images);

/// The voxels of the bricks, together with their keys.
[[nodiscard]] std::vector<core::BrickImage> imagesNow(
    VoxelFields& fields, const std::vector<core::BrickKey>& keys);

/// As writeImages(), but reads the present voxels first. Bricks that hold their image already are
/// not written, and derived fields are updated only around the voxels that differ. Throws GlFailure
/// with everything as it was, or FieldsLost.
/// @param images no key twice
/// @return the bricks that differ, sorted by key
[[nodiscard]] std::vector<core::BrickChange> swapImages(
    VoxelFields& fields, std::vector<core::BrickImage> images);
/// The same if the present voxels have been read already.
/// @param now sorted by key; contains all bricks of @p images
[[nodiscard]] std::vector<core::BrickChange> exchangeImages(VoxelFields& fields,
    const std::vector<core::BrickImage>& now, std::vector<core::BrickImage> images);

/// Calls @p visit(field, plane, run) for each run of elements with the same field and plane. The
/// elements have a `key` and are sorted by it.
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
