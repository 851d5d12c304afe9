// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/BrickImages.h"

#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <cstring>

namespace gpu {

namespace {

constexpr int side = core::BrickGrid::side;

/// A brick to be written, and where in it (in voxels of the volume) it differs from what is there.
struct Write {
    core::BrickKey key;
    const core::BrickBytes* bytes = nullptr;
    core::VoxelBox box;
};

void sortByKey(std::vector<core::BrickImage>& images)
{
    std::sort(images.begin(), images.end(),
        [](const core::BrickImage& a, const core::BrickImage& b) { return a.key < b.key; });
}

/// Empty outside the volume, and without bytes where nothing is left.
void normalise(core::BrickImage& image, const core::BrickGrid& grid)
{
    if (image.bytes.empty())
        return;
    const std::uint8_t empty = core::emptyByte(image.key.field);
    const auto wide = std::size_t(core::bytesPerVoxel(image.key.field));
    const core::VoxelBox box = grid.boxOf(int(image.key.brick));
    const glm::ivec3 size = box.maximum - box.minimum;
    if (size != glm::ivec3(side)) {
        std::vector<std::uint8_t>& bytes = image.bytes.write();
        for (int voxel = 0; voxel < core::BrickGrid::voxelsPerBrick; ++voxel) {
            const glm::ivec3 at(voxel % side, voxel / side % side, voxel / (side * side));
            if (glm::any(glm::greaterThanEqual(at, size)))
                std::fill_n(bytes.begin() + std::ptrdiff_t(wide * std::size_t(voxel)), wide, empty);
        }
    }
    const std::vector<std::uint8_t>& bytes = image.bytes.read();
    const bool allEmpty = bytes.front() == empty
        && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0;
    if (allEmpty)
        image.bytes.clear();
}

/// Where two images of bytes differ, in voxels of the brick.
core::VoxelBox differingBox(const core::BrickBytes& before, const core::BrickBytes& after)
{
    static const std::vector<std::uint8_t> empty(core::BrickGrid::voxelsPerBrick, 0);
    const std::vector<std::uint8_t>& a = before.empty() ? empty : before.read();
    const std::vector<std::uint8_t>& b = after.empty() ? empty : after.read();
    core::VoxelBox box;
    for (int row = 0; row < side * side; ++row) {
        const std::uint8_t* from = &a[std::size_t(row * side)];
        const std::uint8_t* to = &b[std::size_t(row * side)];
        int first = 0;
        while (first < side && from[first] == to[first])
            ++first;
        if (first == side)
            continue;
        int last = side - 1;
        while (from[last] == to[last])
            --last;
        const glm::ivec3 at(0, row % side, row / side);
        box = box.united({at + glm::ivec3(first, 0, 0), at + glm::ivec3(last + 1, 1, 1)});
    }
    return box;
}

void write(VoxelFields& fields, std::span<const Write> writes)
{
    forEachField(
        writes, [&fields](core::Field field, std::uint8_t plane, std::span<const Write> run) {
            BrickField* paged = fields.paged(field, plane);
            std::vector<std::uint32_t> written;
            std::vector<std::uint32_t> emptied;
            std::vector<const std::vector<std::uint8_t>*> contents;
            std::vector<core::VoxelBox> boxes;
            for (const Write& one : run) {
                boxes.push_back(one.box);
                if (paged && one.bytes->empty()) {
                    emptied.push_back(one.key.brick);
                    continue;
                }
                written.push_back(one.key.brick);
                contents.push_back(&one.bytes->read());
            }
            if (paged) {
                paged->release(emptied);
                paged->ensure(written, BrickField::NewPages::AnyContent);
            }
            fields.copier().write(fields.textures(field, plane), written, contents);
            if (field == core::Field::Coverage)
                fields.noteCoverage(boxes);
            else
                fields.noteChanged(field, bricksOf(run));
        });
}

} // namespace

std::vector<std::vector<std::uint8_t>> readImages(
    VoxelFields& fields, std::span<const core::BrickKey> keys)
{
    std::vector<std::vector<std::uint8_t>> result(keys.size());
    std::vector<std::size_t> places;
    std::vector<std::uint32_t> bricks;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (fields.hasData(keys[i])) {
            places.push_back(i);
            bricks.push_back(keys[i].brick);
        }
        const bool last = i + 1 == keys.size() || keys[i + 1].field != keys[i].field
            || keys[i + 1].plane != keys[i].plane;
        if (!last || bricks.empty())
            continue;
        auto images = fields.copier().images(fields.textures(keys[i].field, keys[i].plane), bricks);
        for (std::size_t found = 0; found < places.size(); ++found)
            result[places[found]] = std::move(images[found]);
        places.clear();
        bricks.clear();
    }
    return result;
}

void writeImages(VoxelFields& fields, std::vector<core::BrickImage> images)
{
    sortByKey(images);
    std::vector<Write> writes;
    for (core::BrickImage& image : images) {
        normalise(image, fields.grid());
        writes.push_back({image.key, &image.bytes, fields.grid().boxOf(int(image.key.brick))});
    }
    write(fields, writes);
}

void putBackImages(VoxelFields& fields, const std::vector<core::BrickImage>& images)
{
    constexpr int tries = 3;
    const auto written = [&fields](const std::vector<core::BrickImage>& some) {
        for (int i = 0; i < tries; ++i) {
            try {
                writeImages(fields, some);
                requireNoError();
                return true;
            } catch (const ContextLost&) {
                throw;
            } catch (const std::exception&) {
                // Whatever of it was written is written again.
            }
        }
        return false;
    };
    if (written(images))
        return;
    // Where there is no memory for all of them at once there may be for one.
    for (const core::BrickImage& image : images) {
        if (!written({image}))
            throw FieldsLost({core::ErrorCode::OutOfMemory,
                {core::Clause::saying(
                    "the graphics processor has no more, not even to put back what was "
                    "there")}});
    }
}

std::vector<core::BrickImage> imagesNow(
    VoxelFields& fields, const std::vector<core::BrickKey>& keys)
{
    auto bytes = readImages(fields, keys);
    std::vector<core::BrickImage> images;
    images.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        images.push_back({.key = keys[i], .bytes = std::move(bytes[i])});
    return images;
}

std::vector<core::BrickChange> swapImages(VoxelFields& fields, std::vector<core::BrickImage> images)
{
    std::vector<core::BrickKey> keys;
    for (const core::BrickImage& image : images)
        keys.push_back(image.key);
    std::sort(keys.begin(), keys.end());
    return exchangeImages(fields, imagesNow(fields, keys), std::move(images));
}

std::vector<core::BrickChange> exchangeImages(VoxelFields& fields,
    const std::vector<core::BrickImage>& now, std::vector<core::BrickImage> images)
{
    sortByKey(images);
    std::vector<core::BrickChange> changes;
    auto held = now.begin();
    for (core::BrickImage& image : images) {
        while (held->key < image.key)
            ++held;
        normalise(image, fields.grid());
        if (!(held->bytes == image.bytes))
            changes.push_back(
                {.key = image.key, .before = held->bytes, .after = std::move(image.bytes)});
    }
    std::vector<Write> writes;
    for (const core::BrickChange& change : changes) {
        core::VoxelBox box = fields.grid().boxOf(int(change.key.brick));
        if (change.key.field == core::Field::Coverage) {
            const core::VoxelBox differing = differingBox(change.before, change.after);
            box = {box.minimum + differing.minimum, box.minimum + differing.maximum};
        }
        writes.push_back({change.key, &change.after, box});
    }
    try {
        write(fields, writes);
        requireNoError();
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        std::vector<core::BrickImage> saved;
        saved.reserve(changes.size());
        for (core::BrickChange& change : changes)
            saved.push_back({.key = change.key, .bytes = std::move(change.before)});
        putBackImages(fields, saved);
        throw GlFailure(error);
    }
    return changes;
}

} // namespace gpu
