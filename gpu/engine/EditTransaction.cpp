// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditTransaction.h"

#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gpu {

core::Result<std::unique_ptr<EditTransaction>> EditTransaction::begin(
    EditPrograms& programs, VoxelFields& fields, const core::EngineEdit& edit)
{
    if (const core::Result<void> checked = core::checkEdit(edit, fields.grid()); !checked)
        return tl::unexpected(checked.error());

    std::unique_ptr<EditTransaction> transaction(new EditTransaction(programs, fields));
    try {
        if (const core::Result<void> started = transaction->start(edit); !started)
            return tl::unexpected(started.error());
        requireNoError();
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        transaction->abandon(error);
        throw GlFailure(error);
    }
    return transaction;
}

core::Result<void> EditTransaction::start(const core::EngineEdit& edit)
{
    const WorkContext context{.programs = m_programs, .fields = m_fields, .before = m_before};
    BegunWork begun =
        std::visit([&context](const auto& known) { return beginWork(&known, context); }, edit);
    if (!begun)
        return tl::unexpected(begun.error());
    m_work = *std::move(begun);
    return {};
}

core::Result<void> EditTransaction::extend(const core::EngineExtension& extension)
{
    return m_work->extend(extension);
}

bool EditTransaction::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    return m_work && earlier.index() == next.index() && m_work->join(earlier, next);
}

bool EditTransaction::hasChangesToRead() const
{
    if (!m_work)
        return false;
    return m_unread ? m_unread->size() > 1 : m_before.isMuch();
}

void EditTransaction::readSomeChanges()
{
    divideChanges();
    if (hasChangesToRead())
        readPart();
}

void EditTransaction::divideChanges()
{
    if (m_unread)
        return;
    std::vector<core::BrickKey> keys = m_work->touchedKeys();
    m_changes.reserve(keys.size());
    m_unread = m_before.inParts(std::move(keys));
}

void EditTransaction::readPart()
{
    std::vector<core::BrickChange> changes = m_before.changes(std::move(m_unread->back()));
    m_unread->pop_back();
    std::move(changes.begin(), changes.end(), std::back_inserter(m_changes));
}

void EditTransaction::commit(core::EngineResult& result)
{
    divideChanges();
    while (!m_unread->empty())
        readPart();
    std::sort(m_changes.begin(), m_changes.end(),
        [](const core::BrickChange& one, const core::BrickChange& other) {
            return one.key < other.key;
        });
    result.changes = std::exchange(m_changes, {});
    result.facts = core::factsOf(result.changes, m_fields.grid());
    result.statistics = core::statisticsOf(result.facts);
    for (const core::BrickChange& change : result.changes) {
        if (change.key.field == core::Field::Overwritten && change.after.empty())
            m_fields.overwritten(change.key.plane).release(std::span(&change.key.brick, 1));
    }
    m_work->finish(result);
}

void EditTransaction::rollBack(core::EngineResult& result)
{
    m_before.restore(m_work->touchedKeys());
    m_work->rollBack(result);
}

void EditTransaction::abandon(const core::Error& why)
{
    m_abandoned = why;
    // What it holds is of no use, and its memory is wanted.
    if (m_work)
        m_work->abandon();
    m_work.reset();
    m_unread.reset();
    m_changes = {};
    // Then there is nothing to put back, nor anywhere to put it.
    if (why.code == core::ErrorCode::ContextLost)
        throw ContextLost(why);
    constexpr int tries = 3;
    for (int i = 0; i < tries; ++i) {
        try {
            return m_before.restoreAll();
        } catch (const FieldsLost&) {
            throw;
        } catch (const std::exception&) {
            // No memory for what was there; it may be had by now.
        }
    }
    throw FieldsLost(why);
}

core::GrowthProgress EditTransaction::progress() const
{
    return m_work ? m_work->progress() : core::GrowthProgress();
}

std::optional<std::uint8_t> EditTransaction::growingPlane() const
{
    return m_work ? m_work->growingPlane() : std::nullopt;
}

ComparedGrowth EditTransaction::compareGrowth()
{
    return gpu::compareGrowth(
        m_fields, m_before, m_work->growingPlane().value(), m_work->touchedKeys());
}

tl::unexpected<core::Error> refusal(const char* field, const core::Clause& reason)
{
    return core::failure(core::ErrorCode::InvalidField, QLatin1String(field), reason);
}

} // namespace gpu
