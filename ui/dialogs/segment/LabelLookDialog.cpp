// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/LabelLookDialog.h"

#include "core/session/EditSession.h"
#include "ui/workspace/Workspace.h"

#include <QHideEvent>

namespace ui {

namespace {

constexpr int againMilliseconds = 300;

} // namespace

LabelLookDialog::LabelLookDialog(
    Workspace& workspace, const QString& title, const QString& name, QWidget* parent)
    : SegmentDialog(workspace, title, name, parent)
{
    m_lookSoon.setSingleShot(true);
    connect(&m_lookSoon, &QTimer::timeout, this, &LabelLookDialog::look);
    connect(&m_fetch, &LabelFetch::finished, this, &LabelLookDialog::count);
    connect(&m_fetch, &LabelFetch::failed, this, [this] {
        forget();
        showState();
    });
    connect(&workspace, &Workspace::documentChanged, this, &LabelLookDialog::follow);
    connect(&workspace, &Workspace::sessionClosing, this, &LabelLookDialog::forget);
}

void LabelLookDialog::hideEvent(QHideEvent* event)
{
    if (!event->spontaneous())
        forget();
    SegmentDialog::hideEvent(event);
}

void LabelLookDialog::forget()
{
    m_lookSoon.stop();
    m_fetch.cancel();
    m_counting.cancel();
    m_isLooking = false;
    m_position.reset();
    forgetFound();
}

void LabelLookDialog::look()
{
    forget();
    core::EditSession* session = workspace().session();
    const core::Segment* about = segment();
    // What is open ends with a step, after which it is looked again.
    m_isLooking = about && !session->transactionOpen();
    if (about && session->openIsPreview())
        m_lookSoon.start(againMilliseconds);
    if (m_isLooking) {
        m_position = session->history().position();
        m_fetch.start(*session, {about->plane});
    }
    showState();
}

void LabelLookDialog::follow(const core::DocumentChange& change)
{
    if (!isVisible())
        return;
    // The history also tells when a step is on the disk.
    if (change.what == core::DocumentChange::What::History
        && m_position != workspace().session()->history().position())
        m_lookSoon.start(0);
    showState();
}

} // namespace ui
