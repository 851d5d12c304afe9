// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/bricks/BrickField.h"

#include <cstdint>
#include <vector>

namespace gpu {

class VolumeTextures;
class VoxelFields;

/// Marks on voxels of a growth's label plane that views draw: what a cut would remove, and what a
/// moving interval has changed (render/parts/cutPreview.glsl). There may be several sets of marks;
/// views draw the one that was shown last. Engine thread only.
class PreviewMarks {
public:
    /// The values of marks in shaders.
    enum Mark : std::uint8_t {
        None,
        Goes, ///< would be removed by a cut
        Suspended, ///< has left an open growth
        Reached, ///< was claimed by an open growth
        Reinstated, ///< was claimed after an earlier growth had suspended it
    };
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> marks; ///< one Mark for each of 4096 voxels
        bool operator==(const Brick&) const = default;
    };

    /// @param textures outlive this
    explicit PreviewMarks(VolumeTextures& textures);

    /// Shows marks in the views. Only bricks that differ from those shown already are written.
    /// @param bricks the bricks with marks, each once
    /// @param plane the label plane of the growth; they are seen while that one is shown
    void show(VoxelFields& fields, std::vector<Brick> bricks, std::uint8_t plane = 0);
    /// Removes the marks from the views and frees their memory.
    void hide();
    [[nodiscard]] std::size_t bytes() const;

private:
    VolumeTextures& m_textures;
    std::vector<Brick> m_shown; ///< the content of m_marks
    BrickField m_marks; ///< R8UI
};

} // namespace gpu
