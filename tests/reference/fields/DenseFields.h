// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <bitset>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace reference {

/// A voxel array without bricks, pages or anything clever: x fastest, then y, then z.
template <class T> struct DenseArray {
    glm::ivec3 size{0};
    std::vector<T> values;

    [[nodiscard]] std::size_t offset(const glm::ivec3& voxel) const
    {
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    [[nodiscard]] bool contains(const glm::ivec3& voxel) const
    {
        return voxel.x >= 0 && voxel.y >= 0 && voxel.z >= 0 && voxel.x < size.x && voxel.y < size.y
            && voxel.z < size.z;
    }
    [[nodiscard]] T at(const glm::ivec3& voxel) const { return values[offset(voxel)]; }
    [[nodiscard]] T& at(const glm::ivec3& voxel) { return values[offset(voxel)]; }
};

/// All that edits change, dense. Fields come to be, empty, when they are first named.
class DenseFields {
public:
    DenseFields() = default;
    explicit DenseFields(const glm::ivec3& size);

    using Layers = std::map<std::uint8_t, DenseArray<std::uint8_t>>;

    [[nodiscard]] const glm::ivec3& size() const { return m_grid.volumeSize; }
    [[nodiscard]] DenseArray<std::uint8_t>& coverage(std::uint8_t layer);
    [[nodiscard]] DenseArray<std::uint8_t>& labels(std::uint8_t plane);
    /// The label planes that were ever asked for, ascending.
    [[nodiscard]] std::map<std::uint8_t, const DenseArray<std::uint8_t>*> labelPlanes() const;
    [[nodiscard]] DenseArray<std::uint32_t>& seedWords(std::uint8_t plane);
    [[nodiscard]] DenseArray<std::uint8_t>& overwritten(std::uint8_t plane);
    [[nodiscard]] const Layers& coverageLayers() const { return m_coverage; }
    /// Coverage of the composed layers: at each voxel the greatest of all that are not muted.
    [[nodiscard]] DenseArray<std::uint8_t> composedCoverage(const std::bitset<256>& muted) const;

    [[nodiscard]] bool holds(const core::BrickKey& key) const;
    /// Bytes of one brick as the seam speaks of them: none where every voxel is empty.
    [[nodiscard]] std::vector<std::uint8_t> readBrick(const core::BrickKey& key) const;
    void writeBrick(const core::BrickKey& key, std::span<const std::uint8_t> bytes);

    /// Bricks in which two states differ, sorted by key.
    [[nodiscard]] static std::vector<core::BrickChange> changes(
        const DenseFields& before, const DenseFields& after);
    /// Keys of all bricks that hold anything, sorted.
    [[nodiscard]] std::vector<core::BrickKey> occupiedBricks() const;

private:
    [[nodiscard]] std::vector<core::BrickKey> allKeys() const;
    /// Of a field of bytes.
    [[nodiscard]] const Layers& layersOf(core::Field field) const;

    core::BrickGrid m_grid;
    Layers m_coverage;
    Layers m_labels;
    Layers m_overwritten;
    std::map<std::uint8_t, DenseArray<std::uint32_t>> m_seedWords;
};

} // namespace reference
