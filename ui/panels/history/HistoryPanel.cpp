// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/history/HistoryPanel.h"

#include "core/edits/kinds/history/RevertRows.h"
#include "ui/base/Theme.h"
#include "ui/models/HistoryModel.h"
#include "ui/panels/history/HistoryDelegate.h"
#include "ui/panels/history/HistoryTimeline.h"
#include "ui/panels/history/StrokeRevision.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QKeyEvent>
#include <QListView>
#include <QMenu>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int rowsBesideTimeline = 4;
constexpr int leastRows = 6;
constexpr int timelineHeight = 40;

core::RowId rowOf(const QModelIndex& index)
{
    return core::RowId(index.data(HistoryModel::RowIdRole).toLongLong());
}

int viewStepOf(const QModelIndex& index)
{
    return index.data(HistoryModel::ViewStepRole).toInt();
}

} // namespace

HistoryPanel::HistoryPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_model(new HistoryModel(workspace, this))
    , m_view(new QListView(this))
    , m_timeline(new HistoryTimeline(workspace, *m_model, this))
    , m_revision(new StrokeRevision(workspace, this))
{
    m_view->setObjectName(QStringLiteral("historyList"));
    m_view->setAccessibleName(tr("History"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new HistoryDelegate(m_view));
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setMouseTracking(true);
    m_view->setUniformItemSizes(true);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setMinimumHeight(leastRows * theme::rowHeight); // else the column scrolls
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_view);
    layout->addWidget(m_timeline);

    // activated: double click and Return alike.
    connect(m_view, &QListView::activated, this, &HistoryPanel::goTo);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QListView::customContextMenuRequested, this, &HistoryPanel::showMenu);
    m_view->installEventFilter(this);
    connect(m_model, &HistoryModel::currentRowChanged, this, &HistoryPanel::followPosition);
    connect(m_timeline, &HistoryTimeline::scrubbed, this,
        [this](int lineIndex) { m_view->setCurrentIndex(m_model->indexOnLine(lineIndex)); });
}

QString HistoryPanel::title() const
{
    return tr("History");
}

QString HistoryPanel::summary() const
{
    return m_model->summary();
}

void HistoryPanel::followPosition(int row)
{
    std::optional<std::pair<core::RowId, int>> position;
    if (row >= 0)
        position.emplace(rowOf(m_model->index(row)), viewStepOf(m_model->index(row)));
    // What is only written to the list later (sizes, names) leaves it where the user looks, and
    // what the timeline passes on its way where its handle is.
    if (position && position != m_shownPosition && !m_timeline->isScrubbing())
        m_view->scrollTo(m_model->index(row));
    m_shownPosition = position;
    Q_EMIT summaryChanged(summary());
}

bool HistoryPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_view && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && takeFoldKey(key->key()))
            return true;
    }
    return Panel::eventFilter(watched, event);
}

void HistoryPanel::resizeEvent(QResizeEvent* event)
{
    // In a low window the steps themselves come first.
    m_timeline->setRoom(height() >= rowsBesideTimeline * theme::rowHeight + timelineHeight);
    Panel::resizeEvent(event);
}

bool HistoryPanel::takeFoldKey(int key)
{
    const QModelIndex index = m_view->currentIndex();
    const QModelIndex heading = m_model->headingOf(index);
    if (!heading.isValid() || (key != Qt::Key_Left && key != Qt::Key_Right))
        return false;
    const bool folded = heading.data(HistoryModel::FoldedRole).toBool();
    if (index != heading) {
        if (key == Qt::Key_Left)
            m_view->setCurrentIndex(heading);
    } else if (folded == (key == Qt::Key_Right)) {
        fold(heading, !folded);
    } else if (key == Qt::Key_Right) {
        m_view->setCurrentIndex(m_model->index(heading.row() + 1));
    }
    return true;
}

void HistoryPanel::fold(const QModelIndex& heading, bool folded)
{
    m_model->setData(heading, folded, HistoryModel::FoldedRole);
}

void HistoryPanel::goTo(const QModelIndex& index)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !index.isValid())
        return;
    const core::RowId row = rowOf(index);
    ViewSteps& view = m_workspace.viewSteps();
    if (row == view.position() && !index.data(HistoryModel::HeadingRole).toBool()) {
        const int viewStep = viewStepOf(index);
        view.goTo(viewStep);
        // A growth that runs goes on.
        if (viewStep > 0)
            return;
    }
    if (const auto gone = session->goTo(row); !gone)
        m_workspace.fail(gone.error());
}

void HistoryPanel::undoOnly(const QModelIndex& index)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !index.isValid())
        return;
    if (const auto applied = session->apply(core::RevertRows{{rowOf(index)}}); !applied)
        m_workspace.fail(applied.error());
}

void HistoryPanel::addStrokeActions(QMenu& menu, core::RowId row)
{
    if (!m_revision->canRevise(row))
        return;
    menu.addSeparator();
    const bool removed = m_revision->isRemoved(row);
    menu.addAction(tr("Change stroke …"), this, [this, row] { m_revision->change(row); })
        ->setEnabled(!removed);
    if (removed)
        menu.addAction(tr("Bring stroke back"), this, [this, row] { m_revision->restore(row); });
    else
        menu.addAction(tr("Remove stroke"), this, [this, row] { m_revision->remove(row); });
    menu.addAction(tr("Lift as a piece"), this, [this, row] { m_workspace.pieces().liftCut(row); })
        ->setEnabled(m_workspace.pieces().canLift(row));
}

void HistoryPanel::showMenu(const QPoint& position)
{
    const QPersistentModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    const bool current = index.data(HistoryModel::CurrentRole).toBool();
    QMenu menu(this);
    // Its entries are about this session; another study may be on its way.
    connect(&m_workspace, &Workspace::sessionClosing, &menu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, &menu, &QMenu::close);
    if (index.data(HistoryModel::HeadingRole).toBool()) {
        const bool folded = index.data(HistoryModel::FoldedRole).toBool();
        menu.addAction(tr("Go to the end of this branch"), this, [this, index] { goTo(index); });
        menu.addAction(folded ? tr("Show its steps") : tr("Hide its steps"), this,
            [this, index, folded] { fold(index, !folded); });
    } else {
        const bool done = index.data(HistoryModel::DepthRole).toInt() == 0
            && !index.data(HistoryModel::UndoneRole).toBool();
        const bool changedVoxels = index.data(HistoryModel::VoxelsRole).toBool();
        menu.addAction(tr("Go to this step"), this, [this, index] { goTo(index); })
            ->setEnabled(!current);
        menu.addAction(tr("Undo only this step"), this, [this, index] { undoOnly(index); })
            ->setEnabled(changedVoxels && done);
        if (viewStepOf(index) == 0)
            addStrokeActions(menu, rowOf(index));
    }
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

} // namespace ui
