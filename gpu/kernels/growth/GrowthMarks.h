// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/shrink/PreviewMarks.h"

#include <cstddef>
#include <vector>

namespace gpu {

/// What pictures mark of a moving interval: what the open growth has changed and, if it is to be
/// kept, what is suspended from one growth to the next (core::CompareGrowth, seed A §5.3). Engine
/// thread only.
class GrowthMarks {
public:
    using Bricks = std::vector<PreviewMarks::Brick>;

    /// @param textures outlive this
    explicit GrowthMarks(VolumeTextures& textures)
        : m_marks(textures)
    {
    }

    /// An edit begins. Only a growth may find what earlier ones have suspended.
    void begin(bool grows);
    /// Shows what the open growth has changed so far.
    /// @param keep whether what is suspended stays known once the growth is committed
    void show(VoxelFields& fields, Bricks changed, bool keep);
    void hide() { m_marks.hide(); }
    /// Whether keep() is to be called after the commit of the open growth.
    [[nodiscard]] bool keeps() const { return m_keeps; }
    /// Shows what a committed growth has changed in the end, until forget() or begin().
    void keep(VoxelFields& fields, Bricks changed);
    /// Shows what was kept before the growth, which was taken back.
    void restore(VoxelFields& fields);
    void forget();
    [[nodiscard]] std::size_t bytes() const { return m_marks.bytes(); }

private:
    PreviewMarks m_marks;
    Bricks m_kept;
    bool m_keeps = false;
};

/// The marks of a growth after earlier ones: what those have suspended is suspended still, unless
/// this one has claimed it; then it is reinstated.
/// @param kept the marks of the growth before, each brick once
/// @return ascending; bricks with marks
[[nodiscard]] std::vector<PreviewMarks::Brick> marksAfter(
    const std::vector<PreviewMarks::Brick>& kept, std::vector<PreviewMarks::Brick> changed);

} // namespace gpu
