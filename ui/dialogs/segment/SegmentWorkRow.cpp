// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/SegmentWorkRow.h"

#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace ui {

SegmentWorkRow::SegmentWorkRow(
    Workspace& workspace, const QString& name, const QString& text, QWidget* dialog)
    : QWidget(dialog)
    , m_workspace(workspace)
    , m_progress(new QProgressBar(this))
    , m_abort(new QPushButton(tr("Abort"), this))
    , m_apply(new QPushButton(text, this))
{
    m_progress->setObjectName(name.toLower() + QStringLiteral("Progress"));
    m_progress->setRange(0, 100);
    m_abort->setObjectName(QStringLiteral("abort") + name);
    m_abort->setToolTip(tr("Nothing changes"));
    m_abort->setAutoDefault(false);
    m_abort->setEnabled(false);
    m_apply->setObjectName(QStringLiteral("apply") + name);
    m_apply->setDefault(true);
    auto* close = new QPushButton(tr("Close"), this);
    close->setAutoDefault(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_progress, 1);
    row->addWidget(m_abort);
    row->addWidget(m_apply);
    row->addWidget(close);
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_progress->hide();
    constexpr int watchMs = 100;
    m_watching.setInterval(watchMs);
    connect(&m_watching, &QTimer::timeout, this, &SegmentWorkRow::look);
    connect(m_apply, &QPushButton::clicked, this, &SegmentWorkRow::asked);
    connect(m_abort, &QPushButton::clicked, this, [this] {
        if (core::EditSession* session = m_workspace.session())
            session->segmentWork().abort();
    });
    connect(close, &QPushButton::clicked, this, &SegmentWorkRow::closed);
}

void SegmentWorkRow::showWhyNot(const QString& why)
{
    // An impatient second click would do it all once more.
    const core::EditSession* session = m_workspace.session();
    const bool isPreview = session && session->openIsPreview();
    m_apply->setEnabled(why.isEmpty() && (isPreview || !percentDone()));
    m_apply->setToolTip(why);
}

void SegmentWorkRow::follow()
{
    m_watching.start();
    m_abort->setEnabled(percentDone().has_value());
}

void SegmentWorkRow::focusApply()
{
    m_apply->setFocus();
}

/// What takes less than the first look at it shows no bar, which would only flash up.
void SegmentWorkRow::look()
{
    const core::EditSession* session = m_workspace.session();
    const std::optional<int> percent = percentDone();
    // A preview stands open once it is there.
    const bool isSeen = session && session->openIsPreview() && session->openHasBegun();
    if (!session || session->idle() || isSeen)
        m_watching.stop();
    m_progress->setValue(percent.value_or(0));
    m_progress->setVisible(percent.has_value());
    m_abort->setEnabled(percent.has_value());
    Q_EMIT looked();
}

std::optional<int> SegmentWorkRow::percentDone() const
{
    core::EditSession* session = m_workspace.session();
    return session ? session->segmentWork().percent() : std::nullopt;
}

} // namespace ui
