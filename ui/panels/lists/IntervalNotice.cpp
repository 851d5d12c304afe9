// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/IntervalNotice.h"

#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "ui/workspace/Workspace.h"

#include <QTimer>

namespace ui {

IntervalNotice::IntervalNotice(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &IntervalNotice::begin);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                look();
        });
    begin();
}

void IntervalNotice::begin()
{
    const core::EditSession* session = m_workspace.session();
    m_known = session ? session->history().rows().size() : 0;
}

void IntervalNotice::look()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const std::vector<core::HistoryRow>& rows = session->history().rows();
    QString sentence;
    for (; m_known < rows.size(); ++m_known) {
        if (const QString said = sentenceOf(rows[m_known]); !said.isEmpty())
            sentence = said;
    }
    if (sentence.isEmpty())
        return;
    // After whoever did it has told what it did.
    QTimer::singleShot(0, this, [this, sentence] { m_workspace.say(sentence); });
}

QString IntervalNotice::sentenceOf(const core::HistoryRow& row) const
{
    const core::Document& document = m_workspace.session()->document();
    const auto* threshold = row.edit.as<core::ThresholdSegment>();
    QStringList names;
    bool byThreshold = false;
    for (const int label : row.statistics.intervalsLeft) {
        const core::Segment* segment = document.segment(label);
        if (!segment)
            continue;
        names += tr("'%1'").arg(segment->name);
        byThreshold = threshold && threshold->segment == label;
    }
    if (names.isEmpty())
        return {};
    if (names.size() > 1)
        return tr("%1 no longer follow their intervals: they were changed by hand; Ctrl+Z takes it "
                  "back")
            .arg(names.join(tr(", ")));
    return byThreshold
        ? tr("%1 no longer follows its interval: the new one changed only a part of it; Ctrl+Z "
             "takes it back")
              .arg(names.front())
        : tr("%1 no longer follows its interval: it was changed by hand; Ctrl+Z takes it back")
              .arg(names.front());
}

} // namespace ui
