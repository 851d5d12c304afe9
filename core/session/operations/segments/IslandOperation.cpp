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
#include "core/sculpt/labels/HeldVoxels.h"

#include <set>
#include <utility>

namespace core {

namespace {

/// The segment and those that are smoothed together with it.
std::vector<int> segmentsOf(const ReshapeSegment& edit)
{
    std::vector<int> segments = edit.with.value_or(std::vector<int>());
    segments.push_back(edit.segment);
    return segments;
}

} // namespace

/// What one segment gains and loses.
template <class E> IslandOperation::LabelWork IslandOperation::relabelling(const E& edit)
{
    return [edit](const Document& document, std::span<const LabelPlane> planes,
               const Progress& progress) -> Result<Listed> {
        return relabelListed(edit, document, planes.front().labels, progress);
    };
}

IslandOperation::IslandOperation(const CleanSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, {edit.segment}, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const ReshapeSegment& edit, Kind kind, RowId again)
    : IslandOperation(
        edit, segmentsOf(edit),
        [edit](const Document& document, std::span<const LabelPlane> planes,
            const Progress& progress) -> Result<Listed> {
            if (planes.size() > 1)
                return labelPlanes(edit, document, planes, progress);
            if (edit.with)
                return labelListed(edit, document, planes.front().labels, progress);
            return relabelListed(edit, document, planes.front().labels, progress);
        },
        kind, again)
{
}

IslandOperation::IslandOperation(const FillBetweenSlices& edit, Kind kind, RowId again)
    : IslandOperation(edit, {edit.segment}, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const MirrorSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, {edit.segment}, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const SplitSegment& edit, Kind kind, RowId again)
    : IslandOperation(edit, {edit.segment}, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(const SplitByCurve& edit, Kind kind, RowId again)
    : IslandOperation(edit, {edit.segment}, relabelling(edit), kind, again)
{
}

IslandOperation::IslandOperation(
    Edit edit, std::vector<int> segments, LabelWork workOut, Kind kind, RowId again)
    : WorkedOutOperation(std::move(edit), kind, again)
    , m_segments(std::move(segments))
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
    std::set<std::uint8_t> planes;
    for (const int label : m_segments)
        planes.insert(state.document.segment(label)->plane);
    for (const std::uint8_t plane : planes)
        m_readings.emplace_back(state.document.volumes.front().geometry.size, plane);
    readNext(state);
}

void IslandOperation::readNext(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    for (; m_reading < m_readings.size(); ++m_reading) {
        if (m_readings[m_reading].ask(state.engine))
            return;
    }
    workAside(state,
        [this, workOut = m_workOut, watch = watch(), document = state.document,
            readings = std::make_shared<std::vector<LabelReading>>(std::move(m_readings))] {
            std::vector<std::vector<std::uint8_t>> labels;
            std::vector<LabelPlane> planes;
            for (LabelReading& reading : *readings) {
                const std::uint8_t plane = reading.reader().plane();
                labels.push_back(reading.reader().takeLabels());
                planes.push_back({plane, labels.back()});
            }
            auto listed =
                std::make_shared<Result<Listed>>(workOut(document, planes, watch->progress));
            return SideThread::Sequel(
                [this, listed](SessionState& known) { write(known, std::move(*listed)); });
        });
    m_readings.clear();
}

void IslandOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading < m_readings.size() && m_readings[m_reading].awaits(result.ticket)) {
        if (const Result<void> taken = m_readings[m_reading].take(result); !taken)
            return giveUp(state, taken.error());
        return readNext(state);
    }
    takeWritten(state, std::move(result));
}

} // namespace core
