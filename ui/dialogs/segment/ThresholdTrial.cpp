// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ThresholdTrial.h"

#include "core/session/EditSession.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <utility>

namespace ui {

namespace {

constexpr int soonMilliseconds = 30;
constexpr int laterMilliseconds = 200; ///< while a stroke is under the pen

} // namespace

ThresholdTrial::ThresholdTrial(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &ThresholdTrial::begin);
    connect(&workspace, &Workspace::sessionClosing, this, &ThresholdTrial::drop);
}

bool ThresholdTrial::isOpen() const
{
    const core::EditSession* session = m_workspace.session();
    return m_shown && session && session->isOpen<core::ThresholdSegment>();
}

void ThresholdTrial::show(const core::ThresholdSegment& edit)
{
    m_wanted = edit;
    if (!m_soon.isActive())
        m_soon.start(soonMilliseconds);
}

void ThresholdTrial::begin()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_wanted)
        return;
    if (isOpen() && *m_shown == *m_wanted)
        return m_wanted.reset();
    m_shown.reset();
    // The one before is taken back by this. A growth that stands open is left to its user.
    const bool isTaken = session->transactionOpen() && !session->isOpen<core::ThresholdSegment>();
    if (isTaken)
        return m_soon.start(laterMilliseconds);
    if (session->begin(*m_wanted))
        m_shown = m_wanted;
    m_wanted.reset();
}

void ThresholdTrial::drop()
{
    m_soon.stop();
    m_wanted.reset();
    if (isOpen())
        m_workspace.session()->end(core::Ending::Rollback);
    m_shown.reset();
}

void ThresholdTrial::take(const core::ThresholdSegment& edit)
{
    m_soon.stop();
    m_wanted.reset();
    const bool isShown = isOpen() && *m_shown == edit;
    m_shown.reset();
    takeThreshold(m_workspace, edit, isShown);
}

} // namespace ui
