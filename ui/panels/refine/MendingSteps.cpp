// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/MendingSteps.h"

#include "core/edits/EditNames.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "ui/panels/refine/ComparePanel.h"
#include "ui/panels/refine/LookFirstSection.h"
#include "ui/workspace/Workspace.h"

#include <QSettings>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

QString wantedKey()
{
    return QStringLiteral("mending/strip");
}

/// Whether a step may change labels. What carves, or writes a layer in another way, changes voxels,
/// too, but no segment; what takes older steps back or changes one is as they are.
bool canChangeLabels(const core::History& history, const core::Edit& edit)
{
    if (core::isSculptEdit(edit) || core::writesSomeLayer(edit))
        return false;
    const auto ofRow = [&history](std::int64_t row) {
        return canChangeLabels(history, history.row(core::RowId(row)).edit);
    };
    const std::vector<std::int64_t> rows = core::rowsNamedBy(edit).rows;
    return rows.empty() || std::any_of(rows.begin(), rows.end(), ofRow);
}

} // namespace

MendingSteps::MendingSteps(Workspace& workspace, ComparePanel& panel, MendingStrip& strip)
    : QObject(&panel)
    , m_workspace(workspace)
    , m_panel(panel)
    , m_strip(strip)
    , m_wanted(QSettings().value(wantedKey(), true).toBool())
{
    m_strip.hide();
    connect(&strip, &MendingStrip::closeRequested, this, [this] {
        setWanted(false);
        // Also while a growth or a peeling stands open: whoever presses it is not drawing.
        m_strip.hide();
    });
    connect(&strip, &MendingStrip::stepRequested, this, [this](Step step) {
        m_begun = step;
        update();
    });
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_exported = false;
        m_begun.reset();
        update();
    });
    connect(&workspace, &Workspace::activeSegmentChanged, this, &MendingSteps::update);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            using What = core::DocumentChange::What;
            // A stroke under the pen changes labels many times; its end is told in the history.
            const bool isOlder = change.what == What::Labels && std::exchange(m_exported, false);
            if (isOlder || change.what == What::History)
                update();
        });
    connect(&panel.lookFirst().doubts(), &SegmentDoubts::changed, this, &MendingSteps::update);
    connect(&panel.comparison(), &LiveComparison::changed, this, &MendingSteps::update);
    update();
}

std::optional<MendingSteps::Step> MendingSteps::next() const
{
    if (m_begun && !m_done[std::size_t(*m_begun)])
        return m_begun;
    // A user who has left a step out goes on after the last one that is done; steps that were left
    // out come last.
    const auto furthest = std::find(m_done.rbegin(), m_done.rend(), true);
    const auto behind = std::find(furthest.base(), m_done.end(), false);
    const auto open =
        behind != m_done.end() ? behind : std::find(m_done.begin(), m_done.end(), false);
    return open != m_done.end() ? std::optional(Step(open - m_done.begin())) : std::nullopt;
}

void MendingSteps::setWanted(bool wanted)
{
    if (m_wanted == wanted)
        return;
    m_wanted = wanted;
    QSettings().setValue(wantedKey(), wanted);
    update();
    Q_EMIT changed();
}

void MendingSteps::noteExported()
{
    m_exported = true;
    update();
}

/// Whether a step after the last import has changed voxels.
bool MendingSteps::isMended() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return false;
    const core::History& history = session->history();
    const std::vector<core::RowId> path = history.pathTo(history.position());
    for (auto row = path.rbegin(); row != path.rend(); ++row) {
        const core::HistoryRow& step = history.row(*row);
        if (step.edit.as<core::ImportMask>())
            return false;
        if (step.statistics.voxelsChanged > 0 && canChangeLabels(history, step.edit))
            return true;
    }
    return false;
}

void MendingSteps::update()
{
    const core::EditSession* session = m_workspace.session();
    const SegmentDoubts::Found* found = m_panel.lookFirst().doubts().found();
    const LiveComparison& comparison = m_panel.comparison();
    m_done = {found != nullptr, isMended() || (found && found->allSeen()),
        comparison.isImported() && comparison.outcome().has_value(), m_exported};
    m_strip.showSteps(m_done, next());
    if (session && session->transactionOpen())
        return;
    const bool hasMask = comparison.canTakeImported();
    m_strip.setVisible(m_wanted && hasMask);
    if (std::exchange(m_hasMask, hasMask) != hasMask)
        Q_EMIT changed();
}

} // namespace ui
