// SPDX-License-Identifier: Apache-2.0
#include "app/window/LostContext.h"

#include "core/repair/SeriesRepair.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "ui/base/RowTitleText.h"
#include "ui/frame/MessageBar.h"
#include "ui/texts/ClauseText.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/Workspace.h"

#include <QApplication>
#include <QFileInfo>
#include <QTimer>

#include <utility>

namespace app {

namespace {

QString whatIsKept(core::EditSession& session)
{
    const core::RowId position = session.history().position();
    if (session.storage().whyNoFile())
        return QObject::tr("Its steps were in memory only");
    if (session.history().rows().empty())
        return QObject::tr("No step had been done");
    return position == 0
        ? QObject::tr("Every step is in its session, which stands at its beginning")
        : QObject::tr("Every step is in its session, which stands at '%1'")
              .arg(ui::nameOf(session.history().row(position)));
}

QString sentenceFor(const core::Error& error, core::EditSession& session)
{
    return QObject::tr("The graphics driver broke off its work (%1), so the study was closed. "
                       "%2; what was under way is not done.")
        .arg(ui::clauseText(error.arguments.value(0)), whatIsKept(session));
}

} // namespace

LostContext::LostContext(
    ui::MainWindow& window, std::function<core::Result<void>()> closeStudy, QObject* parent)
    : QObject(parent)
    , m_window(window)
    , m_closeStudy(std::move(closeStudy))
{
    connect(&window.workspace(), &ui::Workspace::failed, this, &LostContext::note);
    connect(&window.opener(), &ui::StudyOpener::started, this, [this] { m_offer.reset(); });
}

/// Sessions, pictures and questions each tell of it, in whatever order.
void LostContext::note(const core::Error& error)
{
    if (error.code != core::ErrorCode::ContextLost || m_isClosing)
        return;
    if (!m_window.workspace().session())
        return show();
    m_isClosing = true;
    // The session itself is telling: it cannot go before it is done.
    QMetaObject::invokeMethod(
        this, [this, error] { close(error); }, Qt::QueuedConnection);
}

void LostContext::close(const core::Error& error)
{
    const ui::Workspace& workspace = m_window.workspace();
    // A dialog may be waiting for an answer with the session in its hands; what is being opened
    // closes the session, unless it is called off.
    if (QApplication::activeModalWidget() || m_window.opener().busy()) {
        constexpr int soon = 200; // ms
        QTimer::singleShot(soon, this, [this, error] { close(error); });
        return;
    }
    if (workspace.session()) {
        // By then it may have been saved elsewhere.
        const auto closing = connect(&workspace, &ui::Workspace::sessionClosing, this, [&] {
            core::EditSession& session = *workspace.session();
            const core::Volume& volume = session.document().volumes.front();
            m_offer = {.sentence = sentenceFor(error, session),
                .session = session.file(),
                .study = volume.sourcePath,
                .series = core::withRepair(volume.seriesKey, volume.repair)};
        });
        static_cast<void>(m_closeStudy());
        disconnect(closing);
        show();
    }
    m_isClosing = false;
}

void LostContext::show()
{
    if (!m_offer)
        return;
    m_window.messages().show(ui::MessageBar::Kind::Error, m_offer->sentence, tr("Open it again"),
        [this] { openAgain(); });
}

void LostContext::openAgain()
{
    const std::optional<Offer> offer = std::exchange(m_offer, std::nullopt);
    if (!offer)
        return;
    if (QFileInfo::exists(offer->session))
        m_window.opener().openSession(offer->session);
    else
        m_window.opener().open(offer->study, offer->series);
}

} // namespace app
