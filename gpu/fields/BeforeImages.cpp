// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/BeforeImages.h"

#include "gpu/fields/BrickImages.h"

#include <algorithm>
#include <utility>

namespace gpu {

void BeforeImages::capture(
    core::Field field, std::uint8_t plane, std::span<const std::uint32_t> bricks)
{
    Batch batch{.field = field, .plane = plane, .bricks = {}, .packed = {}};
    std::map<core::BrickKey, Place> places;
    for (const std::uint32_t brick : bricks) {
        const core::BrickKey key{.field = field, .plane = plane, .brick = brick};
        if (m_places.contains(key) || places.contains(key))
            continue;
        if (!m_fields.hasData(key)) {
            places[key] = Place{};
            continue;
        }
        places[key] = {.batch = m_batches.size(), .slot = batch.bricks.size()};
        batch.bricks.push_back(brick);
    }
    if (!batch.bricks.empty()) {
        batch.packed = m_fields.copier().packed(m_fields.textures(field, plane), batch.bricks);
        m_batches.push_back(std::move(batch));
    }
    m_places.merge(places); // only what is saved counts as saved
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

std::vector<std::vector<core::BrickKey>> BeforeImages::inParts(
    std::vector<core::BrickKey> keys) const
{
    std::vector<std::pair<std::size_t, core::BrickKey>> byBatch;
    byBatch.reserve(keys.size());
    for (const core::BrickKey& key : keys)
        byBatch.emplace_back(m_places.at(key).batch, key);
    std::sort(byBatch.begin(), byBatch.end());
    std::vector<std::vector<core::BrickKey>> parts;
    std::size_t last = wasEmpty;
    for (const auto& [batch, key] : byBatch) {
        const bool mayBegin = batch != last || batch == wasEmpty;
        if (parts.empty() || (mayBegin && parts.back().size() >= bricksOfPart))
            parts.emplace_back();
        parts.back().push_back(key);
        last = batch;
    }
    return parts;
}

std::vector<core::BrickImage> BeforeImages::saved(std::vector<core::BrickKey> keys) const
{
    std::sort(keys.begin(), keys.end());
    auto before = images(keys);
    std::vector<core::BrickImage> saved;
    saved.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        saved.push_back({.key = keys[i], .bytes = std::move(before[i])});
    return saved;
}

void BeforeImages::restore(std::vector<core::BrickKey> keys)
{
    // Coverage wants to know where it changes, and bricks that were empty lose their pages again.
    // All others need not pass through memory.
    std::vector<std::vector<std::uint32_t>> asked(m_batches.size()); // by slot
    const auto goesBackOnGpu = [this, &asked](const core::BrickKey& key) {
        const Place& place = m_places.at(key);
        if (place.batch == wasEmpty || key.field == core::Field::Coverage)
            return false;
        std::vector<std::uint32_t>& bricks = asked[place.batch];
        bricks.resize(m_batches[place.batch].bricks.size(), BrickCopier::skipped);
        bricks[place.slot] = key.brick;
        return true;
    };
    std::erase_if(keys, goesBackOnGpu);
    writeImages(m_fields, saved(std::move(keys)));
    for (std::size_t batch = 0; batch < m_batches.size(); ++batch) {
        if (!asked[batch].empty())
            restoreOnGpu(m_batches[batch], asked[batch]);
    }
}

/// @param asked the bricks of the batch that are restored, each in its slot
void BeforeImages::restoreOnGpu(const Batch& batch, const std::vector<std::uint32_t>& asked)
{
    std::vector<std::uint32_t> bricks = asked;
    std::erase(bricks, BrickCopier::skipped);
    if (BrickField* paged = m_fields.paged(batch.field, batch.plane))
        paged->ensure(bricks, BrickField::NewPages::AnyContent);
    m_fields.copier().write(m_fields.textures(batch.field, batch.plane), asked, batch.packed);
    m_fields.noteChanged(batch.field, bricks);
}

void BeforeImages::restoreAll()
{
    putBackImages(m_fields, saved(keys()));
}

std::vector<core::BrickKey> BeforeImages::keys() const
{
    std::vector<core::BrickKey> keys;
    keys.reserve(m_places.size());
    for (const auto& place : m_places)
        keys.push_back(place.first);
    return keys;
}

} // namespace gpu
