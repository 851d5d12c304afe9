// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/fields/DenseFields.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <set>

namespace reference {

namespace {

template <class T>
DenseArray<T>& named(std::map<std::uint8_t, DenseArray<T>>& fields, std::uint8_t plane,
    const glm::ivec3& size, T empty)
{
    DenseArray<T>& field = fields[plane];
    if (field.values.empty()) {
        field.size = size;
        field.values.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), empty);
    }
    return field;
}

template <class Visit> void forEachVoxel(const core::VoxelBox& box, Visit visit)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                visit(glm::ivec3(x, y, z));
}

} // namespace

DenseFields::DenseFields(const glm::ivec3& size)
    : m_grid{size}
{
}

DenseArray<std::uint8_t>& DenseFields::coverage(std::uint8_t layer)
{
    return named<std::uint8_t>(m_coverage, layer, size(), 0);
}

DenseArray<std::uint8_t>& DenseFields::labels(std::uint8_t plane)
{
    return named<std::uint8_t>(m_labels, plane, size(), 0);
}

std::map<std::uint8_t, const DenseArray<std::uint8_t>*> DenseFields::labelPlanes() const
{
    std::map<std::uint8_t, const DenseArray<std::uint8_t>*> planes;
    for (const auto& [plane, field] : m_labels)
        planes[plane] = &field;
    return planes;
}

DenseArray<std::uint32_t>& DenseFields::seedWords(std::uint8_t plane)
{
    return named<std::uint32_t>(m_seedWords, plane, size(), core::seedWord::unvisited);
}

DenseArray<std::uint8_t>& DenseFields::overwritten(std::uint8_t plane)
{
    return named<std::uint8_t>(m_overwritten, plane, size(), 0);
}

const DenseFields::Layers& DenseFields::layersOf(core::Field field) const
{
    return field == core::Field::Labels     ? m_labels
        : field == core::Field::Overwritten ? m_overwritten
                                            : m_coverage;
}

DenseArray<std::uint8_t> DenseFields::composedCoverage(const std::bitset<256>& muted) const
{
    DenseFields nothing(size());
    DenseArray<std::uint8_t> composed = nothing.coverage(0);
    for (const auto& [layer, coverage] : m_coverage) {
        if (muted[layer])
            continue;
        for (std::size_t i = 0; i < composed.values.size(); ++i)
            composed.values[i] = std::max(composed.values[i], coverage.values[i]);
    }
    return composed;
}

bool DenseFields::holds(const core::BrickKey& key) const
{
    const bool known = key.field == core::Field::Coverage || key.field == core::Field::Labels
        || key.field == core::Field::SeedWords || key.field == core::Field::Overwritten;
    return known && key.brick < std::uint32_t(m_grid.brickCount());
}

std::vector<std::uint8_t> DenseFields::readBrick(const core::BrickKey& key) const
{
    const int width = core::bytesPerVoxel(key.field);
    std::vector<std::uint8_t> bytes(
        std::size_t(core::BrickGrid::voxelsPerBrick * width), core::emptyByte(key.field));
    bool empty = true;
    const auto put = [&](const glm::ivec3& voxel, std::uint32_t value, std::uint32_t emptyValue) {
        const std::size_t first = std::size_t(core::BrickGrid::offsetInBrick(voxel) * width);
        for (int byte = 0; byte < width; ++byte)
            bytes[first + std::size_t(byte)] = std::uint8_t(value >> (8 * byte));
        empty = empty && value == emptyValue;
    };
    const core::VoxelBox box = m_grid.boxOf(int(key.brick));
    if (key.field == core::Field::SeedWords) {
        if (const auto found = m_seedWords.find(key.plane); found != m_seedWords.end()) {
            const auto& field = found->second;
            forEachVoxel(box, [&](const glm::ivec3& voxel) {
                put(voxel, field.at(voxel), core::seedWord::unvisited);
            });
        }
    } else {
        const Layers& layers = layersOf(key.field);
        if (const auto found = layers.find(key.plane); found != layers.end()) {
            const auto& field = found->second;
            forEachVoxel(box, [&](const glm::ivec3& voxel) { put(voxel, field.at(voxel), 0); });
        }
    }
    if (empty)
        bytes.clear();
    return bytes;
}

void DenseFields::writeBrick(const core::BrickKey& key, std::span<const std::uint8_t> bytes)
{
    const int width = core::bytesPerVoxel(key.field);
    const auto get = [&](const glm::ivec3& voxel) {
        const std::size_t first = std::size_t(core::BrickGrid::offsetInBrick(voxel) * width);
        std::uint32_t value = 0;
        for (int byte = 0; byte < width; ++byte) {
            const std::uint32_t part =
                bytes.empty() ? core::emptyByte(key.field) : bytes[first + std::size_t(byte)];
            value |= part << (8 * byte);
        }
        return value;
    };
    const core::VoxelBox box = m_grid.boxOf(int(key.brick));
    if (key.field == core::Field::SeedWords) {
        auto& field = seedWords(key.plane);
        forEachVoxel(box, [&](const glm::ivec3& voxel) { field.at(voxel) = get(voxel); });
    } else {
        auto& field = key.field == core::Field::Labels ? labels(key.plane)
            : key.field == core::Field::Overwritten    ? overwritten(key.plane)
                                                       : coverage(key.plane);
        forEachVoxel(
            box, [&](const glm::ivec3& voxel) { field.at(voxel) = std::uint8_t(get(voxel)); });
    }
}

std::vector<core::BrickKey> DenseFields::allKeys() const
{
    std::vector<core::BrickKey> keys;
    const auto add = [&](core::Field field, std::uint8_t plane) {
        for (int brick = 0; brick < m_grid.brickCount(); ++brick)
            keys.push_back({field, plane, std::uint32_t(brick)});
    };
    for (const auto& [layer, field] : m_coverage)
        add(core::Field::Coverage, layer);
    for (const auto& [plane, field] : m_labels)
        add(core::Field::Labels, plane);
    for (const auto& [plane, field] : m_seedWords)
        add(core::Field::SeedWords, plane);
    for (const auto& [plane, field] : m_overwritten)
        add(core::Field::Overwritten, plane);
    return keys;
}

std::vector<core::BrickChange> DenseFields::changes(
    const DenseFields& before, const DenseFields& after)
{
    std::set<core::BrickKey> keys;
    for (const DenseFields* state : {&before, &after}) {
        for (const core::BrickKey& key : state->allKeys())
            keys.insert(key);
    }
    std::vector<core::BrickChange> changes;
    for (const core::BrickKey& key : keys) {
        core::BrickChange change{key, before.readBrick(key), after.readBrick(key)};
        if (change.before != change.after)
            changes.push_back(std::move(change));
    }
    return changes;
}

std::vector<core::BrickKey> DenseFields::occupiedBricks() const
{
    std::vector<core::BrickKey> keys = allKeys();
    std::erase_if(keys, [&](const core::BrickKey& key) { return readBrick(key).empty(); });
    std::sort(keys.begin(), keys.end());
    return keys;
}

} // namespace reference
