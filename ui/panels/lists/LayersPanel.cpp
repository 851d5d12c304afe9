// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/LayersPanel.h"

#include "core/edits/kinds/layers/MoveLayer.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/models/LayerListModel.h"
#include "ui/panels/lists/LayerDelegate.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int mostLayerRows = 4;

} // namespace

LayersPanel::LayersPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_model(new LayerListModel(workspace, this))
    , m_view(new QListView(this))
    , m_add(new QAction(stateIcon(QStringLiteral("add")), tr("Add sculpt layer"), this))
{
    m_add->setObjectName(QStringLiteral("addLayer"));
    addAction(m_add);
    m_view->setObjectName(QStringLiteral("layerList"));
    m_view->setAccessibleName(tr("Sculpt layers"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new LayerDelegate(m_view));
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setMouseTracking(true);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    buildLook();
    layout->addWidget(m_look);

    connect(m_add, &QAction::triggered, this, &LayersPanel::add);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& current) {
            if (current.isValid())
                m_workspace.setActiveLayer(current.data(LayerListModel::IdRole).toInt());
        });
    connect(m_view, &QListView::customContextMenuRequested, this, &LayersPanel::showMenu);
    connect(&m_workspace.layerLooks(), &LayerLooks::changed, this, &LayersPanel::showLook);
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Pieces)
                showLook();
        });
    connect(m_model, &QAbstractItemModel::dataChanged, this, &LayersPanel::refresh);
    connect(m_model, &QAbstractItemModel::modelReset, this, &LayersPanel::refresh);
    refresh();
}

QString LayersPanel::title() const
{
    return tr("Sculpt layers");
}

QString LayersPanel::summary() const
{
    const int count = m_model->rowCount();
    int muted = 0;
    int solo = 0;
    for (int row = 0; row < count; ++row) {
        muted += m_model->index(row).data(LayerListModel::MutedRole).toBool() ? 1 : 0;
        solo += m_model->index(row).data(LayerListModel::SoloRole).toBool() ? 1 : 0;
    }
    if (solo > 0)
        return tr("%1 of %2 solo").arg(solo).arg(count);
    if (muted > 0)
        return tr("%1 of %2 muted").arg(muted).arg(count);
    return count == 0 ? QString() : count == 1 ? tr("1 layer") : tr("%1 layers").arg(count);
}

void LayersPanel::refresh()
{
    m_add->setEnabled(m_workspace.session() != nullptr);
    m_view->setFixedHeight(
        std::clamp(m_model->rowCount(), 1, mostLayerRows) * LayerDelegate::rowHeight);
    const int active = m_model->rowOf(m_workspace.activeLayer());
    if (active >= 0 && m_view->currentIndex().row() != active)
        m_view->setCurrentIndex(m_model->index(active));
    showLook();
    Q_EMIT summaryChanged(summary());
}

void LayersPanel::buildLook()
{
    m_look = new QWidget(this);
    auto* grid = new QGridLayout(m_look);
    grid->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const auto row = [this, grid](const QString& name, const char* object, const QString& tip,
                         QLabel*& value) {
        const int at = grid->rowCount();
        auto* label = new QLabel(name, m_look);
        label->setFont(theme::smallFont());
        grid->addWidget(label, at, 0);
        auto* slider = new QSlider(Qt::Horizontal, m_look);
        slider->setRange(0, 100);
        slider->setObjectName(QLatin1String(object));
        slider->setAccessibleName(name);
        slider->setToolTip(tip);
        grid->addWidget(slider, at, 1);
        value = new QLabel(m_look);
        value->setFont(theme::smallFont());
        value->setProperty("role", QStringLiteral("secondary"));
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setMinimumWidth(value->fontMetrics().horizontalAdvance(tr("%1 %").arg(100)));
        grid->addWidget(value, at, 2);
        connect(slider, &QSlider::valueChanged, this, &LayersPanel::takeLook);
        return slider;
    };
    m_hides = row(tr("Hides"), "layerHides",
        tr("How much of what the layer carves is hidden in the 3D view. Tools work behind it all "
           "the "
           "same."),
        m_hidesText);
    m_softness = row(tr("Soft edge"), "layerSoftness",
        tr("Volume rendering: matter fades out into the cut, over three voxels at most."),
        m_softnessText);
}

void LayersPanel::showLook()
{
    const int layer = m_workspace.activeLayer();
    const LayerLook look = m_workspace.layerLooks().look(layer);
    const QSignalBlocker hides(m_hides);
    const QSignalBlocker softness(m_softness);
    m_hides->setValue(int(std::lround(100.0 * look.hides)));
    m_softness->setValue(int(std::lround(100.0 * look.softness)));
    m_hidesText->setText(tr("%1 %").arg(m_hides->value()));
    m_softnessText->setText(tr("%1 %").arg(m_softness->value()));
    m_look->setEnabled(m_workspace.layerLooks().hasLook(layer));
}

void LayersPanel::takeLook()
{
    m_workspace.layerLooks().setLook(m_workspace.activeLayer(),
        {.hides = m_hides->value() / 100.0, .softness = m_softness->value() / 100.0});
}

void LayersPanel::add()
{
    if (const auto added = addLayer(m_workspace); !added)
        m_workspace.fail(added.error());
    else
        Q_EMIT unfoldRequested();
}

void LayersPanel::move(const QModelIndex& index, int by)
{
    if (!index.isValid())
        return;
    const core::MoveLayer edit{
        .layer = index.data(LayerListModel::IdRole).toInt(), .place = index.row() + 1 + by};
    if (const auto moved = m_workspace.session()->apply(edit); !moved)
        m_workspace.fail(moved.error());
}

void LayersPanel::showMenu(const QPoint& position)
{
    const QPersistentModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    QMenu menu(this);
    // Its entries are about this session; another point in time may be played meanwhile.
    connect(&m_workspace, &Workspace::sessionClosing, &menu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, &menu, &QMenu::close);
    const int layer = index.data(LayerListModel::IdRole).toInt();
    // What is being carried out may bring other layers, or take some, while the menu is open.
    const auto its = [this, layer] { return m_model->index(m_model->rowOf(layer)); };
    const bool muted = index.data(LayerListModel::MutedRole).toBool();
    menu.addAction(tr("Rename"), this, [this, its] {
        if (its().isValid())
            m_view->edit(its());
    });
    menu.addAction(muted ? tr("Unmute") : tr("Mute"), this,
        [this, its, muted] { m_model->setData(its(), !muted, LayerListModel::MutedRole); });
    const bool solo = index.data(LayerListModel::SoloRole).toBool();
    menu.addAction(solo ? tr("End solo") : tr("Solo"), this,
        [this, its, solo] { m_model->setData(its(), !solo, LayerListModel::SoloRole); });
    const bool isPiece = m_workspace.session()->document().pieceOfLayer(layer) != nullptr;
    QAction* lift = menu.addAction(
        tr("Lift all of it as a piece"), this, [this, layer] { m_workspace.pieces().lift(layer); });
    lift->setEnabled(!isPiece);
    QAction* liftLast = menu.addAction(tr("Lift its last cut as a piece"), this,
        [this, layer] { m_workspace.pieces().liftLast(layer); });
    liftLast->setEnabled(m_workspace.pieces().lastCut(layer) != 0);
    menu.addSeparator();
    addPassages(menu, layer);
    menu.addSeparator();
    QAction* up = menu.addAction(tr("Move up"), this, [this, its] { move(its(), -1); });
    up->setEnabled(index.row() > 0);
    QAction* down = menu.addAction(tr("Move down"), this, [this, its] { move(its(), 1); });
    down->setEnabled(index.row() + 1 < m_model->rowCount());
    menu.addSeparator();
    QAction* away = menu.addAction(
        tr("Delete layer"), this, [this, layer] { removeLayer(m_workspace, layer); });
    away->setEnabled(m_model->rowCount() > 1);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

void LayersPanel::addPassages(QMenu& menu, int layer)
{
    const core::Document& document = m_workspace.session()->document();
    menu.setToolTipsVisible(true);
    menu.addAction(tr("Make it a new segment"), this,
        [this, layer] { layerToSegment(m_workspace, layer, std::nullopt); });
    const core::Segment* segment = document.segment(m_workspace.activeSegment());
    QAction* add = menu.addAction(
        segment ? tr("Add it to segment '%1'").arg(segment->name) : tr("Add it to the segment"),
        this, [this, layer] { layerToSegment(m_workspace, layer, m_workspace.activeSegment()); });
    add->setEnabled(segment && !segment->locked);
    QAction* carve = menu.addAction(segment ? tr("Carve segment '%1' into it").arg(segment->name)
                                            : tr("Carve the segment into it"),
        this, [this, layer] { segmentToLayer(m_workspace, m_workspace.activeSegment(), layer); });
    const QString why = whyNotCarved(document, m_workspace.activeSegment());
    carve->setEnabled(segment && why.isEmpty() && document.carves(*document.layer(layer)));
    carve->setToolTip(why);
    QMenu* merge = menu.addMenu(tr("Merge into"));
    for (const core::SculptLayer& other : document.layers) {
        if (other.id == layer)
            continue;
        QAction* into = merge->addAction(other.name, this,
            [this, layer, id = int(other.id)] { mergeLayers(m_workspace, layer, id); });
        into->setEnabled(document.carves(other) == document.carves(*document.layer(layer)));
    }
    merge->setEnabled(!merge->isEmpty());
}

} // namespace ui
