// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditTask.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/SurfaceEdit.h"

#include <type_traits>
#include <utility>

namespace core {

namespace {

template <class E>
constexpr bool isOfDocument = isOneOf<E, AddSegment, ChangeSegment, MoveSegment, AddLayer,
    ChangeLayer, MoveLayer, AddBookmark, RemoveBookmark, CutPiece, PastePiece, ChangePiece,
    SendPiecesHome, RemovePiece, AddMeasurement, RemoveMeasurement>;
template <class E> constexpr bool isOfSurface = std::is_constructible_v<SurfaceEdit, E>;
template <class E> constexpr bool isOfChunks = isOneOf<E, Chunks, ChunkToggle>;
template <class E> constexpr bool isOfHistory = isOneOf<E, RevertRows, ReviseStroke>;
template <class E>
constexpr bool isWithoutEngine =
    isOfDocument<E> || isOfSurface<E> || isOfChunks<E> || isOfHistory<E>;

/// The command of each kind of edit: one that the engine does, and that has none, does not compile.
class EngineEdits {
public:
    const Document& document;

    Result<EngineEdit> operator()(const SeedStroke& seed) const
    {
        return whole(seedPlacement(seed, document));
    }
    Result<EngineEdit> operator()(const GrowSteps& grow) const
    {
        return whole(growBurst(grow, document));
    }
    Result<EngineEdit> operator()(const ResumeGrowth&) const
    {
        return failure(ErrorCode::InvalidField, QStringLiteral("resume"),
            QStringLiteral("no growth was named that it goes on with"));
    }
    Result<EngineEdit> operator()(const ChangeInterval& change) const
    {
        return whole(growBurst(change, document));
    }
    Result<EngineEdit> operator()(const GrowFromSeeds& spread) const
    {
        return whole(spreadLabels(spread, document));
    }
    Result<EngineEdit> operator()(const ShrinkSteps& shrink) const
    {
        return whole(shrinkGrowth(shrink, document));
    }
    Result<EngineEdit> operator()(const ShrinkAt& shrink) const
    {
        return whole(cutGrowth(shrink, document));
    }
    Result<EngineEdit> operator()(const PlugLeak& plug) const
    {
        return whole(cutGrowth(plug, document));
    }
    Result<EngineEdit> operator()(const BarrierStroke& barrier) const
    {
        return whole(paintBarrier(barrier, document));
    }

    Result<EngineEdit> operator()(const DrillStroke& drill) const
    {
        return whole(drillCut(drill, document));
    }
    Result<EngineEdit> operator()(const LaserStroke& laser) const
    {
        return whole(laserCut(laser, document));
    }
    Result<EngineEdit> operator()(const PeelCut& peel) const
    {
        return whole(maskPeel(peel, document));
    }
    Result<EngineEdit> operator()(const ScissorsCut& scissors) const
    {
        return whole(maskScissors(scissors, document));
    }
    Result<EngineEdit> operator()(const BrushStroke& brush) const
    {
        return whole(capsuleCut(brush, document));
    }
    template <class E>
    requires isOneOf<E, RemoveLayer, MergeLayers> Result<EngineEdit>
    operator()(const E& edit) const
    {
        // What waited in line may meet another document than the one it was checked against.
        Document copy = document;
        if (const Result<bool> applied = applyToDocument(edit, copy); !applied)
            return tl::unexpected(applied.error());
        return EngineEdit(foldLayer(edit));
    }

    Result<EngineEdit> operator()(const PaintStroke& paint) const
    {
        return whole(paintLabel(paint, document));
    }
    Result<EngineEdit> operator()(const RemoveSegment& remove) const
    {
        return whole(eraseLabel(remove, document));
    }
    Result<EngineEdit> operator()(const LayerToSegment& carved) const
    {
        return whole(labelCarved(carved, document));
    }
    Result<EngineEdit> operator()(const SegmentSeen& seen) const
    {
        return whole(labelSeen(seen, document));
    }
    Result<EngineEdit> operator()(const ImportMask& mask) const
    {
        return whole(labelListed(mask, document));
    }
    Result<EngineEdit> operator()(const SegmentToLayer& segment) const
    {
        return whole(coverLabel(segment, document));
    }

    template <class E>
    requires isWithoutEngine<E> Result<EngineEdit>
    operator()(const E&) const
    {
        return failure(ErrorCode::InvalidField, QStringLiteral("edit"),
            QStringLiteral("is not carried out by the engine alone"));
    }

private:
    template <class Command> [[nodiscard]] static Result<EngineEdit> whole(Result<Command> command)
    {
        if (!command)
            return tl::unexpected(command.error());
        return EngineEdit(*std::move(command));
    }
};

} // namespace

EditTask taskOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) {
            using E = std::decay_t<decltype(known)>;
            if constexpr (isOfDocument<E>)
                return EditTask::Document;
            else if constexpr (isOfSurface<E>)
                return EditTask::Surface;
            else if constexpr (isOfChunks<E>)
                return EditTask::Chunks;
            else if constexpr (isOfHistory<E>)
                return EditTask::History;
            else
                return EditTask::Engine; // EngineEdits asks for its command
        },
        edit);
}

bool canStandOpen(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) {
            using E = std::decay_t<decltype(known)>;
            constexpr bool isOpen = isOneOf<E, DrillStroke, LaserStroke, PeelCut, BrushStroke,
                PaintStroke, BarrierStroke, GrowSteps, ResumeGrowth, ChangeInterval, ShrinkSteps,
                GrowFromSeeds, MarkSurface, SpherePush, PlaneScrape, PointDrag, SmoothSurface,
                AttractSurface, ApplyTemplate>;
            constexpr bool isWhole =
                isOfDocument<
                    E> || isOfChunks<E> || isOfHistory<E> || isOneOf<E, ScissorsCut, SeedStroke, ShrinkAt, PlugLeak, RemoveSegment, RemoveLayer, MergeLayers, LayerToSegment, SegmentToLayer, SegmentSeen, ImportMask, LaySurface, DropSurface, FollowMask, ChangeMarks, WriteBack, SurfaceBarrier>;
            static_assert(isOpen != isWhole, "say of a new edit whether it can be begun");
            return isOpen;
        },
        edit);
}

Result<EngineEdit> engineEditOf(const Edit& edit, const Document& document)
{
    return visitEdit(EngineEdits{document}, edit);
}

} // namespace core
