// SPDX-License-Identifier: Apache-2.0
#include "ui/window/KeyframeRecorder.h"

#include "core/session/SessionKeyframes.h"
#include "ui/views/ImageView.h"
#include "ui/workspace/Workspace.h"

namespace ui {

KeyframeRecorder::KeyframeRecorder(Workspace& workspace, ImageView& view)
    : QObject(&view)
    , m_workspace(workspace)
    , m_view(view)
    , m_clock(steadyMilliseconds)
{
    connect(&workspace, &Workspace::sessionChanged, this, &KeyframeRecorder::begin);
    connect(&workspace, &Workspace::sessionClosing, this, &KeyframeRecorder::close);
    connect(&workspace, &Workspace::documentChanged, this, &KeyframeRecorder::follow);
    connect(&view, &ImageView::qualityChanged, this, &KeyframeRecorder::look);
    begin();
}

void KeyframeRecorder::begin()
{
    core::EditSession* session = m_workspace.session();
    m_rows = session ? session->history().rows().size() : 0;
    m_position = session ? session->history().position() : 0;
    m_rule.begin(m_rows, m_position, session && !session->keyframes().rows().empty(), m_clock());
    m_due = false;
    m_outdated = 0;
}

void KeyframeRecorder::follow(const core::DocumentChange& change)
{
    core::EditSession* session = m_workspace.session();
    if (!session || change.what != core::DocumentChange::What::History)
        return;
    const core::History& history = session->history();
    const bool committed = history.rows().size() > m_rows;
    const bool moved = history.position() != m_position;
    m_rows = history.rows().size();
    m_position = history.position();
    if (!moved)
        return;
    // A step of the document alone may leave the picture as it is; no new one would come then.
    const bool sameVoxels = committed && history.rows().back().statistics.bricks == 0;
    if (!sameVoxels)
        m_outdated = m_view.picture().cacheKey();
    m_due = m_due || (committed && m_rule.dueAfterStep(m_rows, m_clock()));
    look();
}

bool KeyframeRecorder::showsPresentState() const
{
    return !m_view.picture().isNull() && m_view.picture().cacheKey() != m_outdated;
}

void KeyframeRecorder::look()
{
    const bool calm = m_view.quality() == gpu::Frame::Quality::Refined && showsPresentState();
    core::EditSession* session = m_workspace.session();
    // What is shown at a tolerance is not there yet.
    if (!m_due || !calm || !session || session->transactionOpen() || m_workspace.atTolerance())
        return;
    keep(m_position, m_view.picture());
}

void KeyframeRecorder::keep(core::RowId row, const QImage& picture)
{
    m_due = false;
    m_rule.kept(row, m_rows, m_clock());
    m_encoder.start(
        this, [picture] { return keyframePng(picture); },
        [this, row](const core::Result<QByteArray>& png) {
            core::EditSession* session = m_workspace.session();
            if (png && session) // the row has no picture, else
                session->keyframes().add(row, *png);
        });
}

void KeyframeRecorder::close()
{
    if (m_rule.dueAtEnd(m_position) && showsPresentState())
        keep(m_position, m_view.picture());
    m_encoder.finish();
}

} // namespace ui
