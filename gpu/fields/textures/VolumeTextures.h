// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"
#include "core/volume/VoxelEncoding.h"
#include "gpu/fields/textures/MacroCells.h"
#include "gpu/fields/textures/MaximumCells.h"
#include "gpu/fields/textures/PieceTextures.h"
#include "gpu/gl/Texture3D.h"

#include <array>
#include <cstdint>
#include <span>

namespace gpu {

class BarrierBricks;
class BrickField;

/// What changes in an open volume, as the renderers see it.
enum class VolumeField : std::uint8_t {
    Labels, ///< label plane 0
    Radiation, ///< of the composed sculpt layers; ≥ 0.5 is carved away
    Segmentation, ///< radiation of the shown segments' members; ≥ 0.5 is inside one
    Pieces, ///< footprints of pieces (PieceTextures)
    Barriers, ///< what is shut to growth: words of the seed map of plane 0
    BarrierBricks, ///< which bricks hold any of that
    Foreseen, ///< what a cut would take
};

/// The dense textures of the open volume (DESIGN §4). Edit kernels write labels, radiation and
/// segmentation and tell markDirty(); renderers read. Everything here belongs to the engine thread.
///
/// All textures have the volume's size; texel (i, j, k) is voxel (i, j, k).
class VolumeTextures {
public:
    /// Replace everything: codes as given, no labels, nothing carved, no segment shown.
    /// @param codes x fastest, then y, then z
    /// Errors: OutOfMemory(size in words). Throws GlFailure; then it is to be closed.
    core::Result<void> open(const glm::ivec3& size, std::span<const std::uint16_t> codes);
    void close(); ///< nothing is open
    /// Where the volume lies and what its codes mean. Renderers draw when it fits the open size.
    void setGeometry(const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding);

    [[nodiscard]] bool isOpen() const { return bool(m_intensity); }
    [[nodiscard]] bool isDrawable() const { return isOpen() && m_geometry.size == size(); }
    [[nodiscard]] glm::ivec3 size() const { return m_intensity.size(); }
    [[nodiscard]] core::BrickGrid grid() const { return {size()}; }
    [[nodiscard]] const core::VolumeGeometry& geometry() const { return m_geometry; }
    [[nodiscard]] const core::VoxelEncoding& encoding() const { return m_encoding; }

    [[nodiscard]] const Texture3D& intensity() const { return m_intensity; } ///< R16, linear
    [[nodiscard]] const Texture3D& intensityCodes() const
    {
        return m_intensityCodes;
    } ///< R16UI view
    [[nodiscard]] Texture3D& labels() { return m_labels; } ///< R8UI
    [[nodiscard]] Texture3D& radiation() { return m_radiation; } ///< R8, linear
    [[nodiscard]] Texture3D& segmentation() { return m_segmentation; } ///< R8, linear
    [[nodiscard]] MacroCells& cells() { return m_cells; }
    [[nodiscard]] const MaximumCells& maximumCells() const { return m_maximumCells; }
    [[nodiscard]] PieceTextures& pieces() { return m_pieces; }
    /// The seed map of plane 0, lent by whoever edits it; null: there is none.
    [[nodiscard]] BrickField* seedWords() { return m_seedWords; }
    void setSeedWords(BrickField* words) { m_seedWords = words; }
    /// Where barriers are among these, likewise.
    [[nodiscard]] const BarrierBricks* barriers() const { return m_barriers; }
    void setBarriers(const BarrierBricks* barriers) { m_barriers = barriers; }
    /// What a cut of the growth of plane 0 would take (R8UI, 1: goes), likewise; null: nothing.
    [[nodiscard]] BrickField* foreseen() { return m_foreseen; }
    void setForeseen(BrickField* foreseen) { m_foreseen = foreseen; }
    /// The tolerance field of a label of plane 0 (R16UI, whole bricks), likewise; null: none
    /// stands.
    [[nodiscard]] const Texture3D* tolerances(int label) const
    {
        return label == m_toleranceLabel ? m_tolerances : nullptr;
    }
    void setTolerances(const Texture3D* tolerances, int label)
    {
        m_tolerances = tolerances;
        m_toleranceLabel = label;
    }

    /// The kernels that were queued before this call change these voxels of this field.
    void markDirty(VolumeField field, const core::VoxelBox& box);
    /// What was marked since the last call; empty: nothing.
    [[nodiscard]] core::VoxelBox takeDirty(VolumeField field);
    /// Whether the field was ever marked since the volume was opened; before that it is empty.
    [[nodiscard]] bool touched(VolumeField field) const { return m_touched[std::size_t(field)]; }
    /// Another number whenever changes were taken in or another volume or geometry came.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// Another volume or geometry since the last call.
    [[nodiscard]] bool takeReplaced();

    /// GPU bytes of the dense textures above for a volume of this size.
    [[nodiscard]] static std::size_t denseBytes(const glm::ivec3& size);

private:
    core::VolumeGeometry m_geometry;
    core::VoxelEncoding m_encoding;
    Texture3D m_intensity;
    Texture3D m_intensityCodes;
    Texture3D m_labels;
    Texture3D m_radiation;
    Texture3D m_segmentation;
    MacroCells m_cells;
    MaximumCells m_maximumCells;
    std::uint64_t m_revision = 0;
    PieceTextures m_pieces;
    BrickField* m_seedWords = nullptr;
    const BarrierBricks* m_barriers = nullptr;
    BrickField* m_foreseen = nullptr;
    const Texture3D* m_tolerances = nullptr;
    int m_toleranceLabel = 0;
    static constexpr std::size_t fields = 7;
    std::array<core::VoxelBox, fields> m_dirty;
    std::array<bool, fields> m_touched{};
    bool m_replaced = false;
};

} // namespace gpu
