// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/history/HistoryTimeline.h"

#include "ui/models/HistoryModel.h"
#include "ui/panels/history/KeyframePopup.h"
#include "ui/tasks/KeyframePictures.h"
#include "ui/workspace/Workspace.h"

#include <QSignalBlocker>

#include <algorithm>

namespace ui {

namespace {

/// A walk cannot be turned round; while the handle is moved none is longer than this.
constexpr int longestWalk = 8;
constexpr int leastSteps = 2;

} // namespace

HistoryTimeline::HistoryTimeline(Workspace& workspace, const HistoryModel& model, QWidget* parent)
    : StepSlider(parent)
    , m_workspace(workspace)
    , m_model(model)
    , m_pictures(new KeyframePictures(workspace, this))
    , m_popup(new KeyframePopup(this))
{
    setObjectName(QStringLiteral("historyTimeline"));
    setAccessibleName(tr("Timeline"));
    connect(this, &QAbstractSlider::valueChanged, this, &HistoryTimeline::want);
    connect(this, &QAbstractSlider::sliderReleased, this, &HistoryTimeline::finish);
    connect(&model, &HistoryModel::currentRowChanged, this, &HistoryTimeline::follow);
    connect(&workspace, &Workspace::sessionChanged, this, &HistoryTimeline::giveUp);
    // Later: the session is still telling what it did.
    connect(&workspace, &Workspace::failed, this, &HistoryTimeline::advance, Qt::QueuedConnection);
    connect(this, &StepSlider::hovered, this, &HistoryTimeline::showPopup);
    connect(this, &StepSlider::left, this, [this] {
        if (!isSliderDown())
            hidePopup();
    });
    connect(this, &QAbstractSlider::sliderReleased, this, [this] {
        if (!underMouse())
            hidePopup();
    });
    connect(m_pictures, &KeyframePictures::arrived, this, [this] {
        if (m_pointedAt >= 0)
            showPopup(m_pointedAt);
    });
    giveUp();
}

void HistoryTimeline::hideEvent(QHideEvent* event)
{
    hidePopup();
    StepSlider::hideEvent(event);
}

void HistoryTimeline::hidePopup()
{
    m_pointedAt = -1;
    m_popup->hide();
}

void HistoryTimeline::showPopup(int lineIndex)
{
    const std::vector<core::RowId>& line = m_model.line();
    if (lineIndex < 0 || lineIndex >= int(line.size()))
        return hidePopup();
    m_pointedAt = lineIndex;
    const auto nameOf = [this](int index) {
        return index == 0
            ? m_model.indexOnLine(index).data().toString()
            : tr("Step %1: %2")
                  .arg(QString::number(index), m_model.indexOnLine(index).data().toString());
    };
    const core::RowId nearest = m_pictures->nearest(line, lineIndex);
    const QImage picture = nearest < 0 ? QImage() : m_pictures->picture(nearest);
    const bool elsewhere = !picture.isNull() && nearest != line[std::size_t(lineIndex)];
    m_popup->show(nameOf(lineIndex),
        elsewhere ? tr("The picture shows step %1").arg(lineIndexOf(nearest)) : QString(), picture);
    m_popup->moveAbove(mapToGlobal(QPoint(int(xOf(lineIndex)), 0)));
}

int HistoryTimeline::lineIndexOf(core::RowId row) const
{
    const std::vector<core::RowId>& line = m_model.line();
    const auto found = std::find(line.begin(), line.end(), row);
    return found == line.end() ? -1 : int(found - line.begin());
}

void HistoryTimeline::setRoom(bool room)
{
    m_room = room;
    setVisible(m_room && maximum() >= leastSteps);
}

void HistoryTimeline::showStep(int lineIndex)
{
    const QSignalBlocker quiet(this);
    // Walked there by other means than this handle: what floats speaks of a place that nobody
    // means any more, until the pointer is moved again.
    if (lineIndex != value() && m_pointedAt >= 0 && lineIndex != m_pointedAt && !isSliderDown())
        hidePopup();
    const int steps = int(m_model.line().size()) - 1;
    setVisible(m_room && steps >= leastSteps);
    setRange(0, std::max(0, steps));
    setValue(std::max(0, lineIndex));
    setCaption(tr("step %1 of %2: %3")
                   .arg(QString::number(value()), QString::number(maximum()),
                       m_model.indexOnLine(value()).data().toString()));
}

void HistoryTimeline::want(int lineIndex)
{
    core::EditSession* session = m_workspace.session();
    if (!session || lineIndex >= int(m_model.line().size()))
        return;
    m_wanted = m_model.line()[std::size_t(lineIndex)];
    if (!isSliderDown())
        hidePopup(); // by keys
    showStep(lineIndex);
    Q_EMIT scrubbed(lineIndex);
    session->closeOpen();
    advance();
}

void HistoryTimeline::finish()
{
    if (m_wanted && m_walkingTo && m_walkingTo != m_wanted)
        walkTo(*m_wanted);
    else
        advance();
}

void HistoryTimeline::follow()
{
    const int wanted = m_wanted ? lineIndexOf(*m_wanted) : -1;
    if (wanted < 0)
        return giveUp();
    showStep(wanted);
    QMetaObject::invokeMethod(this, &HistoryTimeline::advance, Qt::QueuedConnection);
}

core::RowId HistoryTimeline::nextTowards(core::RowId wanted) const
{
    const int to = lineIndexOf(wanted);
    const int from = m_model.linePosition();
    if (!isSliderDown() || to < 0 || from < 0)
        return wanted;
    const int next = from + std::clamp(to - from, -longestWalk, longestWalk);
    return m_model.line()[std::size_t(next)];
}

void HistoryTimeline::advance()
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !m_wanted || !session->idle())
        return;
    const core::RowId position = session->history().position();
    // The walk failed, or somebody else went on from where it ended.
    if (m_walkingTo && *m_walkingTo != position)
        return giveUp();
    m_walkingTo.reset();
    if (position != *m_wanted)
        return walkTo(nextTowards(*m_wanted));
    m_wanted.reset();
}

void HistoryTimeline::walkTo(core::RowId row)
{
    m_walkingTo = row;
    if (const auto walked = m_workspace.session()->goTo(row); !walked) {
        m_workspace.fail(walked.error());
        giveUp();
    }
}

void HistoryTimeline::giveUp()
{
    m_wanted.reset();
    m_walkingTo.reset();
    showStep(m_model.linePosition());
}

} // namespace ui
