// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/BeforeImages.h"

#include <algorithm>

namespace gpu {

namespace {

/// Runs over keys of one field and plane, which stand together once sorted.
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

} // namespace

void BeforeImages::capture(
    core::Field field, std::uint8_t plane, std::span<const std::uint32_t> bricks)
{
    Batch batch{.field = field, .bricks = {}, .packed = {}};
    for (const std::uint32_t brick : bricks) {
        const core::BrickKey key{.field = field, .plane = plane, .brick = brick};
        if (m_places.count(key) != 0)
            continue;
        if (!m_fields.hasData(key)) {
            m_places[key] = Place{};
            continue;
        }
        m_places[key] = {.batch = m_batches.size(), .slot = batch.bricks.size()};
        batch.bricks.push_back(brick);
    }
    if (batch.bricks.empty())
        return;
    batch.packed = m_fields.copier().packed(m_fields.textures(field, plane), batch.bricks);
    m_batches.push_back(std::move(batch));
}

void BeforeImages::capture(std::vector<core::BrickKey> keys)
{
    constexpr std::size_t bricksAtOnce = 1024; // storage blocks end at 128 MiB
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> bricks;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        bricks.push_back(keys[i].brick);
        const bool last = i + 1 == keys.size() || keys[i + 1].field != keys[i].field
            || keys[i + 1].plane != keys[i].plane || bricks.size() == bricksAtOnce;
        if (!last)
            continue;
        capture(keys[i].field, keys[i].plane, bricks);
        bricks.clear();
    }
}

std::vector<std::vector<std::uint8_t>> BeforeImages::images(
    std::span<const core::BrickKey> keys) const
{
    std::map<std::size_t, std::vector<std::vector<std::uint8_t>>> batches;
    std::vector<std::vector<std::uint8_t>> result;
    result.reserve(keys.size());
    for (const core::BrickKey& key : keys) {
        const Place& place = m_places.at(key);
        if (place.batch == wasEmpty) {
            result.emplace_back();
            continue;
        }
        auto& images = batches[place.batch];
        if (images.empty()) {
            const Batch& batch = m_batches[place.batch];
            images = BrickCopier::images(batch.packed, batch.field, batch.bricks.size());
        }
        result.push_back(std::move(images[place.slot]));
    }
    return result;
}

std::vector<core::BrickChange> BeforeImages::changes(std::vector<core::BrickKey> keys)
{
    std::sort(keys.begin(), keys.end());
    auto before = images(keys);
    std::vector<core::BrickChange> changes;
    changes.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        changes.push_back({.key = keys[i], .before = std::move(before[i]), .after = {}});
    forEachField(std::span<core::BrickChange>(changes),
        [this](core::Field field, std::uint8_t plane, std::span<core::BrickChange> group) {
            auto after = m_fields.copier().images(m_fields.textures(field, plane), bricksOf(group));
            for (std::size_t i = 0; i < group.size(); ++i)
                group[i].after = std::move(after[i]);
        });
    std::erase_if(changes, [](const core::BrickChange& c) { return c.before == c.after; });
    return changes;
}

void BeforeImages::restore(std::vector<core::BrickKey> keys)
{
    std::sort(keys.begin(), keys.end());
    auto before = images(keys);
    std::vector<core::BrickImage> saved;
    saved.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        saved.push_back({.key = keys[i], .bytes = std::move(before[i])});
    writeImages(m_fields, saved);
}

std::vector<core::BrickKey> BeforeImages::keys() const
{
    std::vector<core::BrickKey> keys;
    keys.reserve(m_places.size());
    for (const auto& place : m_places)
        keys.push_back(place.first);
    return keys;
}

void writeImages(VoxelFields& fields, std::span<const core::BrickImage> images)
{
    std::vector<core::BrickImage> sorted(images.begin(), images.end());
    std::sort(sorted.begin(), sorted.end(),
        [](const core::BrickImage& a, const core::BrickImage& b) { return a.key < b.key; });
    forEachField(std::span<core::BrickImage>(sorted),
        [&fields](core::Field field, std::uint8_t plane, std::span<core::BrickImage> group) {
            BrickField* paged = fields.paged(field, plane);
            std::vector<std::uint32_t> written;
            std::vector<std::uint32_t> emptied;
            std::vector<const std::vector<std::uint8_t>*> contents;
            for (const core::BrickImage& image : group) {
                if (paged && image.bytes.empty()) {
                    emptied.push_back(image.key.brick);
                    continue;
                }
                written.push_back(image.key.brick);
                contents.push_back(&image.bytes);
            }
            if (paged) {
                paged->release(emptied);
                paged->ensure(written);
            }
            fields.copier().write(fields.textures(field, plane), written, contents);
            fields.noteChanged(field, bricksOf(group));
        });
}

} // namespace gpu
