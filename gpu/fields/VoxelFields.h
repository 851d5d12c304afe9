// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "gpu/fields/bricks/BarrierBricks.h"
#include "gpu/fields/bricks/BrickCopier.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/SpreadField.h"
#include "gpu/fields/bricks/ToleranceField.h"
#include "gpu/fields/textures/ShownLabels.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/kernels/radiation/RadiationKernel.h"
#include "gpu/scene/Scene.h"

#include <array>
#include <bitset>
#include <map>
#include <optional>
#include <set>

namespace gpu {

/// All fields of the open volume: those that edits write, and those that are derived from them.
/// Engine thread only.
///
/// Radiation (the smoothed coverage of the layers that are not muted) is updated at once, since
/// strokes and picks read it. The segmentation map serves only pictures and is updated between
/// edits (updateSegmentation()). What changes in pictures is marked dirty in VolumeTextures.
class VoxelFields {
public:
    /// @param shared the dense textures of the open volume; both outlive this object
    /// @param by whether kernels or the processor copy bricks and find barriers
    VoxelFields(FieldPrograms& programs, VolumeTextures& shared, WorkBy by = WorkBy::Driver);
    ~VoxelFields();
    VoxelFields(const VoxelFields&) = delete;
    VoxelFields& operator=(const VoxelFields&) = delete;

    [[nodiscard]] const core::BrickGrid& grid() const { return m_grid; }
    [[nodiscard]] const Texture3D& codes() const { return m_shared.intensityCodes(); }
    /// Least and greatest code of each macro-cell (MacroCells::ranges()).
    [[nodiscard]] const Texture3D& codeRanges() const { return m_shared.cells().ranges(); }
    /// Whether a brick, by its number, may hold one of these codes (MacroCells::mayHold()).
    [[nodiscard]] bool mayHold(std::uint32_t brick, int lowestCode, int highestCode) const
    {
        return m_shared.cells().mayHold(m_grid.brickPosition(int(brick)), lowestCode, highestCode);
    }
    [[nodiscard]] const Texture3D& radiation() const { return m_radiation; }
    [[nodiscard]] const BrickCopier& copier() const { return m_copier; }

    [[nodiscard]] BrickField& coverage(std::uint8_t layer);
    [[nodiscard]] BrickField& seedWords(std::uint8_t plane);
    /// The labels that growth took from other segments (Field::Overwritten). Only bricks where it
    /// took any have pages.
    [[nodiscard]] BrickField& overwritten(std::uint8_t plane);
    [[nodiscard]] bool anyOverwritten(std::uint8_t plane) const;
    /// A label plane. One that does not exist yet is created, empty, and views count it as in use.
    /// Throws GlFailure.
    [[nodiscard]] const Texture3D& labels(std::uint8_t plane);
    /// The label planes by number; null: not in use. Plane 0 always is.
    [[nodiscard]] std::array<const Texture3D*, core::mostLabelPlanes> labelPlanes() const;
    /// The intermediate result of growing from seeds, kept for the next preview. It can be
    /// recomputed.
    [[nodiscard]] SpreadField& spread() { return m_spread; }
    [[nodiscard]] FieldTextures textures(core::Field field, std::uint8_t plane);
    /// The paged field, or null for the dense label planes.
    [[nodiscard]] BrickField* paged(core::Field field, std::uint8_t plane);
    /// Whether the brick may hold anything. Makes no label plane.
    [[nodiscard]] bool hasData(const core::BrickKey& key);
    /// Bricks in which any label plane was ever written, ascending. They include all bricks that
    /// hold labels.
    [[nodiscard]] std::vector<std::uint32_t> labelledBricks() const;

    /// Must be called after writing bricks. For coverage, radiation is updated around them.
    void noteChanged(core::Field field, std::span<const std::uint32_t> bricks);
    /// The same for coverage if the changed voxels are known more closely. Each box lies within one
    /// brick.
    void noteCoverage(std::span<const core::VoxelBox> boxes);
    /// Sets which layers radiation leaves out, and updates it where any layer whose state changes
    /// has cut.
    void setMutedLayers(const std::bitset<256>& muted);
    [[nodiscard]] const std::bitset<256>& mutedLayers() const { return m_mutedLayers; }
    /// Bricks whose radiation depends on the given ones: themselves and their neighbours.
    [[nodiscard]] std::vector<std::uint32_t> withNeighbours(
        std::span<const std::uint32_t> bricks) const;

    /// Sets which labels the segmentation map shows. After a change every labelled brick is out of
    /// date.
    /// @param translucent which of them are; this matters only where segments overlap
    void setShownLabels(const std::bitset<256>& shown, const std::bitset<256>& translucent = {});
    [[nodiscard]] bool segmentationStale() const { return !m_staleSegmentation.empty(); }
    /// Updates at most @p maxBricks bricks that are out of date.
    void updateSegmentation(std::size_t maxBricks);

    /// Sets the label plane whose growth pictures show: barriers, the generations that warn, and a
    /// segment at a tolerance.
    void showGrowth(std::uint8_t plane);
    /// The list of bricks in which pictures look for barriers is updated between edits, too.
    [[nodiscard]] bool barriersStale() const { return m_barriers.stale(); }
    void updateBarriers();
    /// The bricks in which a label plane holds barriers, ascending. For the plane whose growth
    /// pictures show they are known, except for bricks that changed since; for other planes all
    /// bricks are searched.
    [[nodiscard]] std::vector<std::uint32_t> bricksWithBarriers(std::uint8_t plane);

    /// The tolerance field that tracing computes. It can be recomputed.
    [[nodiscard]] ToleranceField& tolerance() { return m_tolerance; }
    /// Declares the tolerance field valid: it may now be reported and shown.
    void standTolerance();
    /// Declares the tolerance field invalid, because its input may have changed. Its memory is
    /// kept.
    void hideTolerance();
    /// As hideTolerance(), and frees its memory.
    void dropTolerance();
    /// Sets how pictures show a segment while its tolerance field is valid. The segmentation map is
    /// updated where members come or go.
    void showAtTolerance(const std::optional<ToleranceDisplay>& shown);

    /// Sets the layers and segments whose footprints are kept in VolumeTextures::pieces(). Where
    /// the driver refuses the memory for them there are none until others are set.
    void setPieces(const std::vector<PieceSource>& sources);
    [[nodiscard]] bool piecesStale() const;
    /// Updates about @p maxBricks bricks of footprints.
    void updatePieces(std::size_t maxBricks);
    /// Marks everything that is derived between edits as out of date, after a part of it failed.
    void deriveAnew();
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Tells VolumeTextures which label planes are in use.
    void sharePlanes();
    /// Tells it whose growth is shown.
    void shareGrowth();
    /// The place of a plane among those in use; none: it is not.
    [[nodiscard]] std::optional<std::size_t> placeOf(std::uint8_t plane) const;
    [[nodiscard]] core::VoxelBox boxOf(std::span<const std::uint32_t> bricks) const;
    [[nodiscard]] std::vector<core::VoxelBox> boxesOf(std::span<const std::uint32_t> bricks) const;
    /// The regions whose radiation depends on changed boxes.
    [[nodiscard]] std::vector<RadiationKernel::Region> around(
        std::span<const core::VoxelBox> boxes) const;

    /// The box, in whole bricks, that may hold some of a piece, with one brick around it for its
    /// smoothed edge.
    [[nodiscard]] core::VoxelBox roomFor(const PieceSource& source);
    /// Allocates the footprints of all pieces again if one has outgrown its box.
    void arrangePieces();
    /// Allocates them. @return false: that was refused, so there are none
    [[nodiscard]] bool makeRoomFor(const std::map<PieceSource, core::VoxelBox>& rooms);
    void updatePiece(const PieceSource& source, std::span<const RadiationKernel::Region> regions);
    void notePieces(bool ofLayers, std::span<const std::uint32_t> bricks);
    /// The tolerance at which pictures show the field's segment; none if they show it as it is.
    [[nodiscard]] std::optional<int> shownTolerance() const;
    void noteTolerance(std::optional<int> before);
    /// Tells VolumeTextures whether there is a tolerance field to show.
    void shareTolerances();

    core::BrickGrid m_grid;
    VolumeTextures& m_shared;
    Texture3D m_radiation; ///< R8UI view
    Texture3D m_segmentation; ///< R8UI view
    BrickCopier m_copier;
    RadiationKernel m_radiationKernel;
    std::map<std::uint8_t, BrickField> m_coverage;
    std::map<std::uint8_t, BrickField> m_seedWords;
    std::map<std::uint8_t, BrickField> m_overwritten;
    std::map<std::uint8_t, Texture3D> m_furtherPlanes;
    std::optional<ShownLabels> m_seenLabels; ///< exists while there are several label planes
    SpreadField m_spread;
    std::uint8_t m_growthPlane = 0; ///< whose growth is shown
    BarrierBricks m_barriers; ///< of that plane
    ToleranceField m_tolerance;
    std::optional<ToleranceDisplay> m_atTolerance;
    std::bitset<256> m_mutedLayers;
    std::bitset<256> m_shownLabels;
    std::bitset<256> m_translucentLabels;
    std::set<std::uint32_t> m_labelledBricks; ///< ever written; includes all that hold labels
    std::set<std::uint32_t> m_staleSegmentation;
    FieldPrograms& m_programs;
    /// For each source, the bricks to update.
    std::map<PieceSource, std::set<std::uint32_t>> m_stalePieces;
    bool m_arrangeAnew = false; ///< the pieces have to be arranged before they are updated
    bool m_piecesRefused = false; ///< there was no memory for them
};

} // namespace gpu
