// SPDX-License-Identifier: Apache-2.0
#include "core/engine/LabelGuard.h"

#include "core/delta/BrickDelta.h"

#include <map>
#include <set>
#include <utility>

namespace core {

namespace {

constexpr std::size_t voxelsInBrick = BrickGrid::voxelsPerBrick;

/// Of a field of bytes; all 0 where there are none.
const std::vector<std::uint8_t>& valuesOf(const BrickBytes& bytes)
{
    static const std::vector<std::uint8_t> empty(voxelsInBrick, 0);
    return bytes.empty() ? empty : bytes.read();
}

tl::unexpected<Error> refused(ErrorCode code, std::uint8_t label)
{
    return failure(code, QString::number(label));
}

Result<void> checkKept(const std::bitset<256>& kept, const BrickBytes& now, const BrickBytes& then)
{
    const std::vector<std::uint8_t>& held = valuesOf(now);
    const std::vector<std::uint8_t>& coming = valuesOf(then);
    for (std::size_t voxel = 0; voxel < voxelsInBrick; ++voxel) {
        if (held[voxel] == coming[voxel])
            continue;
        if (kept[held[voxel]])
            return refused(ErrorCode::SegmentLocked, held[voxel]);
        if (kept[coming[voxel]])
            return refused(ErrorCode::SegmentLocked, coming[voxel]);
    }
    return {};
}

Result<void> checkUncarved(const std::bitset<256>& uncarved, const BrickBytes& labels,
    const BrickBytes& now, const BrickBytes& then)
{
    const std::vector<std::uint8_t>& label = valuesOf(labels);
    const std::vector<std::uint8_t>& held = valuesOf(now);
    const std::vector<std::uint8_t>& coming = valuesOf(then);
    for (std::size_t voxel = 0; voxel < voxelsInBrick; ++voxel) {
        if (coming[voxel] > held[voxel] && uncarved[label[voxel]])
            return refused(ErrorCode::SegmentProtected, label[voxel]);
    }
    return {};
}

/// The label bricks over a brick of coverage that hold what must not be carved.
std::vector<BrickKey> labelsOver(const ProtectedLabels& uncarved, std::uint32_t brick)
{
    std::vector<BrickKey> keys;
    for (std::size_t plane = 0; plane < uncarved.planes.size() && uncarved.labels.any(); ++plane) {
        if (uncarved.planes[plane])
            keys.push_back({Field::Labels, std::uint8_t(plane), brick});
    }
    return keys;
}

std::map<BrickKey, const BrickImage*> byKey(const std::vector<BrickImage>& images)
{
    std::map<BrickKey, const BrickImage*> found;
    for (const BrickImage& image : images)
        found[image.key] = &image;
    return found;
}

} // namespace

std::vector<BrickKey> bricksToRead(const std::vector<BrickImage>& bricks, const LabelGuard& guard)
{
    std::set<BrickKey> keys;
    for (const BrickImage& brick : bricks) {
        keys.insert(brick.key);
        if (brick.key.field != Field::Coverage)
            continue;
        const std::vector<BrickKey> labels = labelsOver(guard.uncarved, brick.key.brick);
        keys.insert(labels.begin(), labels.end());
    }
    return {keys.begin(), keys.end()};
}

Result<void> checkGuard(const LabelGuard& guard, const std::vector<BrickImage>& now,
    const std::vector<BrickImage>& then)
{
    if (!guard.any())
        return {};
    const std::map<BrickKey, const BrickImage*> held = byKey(now);
    for (const BrickImage& image : then) {
        const BrickBytes& before = held.at(image.key)->bytes;
        Result<void> checked;
        if (image.key.field == Field::Labels && guard.kept.any()) {
            checked = checkKept(guard.kept, before, image.bytes);
        } else if (image.key.field == Field::Coverage) {
            for (const BrickKey& labels : labelsOver(guard.uncarved, image.key.brick)) {
                if (checked)
                    checked = checkUncarved(
                        guard.uncarved.labels, held.at(labels)->bytes, before, image.bytes);
            }
        }
        if (!checked)
            return checked;
    }
    return {};
}

std::vector<BrickImage> laidOver(
    const std::vector<BrickImage>& differences, const std::vector<BrickImage>& now)
{
    const std::map<BrickKey, const BrickImage*> held = byKey(now);
    std::map<BrickKey, BrickImage> then;
    for (const BrickImage& difference : differences) {
        const auto known = then.find(difference.key);
        const BrickImage& before = known == then.end() ? *held.at(difference.key) : known->second;
        BrickImage after = exclusiveOr(before, difference);
        then.insert_or_assign(difference.key, std::move(after));
    }
    std::vector<BrickImage> images;
    images.reserve(then.size());
    for (auto& [key, image] : then)
        images.push_back(std::move(image));
    return images;
}

} // namespace core
