// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/morphology/BallFilters.h"
#include "core/morphology/GaussianFilter.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// Goes through the rows of a box of a volume; both are stored x fastest. Once the work is
/// cancelled it stops on the way, so what it returns then is of no use.
/// @pre the box lies within the volume
class BoxRows {
public:
    BoxRows(const VoxelBox& box, const glm::ivec3& volumeSize, const Progress& progress)
        : m_box(box)
        , m_size(volumeSize)
        , m_progress(progress)
    {
    }

    [[nodiscard]] glm::ivec3 boxSize() const { return m_box.maximum - m_box.minimum; }
    [[nodiscard]] ImageEnds ends() const
    {
        return {.before = glm::equal(m_box.minimum, glm::ivec3(0)),
            .behind = glm::equal(m_box.maximum, m_size)};
    }
    /// Calls @p visit(index in the volume, index in the box, width) for each row of the box; the
    /// indices are those of its first voxel.
    template <class Visit> void forEach(const Visit& visit) const
    {
        const auto width = std::size_t(boxSize().x);
        std::size_t in = 0;
        for (int z = m_box.minimum.z; z < m_box.maximum.z && !m_progress.cancelled(); ++z) {
            for (int y = m_box.minimum.y; y < m_box.maximum.y; ++y, in += width) {
                const std::size_t row = std::size_t(z) * std::size_t(m_size.y) + std::size_t(y);
                visit(row * std::size_t(m_size.x) + std::size_t(m_box.minimum.x), in, width);
            }
        }
    }
    /// Calls @p visit(index in this box, index in the other box, width) for the part of each row
    /// that lies in both boxes.
    template <class Visit> void forEachWithin(const BoxRows& other, const Visit& visit) const
    {
        const glm::ivec3 from = glm::max(m_box.minimum, other.m_box.minimum);
        const glm::ivec3 to = glm::min(m_box.maximum, other.m_box.maximum);
        if (to.x <= from.x)
            return;
        for (int z = from.z; z < to.z && !m_progress.cancelled(); ++z) {
            for (int y = from.y; y < to.y; ++y)
                visit(indexOf({from.x, y, z}), other.indexOf({from.x, y, z}),
                    std::size_t(to.x - from.x));
        }
    }
    /// The voxels of the box that have the label, or with `own` false those that do not.
    [[nodiscard]] ByteMask mask(
        std::span<const std::uint8_t> labels, std::uint8_t label, bool own = true) const
    {
        const glm::ivec3 size = boxSize();
        ByteMask mask{.size = size,
            .voxels = std::vector<std::uint8_t>(
                std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))};
        forEach([&](std::size_t of, std::size_t in, std::size_t width) {
            for (std::size_t x = 0; x < width; ++x)
                mask.voxels[in + x] = (labels[of + x] == label) == own ? 1 : 0;
        });
        return mask;
    }
    /// The voxels of a label that are chosen, in the order of memory.
    /// @param isChosen called with the index of the voxel in the box
    template <class IsChosen>
    [[nodiscard]] VoxelRuns voxels(
        std::span<const std::uint8_t> labels, std::uint8_t label, const IsChosen& isChosen) const
    {
        VoxelRuns runs;
        forEach([&](std::size_t of, std::size_t in, std::size_t width) {
            for (std::size_t x = 0; x < width; ++x) {
                const std::size_t begin = x;
                while (x < width && labels[of + x] == label && isChosen(in + x))
                    ++x;
                runs.append(of + begin, x - begin);
            }
        });
        return runs;
    }

private:
    [[nodiscard]] std::size_t indexOf(const glm::ivec3& voxel) const
    {
        const glm::ivec3 at = voxel - m_box.minimum;
        const glm::ivec3 size = boxSize();
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
            + std::size_t(at.x);
    }

    VoxelBox m_box;
    glm::ivec3 m_size;
    const Progress& m_progress;
};

} // namespace core
