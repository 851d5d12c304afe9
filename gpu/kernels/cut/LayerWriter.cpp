// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/LayerWriter.h"

#include "gpu/fields/BrickImages.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace gpu {

namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<core::BrickKey> keysOf(
    core::Field field, std::uint8_t plane, const std::vector<std::uint32_t>& bricks)
{
    std::vector<core::BrickKey> keys;
    for (const std::uint32_t brick : bricks)
        keys.push_back({field, plane, brick});
    return keys;
}

/// Coverage of a layer by what another field holds in the same bricks.
/// @param rule what a voxel's coverage becomes, from what the other field holds and from itself
std::vector<core::BrickKey> cover(VoxelFields& fields, BeforeImages& before,
    const std::vector<core::BrickKey>& sources, std::uint8_t layer,
    const std::function<std::uint8_t(std::uint8_t, std::uint8_t)>& rule)
{
    std::vector<core::BrickKey> keys;
    std::vector<std::uint32_t> bricks;
    for (const core::BrickKey& source : sources) {
        keys.push_back({core::Field::Coverage, layer, source.brick});
        bricks.push_back(source.brick);
    }
    before.capture(core::Field::Coverage, layer, bricks);
    const std::vector<Bytes> from = readImages(fields, sources);
    std::vector<Bytes> held = readImages(fields, keys);
    std::vector<core::BrickKey> changed;
    std::vector<core::BrickImage> images;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (from[i].empty())
            continue;
        Bytes now = held[i].empty() ? Bytes(from[i].size(), 0) : held[i];
        std::transform(from[i].begin(), from[i].end(), now.begin(), now.begin(), rule);
        const bool nothing =
            std::all_of(now.begin(), now.end(), [](int each) { return each == 0; });
        if (now == held[i] || (held[i].empty() && nothing))
            continue;
        changed.push_back(keys[i]);
        images.push_back({keys[i], std::move(now)});
    }
    writeImages(fields, std::move(images));
    return changed;
}

/// All that has another label, so many bricks at once that their bytes need little memory.
std::vector<core::BrickKey> coverOutside(
    VoxelFields& fields, BeforeImages& before, const core::CoverLabel& edit)
{
    constexpr std::uint32_t atOnce = 1024;
    const core::BrickGrid& grid = fields.grid();
    const auto count = std::uint32_t(grid.brickCount());
    std::vector<core::BrickKey> changed;
    for (std::uint32_t first = 0; first < count; first += atOnce) {
        std::vector<std::uint32_t> bricks(std::min(atOnce, count - first));
        std::iota(bricks.begin(), bricks.end(), first);
        const std::vector<core::BrickKey> keys = keysOf(core::Field::Coverage, edit.layer, bricks);
        before.capture(core::Field::Coverage, edit.layer, bricks);
        const std::vector<Bytes> labels =
            readImages(fields, keysOf(core::Field::Labels, edit.plane, bricks));
        const std::vector<Bytes> held = readImages(fields, keys);
        std::vector<core::BrickImage> images;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            Bytes now = held[i].empty() ? Bytes(core::BrickGrid::voxelsPerBrick, 0) : held[i];
            bool any = false;
            const core::VoxelBox box = grid.boxOf(int(bricks[i]));
            for (int z = box.minimum.z; z < box.maximum.z; ++z) {
                for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                    for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                        const auto at = std::size_t(core::BrickGrid::offsetInBrick({x, y, z}));
                        const std::uint8_t label = labels[i].empty() ? 0 : labels[i][at];
                        if (label == edit.label || edit.protectedLabels[label] || now[at] == 255)
                            continue;
                        now[at] = 255;
                        any = true;
                    }
                }
            }
            if (!any)
                continue;
            changed.push_back(keys[i]);
            images.push_back({keys[i], std::move(now)});
        }
        writeImages(fields, std::move(images));
    }
    return changed;
}

} // namespace

std::vector<core::BrickKey> coverLabel(ErasePrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::CoverLabel& edit)
{
    if (edit.outside)
        return coverOutside(fields, before, edit);
    const std::vector<std::uint32_t> holders =
        labelHolders(programs, fields, edit.plane, edit.label);
    return cover(fields, before, keysOf(core::Field::Labels, edit.plane, holders), edit.layer,
        [&edit](std::uint8_t label, std::uint8_t coverage) {
            return label == edit.label ? std::uint8_t(255) : coverage;
        });
}

std::vector<core::BrickKey> foldLayer(
    VoxelFields& fields, BeforeImages& before, const core::FoldLayer& edit)
{
    const std::vector<core::BrickKey> emptied =
        keysOf(core::Field::Coverage, edit.layer, fields.coverage(edit.layer).heldBricks());
    std::vector<core::BrickKey> touched;
    if (edit.into)
        touched = cover(fields, before, emptied, *edit.into,
            [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    std::vector<std::uint32_t> bricks;
    std::vector<core::BrickImage> images;
    for (const core::BrickKey& key : emptied) {
        bricks.push_back(key.brick);
        images.push_back({key, {}});
    }
    before.capture(core::Field::Coverage, edit.layer, bricks);
    writeImages(fields, std::move(images));
    touched.insert(touched.end(), emptied.begin(), emptied.end());
    return touched;
}

} // namespace gpu
