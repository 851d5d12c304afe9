// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/trials/SplitTrial.h"

#include "core/brick/LabelRuns.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/session/EditSession.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <utility>

namespace ui {

SplitTrial::SplitTrial(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&m_fetch, &LabelFetch::finished, this, &SplitTrial::takeLabels);
    connect(&m_fetch, &LabelFetch::failed, this, &SplitTrial::drop);
    connect(&workspace, &Workspace::sessionClosing, this, &SplitTrial::drop);
}

template <class E> void SplitTrial::lookAt(const E& edit)
{
    if (edit.segment != m_segment)
        drop();
    m_segment = edit.segment;
    m_wanted = [edit](const core::Document& document, const core::VoxelRuns& voxels,
                   const core::Progress& progress) {
        return core::sidesOf(edit, document, voxels, progress);
    };
    goOn();
}

void SplitTrial::look(const core::SplitByCurve& edit)
{
    lookAt(edit);
}

void SplitTrial::look(const core::SplitSegment& edit)
{
    lookAt(edit);
}

void SplitTrial::drop()
{
    m_fetch.cancel();
    m_sorting.cancel();
    m_counting.cancel();
    m_wanted = nullptr;
    m_voxels.reset();
    m_segment = 0;
    const bool hadParts = m_parts.has_value();
    m_parts.reset();
    if (hadParts)
        Q_EMIT changed();
}

QString SplitTrial::text(const QString& name, const QString& newName) const
{
    if (!m_parts || !m_workspace.volume())
        return {};
    if (m_parts->beyond == 0 || m_parts->staying == 0)
        return tr("all of %1 lies on one side").arg(name);
    return partsText(m_workspace, name, m_parts->staying, newName, m_parts->beyond);
}

/// To whatever the question that waits needs next, unless that is under way.
void SplitTrial::goOn()
{
    const core::EditSession* session = m_workspace.session();
    if (!m_wanted || !session)
        return;
    const bool isRead = m_voxels && m_position == session->history().position();
    if (isRead)
        count();
    else if (!m_fetch.running() && !m_sorting.busy())
        read();
}

void SplitTrial::read()
{
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session->document().segment(m_segment);
    if (!segment || session->transactionOpen())
        return drop();
    m_voxels.reset();
    m_fetch.start(*session, {segment->plane});
}

void SplitTrial::takeLabels(const LabelFetch::Planes& planes)
{
    const core::RowId position = m_workspace.session()->history().position();
    m_sorting.replace(
        this,
        [planes, label = std::uint8_t(m_segment)] {
            return std::make_shared<const core::VoxelRuns>(
                core::labelRuns(planes->front().labels, label));
        },
        [this, position](const core::Result<std::shared_ptr<const core::VoxelRuns>>& voxels) {
            if (!voxels)
                return drop();
            m_voxels = *voxels;
            m_position = position;
            goOn();
        });
}

void SplitTrial::count()
{
    if (m_counting.busy())
        return; // its end goes on with the latest question
    m_counting.start(
        this,
        [wanted = std::exchange(m_wanted, nullptr), voxels = m_voxels,
            document = m_workspace.session()->document()](
            const core::Progress& progress) -> core::Result<Parts> {
            const core::Result<core::SplitSides> sides = wanted(document, *voxels, progress);
            if (!sides)
                return tl::unexpected(sides.error());
            return Parts{.staying = std::int64_t(sides->staying),
                .beyond = std::int64_t(sides->beyond.voxelCount()),
                .isInside = sides->isInside};
        },
        [this](const core::Result<Parts>& parts) {
            // A curve that is too small still has no sides.
            m_parts = parts ? std::optional(*parts) : std::nullopt;
            goOn();
            Q_EMIT changed();
        });
}

} // namespace ui
