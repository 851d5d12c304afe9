// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// What changes voxels only, or by the history.
template <class E>
requires isOneOf<E, ChunkToggle, SeedStroke, GrowSteps, ShrinkSteps, ChangeInterval, ResumeGrowth,
    ShrinkAt, PlugLeak, BarrierStroke, GrowFromSeeds, DrillStroke, LaserStroke, RevertRows,
    ReviseStroke, PaintStroke, BrushStroke, PeelCut, ScissorsCut, SegmentToLayer>
    Result<bool> apply(const E&, Document&)
{
    return false;
}

/// Whether it is a segment's voxels that an edit is about. What growth does to it is not known
/// before; nor what others take from it.
bool writesTo(const Edit& edit, int segment)
{
    return visitEdit(
        [segment](const auto& known) {
            using E = std::decay_t<decltype(known)>;
            if constexpr (isOneOf<E, PaintStroke, ChunkToggle>)
                return known.segment == segment;
            else if constexpr (isOneOf<E, LayerToSegment, SegmentSeen>)
                return known.target.segment == segment;
            else if constexpr (isOneOf<E, ImportMask>)
                return known.as && known.as->number == segment;
            else
                return false;
        },
        edit);
}

} // namespace

bool changesDocumentOnly(const Edit& edit)
{
    return visitEdit(
        [&edit](const auto& known) {
            using E = std::decay_t<decltype(known)>;
            return changedPart(edit)
                && !isOneOf<E, RemoveSegment, RemoveLayer, MergeLayers, LayerToSegment, SegmentSeen,
                    ImportMask, WriteBack>;
        },
        edit);
}

bool takesVoxelsOrNothing(const Edit& edit)
{
    return edit.is<LayerToSegment>() || edit.is<ImportMask>() || edit.is<SegmentSeen>();
}

std::optional<DocumentChange::What> changedPart(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> std::optional<DocumentChange::What> {
            using E = std::decay_t<decltype(known)>;
            using What = DocumentChange::What;
            if constexpr (isOneOf<E, AddSegment, ChangeSegment, MoveSegment, RemoveSegment>)
                return What::Segments;
            else if constexpr (isOneOf<E, LayerToSegment, SegmentSeen>)
                return known.target.segment ? std::nullopt : std::optional(What::Segments);
            else if constexpr (isOneOf<E, ImportMask>)
                return known.as && known.as->number ? std::nullopt : std::optional(What::Segments);
            else if constexpr (isOneOf<E, AddLayer, ChangeLayer, MoveLayer, RemoveLayer,
                                   MergeLayers>)
                return What::Layers;
            else if constexpr (isOneOf<E, AddBookmark, RemoveBookmark>)
                return What::Bookmarks;
            else if constexpr (isOneOf<E, AddMeasurement, RemoveMeasurement>)
                return What::Measurements;
            else if constexpr (isOneOf<E, LaySurface, DropSurface, FollowMask, MarkSurface,
                                   ChangeMarks, SpherePush, PlaneScrape, PointDrag, ApplyTemplate,
                                   SmoothSurface, AttractSurface, WriteBack>)
                return What::Surface;
            else if constexpr (isOneOf<E, Chunks>)
                return What::Chunks;
            else if constexpr (isOneOf<E, CutPiece, PastePiece, ChangePiece, SendPiecesHome,
                                   RemovePiece>)
                return What::Pieces;
            else
                return std::nullopt;
        },
        edit);
}

Result<bool> applyToDocument(const Edit& edit, Document& document)
{
    const Result<bool> applied =
        visitEdit([&document](const auto& known) { return apply(known, document); }, edit);
    if (applied && document.surface && writesTo(edit, document.surface->segment))
        document.surface->differs = true;
    return applied;
}

Document initialDocument(Volume volume)
{
    Document document;
    document.volumes.push_back(std::move(volume));
    document.layers.push_back({.id = 1, .name = QStringLiteral("Sculpt 1")});
    document.growths.push_back({.plane = 0, .generation = 0});
    return document;
}

} // namespace core
