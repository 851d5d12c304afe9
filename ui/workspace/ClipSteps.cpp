// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ClipSteps.h"

#include "core/session/EditSession.h"
#include "ui/workspace/Workspace.h"

#include <QScopedValueRollback>

#include <chrono>

namespace ui {

ClipSteps::ClipSteps(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(std::chrono::milliseconds(400));
    connect(&m_rest, &QTimer::timeout, this, &ClipSteps::closeStep);
    connect(&workspace, &Workspace::sessionChanged, this, &ClipSteps::forget);
    connect(&workspace, &Workspace::clipChanged, this, [this] {
        if (!m_own)
            forget();
    });
    // What was undone is gone once something else is done.
    connect(&workspace, &Workspace::documentChanged, this, [this] {
        if (m_position != position())
            m_after.clear();
    });
}

std::optional<core::RowId> ClipSteps::position() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? std::optional(session->history().position()) : std::nullopt;
}

void ClipSteps::change(const core::ClipRegion& clip)
{
    const core::ClipRegion before = m_workspace.clip();
    if (clip == before)
        return;
    if (m_position != position())
        forget();
    m_position = position();
    if (!m_open)
        m_before.push_back(before);
    m_after.clear();
    m_open = true;
    if (!m_held)
        m_rest.start();
    const QScopedValueRollback own(m_own, true);
    m_workspace.setClip(clip);
}

void ClipSteps::hold()
{
    closeStep();
    m_held = true;
}

void ClipSteps::release()
{
    closeStep();
}

void ClipSteps::cancelHold()
{
    if (m_held && m_open) {
        const core::ClipRegion before = m_before.back();
        m_before.pop_back();
        const QScopedValueRollback own(m_own, true);
        m_workspace.setClip(before);
    }
    closeStep();
}

void ClipSteps::closeStep()
{
    m_open = false;
    m_held = false;
    m_rest.stop();
}

bool ClipSteps::canUndo() const
{
    return !m_before.empty() && m_position == position();
}

bool ClipSteps::canRedo() const
{
    return !m_after.empty() && m_position == position();
}

void ClipSteps::undo()
{
    if (canUndo())
        go(m_before, m_after);
}

void ClipSteps::redo()
{
    if (canRedo())
        go(m_after, m_before);
}

void ClipSteps::go(std::vector<core::ClipRegion>& from, std::vector<core::ClipRegion>& to)
{
    closeStep();
    to.push_back(m_workspace.clip());
    const core::ClipRegion clip = from.back();
    from.pop_back();
    const QScopedValueRollback own(m_own, true);
    m_workspace.setClip(clip);
}

void ClipSteps::forget()
{
    m_before.clear();
    m_after.clear();
    m_position.reset();
    closeStep();
}

} // namespace ui
