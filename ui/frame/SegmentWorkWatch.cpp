// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/SegmentWorkWatch.h"

#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "ui/frame/LoadingBar.h"
#include "ui/workspace/Workspace.h"

#include <QShortcut>

#include <optional>

namespace ui {

namespace {

constexpr int lookMilliseconds = 200;
constexpr int showAfterMilliseconds = 400;

} // namespace

SegmentWorkWatch::SegmentWorkWatch(Workspace& workspace, LoadingBar& bar)
    : QObject(&bar)
    , m_workspace(workspace)
    , m_bar(bar)
    , m_escape(new QShortcut(QKeySequence(Qt::Key_Escape), &bar))
{
    bar.showAfter(showAfterMilliseconds);
    m_looks.setInterval(lookMilliseconds);
    connect(&m_looks, &QTimer::timeout, this, &SegmentWorkWatch::look);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        look();
        if (m_workspace.session())
            m_looks.start();
        else
            m_looks.stop();
    });
    connect(&bar, &LoadingBar::aborted, this, &SegmentWorkWatch::abort);
    connect(m_escape, &QShortcut::activated, this, &SegmentWorkWatch::abort);
}

void SegmentWorkWatch::abort()
{
    if (core::EditSession* session = m_workspace.session())
        session->segmentWork().abort();
    look();
}

void SegmentWorkWatch::look()
{
    core::EditSession* session = m_workspace.session();
    const std::optional<int> percent = session && !session->segmentWork().isPreview()
        ? session->segmentWork().percent()
        : std::optional<int>();
    if (percent && !m_works)
        m_bar.begin(tr("A segment is being worked out"));
    if (!percent && m_works)
        m_bar.end();
    m_works = percent.has_value();
    // While a stroke is open, Esc takes back the stroke instead.
    m_escape->setEnabled(m_works && (!session->transactionOpen() || session->openIsPreview()));
    if (percent)
        m_bar.percent(*percent);
}

} // namespace ui
