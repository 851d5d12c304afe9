// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"

#include "core/base/Guarded.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/EditTask.h"
#include "core/session/operations/EditOperation.h"
#include "core/session/operations/OperationQueue.h"
#include "core/session/operations/SurfaceOperation.h"
#include "core/session/operations/VoxelOperation.h"
#include "core/session/operations/history/WalkOperation.h"

#include <utility>

namespace core {

Document EditSession::foreseenDocument() const
{
    return m_queue->foreseen();
}

std::optional<RowId> EditSession::foreseenPosition() const
{
    return m_queue->foreseenPosition();
}

const Document& EditSession::document() const
{
    return m_queue->state().document;
}

const History& EditSession::history() const
{
    return m_queue->state().history;
}

GrowthProgress EditSession::growthProgress() const
{
    return m_queue->state().engine.growthProgress();
}

void EditSession::expectEditableRanges()
{
    m_queue->state().engine.expectEditableRanges();
}

QString EditSession::file() const
{
    const SessionState& state = m_queue->state();
    return state.file ? state.file->path() : QString();
}

QString EditSession::whyReadOnly() const
{
    const SessionState& state = m_queue->state();
    return state.file && state.file->isPrivateCopy() ? m_whyReadOnly : QString();
}

Result<void> EditSession::mayEdit() const
{
    const Clause why = whyReadOnly();
    if (why.isEmpty())
        return {};
    return failure(ErrorCode::SessionReadOnly, file(), why);
}

Result<void> EditSession::apply(const Edit& edit)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> may = mayEdit(); !may)
            return may;
        if (const Result<void> checked = checkFields(edit); !checked)
            return checked;
        const Edit rounded = quantised(edit);
        m_queue->closeOpen();
        if (const Result<void> checked = m_queue->check(rounded); !checked)
            return checked;
        m_queue->submit(operationOf(rounded));
        return {};
    });
}

Result<void> EditSession::begin(const Edit& edit)
{
    return guarded([&]() -> Result<void> {
        if (const Result<void> may = mayEdit(); !may)
            return may;
        if (const Result<void> checked = checkFieldsAtBegin(edit); !checked)
            return checked;
        const Edit rounded = quantised(edit);
        std::unique_ptr<Operation> operation = openOperationOf(rounded);
        if (!operation || !canStandOpen(rounded))
            return failure(ErrorCode::InvalidField, editName(rounded),
                Clause::saying("it is carried out whole, there is nothing to begin"));
        m_queue->closeOpen();
        if (m_queue->interactive())
            return failure(ErrorCode::InvalidField, editName(rounded),
                Clause::saying("another stroke has not ended yet"));
        if (const Result<void> checked = m_queue->check(rounded); !checked)
            return checked;
        m_queue->submit(std::move(operation));
        return {};
    });
}

void EditSession::extend(const StrokeExtension& extension)
{
    OpenOperation* open = m_queue->interactive();
    if (!open)
        return;
    m_queue->guard([&] {
        if (const std::optional<StrokeExtension> told = quantisedIfInRange(extension))
            open->extend(m_queue->state(), *told);
    });
}

void EditSession::end(Ending ending)
{
    if (OpenOperation* open = m_queue->interactive())
        m_queue->end(*open, ending);
}

void EditSession::forgetPreview()
{
    const OpenOperation* open = m_queue->interactive();
    if (!open || !open->manner().keepsForNext)
        return;
    extend(ForgetPreview{});
    end(Ending::Rollback); // whichever is open by now: one that failed has been taken back
}

const Edit* EditSession::openEdit() const
{
    const OpenOperation* open = m_queue->interactive();
    return open ? &open->edit() : nullptr;
}

bool EditSession::openIsPreview() const
{
    const OpenOperation* open = m_queue->interactive();
    return open && open->manner().withoutPen && open->manner().usualEnding == Ending::Rollback;
}

bool EditSession::openIsReplaceable() const
{
    const OpenOperation* open = m_queue->interactive();
    return openIsPreview() && open->manner().endsIfRefused && !open->manner().keepsForNext;
}

bool EditSession::openHasBegun() const
{
    const OpenOperation* open = m_queue->interactive();
    return open && open->hasBegun();
}

bool EditSession::openIsRefused() const
{
    const OpenOperation* open = m_queue->interactive();
    return open && open->refused();
}

bool EditSession::transactionOpen() const
{
    return openEdit() != nullptr;
}

void EditSession::closeOpen()
{
    m_queue->closeOpen();
}

Result<void> EditSession::undo()
{
    return guarded([&]() -> Result<void> {
        m_queue->closeOpen();
        if (m_queue->idle() && !history().canUndo())
            return failure(ErrorCode::InvalidField, QStringLiteral("undo"),
                Clause::saying("the history is at its beginning"));
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Undo));
        return {};
    });
}

Result<void> EditSession::redo()
{
    return guarded([&]() -> Result<void> {
        m_queue->closeOpen();
        if (m_queue->idle() && !history().canRedo())
            return failure(ErrorCode::InvalidField, QStringLiteral("redo"),
                Clause::saying("the history is at its end"));
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Redo));
        return {};
    });
}

Result<void> EditSession::goTo(RowId row)
{
    return guarded([&]() -> Result<void> {
        if (row < 0 || row > RowId(history().rows().size()))
            return failure(ErrorCode::InvalidField, QStringLiteral("goTo"),
                Clause::saying("the history has no row %1", row));
        m_queue->closeOpen();
        m_queue->submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row));
        return {};
    });
}

void EditSession::poll()
{
    m_queue->poll();
}

bool EditSession::idle() const
{
    return m_queue->idle();
}

Result<void> EditSession::settle()
{
    return m_queue->settle();
}

Result<void> EditSession::endWork()
{
    return m_queue->endWork();
}

void EditSession::endUnheard()
{
    m_queue->endUnheard();
}

QByteArray EditSession::stateHash() const
{
    const SessionState& state = m_queue->state();
    return state.worker->stateHash(state.documentJson());
}

void EditSession::setOrigin(std::function<RowOrigin()> origin)
{
    m_queue->state().origin = std::move(origin);
}

void EditSession::setListener(std::function<void(const DocumentChange&)> listener)
{
    m_queue->setListener(std::move(listener));
}

void EditSession::setErrorListener(std::function<void(const Error&)> listener)
{
    m_queue->setErrorListener(std::move(listener));
}

} // namespace core
