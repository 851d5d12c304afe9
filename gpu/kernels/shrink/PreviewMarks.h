// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/bricks/BrickField.h"

#include <cstdint>
#include <vector>

namespace gpu {

class VolumeTextures;
class VoxelFields;

/// Marks on voxels of plane 0 that pictures draw: what a cut would remove, and what a moving
/// interval has changed (render/parts/cutPreview.glsl). Pictures show one set at a time, the one
/// that was set last. Engine thread only.
class PreviewMarks {
public:
    /// The values of the marks, as the shaders read them.
    enum Mark : std::uint8_t {
        None,
        Goes, ///< a cut would remove it
        Suspended, ///< it has left an open growth
        Reached, ///< an open growth has claimed it
        Reinstated, ///< the same, after an earlier one had suspended it
    };
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> marks; ///< 4096
        bool operator==(const Brick&) const = default;
    };

    /// @param textures outlive this
    explicit PreviewMarks(VolumeTextures& textures);

    /// Only what differs from what is shown already is written.
    /// @param bricks those with marks, each once
    void show(VoxelFields& fields, std::vector<Brick> bricks);
    void hide();
    [[nodiscard]] std::size_t bytes() const;

private:
    VolumeTextures& m_textures;
    std::vector<Brick> m_shown; ///< what m_marks holds
    BrickField m_marks; ///< R8UI
};

} // namespace gpu
