// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/PiecesPanel.h"

#include "ui/base/SmallLabel.h"
#include "ui/base/Theme.h"
#include "ui/models/PieceListModel.h"
#include "ui/panels/lists/PieceDelegate.h"
#include "ui/settings/TransferPresets.h"
#include "ui/views/VolumeView.h"
#include "ui/widgets/ColorButton.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QColor>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int mostPieceRows = 5;
constexpr int wholeEntry = 1; // of the colours; before it "As volume", after it the presets

QDoubleSpinBox* numberBox(QWidget* parent, double reach, int decimals, const QString& name)
{
    auto* box = new NumberField(parent);
    box->setRange(-reach, reach);
    box->setDecimals(decimals);
    box->setKeyboardTracking(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setFixedHeight(theme::controlHeight);
    box->setMinimumWidth(48);
    box->setAlignment(Qt::AlignRight);
    box->setAccessibleName(name);
    return box;
}

QToolButton* textButton(QWidget* parent, const QString& text, const char* name, const QString& tip)
{
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

} // namespace

PiecesPanel::PiecesPanel(Workspace& workspace, VolumeView& view, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_view(view)
    , m_model(new PieceListModel(workspace, this))
{
    build();
    connectParts();
    showMaps();
    refresh();
}

void PiecesPanel::build()
{
    m_list = new QListView(this);
    m_list->setObjectName(QStringLiteral("pieceList"));
    m_list->setAccessibleName(tr("Pieces"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(new PieceDelegate(m_list));
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setMouseTracking(true);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_empty = new QLabel(
        tr("None yet. Ctrl+L lifts the last cut of the active layer; a segment's menu pastes it."),
        this);
    m_empty->setProperty("role", QStringLiteral("secondary"));
    m_empty->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    m_empty->setWordWrap(true);

    m_editor = new QWidget(this);
    auto* grid = new QGridLayout(m_editor);
    grid->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    const std::array<QString, 3> letters{tr("L"), tr("P"), tr("S")};
    grid->addWidget(smallNote(tr("mm"), m_editor), 1, 0);
    grid->addWidget(smallNote(tr("°"), m_editor), 2, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = std::size_t(axis);
        QLabel* letter = smallNote(letters[at], m_editor);
        letter->setAlignment(Qt::AlignCenter);
        grid->addWidget(letter, 0, axis + 1);
        m_offset[at] = numberBox(m_editor, 10000.0, 1, tr("Moved towards %1, mm").arg(letters[at]));
        m_offset[at]->setObjectName(QStringLiteral("pieceOffset%1").arg(axis));
        m_turn[at] = numberBox(m_editor, 360.0, 1, tr("Turned about %1, degrees").arg(letters[at]));
        m_turn[at]->setObjectName(QStringLiteral("pieceTurn%1").arg(axis));
        m_turn[at]->setToolTip(
            tr("Axis and angle in one: the arrow these three numbers make is the "
               "axis, its length the angle"));
        grid->addWidget(m_offset[at], 1, axis + 1);
        grid->addWidget(m_turn[at], 2, axis + 1);
        grid->setColumnStretch(axis + 1, 1);
    }
    grid->addWidget(smallNote(tr("Zoom"), m_editor), 3, 0);
    m_zoom = numberBox(m_editor, 16.0, 2, tr("Zoom"));
    m_zoom->setRange(0.125, 16.0);
    m_zoom->setSuffix(QStringLiteral(" ×"));
    m_zoom->setObjectName(QStringLiteral("pieceZoom"));
    grid->addWidget(m_zoom, 3, 1);
    m_opacity = new QSlider(Qt::Horizontal, m_editor);
    m_opacity->setRange(5, 100);
    m_opacity->setObjectName(QStringLiteral("pieceOpacity"));
    m_opacity->setAccessibleName(tr("Opacity"));
    m_opacity->setToolTip(tr("Opacity"));
    grid->addWidget(m_opacity, 3, 2, 1, 2);

    grid->addWidget(smallNote(tr("Colours"), m_editor), 4, 0);
    auto* colours = new QHBoxLayout;
    colours->setSpacing(4);
    m_colour = new ColorButton(m_editor);
    m_colour->setObjectName(QStringLiteral("pieceColour"));
    m_plain = textButton(m_editor, tr("None"), "pieceNoColour", tr("No colour of its own"));
    m_plain->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_map = new QComboBox(m_editor);
    m_map->setObjectName(QStringLiteral("pieceMap"));
    m_map->setFixedHeight(theme::controlHeight);
    m_map->setToolTip(tr("Its own transfer function in volume rendering; of a segment, whether its "
                         "body is shown in its colour or its values"));
    colours->addWidget(m_colour);
    colours->addWidget(m_plain);
    colours->addWidget(m_map, 1);
    grid->addLayout(colours, 4, 1, 1, 3);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    m_home = textButton(m_editor, tr("Home"), "pieceHome", tr("Back to its true place and size"));
    m_lid = textButton(m_editor, tr("Open like a lid"), "pieceLid",
        tr("Turn it about the edge of its cut that is uppermost in the 3D view"));
    m_allHome = textButton(m_editor, tr("All home"), "piecesHome", tr("Send all pieces home"));
    buttons->addWidget(m_home);
    buttons->addWidget(m_lid);
    buttons->addWidget(m_allHome);
    grid->addLayout(buttons, 5, 0, 1, 4);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_empty);
    layout->addWidget(m_list);
    layout->addWidget(m_editor);
}

void PiecesPanel::connectParts()
{
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& current) {
            if (current.isValid())
                m_workspace.pieces().setActive(current.data(PieceListModel::IdRole).toInt());
        });
    connect(m_list, &QListView::customContextMenuRequested, this, &PiecesPanel::showMenu);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &PiecesPanel::refresh);
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        refresh();
        if (m_model->rowCount() == 1) // the first one is to be seen
            Q_EMIT unfoldRequested();
    });
    connect(&m_workspace, &Workspace::sessionChanged, this, &PiecesPanel::showMaps);
    for (int axis = 0; axis < 3; ++axis) {
        for (QDoubleSpinBox* box : {m_offset[std::size_t(axis)], m_turn[std::size_t(axis)]})
            connect(box, &QDoubleSpinBox::valueChanged, this, &PiecesPanel::takePose);
    }
    connect(m_zoom, &QDoubleSpinBox::valueChanged, this, &PiecesPanel::takePose);
    connect(m_opacity, &QSlider::valueChanged, this, &PiecesPanel::takeLook);
    connect(m_map, &QComboBox::activated, this, &PiecesPanel::takeLook);
    connect(m_colour, &ColorButton::colourPicked, this, [this](const QColor& colour) {
        PieceLook look = m_workspace.pieces().look(m_workspace.pieces().active());
        look.rgb = colour.rgb() & 0xFFFFFFU;
        m_workspace.pieces().setLook(m_workspace.pieces().active(), look);
    });
    connect(m_plain, &QToolButton::clicked, this, [this] {
        PieceLook look = m_workspace.pieces().look(m_workspace.pieces().active());
        look.rgb.reset();
        m_workspace.pieces().setLook(m_workspace.pieces().active(), look);
    });
    connect(m_home, &QToolButton::clicked, this, [this] {
        if (const core::Piece* piece = active())
            m_workspace.pieces().setPose(piece->id, {});
    });
    connect(m_lid, &QToolButton::clicked, this, [this] {
        m_workspace.pieces().openLikeALid(m_workspace.pieces().active(), m_view.camera().up);
    });
    connect(m_allHome, &QToolButton::clicked, this, [this] { m_workspace.pieces().sendHome(); });
}

QString PiecesPanel::title() const
{
    return tr("Pieces");
}

QString PiecesPanel::summary() const
{
    const int count = m_model->rowCount();
    int away = 0;
    for (int row = 0; row < count; ++row)
        away += m_model->index(row).data(PieceListModel::BadgeRole).toString().isEmpty() ? 0 : 1;
    if (away > 0)
        return tr("%1 of %2 moved").arg(away).arg(count);
    return count == 0 ? QString() : count == 1 ? tr("1 piece") : tr("%1 pieces").arg(count);
}

const core::Piece* PiecesPanel::active() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? session->document().piece(m_workspace.pieces().active()) : nullptr;
}

void PiecesPanel::refresh()
{
    const bool any = m_model->rowCount() > 0;
    m_empty->setVisible(!any);
    m_list->setVisible(any);
    m_list->setFixedHeight(
        std::clamp(m_model->rowCount(), 1, mostPieceRows) * PieceDelegate::rowHeight);
    const int row = m_model->rowOf(m_workspace.pieces().active());
    if (row >= 0 && m_list->currentIndex().row() != row)
        m_list->setCurrentIndex(m_model->index(row));
    showPiece();
    Q_EMIT summaryChanged(summary());
}

void PiecesPanel::showMaps()
{
    const QSignalBlocker blocker(m_map);
    m_map->clear();
    m_map->addItem(tr("As volume"));
    m_map->addItem(tr("Whole"));
    if (const core::Volume* volume = m_workspace.volume()) {
        for (const TransferPreset& preset : transferPresets(*volume))
            m_map->addItem(preset.name);
    }
    showPiece(); // what it chooses of them
}

void PiecesPanel::showPiece()
{
    const core::Piece* piece = active();
    m_editor->setVisible(piece != nullptr);
    if (!piece)
        return;
    const Pieces& pieces = m_workspace.pieces();
    const core::PiecePose pose = pieces.pose(*piece);
    const PieceLook look = pieces.look(piece->id);
    const auto show = [](QDoubleSpinBox* box, double value) {
        const QSignalBlocker blocker(box);
        box->setValue(value);
    };
    for (int axis = 0; axis < 3; ++axis) {
        show(m_offset[std::size_t(axis)], pose.offsetMm[axis]);
        show(m_turn[std::size_t(axis)], pose.rotationDegrees[axis]);
    }
    show(m_zoom, pose.zoom);
    const QSignalBlocker opacity(m_opacity);
    m_opacity->setValue(int(std::lround(look.opacity * 100.0)));
    const core::Segment* segment = m_workspace.session()->document().segment(piece->segment);
    m_colour->setColour(QColor(QRgb(look.rgb.value_or(segment ? segment->rgb : 0xFFFFFFU))));
    m_plain->setEnabled(look.rgb.has_value());
    // Only a segment has a body to be whole; what was cut out is always shown by its values.
    if (const auto* entries = qobject_cast<const QStandardItemModel*>(m_map->model()))
        entries->item(wholeEntry)->setEnabled(segment != nullptr);
    int map = segment && !look.tissue ? wholeEntry : 0;
    if (!look.map.points.empty()) {
        const std::vector<TransferPreset> presets = transferPresets(*m_workspace.volume());
        for (std::size_t i = 0; i < presets.size(); ++i) {
            if (presets[i].function == look.map)
                map = int(i) + 2;
        }
    }
    const QSignalBlocker maps(m_map);
    m_map->setCurrentIndex(map);
    m_home->setEnabled(!pose.isHome());
    m_allHome->setEnabled(!pieces.allHome());
}

void PiecesPanel::takePose()
{
    const core::Piece* piece = active();
    if (!piece)
        return;
    // What the boxes show rounded stays as it is.
    core::PiecePose pose = piece->pose;
    const auto take = [](const QDoubleSpinBox* box, double& value) {
        if (std::abs(box->value() - value) > 0.5 * std::pow(10.0, -box->decimals()))
            value = box->value();
    };
    for (int axis = 0; axis < 3; ++axis) {
        take(m_offset[std::size_t(axis)], pose.offsetMm[axis]);
        take(m_turn[std::size_t(axis)], pose.rotationDegrees[axis]);
    }
    take(m_zoom, pose.zoom);
    if (pose != piece->pose)
        m_workspace.pieces().setPose(piece->id, pose);
}

void PiecesPanel::takeLook()
{
    const core::Piece* piece = active();
    if (!piece)
        return;
    PieceLook look = m_workspace.pieces().look(piece->id);
    look.opacity = m_opacity->value() / 100.0;
    const int map = m_map->currentIndex();
    look.tissue = map != wholeEntry;
    look.map = {};
    if (map >= 2)
        look.map = transferPresets(*m_workspace.volume())[std::size_t(map - 2)].function;
    m_workspace.pieces().setLook(piece->id, look);
}

void PiecesPanel::showMenu(const QPoint& position)
{
    const QPersistentModelIndex index = m_list->indexAt(position);
    if (!index.isValid())
        return;
    const int piece = index.data(PieceListModel::IdRole).toInt();
    const bool visible = index.data(PieceListModel::VisibleRole).toBool();
    QMenu menu(this);
    // Its entries are about this session; another point in time may be played meanwhile.
    connect(&m_workspace, &Workspace::sessionClosing, &menu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, &menu, &QMenu::close);
    menu.addAction(tr("Rename"), this, [this, index] { m_list->edit(index); });
    menu.addAction(visible ? tr("Hide") : tr("Show"), this,
        [this, index, visible] { m_model->setData(index, !visible, PieceListModel::VisibleRole); });
    menu.addAction(tr("Home"), this, [this, piece] { m_workspace.pieces().setPose(piece, {}); });
    menu.addAction(tr("Open like a lid"), this,
        [this, piece] { m_workspace.pieces().openLikeALid(piece, m_view.camera().up); });
    const core::Piece* known = m_workspace.session()->document().piece(piece);
    QAction* segment = menu.addAction(tr("Make a segment"), this, [this, piece] {
        const core::Piece* cut = m_workspace.session()->document().piece(piece);
        if (cut && cut->layer > 0)
            layerToSegment(m_workspace, cut->layer, std::nullopt);
    });
    segment->setToolTip(tr("At its true place, in its true size"));
    segment->setEnabled(known && known->layer > 0); // that of a segment is one
    menu.addSeparator();
    menu.addAction(tr("Remove piece"), this, [this, piece] { m_workspace.pieces().remove(piece); });
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

} // namespace ui
