// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/bricks/BarrierBricks.h"
#include "gpu/fields/bricks/BrickCopier.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/SpreadField.h"
#include "gpu/fields/bricks/ToleranceField.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/kernels/radiation/RadiationKernel.h"
#include "gpu/scene/Scene.h"

#include <bitset>
#include <map>
#include <optional>
#include <set>

namespace gpu {

/// Every field that edits write, and what is derived from them. Engine thread only.
///
/// Radiation follows the coverage of the layers that are not muted at once, since strokes and picks
/// read it. The segmentation map is for pictures only and follows between edits
/// (updateSegmentation). What pictures show of a change is marked dirty in VolumeTextures.
class VoxelFields {
public:
    /// @param shared the dense textures of the open volume; both outlive the fields
    VoxelFields(FieldPrograms& programs, VolumeTextures& shared);
    ~VoxelFields();
    VoxelFields(const VoxelFields&) = delete;
    VoxelFields& operator=(const VoxelFields&) = delete;

    [[nodiscard]] const core::BrickGrid& grid() const { return m_grid; }
    [[nodiscard]] const Texture3D& codes() const { return m_shared.intensityCodes(); }
    /// Least and greatest code of each macro-cell (MacroCells::ranges()).
    [[nodiscard]] const Texture3D& codeRanges() const { return m_shared.cells().ranges(); }
    [[nodiscard]] const Texture3D& radiation() const { return m_radiation; }
    [[nodiscard]] const BrickCopier& copier() const { return m_copier; }

    [[nodiscard]] BrickField& coverage(std::uint8_t layer);
    [[nodiscard]] BrickField& seedWords(std::uint8_t plane);
    /// Field::Beneath; only bricks where growth took something from another label have pages.
    [[nodiscard]] BrickField& beneath(std::uint8_t plane);
    [[nodiscard]] bool anythingBeneath(std::uint8_t plane) const;
    [[nodiscard]] const Texture3D& labels(std::uint8_t plane);
    /// What growing from seeds works out, and keeps for the next time; no truth.
    [[nodiscard]] SpreadField& spread() { return m_spread; }
    [[nodiscard]] FieldTextures textures(core::Field field, std::uint8_t plane);
    /// The paged field, or null for the dense label planes.
    [[nodiscard]] BrickField* paged(core::Field field, std::uint8_t plane);
    [[nodiscard]] bool hasData(const core::BrickKey& key);
    /// Bricks in which a label plane was ever written, ascending: all that hold labels.
    [[nodiscard]] std::vector<std::uint32_t> labelledBricks() const;

    /// Tell what was written. Coverage: radiation is brought up to date around these bricks.
    void noteChanged(core::Field field, std::span<const std::uint32_t> bricks);
    /// The same of coverage where it is known more closely: boxes within a brick each.
    void noteCoverage(std::span<const core::VoxelBox> boxes);
    /// Which layers are left out of radiation; brings it up to date where any of them has cut.
    void setMutedLayers(const std::bitset<256>& muted);
    [[nodiscard]] const std::bitset<256>& mutedLayers() const { return m_mutedLayers; }
    /// Bricks whose radiation depends on these: they and their neighbours.
    [[nodiscard]] std::vector<std::uint32_t> withNeighbours(
        std::span<const std::uint32_t> bricks) const;

    /// Which labels count for the segmentation map; a change makes every labelled brick stale.
    void setShownLabels(const std::bitset<256>& shown);
    [[nodiscard]] bool segmentationStale() const { return !m_staleSegmentation.empty(); }
    /// Brings up to @p maxBricks stale bricks up to date.
    void updateSegmentation(std::size_t maxBricks);

    /// Where pictures look for barriers follows between edits, too.
    [[nodiscard]] bool barriersStale() const { return m_barriers.stale(); }
    void updateBarriers();

    /// What tracing works out; no truth.
    [[nodiscard]] ToleranceField& tolerance() { return m_tolerance; }
    /// It is worked out: from now on it is told and shown.
    void standTolerance();
    /// What it read may be another now.
    void hideTolerance();
    /// Gives its memory back, too.
    void dropTolerance();
    /// How pictures are to show a segment while a field of it stands; the segmentation map follows
    /// where members come or go.
    void showAtTolerance(const std::optional<ToleranceDisplay>& shown);

    /// Of which layers and segments footprints are kept in VolumeTextures::pieces().
    void setPieces(const std::vector<PieceSource>& sources);
    [[nodiscard]] bool piecesStale() const;
    /// Brings about @p maxBricks bricks of footprints up to date.
    void updatePieces(std::size_t maxBricks);
    /// All that follows between edits is stale: some of it failed half-way.
    void deriveAnew();
    [[nodiscard]] std::size_t bytes() const;

private:
    [[nodiscard]] core::VoxelBox boxOf(std::span<const std::uint32_t> bricks) const;
    [[nodiscard]] std::vector<core::VoxelBox> boxesOf(std::span<const std::uint32_t> bricks) const;
    /// What radiation must be brought up to date in, around boxes that changed.
    [[nodiscard]] std::vector<RadiationKernel::Region> around(
        std::span<const core::VoxelBox> boxes) const;

    /// Bricks that may hold some of a piece, with one brick around for what lies at its edge.
    [[nodiscard]] core::VoxelBox roomFor(const PieceSource& source);
    /// Makes room for all pieces anew where one has outgrown its own.
    void arrangePieces();
    void updatePiece(const PieceSource& source, std::span<const RadiationKernel::Region> regions);
    void notePieces(bool ofLayers, std::span<const std::uint32_t> bricks);
    /// At which tolerance pictures show the field's segment; none: as it is.
    [[nodiscard]] std::optional<int> shownTolerance() const;
    void noteTolerance(std::optional<int> before);

    core::BrickGrid m_grid;
    VolumeTextures& m_shared;
    Texture3D m_radiation; ///< R8UI view
    Texture3D m_segmentation; ///< R8UI view
    BrickCopier m_copier;
    RadiationKernel m_radiationKernel;
    std::map<std::uint8_t, BrickField> m_coverage;
    std::map<std::uint8_t, BrickField> m_seedWords;
    std::map<std::uint8_t, BrickField> m_beneath;
    std::map<std::uint8_t, Texture3D> m_furtherPlanes;
    SpreadField m_spread;
    BarrierBricks m_barriers; ///< of plane 0
    ToleranceField m_tolerance;
    std::optional<ToleranceDisplay> m_atTolerance;
    std::bitset<256> m_mutedLayers;
    std::bitset<256> m_shownLabels;
    std::set<std::uint32_t> m_labelledBricks; ///< ever written; a superset of those with labels
    std::set<std::uint32_t> m_staleSegmentation;
    FieldPrograms& m_programs;
    std::map<PieceSource, std::set<std::uint32_t>> m_stalePieces; ///< of each what is to be done
    bool m_arrangeAnew = false; ///< the pieces, before more is done for them
};

} // namespace gpu
