// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/export/common/SegmentStatistics.h"

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// Measures one segment. Its values may come in portions: exports pass the whole volume, the window
/// passes the boxes that it reads. Values and positions are counted in whole numbers, so both get
/// exactly the same results. Any thread, one at a time.
class SegmentMeter {
public:
    /// @param labels one for each voxel of the volume in the segment's plane, x fastest; they must
    /// outlive this
    SegmentMeter(const VolumeGeometry& geometry, const VoxelEncoding& encoding,
        const Segment& segment, std::span<const std::uint8_t> labels);

    /// Counts the segment's voxels in a box. Boxes must not overlap.
    /// @param codes one for each voxel of the box, x fastest
    void count(const VoxelBox& box, std::span<const std::uint16_t> codes);
    /// The measurements of the voxels that were counted. The surface is measured from all labels,
    /// so the result is consistent only after boxes around all voxels of the segment were counted.
    /// Changes since an import are not included.
    /// @pre a voxel was counted
    [[nodiscard]] SegmentStatistics statistics() const;

private:
    [[nodiscard]] int percentileCode(int share) const;
    void measureValues(SegmentStatistics& found) const;
    void measurePlace(SegmentStatistics& found) const;

    VolumeGeometry m_geometry;
    VoxelEncoding m_encoding;
    Segment m_segment;
    std::span<const std::uint8_t> m_labels;
    std::vector<std::int64_t> m_ofCode;
    std::vector<std::int64_t> m_ofSlice;
    std::vector<std::int64_t> m_columnSums; ///< per slice
    std::vector<std::int64_t> m_rowSums;
    glm::ivec3 m_first{0};
    glm::ivec3 m_last{-1};
    std::int64_t m_voxels = 0;
};

} // namespace core
