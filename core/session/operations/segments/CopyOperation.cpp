// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/CopyOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

namespace {

/// Whether a voxel that has the label in one plane has any in the other.
bool sharesVoxels(const std::vector<std::uint8_t>& own, std::uint8_t label,
    const std::vector<std::uint8_t>& other)
{
    for (std::size_t voxel = 0; voxel < own.size(); ++voxel) {
        if (own[voxel] == label && other[voxel] != 0)
            return true;
    }
    return false;
}

} // namespace

CopyOperation::CopyOperation(CopySegment edit, RowId again)
    : WorkedOutOperation(std::move(edit), Kind::Whole, again)
{
}

bool CopyOperation::foresee(Document& document) const
{
    // Its label is taken even while the plane is not known.
    const bool isApplied = bool(applyToDocument(edit(), document));
    return isApplied && copy().plane.has_value();
}

void CopyOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    if (copy().plane)
        return writeCopy(state);
    const std::uint8_t own = state.document.segment(copy().segment)->plane;
    for (const std::uint8_t plane : state.document.labelPlanes()) {
        if (plane != own)
            m_left.insert(m_left.begin(), plane);
    }
    if (m_left.empty())
        return lookFurther(state);
    lookAt(state, own);
}

void CopyOperation::lookAt(SessionState& state, std::uint8_t plane)
{
    m_reading.emplace(state.document.volumes.front().geometry.size, plane);
    readNext(state);
}

void CopyOperation::readNext(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (m_reading->ask(state.engine))
        return;
    workAside(state,
        [this, own = m_own, label = std::uint8_t(copy().segment),
            reader = std::make_shared<LabelReader>(std::move(m_reading->reader()))] {
            auto labels = std::make_shared<std::vector<std::uint8_t>>(reader->takeLabels());
            if (!own)
                return SideThread::Sequel([this, labels](SessionState& known) {
                    m_own = labels;
                    lookFurther(known);
                });
            const bool isTaken = sharesVoxels(*own, label, *labels);
            return SideThread::Sequel(
                [this, isTaken, plane = reader->plane()](SessionState& known) {
                    if (isTaken)
                        m_taken.push_back(plane);
                    else
                        m_left.clear(); // planeOfCopy() takes the first one that is not taken
                    lookFurther(known);
                });
        });
    m_reading.reset();
}

void CopyOperation::lookFurther(SessionState& state)
{
    if (!m_left.empty()) {
        const std::uint8_t next = m_left.back();
        m_left.pop_back();
        return lookAt(state, next);
    }
    m_own.reset();
    CopySegment completed = copy();
    const Result<int> plane = planeOfCopy(completed, state.document, m_taken);
    if (!plane)
        return giveUp(state, plane.error());
    completed.plane = *plane;
    complete(std::move(completed));
    writeCopy(state);
}

void CopyOperation::writeCopy(SessionState& state)
{
    Result<MapLabels> map = mapLabels(copy(), state.document);
    if (!map)
        return giveUp(state, map.error());
    write(state, Listed(*std::move(map)));
}

void CopyOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading && m_reading->awaits(result.ticket)) {
        if (const Result<void> taken = m_reading->take(result); !taken)
            return giveUp(state, taken.error());
        return readNext(state);
    }
    takeWritten(state, std::move(result));
}

} // namespace core
