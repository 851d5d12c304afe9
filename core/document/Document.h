// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/brick/BrickGrid.h"
#include "core/document/Measurement.h"
#include "core/document/OrthographicView.h"
#include "core/document/Piece.h"
#include "core/volume/Volume.h"

#include <QJsonObject>
#include <QString>

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// A concept from a coding scheme (DICOM PS3.3 table 8.8-1), e.g. SCT 89546000 "Skull".
struct CodedConcept {
    QString scheme;
    QString value;
    QString meaning;

    [[nodiscard]] bool isSet() const { return !value.isEmpty(); }
    bool operator==(const CodedConcept&) const = default;
};

/// The greatest number of label planes of a session. Segments that share voxels lie in different
/// planes; overlapping masks of one file are imported in this way (ImportMask::planes), and copies
/// of segments lie beside them (CopySegment). A plane costs a byte per voxel.
inline constexpr int mostLabelPlanes = 4;

/// One structure of the result: the voxels of `plane` that hold `label`.
///
/// Edits of a segment act on its plane. A voxel is free there if no other segment of this plane has
/// it; segments of other planes do not matter. Only imports look at all planes, and copies, which
/// look for one that has room.
struct Segment {
    /// 1 … 255, unique in the document regardless of the plane, and never used again. So a label
    /// alone identifies a segment.
    std::uint8_t label = 0;
    std::uint8_t plane = 0; ///< below mostLabelPlanes; a segment never leaves its plane
    QString name;
    std::uint32_t rgb = 0; ///< 0xRRGGBB
    CodedConcept code; ///< not set: "not coded yet", asked for at export
    bool locked = false; ///< no tool, growth or write-back changes its voxels
    bool uncarvable = false; ///< protected from sculpting: no tool carves where it is
    bool visible = true; ///< display only: neither a step of undo nor part of the hash
    std::int64_t voxels = 0; ///< kept up to date by the session; derived, not part of the hash
    /// The row of the ThresholdSegment whose interval the segment follows, because nothing else has
    /// changed its voxels since; 0: it follows none. It is derived from rows
    /// (EditStatistics::followsInterval) and is not part of the hash.
    std::int64_t followsRow = 0;
};

/// A sculpt layer: hides part of the volume in the 3D view. It changes no segment and no statistic.
struct SculptLayer {
    std::uint8_t id = 0; ///< 1 … 254, unique; names its coverage
    QString name;
    bool muted = false; ///< hides nothing; whatever reads carved voxels ignores it
    bool solo = false; ///< while any layer is solo, all that are not are as if muted
};

/// A view of the 3D view to come back to.
struct CameraBookmark {
    int id = 0; ///< 1, 2, 3 …, unique and never used again
    QString name;
    OrthographicView view; ///< of the 3D view
    glm::dvec3 crosshairLps{0.0};
};

/// The live growth of one label plane.
struct Growth {
    std::uint8_t plane = 0;
    std::uint32_t generation = 0;
};

/// The surface of one segment while it is refined (core/refine). The session holds its mesh.
struct RefinedSurface {
    int segment = 0; ///< label
    /// Surface and segment may differ by an edit: the surface was changed since it was laid or
    /// written back, or an edit wrote to its segment. The row that laid it says how far apart they
    /// were then.
    bool differs = false;
    /// An edit that is not about its segment, mostly a growth, has changed the segment's voxels
    /// since. This follows from rows (EditStatistics::surfaceMaskChanged), not from edits, and is
    /// not part of the state hash.
    bool maskChanged = false;

    /// Whether surface and segment may differ.
    [[nodiscard]] bool isApart() const { return differs || maskChanged; }
    bool operator==(const RefinedSurface&) const = default;
};

/// The newest division of a segment and its surroundings into chunks (core/chunks). The edit that
/// made it holds the rest.
struct ChunkDivision {
    int id = 0; ///< 1, 2, 3 …, never used again
    int segment = 0; ///< label
    double marginMm = 0.0;
};

/// The model: everything that a session holds besides voxels. All parts are lists, although the
/// window shows one volume at present.
struct Document {
    std::vector<Volume> volumes;
    std::vector<Segment> segments;
    std::vector<SculptLayer> layers; ///< in the order of their list, which has no effect
    std::vector<Growth> growths; ///< by plane; that of plane 0 is always among them
    std::vector<CameraBookmark> bookmarks;
    std::vector<Piece> pieces; ///< by id; the order has no effect
    std::vector<Measurement> measurements; ///< by id
    std::optional<RefinedSurface> surface;
    std::optional<ChunkDivision> chunks; ///< the newest one, as long as its segment exists
    /// the greatest label of a deleted segment; no number is used again
    int greatestRemovedLabel = 0;
    int greatestRemovedBookmark = 0; ///< likewise
    int greatestRemovedLayer = 0; ///< likewise
    int greatestRemovedPiece = 0;
    int greatestRemovedMeasurement = 0;
    int greatestRemovedChunks = 0;

    [[nodiscard]] const Segment* segment(int label) const;
    [[nodiscard]] Segment* segment(int label);
    [[nodiscard]] const SculptLayer* layer(int id) const;
    [[nodiscard]] SculptLayer* layer(int id);
    /// Whether what the layer carves counts: it is not muted, and not ignored because others are
    /// solo.
    [[nodiscard]] bool carves(const SculptLayer& layer) const;
    /// The reason why it does not, in words ("is muted"); empty if it does.
    [[nodiscard]] Clause whyItDoesNotCarve(const SculptLayer& layer) const;
    [[nodiscard]] const CameraBookmark* bookmark(int id) const;
    [[nodiscard]] const Measurement* measurement(int id) const;
    [[nodiscard]] const Piece* piece(int id) const;
    [[nodiscard]] Piece* piece(int id);
    /// The piece that this sculpt layer cut out; null: none.
    [[nodiscard]] const Piece* pieceOfLayer(int layer) const;
    /// The planes in which segments lie, ascending; plane 0 always.
    [[nodiscard]] std::vector<std::uint8_t> labelPlanes() const;
    /// The first plane in which no segment lies; none: segments lie in all that there can be.
    [[nodiscard]] std::optional<std::uint8_t> planeWithoutSegments() const;
    /// The labels of all segments of a plane.
    [[nodiscard]] std::bitset<256> labelsIn(int plane) const;
    /// The labels of a plane that no tool may change.
    [[nodiscard]] std::bitset<256> lockedLabels(int plane) const;
    [[nodiscard]] std::bitset<256> unlockedLabels(int plane) const;
    /// The greatest label that was ever given to a segment; 0: none.
    [[nodiscard]] int lastLabelGiven() const;
    [[nodiscard]] int lastBookmarkGiven() const;
    [[nodiscard]] int lastLayerGiven() const;
    [[nodiscard]] int lastPieceGiven() const;
    [[nodiscard]] int lastMeasurementGiven() const;
    [[nodiscard]] int lastChunksGiven() const;
    /// The growth of a label plane; null if nothing has grown in it.
    [[nodiscard]] const Growth* growth(int plane) const;
    /// The generation of the growth of a plane; 0 if nothing has grown in it.
    [[nodiscard]] std::uint32_t generation(int plane) const;
    /// Notes the generation of a growth.
    void place(const Growth& growth);
    /// The part of the document that the state hash covers, in one canonical form: keys sorted, no
    /// display state (core/session/README.md).
    [[nodiscard]] QJsonObject hashedState() const;
};

/// What changed in a session, for views and item models.
struct DocumentChange {
    enum class What {
        Volume,
        Segments,
        Layers,
        Bookmarks,
        Pieces,
        Measurements,
        Surface,
        Chunks, ///< what is divided, or its chunks have been computed
        Labels,
        Coverage,
        Growth,
        History,
        Disk
    };
    What what = What::Volume;
    VoxelBox box; ///< where voxels changed; empty for the rest
};

} // namespace core
