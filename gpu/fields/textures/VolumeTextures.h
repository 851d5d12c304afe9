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
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gpu {

class BarrierBricks;
class BrickField;

/// The fields of an open volume that can change, as the renderers see them.
enum class VolumeField : std::uint8_t {
    Labels, ///< the label planes
    Radiation, ///< of the composed sculpt layers; ≥ 0.5 is carved away
    Segmentation, ///< radiation of the shown segments' members; ≥ 0.5 is inside one
    Pieces, ///< footprints of pieces (PieceTextures)
    Barriers, ///< voxels closed to growth: seed words of the plane whose growth is shown
    BarrierBricks, ///< which bricks hold barriers
    CutPreview, ///< what a cut of the growth would remove
};

/// The dense textures of the open volume (DESIGN §4). Edit kernels write labels, radiation and
/// segmentation and call markDirty(); renderers read them. Engine thread only.
///
/// All textures have the volume's size; texel (i, j, k) is voxel (i, j, k).
class VolumeTextures {
public:
    /// Replaces everything: codes as given, no labels, nothing carved, no segment shown.
    /// @param codes x fastest, then y, then z
    /// Errors: OutOfMemory if a side is longer than textures may be, or if they and the codes would
    /// share the machine's memory and it is too small (core::checkBytes()). Throws GlFailure; then
    /// close() must be called.
    core::Result<void> open(const glm::ivec3& size, std::span<const std::uint16_t> codes);
    /// The same with codes whose memory is given back slice by slice, as soon as they are in a
    /// texture: they do not count beside the textures.
    core::Result<void> take(const glm::ivec3& size, std::vector<std::uint16_t> codes);
    void close(); ///< frees everything; nothing is open afterwards
    /// Sets where the volume lies in the patient and what its codes mean. Renderers draw only if
    /// its size equals that of the open volume.
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
    [[nodiscard]] Texture3D& labels() { return m_labels; } ///< R8UI, plane 0
    /// The label planes that are in use, ascending: labels(), and those that the edit engine owns
    /// (R8UI); core::mostLabelPlanes at most.
    [[nodiscard]] std::vector<const Texture3D*> labelPlanes() const;
    /// What the 3D view sees where label planes overlap (ShownLabels); labels() while it is the
    /// only plane.
    [[nodiscard]] const Texture3D& shownLabels() const
    {
        return m_shownLabels ? *m_shownLabels : m_labels;
    }
    /// @param planes the further ones, ascending
    /// @param shown of all planes; null if there are no further ones
    void setFurtherPlanes(std::vector<const Texture3D*> planes, const Texture3D* shown);
    [[nodiscard]] Texture3D& radiation() { return m_radiation; } ///< R8, linear
    [[nodiscard]] Texture3D& segmentation() { return m_segmentation; } ///< R8, linear
    [[nodiscard]] MacroCells& cells() { return m_cells; }
    [[nodiscard]] const MaximumCells& maximumCells() const { return m_maximumCells; }
    [[nodiscard]] PieceTextures& pieces() { return m_pieces; }
    /// The seed map of the label plane whose growth is shown, owned by the edit engine; null if
    /// there is none.
    [[nodiscard]] BrickField* seedWords() { return m_seedWords; }
    /// The place of that plane in labelPlanes(); none: nothing is labelled there.
    [[nodiscard]] std::optional<std::size_t> growthPlace() const { return m_growthPlace; }
    void setGrowth(std::uint8_t plane, BrickField* words, std::optional<std::size_t> place)
    {
        m_growthPlane = plane;
        m_seedWords = words;
        m_growthPlace = place;
    }
    /// The bricks of the seed map that hold barriers, also owned by the edit engine.
    [[nodiscard]] const BarrierBricks* barriers() const { return m_barriers; }
    void setBarriers(const BarrierBricks* barriers) { m_barriers = barriers; }
    /// The marks of what a cut of a growth would remove, or of what an interval changes in one
    /// (R8UI, PreviewMarks::Mark), also owned by the edit engine; null if there are none.
    [[nodiscard]] BrickField* cutPreview()
    {
        return m_cutPreviewPlane == m_growthPlane ? m_cutPreview : nullptr;
    }
    /// A box around what is suspended, in whole bricks; empty if nothing is.
    [[nodiscard]] const core::VoxelBox& suspended() const { return m_suspended; }
    /// @param plane of the growth that is marked; its marks are given out while it is shown
    void setCutPreview(BrickField* cutPreview, std::uint8_t plane, const core::VoxelBox& suspended)
    {
        m_cutPreview = cutPreview;
        m_cutPreviewPlane = plane;
        m_suspended = suspended;
    }
    /// Takes these marks away; others stay.
    void dropCutPreview(const BrickField& marks)
    {
        if (m_cutPreview == &marks)
            setCutPreview(nullptr, 0, {});
    }
    /// The tolerance field of a label in the plane whose growth is shown (R16UI, whole bricks),
    /// also owned by the edit engine; null if no valid one exists.
    [[nodiscard]] const Texture3D* tolerances(int label) const
    {
        return label == m_toleranceLabel ? m_tolerances : nullptr;
    }
    void setTolerances(const Texture3D* tolerances, int label)
    {
        m_tolerances = tolerances;
        m_toleranceLabel = label;
    }

    /// Notes that kernels queued before this call change these voxels of this field.
    void markDirty(VolumeField field, const core::VoxelBox& box);
    /// The box that was marked since the last call; empty if none was.
    [[nodiscard]] core::VoxelBox takeDirty(VolumeField field);
    /// Whether the field was marked since the volume was opened. Before that it is empty.
    [[nodiscard]] bool touched(VolumeField field) const { return m_touched[std::size_t(field)]; }
    /// Changes whenever changes were taken, or the volume or its geometry was replaced.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// Whether the volume or its geometry was replaced since the last call.
    [[nodiscard]] bool takeReplaced();

    /// A dense texture above, by its label, and the GPU bytes that it takes.
    struct Part {
        const char* label = "";
        std::size_t bytes = 0;
    };
    /// All of them for a volume of this size, and their sum.
    [[nodiscard]] static std::vector<Part> denseParts(const glm::ivec3& size);
    [[nodiscard]] static std::size_t denseBytes(const glm::ivec3& size);

private:
    /// @param besides bytes of memory that stay in use while the textures are made
    [[nodiscard]] static core::Result<void> checkSize(const glm::ivec3& size, std::size_t besides);
    /// @param there called with codes that are in the textures and the cells, so that their memory
    ///     may be given back
    void fill(const glm::ivec3& size, std::span<const std::uint16_t> codes,
        const std::function<void(std::span<const std::uint16_t> codes)>& there);

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
    std::vector<const Texture3D*> m_furtherPlanes;
    const Texture3D* m_shownLabels = nullptr;
    std::uint8_t m_growthPlane = 0;
    BrickField* m_seedWords = nullptr;
    std::optional<std::size_t> m_growthPlace = 0;
    const BarrierBricks* m_barriers = nullptr;
    BrickField* m_cutPreview = nullptr;
    std::uint8_t m_cutPreviewPlane = 0;
    core::VoxelBox m_suspended;
    const Texture3D* m_tolerances = nullptr;
    int m_toleranceLabel = 0;
    static constexpr std::size_t fields = 7;
    std::array<core::VoxelBox, fields> m_dirty;
    std::array<bool, fields> m_touched{};
    bool m_replaced = false;
};

} // namespace gpu
