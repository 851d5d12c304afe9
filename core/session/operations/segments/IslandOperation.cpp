// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/IslandOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/engine/EngineResult.h"

#include <utility>

namespace core {

namespace {

/// What one segment gains and loses.
template <class E> auto relabelling(const E& edit)
{
    return [edit](const Document& document, std::span<const std::uint8_t> labels,
               const Progress& progress) -> Result<WorkedOutOperation::Listed> {
        return relabelListed(edit, document, labels, progress);
    };
}

} // namespace

IslandOperation::IslandOperation(const CleanSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, edit.segment, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const ReshapeSegment& edit, Kind kind, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress) -> Result<Listed> {
            if (edit.with)
                return labelListed(edit, document, labels, progress);
            return relabelListed(edit, document, labels, progress);
        },
        kind, again)
{
}

IslandOperation::IslandOperation(const FillBetweenSlices& edit, Kind kind, RowId again)
    : IslandOperation(edit, edit.segment, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const MirrorSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, edit.segment, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const SplitSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, edit.segment, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const SplitByCurve& edit, Kind kind, RowId again)
    : IslandOperation(edit, edit.segment, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(Edit edit, int segment, LabelWork workOut, Kind kind, RowId again)
    : WorkedOutOperation(std::move(edit), kind, again)
    , m_segment(segment)
    , m_workOut(std::move(workOut))
{
}

bool IslandOperation::foresee(Document& document) const
{
    return !isCommitted() || applyToDocument(edit(), document);
}

void IslandOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    m_reading.emplace(
        state.document.volumes.front().geometry.size, state.document.segment(m_segment)->plane);
    readNext(state);
}

void IslandOperation::readNext(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (m_reading->ask(state.engine))
        return;
    workAside(state,
        [this, workOut = m_workOut, watch = watch(), document = state.document,
            reader = std::make_shared<LabelReader>(std::move(m_reading->reader()))] {
            auto listed = std::make_shared<Result<Listed>>(
                workOut(document, reader->takeLabels(), watch->progress));
            return SideThread::Sequel(
                [this, listed](SessionState& known) { write(known, std::move(*listed)); });
        });
    m_reading.reset();
}

void IslandOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading && m_reading->awaits(result.ticket)) {
        if (const Result<void> taken = m_reading->take(result); !taken)
            return giveUp(state, taken.error());
        return readNext(state);
    }
    takeWritten(state, std::move(result));
}

} // namespace core
