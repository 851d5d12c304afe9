// SPDX-License-Identifier: Apache-2.0
#include "ui/window/ShownStudy.h"

#include "core/volume/encoding/EarlySlice.h"
#include "ui/frame/MessageBar.h"
#include "ui/overlays/CautionStrip.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Workspace.h"

namespace ui {

namespace {

QString cautionSentence(const core::Volume& volume)
{
    return QObject::tr("%1 Views say so until you choose to keep the series as it is, exports "
                       "always; the panel Series doctor shows what can be mended.")
        .arg(cautionText(volume));
}

} // namespace

ShownStudy::ShownStudy(Workspace& workspace, ViewGrid& views, MessageBar& messages, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_views(views)
    , m_messages(messages)
{
    // The series doctor has a button for it, too: it is said once, and answered once.
    connect(&workspace, &Workspace::cautionAcceptedChanged, this, [this] {
        const core::Volume* open = m_workspace.volume();
        if (open && m_workspace.cautionAccepted()
            && m_messages.sentence() == cautionSentence(*open))
            m_messages.dismiss();
    });
}

void ShownStudy::setEarly(const std::shared_ptr<const core::EarlySlice>& early)
{
    m_early = early;
    showEarly(early);
}

void ShownStudy::showEarlyAgain()
{
    if (m_early && !m_views.holdsPictures())
        showEarly(m_early);
}

const core::Volume* ShownStudy::volume() const
{
    const core::EarlySlice* early = m_views.earlySlice();
    return early && !m_workspace.volume() ? &early->volume : m_workspace.volume();
}

void ShownStudy::showEarly(const std::shared_ptr<const core::EarlySlice>& early)
{
    const core::EarlySlice* before = m_views.earlySlice();
    const QString said = before ? cautionSentence(before->volume) : QString();
    // An open study stays, and can be worked on, until the next one is there.
    if (!m_views.showEarlySlice(m_workspace.session() ? nullptr : early) && !before)
        return;
    Q_EMIT earlyChanged();
    // What is seen first must not be taken for sound.
    if (early && early->volume.needsCaution())
        m_messages.show(MessageBar::Kind::Caution, cautionSentence(early->volume));
    else if (!m_workspace.volume() && m_messages.sentence() == said)
        m_messages.dismiss();
}

void ShownStudy::showCaution()
{
    const core::Volume* volume = m_workspace.volume();
    m_messages.dismiss();
    if (!volume || !volume->needsCaution() || m_workspace.cautionAccepted())
        return;
    // In the words of the series doctor, whose button does the same.
    m_messages.show(MessageBar::Kind::Caution, cautionSentence(*volume), tr("Keep as it is"),
        [this] { m_workspace.acceptCaution(); });
    m_messages.setTips(tr("Takes the caution out of the views: nothing of the series changes, and "
                          "exports still tell it"),
        tr("Closes this message only: the views keep their caution"));
}

} // namespace ui
