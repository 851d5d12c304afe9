// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/IslandOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <utility>

namespace core {

IslandOperation::Work::Work()
    : progress([this](ProgressStep, int done, int total) {
        constexpr std::int64_t percents = 100;
        percent = int(percents * done / std::max(1, total));
    })
{
}

IslandOperation::IslandOperation(const CleanSegment& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress,
            Edit&) -> Result<Listed> { return relabelListed(edit, document, labels, progress); },
        again)
{
}

IslandOperation::IslandOperation(const ReshapeSegment& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress, Edit&) -> Result<Listed> {
            if (edit.with)
                return labelListed(edit, document, labels, progress);
            return relabelListed(edit, document, labels, progress);
        },
        again)
{
}

IslandOperation::IslandOperation(const FillBetweenSlices& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress,
            Edit&) -> Result<Listed> { return relabelListed(edit, document, labels, progress); },
        again)
{
}

IslandOperation::IslandOperation(const MirrorSegment& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress,
            Edit&) -> Result<Listed> { return relabelListed(edit, document, labels, progress); },
        again)
{
}

IslandOperation::IslandOperation(const SplitIslands& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [](const Document& document, std::span<const std::uint8_t> labels, const Progress& progress,
            Edit& completed) -> Result<Listed> {
            return labelListed(completed.get<SplitIslands>(), document, labels, progress);
        },
        again)
{
}

IslandOperation::IslandOperation(const SplitSegment& edit, RowId again)
    : IslandOperation(
        edit, edit.segment,
        [edit](const Document& document, std::span<const std::uint8_t> labels,
            const Progress& progress,
            Edit&) -> Result<Listed> { return relabelListed(edit, document, labels, progress); },
        again)
{
}

IslandOperation::IslandOperation(Edit edit, int segment, LabelWork workOut, RowId again)
    : m_edit(std::move(edit))
    , m_segment(segment)
    , m_workOut(std::move(workOut))
    , m_work(std::make_shared<Work>())
    , m_relabelling(again)
{
}

bool IslandOperation::foresee(Document& document) const
{
    const auto* islands = m_edit.as<SplitIslands>();
    return (!islands || islands->into) && applyToDocument(m_edit, document);
}

void IslandOperation::start(SessionState& state)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return m_relabelling.giveUp(state, checked.error());
    m_reader.emplace(
        state.document.volumes.front().geometry.size, state.document.segment(m_segment)->plane);
    readNext(state);
}

void IslandOperation::readNext(SessionState& state)
{
    if (m_work->progress.cancelled())
        return m_relabelling.giveUp(state, {ErrorCode::Cancelled, {}});
    if (std::optional<ReadBricks> question = m_reader->next()) {
        m_asked = state.engine.submit(*std::move(question));
        return;
    }
    state.side->post(
        [this, workOut = m_workOut, work = m_work, document = state.document,
            edit = std::make_shared<Edit>(m_edit),
            reader = std::make_shared<LabelReader>(*std::move(m_reader))] {
            auto listed = std::make_shared<Result<Listed>>(
                workOut(document, reader->takeLabels(), work->progress, *edit));
            return SideThread::Sequel([this, listed, edit](SessionState& known) {
                m_edit = std::move(*edit);
                write(known, std::move(*listed));
            });
        },
        [this](SessionState& known, const Error& error) { m_relabelling.giveUp(known, error); });
    m_reader.reset();
}

void IslandOperation::write(SessionState& state, Result<Listed>&& listed)
{
    if (!listed)
        return m_relabelling.giveUp(state, listed.error());
    if (m_work->progress.cancelled())
        return m_relabelling.giveUp(state, {ErrorCode::Cancelled, {}});
    m_isWriting = true;
    std::visit([&](auto& known) { m_relabelling.write(state, m_edit, std::move(known)); }, *listed);
}

void IslandOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked) {
        m_asked.reset();
        if (const Result<void> taken = m_reader->take(result); !taken)
            return m_relabelling.giveUp(state, taken.error());
        return readNext(state);
    }
    m_relabelling.takeResult(state, std::move(result));
}

void IslandOperation::abort()
{
    if (isAbortable())
        m_work->progress.cancel();
}

} // namespace core
