// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ViewSteps.h"

#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "ui/workspace/Workspace.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace ui {

namespace {

/// The labels of a that b has not; both are ascending.
std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b)
{
    std::vector<int> left;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(left));
    return left;
}

} // namespace

ViewSteps::ViewSteps(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(std::chrono::milliseconds(400));
    connect(&m_rest, &QTimer::timeout, this, &ViewSteps::closeStep);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        const core::EditSession* session = m_workspace.session();
        m_knownRows = session ? session->history().rows().size() : 0;
        m_hiddenBeforeAlone.reset();
        // Who shows them begins anew with the session, too, and should not be told in between.
        m_walks.clear();
        closeStep();
    });
    connect(&workspace, &Workspace::clipChanged, this, [this] {
        if (!m_own)
            forget();
    });
    connect(&workspace, &Workspace::documentChanged, this, &ViewSteps::followHistory);
}

core::RowId ViewSteps::position() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? session->foreseenPosition().value_or(session->history().position()) : 0;
}

/// Whether an edit is under way, which undo would take back.
bool ViewSteps::isEditing() const
{
    const core::EditSession* session = m_workspace.session();
    return session && !session->foreseenPosition();
}

const ViewSteps::Walk* ViewSteps::here() const
{
    const auto found = m_walks.find(position());
    return found == m_walks.end() ? nullptr : &found->second;
}

void ViewSteps::followHistory()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    // Eyes that follow a step of the history are another step, even if that one is taken back.
    if (m_open == What::Segments && m_openAt != position())
        closeStep();
    // What was undone is gone once something else is done.
    const std::vector<core::HistoryRow>& rows = session->history().rows();
    bool dropped = false;
    for (std::size_t i = m_knownRows; i < rows.size(); ++i) {
        const auto walk = m_walks.find(rows[i].parent);
        if (walk == m_walks.end() || walk->second.undone.empty())
            continue;
        walk->second.undone.clear();
        dropped = true;
    }
    m_knownRows = rows.size();
    if (dropped)
        Q_EMIT changed();
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

ViewSteps::Change& ViewSteps::begin(What what)
{
    const core::RowId row = position();
    const bool isBeside = isEditing();
    Walk& walk = m_walks[row];
    if (m_open != what || m_openAt != row || walk.done.back().isBeside != isBeside) {
        closeStep();
        walk.done.push_back({.what = what, .isBeside = isBeside, .before = shown(), .after = {}});
    }
    m_open = what;
    m_openAt = row;
    walk.undone.clear();
    return walk.done.back();
}

void ViewSteps::change(const core::ClipRegion& clip)
{
    if (clip == m_workspace.clip())
        return;
    const bool goesOn = m_open == What::Clip && m_openAt == position();
    const bool held = m_held;
    Change& step = begin(What::Clip);
    step.after = step.before;
    step.after.clip = clip;
    m_held = held;
    if (!m_held)
        m_rest.start();
    {
        const QScopedValueRollback own(m_own, true);
        m_workspace.setClip(clip);
    }
    // Who lists the steps need not hear of each movement of a drag.
    if (!goesOn)
        Q_EMIT changed();
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
        std::vector<Change>& done = m_walks[m_openAt].done;
        const core::ClipRegion before = done.back().before.clip;
        done.pop_back();
        {
            const QScopedValueRollback own(m_own, true);
            m_workspace.setClip(before);
        }
        Q_EMIT changed();
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
    Change& step = begin(What::Segments);
    step.after = step.before;
    step.after.hidden = hidden;
    // Who is told of the change asks what can be undone.
    if (step.before.hidden == hidden) {
        m_walks[m_openAt].done.pop_back();
        closeStep();
    }
    hideOnly(hidden);
    Q_EMIT changed();
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

ViewSteps::Step ViewSteps::named(const Change& change)
{
    if (change.what == What::Clip)
        return {.what = What::Clip};
    return {.what = What::Segments,
        .hidden = without(change.after.hidden, change.before.hidden),
        .shown = without(change.before.hidden, change.after.hidden)};
}

std::optional<ViewSteps::Step> ViewSteps::undoable() const
{
    const Walk* walk = here();
    if (!walk || walk->done.empty() || (isEditing() && !walk->done.back().isBeside))
        return std::nullopt;
    return named(walk->done.back());
}

std::optional<ViewSteps::Step> ViewSteps::redoable() const
{
    const Walk* walk = here();
    return walk && !walk->undone.empty() ? std::optional(named(walk->undone.back())) : std::nullopt;
}

void ViewSteps::undo()
{
    if (undoable())
        takeBack();
}

void ViewSteps::takeBack()
{
    closeStep();
    Walk& walk = m_walks[position()];
    const Change change = walk.done.back();
    walk.done.pop_back();
    walk.undone.push_back(change);
    show(change, change.before);
}

void ViewSteps::redo()
{
    if (!redoable())
        return;
    closeStep();
    Walk& walk = m_walks[position()];
    const Change change = walk.undone.back();
    walk.undone.pop_back();
    walk.done.push_back(change);
    show(change, change.after);
}

void ViewSteps::goTo(int done)
{
    while (here() && int(here()->done.size()) > std::max(done, 0))
        takeBack();
    while (redoable() && int(here()->done.size()) < done)
        redo();
}

/// Makes what a change is about as it was at one of its ends, and leaves everything else alone:
/// other rows may have changed that since.
void ViewSteps::show(const Change& change, const Shown& wanted)
{
    if (change.what == What::Clip) {
        const QScopedValueRollback own(m_own, true);
        m_workspace.setClip(wanted.clip);
    } else {
        const Step step = named(change);
        std::vector<int> hidden = without(without(shown().hidden, step.hidden), step.shown);
        for (const std::vector<int>* labels : {&step.hidden, &step.shown}) {
            for (const int label : *labels) {
                if (std::binary_search(wanted.hidden.begin(), wanted.hidden.end(), label))
                    hidden.push_back(label);
            }
        }
        hideOnly(hidden);
    }
    Q_EMIT changed();
}

ViewSteps::Steps ViewSteps::at(core::RowId row) const
{
    Steps steps;
    const auto found = m_walks.find(row);
    if (found == m_walks.end())
        return steps;
    const Walk& walk = found->second;
    std::transform(
        walk.done.begin(), walk.done.end(), std::back_inserter(steps.all), &ViewSteps::named);
    std::transform(
        walk.undone.rbegin(), walk.undone.rend(), std::back_inserter(steps.all), &ViewSteps::named);
    steps.done = int(walk.done.size());
    return steps;
}

std::map<core::RowId, int> ViewSteps::counts() const
{
    std::map<core::RowId, int> counts;
    for (const auto& [row, walk] : m_walks) {
        if (const int count = int(walk.done.size() + walk.undone.size()); count > 0)
            counts[row] = count;
    }
    return counts;
}

void ViewSteps::forget()
{
    const bool any = !m_walks.empty();
    m_walks.clear();
    closeStep();
    if (any)
        Q_EMIT changed();
}

bool isShownAlone(const core::Document& document, int label)
{
    return std::all_of(document.segments.begin(), document.segments.end(),
        [label](const core::Segment& each) { return each.visible == (each.label == label); });
}

} // namespace ui
