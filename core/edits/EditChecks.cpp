// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/chunks/ChunkVoxels.h"
#include "core/edits/sculpt/SculptEdits.h"

namespace core {

namespace {

/// A stroke into a layer that is not there or not seen would be lost work.
Result<void> checkLayer(const char* field, int id, const Document& document)
{
    const SculptLayer* layer = document.layer(id);
    if (!layer)
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            QStringLiteral("there is no sculpt layer %1").arg(id));
    if (const QString why = document.whyItDoesNotCarve(*layer); !why.isEmpty())
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            QStringLiteral("sculpt layer '%1' %2: what is carved there would not be seen")
                .arg(layer->name, why));
    return {};
}

Result<void> checkSparedAreThere(const Edit& edit, const Document& document)
{
    const SparedSegments* spared = sparedBy(edit);
    if (!spared || !*spared)
        return {};
    for (const int label : **spared) {
        if (!document.segment(label))
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                QStringLiteral("in field 'spared'"));
    }
    return {};
}

template <class T> Result<void> discardValue(const Result<T>& result)
{
    if (!result)
        return tl::unexpected(result.error());
    return {};
}

/// What is looked at of each kind of edit: one that is not named does not compile.
class Checks {
public:
    const Document& document;

    Result<void> operator()(const DrillStroke& drill) const
    {
        return carves("drill.layer", drill.layer, drillCut(drill, document));
    }
    Result<void> operator()(const LaserStroke& laser) const
    {
        return carves("laser.layer", laser.layer, laserCut(laser, document));
    }
    Result<void> operator()(const PeelCut& peel) const
    {
        return carves("peel.layer", peel.layer, maskPeel(peel, document));
    }
    Result<void> operator()(const ScissorsCut& cut) const
    {
        return carves("scissors.layer", cut.layer, maskScissors(cut, document));
    }
    Result<void> operator()(const BrushStroke& brush) const
    {
        return carves("brush.layer", brush.layer, capsuleCut(brush, document));
    }
    Result<void> operator()(const SegmentToLayer& cover) const
    {
        return carves("segmentToLayer.layer", cover.layer, coverLabel(cover, document));
    }

    Result<void> operator()(const Chunks& chunks) const
    {
        if (!chunks.owners)
            return {};
        return discardValue(ownedBox(chunks, document.volumes.front().geometry));
    }
    Result<void> operator()(const ChunkToggle& toggle) const
    {
        return discardValue(chunkClick(toggle, document));
    }

    /// That they can be converted says it all.
    template <class E>
    requires isOneOf<E, SeedStroke, GrowSteps, ChangeInterval, GrowFromSeeds, ShrinkSteps, ShrinkAt,
        PlugLeak, BarrierStroke, PaintStroke, LayerToSegment, SegmentSeen, ImportMask>
        Result<void>
    operator()(const E& edit) const { return discardValue(engineEditOf(edit, document)); }
    /// What the document said to them is all; a growth that goes on, what takes older rows back and
    /// revisions read the history, not the document.
    template <class E>
    requires isOneOf<E, AddSegment, ChangeSegment, MoveSegment, RemoveSegment, AddLayer,
        ChangeLayer, MoveLayer, RemoveLayer, MergeLayers, AddBookmark, RemoveBookmark, CutPiece,
        PastePiece, ChangePiece, SendPiecesHome, RemovePiece, AddMeasurement, RemoveMeasurement,
        LaySurface, DropSurface, FollowMask, MarkSurface, ChangeMarks, SpherePush, PlaneScrape,
        PointDrag, ApplyTemplate, SmoothSurface, AttractSurface, WriteBack, SurfaceBarrier,
        ResumeGrowth, RevertRows, ReviseStroke>
        Result<void>
    operator()(const E&) const { return {}; }

private:
    template <class Command>
    [[nodiscard]] Result<void> carves(
        const char* field, int layer, const Result<Command>& command) const
    {
        if (const Result<void> checked = checkLayer(field, layer, document); !checked)
            return checked;
        return discardValue(command);
    }
};

} // namespace

Result<void> checkAgainst(const Document& document, const Edit& edit)
{
    if (changedPart(edit) || edit.is<SurfaceBarrier>()) {
        Document copy = document;
        if (const Result<bool> applied = applyToDocument(edit, copy); !applied)
            return tl::unexpected(applied.error());
    }
    if (const Result<void> checked = checkSparedAreThere(edit, document); !checked)
        return checked;
    return visitEdit(Checks{document}, edit);
}

} // namespace core
