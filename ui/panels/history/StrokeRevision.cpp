// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/history/StrokeRevision.h"

#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/history/StandingStrokes.h"
#include "core/session/StepFindings.h"
#include "ui/base/RevisionText.h"
#include "ui/base/RowTitleText.h"
#include "ui/dialogs/session/ReviseStrokeDialog.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>

namespace ui {

namespace {

std::optional<core::StandingStroke> standingStroke(const core::History& history, core::RowId row)
{
    for (core::StandingStroke& stroke : core::standingStrokes(history, history.position())) {
        if (stroke.row == row)
            return std::move(stroke);
    }
    return {};
}

/// The revision that makes a removed stroke what it was before, be it what was drawn.
core::ReviseStroke asBeforeRemoval(const core::History& history, core::RowId row)
{
    core::ReviseStroke revise{.row = row};
    for (const core::RowId each : history.standing()) {
        const auto* earlier = history.row(each).edit.as<core::ReviseStroke>();
        if (earlier && earlier->row == row && !earlier->removed)
            revise = *earlier;
    }
    return revise;
}

} // namespace

StrokeRevision::StrokeRevision(Workspace& workspace, QWidget* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_window(parent)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_offered = 0; });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                offerRedrill();
        });
}

bool StrokeRevision::canRevise(core::RowId row) const
{
    const core::EditSession* session = m_workspace.session();
    return session && row != 0 && standingStroke(session->history(), row);
}

bool StrokeRevision::isRemoved(core::RowId row) const
{
    const core::EditSession* session = m_workspace.session();
    const auto stroke = session ? standingStroke(session->history(), row) : std::nullopt;
    return stroke && stroke->removed;
}

void StrokeRevision::change(core::RowId row)
{
    const core::EditSession* session = m_workspace.session();
    const auto stroke = session ? standingStroke(session->history(), row) : std::nullopt;
    if (!stroke)
        return;
    const core::HistoryRow& drawn = session->history().row(row);
    auto* dialog = new ReviseStrokeDialog(*stroke, *core::sculptEdit(drawn.edit), nameOf(drawn),
        session->document(), m_window->window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The study may be closed while it stands open.
    connect(&m_workspace, &Workspace::sessionChanged, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { apply(dialog->edit()); });
    dialog->open();
}

void StrokeRevision::remove(core::RowId row)
{
    apply(core::ReviseStroke{.row = row, .removed = true});
}

void StrokeRevision::restore(core::RowId row)
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    core::ReviseStroke revise = asBeforeRemoval(session->history(), row);
    // The layer that it was moved to may be gone since.
    if (revise.layer && !session->document().layer(*revise.layer))
        revise.layer.reset();
    apply(revise);
}

void StrokeRevision::apply(const core::Edit& edit)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto applied = session->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

void StrokeRevision::offerRedrill()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const core::RowId position = session->history().position();
    const std::vector<core::RowId> rows = session->findings().strokesOnRevisedSurface();
    if (rows.empty() || position == m_offered)
        return;
    m_offered = position;
    m_workspace.offer({.sentence = keepsPlaceText(rows.size()),
        .button = tr("Cut again on the new surface"),
        .run = [this, rows] { redrill(rows); }});
}

void StrokeRevision::redrill(const std::vector<core::RowId>& rows)
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    // The bar may still offer it when the user has gone on.
    if (session->findings().strokesOnRevisedSurface() != rows) {
        m_workspace.say(tr("The history has gone on since; nothing was cut again"));
        return;
    }
    std::vector<core::SculptEdit> strokes;
    for (const core::RowId row : rows) {
        const auto stroke = standingStroke(session->history(), row);
        if (!stroke || stroke->removed)
            continue;
        strokes.push_back(stroke->form);
        remove(row);
    }
    for (const core::SculptEdit& stroke : strokes)
        apply(stroke.plain());
}

} // namespace ui
