// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/SplitIslandsOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/engine/EngineCommands.h"
#include "core/sculpt/labels/HeldVoxels.h"

#include <utility>

namespace core {

SplitIslandsOperation::SplitIslandsOperation(const SplitIslands& edit, Kind kind, RowId again)
    : WorkedOutOperation(edit, kind, again)
    , m_work(std::make_shared<Work>())
{
}

bool SplitIslandsOperation::foresee(Document& document) const
{
    if (isRolledBack())
        return true; // it changes nothing
    return isCommitted() && split().into && applyToDocument(edit(), document);
}

void SplitIslandsOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    const glm::ivec3& size = state.document.volumes.front().geometry.size;
    const std::uint8_t own = state.document.segment(split().segment)->plane;
    m_work->readings.emplace_back(size, own);
    // A range that is not valid was refused.
    if (const auto editable = editableVoxels(split().editable, state.document, "splitIslands");
        editable && *editable) {
        std::set<std::uint8_t> others = planesOf(**editable);
        others.erase(own);
        for (const std::uint8_t plane : others)
            m_work->readings.emplace_back(size, plane);
    }
    readLabels(state);
}

void SplitIslandsOperation::readLabels(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    for (; m_reading < m_work->readings.size(); ++m_reading) {
        if (m_work->readings[m_reading].ask(state.engine))
            return;
    }
    if (isByValue(split()))
        findBox(state);
    else
        workOut(state);
}

void SplitIslandsOperation::findBox(SessionState& state)
{
    workAside(state, [this, work = m_work, label = state.document.segment(split().segment)->label] {
        if (const std::optional<LabelPlace> place = work->readings.front().reader().placeOf(label))
            work->box = place->box;
        return SideThread::Sequel([this](SessionState& known) {
            m_slabs = CodeSlabs(m_work->box);
            readCodes(known);
        });
    });
}

void SplitIslandsOperation::readCodes(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (const std::optional<VoxelBox> slab = m_slabs.take())
        m_asked = state.engine.submit(ReadCodes{*slab});
    else
        workOut(state);
}

void SplitIslandsOperation::workOut(SessionState& state)
{
    workAside(state,
        [this, work = m_work, watch = watch(), document = state.document,
            completed = std::make_shared<SplitIslands>(split())] {
            auto result = std::make_shared<Result<Listed>>(
                listed(*completed, document, *work, watch->progress));
            return SideThread::Sequel([this, result, completed](SessionState& known) {
                complete(*completed);
                write(known, std::move(*result));
            });
        });
}

Result<LabelListed> SplitIslandsOperation::listed(
    SplitIslands& edit, const Document& document, Work& work, const Progress& progress)
{
    std::vector<std::vector<std::uint8_t>> labels;
    std::vector<LabelPlane> planes;
    for (LabelReading& reading : work.readings) {
        const std::uint8_t plane = reading.reader().plane();
        labels.push_back(reading.reader().takeLabels());
        planes.push_back({plane, labels.back()});
    }
    return labelListed(
        edit, document, {.planes = planes, .box = work.box, .codes = work.codes}, progress);
}

void SplitIslandsOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading < m_work->readings.size() && m_work->readings[m_reading].awaits(result.ticket)) {
        if (const Result<void> taken = m_work->readings[m_reading].take(result); !taken)
            return giveUp(state, taken.error());
        return readLabels(state);
    }
    if (!m_asked || result.ticket != *m_asked)
        return takeWritten(state, std::move(result));
    m_asked.reset();
    if (result.error)
        return giveUp(state, *result.error);
    // The side thread rests meanwhile.
    m_work->codes.insert(m_work->codes.end(), result.codes.begin(), result.codes.end());
    readCodes(state);
}

} // namespace core
