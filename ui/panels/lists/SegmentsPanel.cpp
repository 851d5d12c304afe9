// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/SegmentsPanel.h"

#include "core/edits/kinds/segments/MoveSegment.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/CodeDialog.h"
#include "ui/measure/CentreOnSegment.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/menus/SegmentOpacity.h"
#include "ui/menus/SegmentViews.h"
#include "ui/models/SegmentListModel.h"
#include "ui/panels/lists/IntervalNotice.h"
#include "ui/panels/lists/SegmentDelegate.h"
#include "ui/tasks/UndoOnly.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QColorDialog>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int mostSegmentRows = 6;

} // namespace

SegmentsPanel::SegmentsPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_model(new SegmentListModel(workspace, this))
    , m_view(new QListView(this))
    , m_empty(new QLabel(tr("None yet. Add one, or sketch seeds."), this))
    , m_add(new QAction(stateIcon(QStringLiteral("add")), tr("Add segment"), this))
    , m_remove(new QAction(tr("Delete segment"), m_view))
{
    m_add->setObjectName(QStringLiteral("addSegment"));
    addAction(m_add);
    // In the list only: elsewhere the key would delete what nobody is looking at.
    m_remove->setObjectName(QStringLiteral("removeSegment"));
    m_remove->setShortcut(QKeySequence::Delete);
    m_remove->setShortcutContext(Qt::WidgetShortcut);
    m_view->addAction(m_remove);
    auto* delegate = new SegmentDelegate(m_view);
    m_view->setObjectName(QStringLiteral("segmentList"));
    m_view->setAccessibleName(tr("Segments"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(delegate);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setMouseTracking(true);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_empty->setProperty("role", QStringLiteral("secondary"));
    m_empty->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    m_empty->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_empty);
    layout->addWidget(m_view);

    connect(m_add, &QAction::triggered, this, [this] {
        if (const auto added = addSegment(m_workspace); !added)
            m_workspace.fail(added.error());
    });
    connect(m_remove, &QAction::triggered, this, [this] { remove(m_view->currentIndex()); });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& current) {
            if (current.isValid())
                m_workspace.setActiveSegment(current.data(SegmentListModel::LabelRole).toInt());
        });
    connect(m_view, &QListView::customContextMenuRequested, this, &SegmentsPanel::showMenu);
    connect(delegate, &SegmentDelegate::colourRequested, this, &SegmentsPanel::chooseColour);
    connect(delegate, &SegmentDelegate::codeRequested, this, &SegmentsPanel::chooseCode);
    connect(delegate, &SegmentDelegate::intervalRequested, this,
        [this](const QPersistentModelIndex& index) {
            m_workspace.askForThreshold(index.data(SegmentListModel::LabelRole).toInt());
        });
    new IntervalNotice(m_workspace, this);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &SegmentsPanel::refresh);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, &SegmentsPanel::refresh);
    connect(m_model, &QAbstractItemModel::modelReset, this, &SegmentsPanel::refresh);
    connect(&m_workspace, &Workspace::sessionChanged, this, &SegmentsPanel::refresh);
    refresh();
}

QString SegmentsPanel::title() const
{
    return tr("Segments");
}

QString SegmentsPanel::summary() const
{
    const int count = m_model->rowCount();
    return count == 0 ? QString() : count == 1 ? tr("1 segment") : tr("%1 segments").arg(count);
}

void SegmentsPanel::refresh()
{
    const bool any = m_model->rowCount() > 0;
    m_add->setEnabled(m_workspace.session() != nullptr);
    m_empty->setVisible(!any && m_workspace.session());
    m_view->setVisible(any);
    // As high as its rows, so that the history has what is left; many segments scroll.
    m_view->setFixedHeight(
        std::clamp(m_model->rowCount(), 1, mostSegmentRows) * SegmentDelegate::rowHeight);
    const int active = m_model->rowOf(m_workspace.activeSegment());
    if (active >= 0 && m_view->currentIndex().row() != active)
        m_view->setCurrentIndex(m_model->index(active));
    Q_EMIT summaryChanged(summary());
}

void SegmentsPanel::chooseColour(const QModelIndex& index)
{
    const auto present = index.data(SegmentListModel::ColourRole).value<QColor>();
    const QPersistentModelIndex row = index;
    const QColor picked =
        QColorDialog::getColor(present, window(), tr("Colour of %1").arg(index.data().toString()));
    if (picked.isValid() && row.isValid())
        m_model->setData(row, picked, SegmentListModel::ColourRole);
}

void SegmentsPanel::chooseCode(const QModelIndex& index)
{
    const QStringList present = index.data(SegmentListModel::CodeRole).toStringList();
    const QPersistentModelIndex row = index;
    CodeDialog dialog(
        index.data().toString(), {present.value(0), present.value(1), present.value(2)}, window());
    if (dialog.exec() != QDialog::Accepted || !row.isValid())
        return;
    const core::CodedConcept code = dialog.code();
    m_model->setData(
        row, QStringList{code.scheme, code.value, code.meaning}, SegmentListModel::CodeRole);
}

void SegmentsPanel::move(const QModelIndex& index, int by)
{
    if (!index.isValid())
        return;
    const core::MoveSegment edit{
        .segment = index.data(SegmentListModel::LabelRole).toInt(), .place = index.row() + 1 + by};
    if (const auto moved = m_workspace.session()->apply(edit); !moved)
        m_workspace.fail(moved.error());
}

void SegmentsPanel::remove(const QModelIndex& index)
{
    if (index.isValid())
        removeSegment(m_workspace, index.data(SegmentListModel::LabelRole).toInt());
}

void SegmentsPanel::showMenu(const QPoint& position)
{
    // What is being worked out may bring other segments, or take some, while the menu is open.
    const QPersistentModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    QMenu menu(this);
    // Its entries are about this session; another point in time may be played meanwhile.
    connect(&m_workspace, &Workspace::sessionClosing, &menu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, &menu, &QMenu::close);
    const bool visible = index.data(SegmentListModel::VisibleRole).toBool();
    menu.addAction(tr("Rename"), this, [this, index] {
        if (index.isValid())
            m_view->edit(index);
    });
    menu.addAction(tr("Colour …"), this, [this, index] { chooseColour(index); });
    menu.addAction(tr("Code …"), this, [this, index] { chooseCode(index); });
    const bool locked = index.data(SegmentListModel::LockedRole).toBool();
    menu.addAction(locked ? tr("Unlock") : tr("Lock"), this,
        [this, index, locked] { m_model->setData(index, !locked, SegmentListModel::LockedRole); });
    const bool isProtected = index.data(SegmentListModel::ProtectedRole).toBool();
    menu.addAction(isProtected ? tr("Let tools carve it") : tr("Protect from sculpting"), this,
        [this, index, isProtected] {
            m_model->setData(index, !isProtected, SegmentListModel::ProtectedRole);
        });
    menu.addAction(visible ? tr("Hide") : tr("Show"), this, [this, index, visible] {
        m_model->setData(index, !visible, SegmentListModel::VisibleRole);
    });
    const int label = index.data(SegmentListModel::LabelRole).toInt();
    const core::Document& document = m_workspace.session()->document();
    QAction* alone = menu.addAction(showAloneText(m_workspace, *document.segment(label)), this,
        [this, label] { m_workspace.viewSteps().showAlone(label); });
    alone->setEnabled(document.segments.size() > 1);
    addSegmentOpacity(menu, m_workspace, label);
    menu.addAction(
        tr("Centre views on it"), this, [this, label] { centreOnSegment(m_workspace, label); });
    menu.addAction(
        tr("Paste as a piece"), this, [this, label] { m_workspace.pieces().paste(label); });
    addPassages(*menu.addMenu(tr("Sculpt")), index);
    menu.addSeparator();
    menu.addAction(
        tr("Undo its last step only"), this, [this, label, name = index.data().toString()] {
            undoOnlyLast(m_workspace, {.segment = label}, tr("in '%1'").arg(name));
        });
    QAction* up = menu.addAction(tr("Move up"), this, [this, index] { move(index, -1); });
    up->setEnabled(index.row() > 0);
    QAction* down = menu.addAction(tr("Move down"), this, [this, index] { move(index, 1); });
    down->setEnabled(index.row() + 1 < m_model->rowCount());
    menu.addSeparator();
    addCombinations(
        menu, nullptr, m_workspace, [label] { return label; }, false);
    for (const SegmentAction& each : segmentActions()) {
        QAction* item = menuOf(menu, each).addAction(each.text, this, [this, label, &each] {
            each.run(m_workspace, label);
        });
        item->setShortcut(each.keys); // shown; the list's own action hears it
        item->setShortcutContext(Qt::WidgetShortcut);
        const QString why = each.whyNot ? each.whyNot(m_workspace) : QString();
        item->setEnabled((each.onlyReads || !locked) && why.isEmpty());
        item->setToolTip(why);
    }
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

void SegmentsPanel::addPassages(QMenu& menu, const QModelIndex& index)
{
    const int label = index.data(SegmentListModel::LabelRole).toInt();
    const bool locked = index.data(SegmentListModel::LockedRole).toBool();
    menu.setToolTipsVisible(true);
    QAction* seen = menu.addAction(
        tr("Add what I see in 3D"), this, [this, label] { segmentWhatIsSeen(m_workspace, label); });
    seen->setEnabled(!locked);
    const core::Document& document = m_workspace.session()->document();
    const core::SculptLayer* layer = document.layer(m_workspace.activeLayer());
    if (!layer)
        return;
    const int id = layer->id;
    QAction* add = menu.addAction(tr("Add what '%1' has carved").arg(layer->name), this,
        [this, label, id] { layerToSegment(m_workspace, id, label); });
    add->setEnabled(!locked);
    QAction* carve = menu.addAction(tr("Carve it into layer '%1'").arg(layer->name), this,
        [this, label, id] { segmentToLayer(m_workspace, label, id); });
    const auto allow = [&](QAction& action, bool outside) {
        const QString why = whyNotCarved(document, label, outside);
        action.setEnabled(document.carves(*layer) && why.isEmpty());
        action.setToolTip(why);
    };
    allow(*carve, false);
    QAction* mask = menu.addAction(tr("Carve all but it into layer '%1'").arg(layer->name), this,
        [this, label, id] { segmentToLayer(m_workspace, label, id, true); });
    allow(*mask, true);
}

} // namespace ui
