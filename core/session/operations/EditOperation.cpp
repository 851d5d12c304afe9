// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/EditOperation.h"

#include "core/edits/answers/EditEffects.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/SurfaceEdit.h"
#include "core/session/operations/ChunkOperation.h"
#include "core/session/operations/DocumentOperation.h"
#include "core/session/operations/SurfaceOperation.h"
#include "core/session/operations/VoxelOperation.h"
#include "core/session/operations/history/RevertOperation.h"
#include "core/session/operations/history/ReviseOperation.h"
#include "core/session/operations/segments/ContourOperation.h"
#include "core/session/operations/segments/CopyOperation.h"
#include "core/session/operations/segments/FloodOperation.h"
#include "core/session/operations/segments/ImportOperation.h"
#include "core/session/operations/segments/IslandOperation.h"
#include "core/session/operations/segments/SplitIslandsOperation.h"

#include <type_traits>

namespace core {

namespace {

/// What is computed from all labels of a plane.
template <class E>
concept isWorkedOutKind = isOneOf<E, CleanSegment, ReshapeSegment, FillBetweenSlices, MirrorSegment,
    SplitSegment, SplitByCurve>;

/// Makes the operation of an edit from its kind. A kind that the engine does not carry out and that
/// is named nowhere here has no overload, so that it does not compile.
class OperationMaker {
public:
    using Made = std::unique_ptr<Operation>;

    OperationMaker(const Edit& edit, RowId again)
        : m_edit(edit)
        , m_again(again)
    {
    }

    template <class E>
    requires hasEngineEdit<E> Made operator()(const E&) const
    {
        return std::make_unique<VoxelOperation>(m_edit, VoxelOperation::Kind::Whole, m_again);
    }

    template <class E>
    requires isSurfaceKind<E> Made operator()(const E& edit) const
    {
        return std::make_unique<SurfaceOperation>(edit, SurfaceOperation::Kind::Whole, m_again);
    }

    template <class E>
    requires isOneOf<E, AddSegment, ChangeSegment, MoveSegment, AddLayer, ChangeLayer, MoveLayer,
        AddBookmark, RemoveBookmark, AddMeasurement, Annotate, MoveMeasurement, RemoveMeasurement,
        CutPiece, PastePiece, ChangePiece, SendPiecesHome, RemovePiece>
        Made operator()(const E&) const
    {
        return std::make_unique<DocumentOperation>(m_edit, m_again);
    }

    template <class E>
    requires isWorkedOutKind<E> Made operator()(const E& edit) const
    {
        return std::make_unique<IslandOperation>(edit, IslandOperation::Kind::Whole, m_again);
    }

    Made operator()(const SplitIslands& edit) const
    {
        return std::make_unique<SplitIslandsOperation>(
            edit, SplitIslandsOperation::Kind::Whole, m_again);
    }
    Made operator()(const CopySegment& edit) const
    {
        return std::make_unique<CopyOperation>(edit, m_again);
    }
    Made operator()(const ImportMask& edit) const
    {
        return std::make_unique<ImportOperation>(edit, m_again);
    }
    Made operator()(const FloodFill& edit) const
    {
        return std::make_unique<FloodOperation>(edit, m_again);
    }
    Made operator()(const EvolveContour& edit) const
    {
        return std::make_unique<ContourOperation>(edit, m_again);
    }
    Made operator()(const DivideSegment& edit) const
    {
        return std::make_unique<DivideOperation>(edit, m_again);
    }
    Made operator()(const ChunkToggle& edit) const
    {
        return std::make_unique<ToggleChunks>(edit, m_again);
    }
    Made operator()(const RevertRows& edit) const
    {
        return std::make_unique<RevertOperation>(edit, m_again);
    }
    Made operator()(const ReviseStroke& edit) const
    {
        return std::make_unique<ReviseOperation>(edit, m_again);
    }

private:
    const Edit& m_edit;
    RowId m_again;
};

} // namespace

std::unique_ptr<Operation> operationOf(const Edit& edit, RowId again)
{
    return visitEdit(OperationMaker(edit, again), edit);
}

std::unique_ptr<Operation> openOperationOf(const Edit& edit)
{
    return visitEdit(
        [&edit](const auto& known) -> std::unique_ptr<Operation> {
            using E = std::decay_t<decltype(known)>;
            if constexpr (hasEngineEdit<E>)
                return std::make_unique<VoxelOperation>(edit, VoxelOperation::Kind::Interactive);
            else if constexpr (isSurfaceKind<E>)
                return std::make_unique<SurfaceOperation>(
                    known, SurfaceOperation::Kind::Interactive);
            else if constexpr (isWorkedOutKind<E>)
                return std::make_unique<IslandOperation>(known, IslandOperation::Kind::Interactive);
            else if constexpr (isOneOf<E, SplitIslands>)
                return std::make_unique<SplitIslandsOperation>(
                    known, SplitIslandsOperation::Kind::Interactive);
            else {
                static_assert(!hasOpenManner<E>, "an edit that can stand open needs its operation");
                return nullptr;
            }
        },
        edit);
}

} // namespace core
