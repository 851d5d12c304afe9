// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ViewSteps.h"

#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "ui/workspace/Workspace.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <chrono>
#include <utility>

namespace ui {

ViewSteps::ViewSteps(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(std::chrono::milliseconds(400));
    connect(&m_rest, &QTimer::timeout, this, &ViewSteps::closeStep);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_hiddenBeforeAlone.reset();
        forget();
    });
    connect(&workspace, &Workspace::clipChanged, this, [this] {
        if (!m_own)
            forget();
    });
    // What was undone is gone once something else is done, and eyes that follow are another step,
    // even if that is taken back.
    connect(&workspace, &Workspace::documentChanged, this, [this] {
        if (m_position == position())
            return;
        m_after.clear();
        if (m_open == What::Segments)
            closeStep();
    });
}

std::optional<core::RowId> ViewSteps::position() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? std::optional(session->history().position()) : std::nullopt;
}

ViewSteps::Shown ViewSteps::shown() const
{
    Shown now{.clip = m_workspace.clip(), .hidden = {}};
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::Segment& each : session->document().segments) {
            if (!each.visible)
                now.hidden.push_back(each.label);
        }
    }
    std::sort(now.hidden.begin(), now.hidden.end());
    return now;
}

void ViewSteps::show(const Shown& wanted)
{
    hideOnly(wanted.hidden);
    const QScopedValueRollback own(m_own, true);
    m_workspace.setClip(wanted.clip);
}

void ViewSteps::hideOnly(const std::vector<int>& hidden)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const QScopedValueRollback own(m_own, true);
    std::vector<std::pair<int, bool>> changed;
    for (const core::Segment& each : session->document().segments) {
        const bool wanted = std::find(hidden.begin(), hidden.end(), each.label) == hidden.end();
        if (each.visible != wanted)
            changed.emplace_back(each.label, wanted);
    }
    session->display().setSegmentsVisible(changed);
}

/// The next change belongs to a step, the last one or a new one.
void ViewSteps::begin(What what)
{
    if (m_position != position())
        forget();
    m_position = position();
    if (m_open != what) {
        closeStep();
        m_before.push_back({what, shown()});
    }
    m_open = what;
    m_after.clear();
}

void ViewSteps::change(const core::ClipRegion& clip)
{
    if (clip == m_workspace.clip())
        return;
    const bool held = m_held;
    begin(What::Clip);
    m_held = held;
    if (!m_held)
        m_rest.start();
    const QScopedValueRollback own(m_own, true);
    m_workspace.setClip(clip);
}

void ViewSteps::hold()
{
    closeStep();
    m_held = true;
}

void ViewSteps::release()
{
    closeStep();
}

void ViewSteps::cancelHold()
{
    if (m_held && m_open == What::Clip) {
        const core::ClipRegion before = m_before.back().shown.clip;
        m_before.pop_back();
        const QScopedValueRollback own(m_own, true);
        m_workspace.setClip(before);
    }
    closeStep();
}

void ViewSteps::showSegment(int label, bool wanted)
{
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment || segment->visible == wanted)
        return;
    m_hiddenBeforeAlone.reset();
    std::vector<int> hidden = shown().hidden;
    if (wanted)
        hidden.erase(std::find(hidden.begin(), hidden.end(), label));
    else
        hidden.push_back(label);
    changeHidden(hidden);
}

void ViewSteps::changeHidden(std::vector<int> hidden)
{
    std::sort(hidden.begin(), hidden.end());
    begin(What::Segments);
    // Who is told of the change asks what can be undone.
    if (m_before.back().shown.hidden == hidden) {
        m_before.pop_back();
        closeStep();
    }
    hideOnly(hidden);
}

void ViewSteps::showAlone(int label)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !session->document().segment(label))
        return;
    const core::Document& document = session->document();
    if (isShownAlone(document, label)) {
        const std::vector<int> before = m_hiddenBeforeAlone.value_or(std::vector<int>{});
        m_hiddenBeforeAlone.reset();
        return changeHidden(before);
    }
    // From one alone to another one: what comes back is what was shown before the first. But undo,
    // or a new segment, may have ended that.
    const auto seen = std::count_if(document.segments.begin(), document.segments.end(),
        [](const core::Segment& each) { return each.visible; });
    if (!m_hiddenBeforeAlone || seen != 1)
        m_hiddenBeforeAlone = shown().hidden;
    std::vector<int> hidden;
    for (const core::Segment& each : document.segments) {
        if (each.label != label)
            hidden.push_back(each.label);
    }
    changeHidden(hidden);
}

bool ViewSteps::knowsOthers(int label) const
{
    const core::EditSession* session = m_workspace.session();
    return session && isShownAlone(session->document(), label) && m_hiddenBeforeAlone
        && !m_hiddenBeforeAlone->empty();
}

void ViewSteps::closeStep()
{
    m_open.reset();
    m_held = false;
    m_rest.stop();
}

std::optional<ViewSteps::What> ViewSteps::undoable() const
{
    if (m_before.empty() || m_position != position())
        return std::nullopt;
    return m_before.back().what;
}

std::optional<ViewSteps::What> ViewSteps::redoable() const
{
    if (m_after.empty() || m_position != position())
        return std::nullopt;
    return m_after.back().what;
}

void ViewSteps::undo()
{
    if (undoable())
        go(m_before, m_after);
}

void ViewSteps::redo()
{
    if (redoable())
        go(m_after, m_before);
}

void ViewSteps::go(std::vector<Step>& from, std::vector<Step>& to)
{
    closeStep();
    const Step step = from.back();
    from.pop_back();
    to.push_back({step.what, shown()});
    show(step.shown);
}

void ViewSteps::forget()
{
    m_before.clear();
    m_after.clear();
    m_position.reset();
    closeStep();
}

bool isShownAlone(const core::Document& document, int label)
{
    return std::all_of(document.segments.begin(), document.segments.end(),
        [label](const core::Segment& each) { return each.visible == (each.label == label); });
}

} // namespace ui
