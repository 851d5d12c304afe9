// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/shrink/PreviewMarks.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gpu {

/// The marks that views draw while an interval is moved: what the open growth has changed and, if
/// asked for, what was suspended by earlier growths (core::CompareGrowth, seed A §5.3). Engine
/// thread only.
class GrowthMarks {
public:
    using Bricks = std::vector<PreviewMarks::Brick>;

    /// @param textures outlive this
    explicit GrowthMarks(VolumeTextures& textures)
        : m_marks(textures)
    {
    }

    /// Called when an edit begins. Any edit other than a growth in the same label plane ends the
    /// memory of what was suspended.
    /// @param growing the plane of a growth; none: the edit is none
    void begin(std::optional<std::uint8_t> growing);
    /// Marks what the open growth has changed so far.
    /// @param keep whether suspended voxels are remembered after the commit
    void show(VoxelFields& fields, Bricks changed, bool keep);
    void hide() { m_marks.hide(); }
    /// Whether keep() must be called after the commit of the open growth.
    [[nodiscard]] bool keeps() const { return m_keeps; }
    /// Marks what a committed growth has changed. The marks stay until forget(), or until an edit
    /// begins that is no growth.
    void keep(VoxelFields& fields, Bricks changed);
    /// Restores the marks from before a growth that was rolled back.
    void restore(VoxelFields& fields);
    /// Hides the marks and forgets what was suspended.
    void forget();
    [[nodiscard]] std::size_t bytes() const { return m_marks.bytes(); }

private:
    PreviewMarks m_marks;
    Bricks m_kept;
    std::optional<std::uint8_t> m_plane; ///< of the last growth
    bool m_keeps = false;
};

/// Returns the marks after a further growth. A voxel that was suspended by an earlier growth stays
/// Suspended unless the further growth has changed it; if that growth has claimed it (Reached), it
/// becomes Reinstated.
/// @param kept the marks before the growth, each brick once
/// @param changed the growth's own marks
/// @return bricks with marks, ascending
[[nodiscard]] std::vector<PreviewMarks::Brick> marksAfter(
    const std::vector<PreviewMarks::Brick>& kept, std::vector<PreviewMarks::Brick> changed);

} // namespace gpu
