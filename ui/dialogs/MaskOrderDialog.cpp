// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/MaskOrderDialog.h"

#include "core/masks/ReadImport.h"
#include "core/titles/TitleLanguage.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/tasks/MaskImporter.h"
#include "ui/texts/MaskTexts.h"
#include "ui/widgets/FittingLabel.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace ui {

namespace {

constexpr int placeRole = Qt::UserRole; ///< in the list of the mask's segments, from 0

QListWidgetItem* itemOf(const core::ImportedSegment& segment, std::size_t place)
{
    constexpr int swatchSide = 12;
    QPixmap swatch(swatchSide, swatchSide);
    swatch.fill(QColor(segment.rgb));
    QIcon icon(swatch);
    icon.addPixmap(swatch, QIcon::Selected); // else it is tinted
    auto* item = new QListWidgetItem(icon, segment.name);
    item->setData(placeRole, int(place));
    return item;
}

/// As tall as its rows, if they are few; a taller dialog gives it more.
class ShortList : public QListWidget {
public:
    using QListWidget::QListWidget;
    [[nodiscard]] QSize sizeHint() const override
    {
        return {QListWidget::sizeHint().width(), theme::rowHeight * std::clamp(count(), 3, 6)};
    }
};

} // namespace

MaskOrderDialog::MaskOrderDialog(
    const core::ReadImport& read, const core::VolumeGeometry& geometry, QWidget* parent)
    : QDialog(parent)
    , m_read(std::make_unique<core::ReadImport>(read))
    , m_geometry(geometry)
    , m_keep(new QRadioButton(tr("Each segment keeps its voxels"), this))
    , m_flatten(new QRadioButton(tr("Each voxel goes to one segment"), this))
    , m_ordering(new QWidget(this))
    , m_order(new ShortList(m_ordering))
    , m_given(new ShortList(m_ordering))
    , m_up(new QPushButton(tr("Further up"), m_ordering))
    , m_down(new QPushButton(tr("Further down"), m_ordering))
{
    setWindowTitle(tr("Segments overlap"));
    constexpr int leastWidth = 480;
    setMinimumWidth(leastWidth);
    auto* heading = new FittingLabel(Qt::AlignLeft, this);
    heading->setFont(theme::headingFont());
    heading->setText(
        tr("Segments of '%1' overlap in %2 voxels")
            .arg(m_read->edit.file, core::grouped(std::int64_t(core::voxelsOf(m_read->overlaps)))));
    const bool fits = m_read->planesNeeded() <= core::mostLabelPlanes;
    m_keep->setObjectName(QStringLiteral("maskOrderKeep"));
    m_keep->setEnabled(fits);
    m_keep->setChecked(fits);
    m_flatten->setObjectName(QStringLiteral("maskOrderFlatten"));
    m_flatten->setChecked(!fits);
    auto* kept = new QLabel(
        fits ? tr(
            "The segments lie in %1 label planes. Each is edited, grown, measured and exported for "
            "itself. Label maps cannot hold overlaps.")
                   .arg(m_read->planesNeeded())
             : tr("They would need %1 label planes; there are at most %2.")
                   .arg(m_read->planesNeeded())
                   .arg(core::mostLabelPlanes),
        this);
    kept->setWordWrap(true);
    kept->setFont(theme::smallFont());
    auto* hint = new QLabel(
        tr("Where several of these have a voxel, it goes to the one furthest up."), m_ordering);
    hint->setWordWrap(true);
    hint->setFont(theme::smallFont());
    m_order->setObjectName(QStringLiteral("maskOrder"));
    m_order->setAccessibleName(tr("Segments that overlap, the first one before the others"));
    m_up->setObjectName(QStringLiteral("maskOrderUp"));
    m_down->setObjectName(QStringLiteral("maskOrderDown"));
    m_given->setObjectName(QStringLiteral("maskOrderGiven"));
    m_given->setAccessibleName(tr("How much goes to which segment"));
    m_given->setSelectionMode(QAbstractItemView::NoSelection);
    m_given->setWordWrap(true);
    m_given->setFont(theme::smallFont());
    auto* take = new QPushButton(tr("Import"), this);
    take->setObjectName(QStringLiteral("maskOrderImport"));
    take->setDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(QStringLiteral("maskOrderCancel"));
    for (QPushButton* button : {m_up, m_down, cancel})
        button->setAutoDefault(false);

    auto* moves = new QVBoxLayout;
    moves->addWidget(m_up);
    moves->addWidget(m_down);
    moves->addStretch(1);
    auto* order = new QHBoxLayout;
    order->setSpacing(theme::smallPadding);
    order->addWidget(m_order, 1);
    order->addLayout(moves);
    auto* ordering = new QVBoxLayout(m_ordering);
    ordering->setContentsMargins(0, 0, 0, 0);
    ordering->setSpacing(theme::smallPadding);
    ordering->addWidget(hint);
    ordering->addLayout(order, 1);
    ordering->addWidget(m_given, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    buttons->addStretch(1);
    buttons->addWidget(take);
    buttons->addWidget(cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(heading);
    layout->addWidget(m_keep);
    layout->addWidget(kept);
    layout->addWidget(m_flatten);
    layout->addWidget(m_ordering, 1);
    layout->addLayout(buttons);
    tabAsLaidOut(*this);

    std::set<std::size_t> places;
    for (const core::MaskOverlap& overlap : m_read->overlaps)
        places.insert(overlap.segments.begin(), overlap.segments.end());
    for (const std::size_t place : places)
        m_order->addItem(itemOf((*m_read->edit.segments)[place], place));
    m_order->setCurrentRow(0);
    connect(m_up, &QPushButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QPushButton::clicked, this, [this] { move(1); });
    connect(m_keep, &QRadioButton::toggled, this, &MaskOrderDialog::showState);
    connect(m_order, &QListWidget::currentRowChanged, this, &MaskOrderDialog::showState);
    connect(take, &QPushButton::clicked, this, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    showState();
    (fits ? m_keep : m_flatten)->setFocus();
}

MaskOrderDialog::~MaskOrderDialog() = default;

std::optional<std::vector<int>> MaskOrderDialog::ahead() const
{
    if (m_keep->isChecked())
        return std::nullopt;
    std::vector<int> places;
    for (int row = 0; row < m_order->count(); ++row)
        places.push_back(m_order->item(row)->data(placeRole).toInt() + 1);
    if (std::is_sorted(places.begin(), places.end()))
        return std::nullopt;
    return places;
}

std::optional<std::vector<int>> MaskOrderDialog::planes() const
{
    return m_keep->isChecked() ? std::optional(m_read->planes) : std::nullopt;
}

void MaskOrderDialog::move(int by)
{
    const int row = m_order->currentRow();
    if (row < 0 || row + by < 0 || row + by >= m_order->count())
        return;
    QListWidgetItem* item = m_order->takeItem(row);
    m_order->insertItem(row + by, item);
    m_order->setCurrentItem(item);
    showState();
}

void MaskOrderDialog::showState()
{
    const int row = m_order->currentRow();
    const bool ordered = m_flatten->isChecked();
    m_order->setEnabled(ordered);
    m_up->setEnabled(ordered && row > 0);
    m_down->setEnabled(ordered && row >= 0 && row + 1 < m_order->count());
    m_read->edit.ahead = ahead();
    m_read->edit.planes = planes();
    m_given->clear();
    for (const core::MaskNote& note :
        core::notesOnOverlaps(m_read->overlaps, m_read->edit, m_geometry))
        m_given->addItem(maskNoteText(note));
    if (m_ordering->isHidden() == ordered) {
        m_ordering->setVisible(ordered);
        // Sentences that are broken may need more height in this width than the hint has.
        resize(width(), std::max(sizeHint().height(), layout()->totalHeightForWidth(width())));
    }
}

void askForOrderOf(MaskImporter& importer, QWidget& window)
{
    QObject::connect(&importer, &MaskImporter::overlapping, &window,
        [&importer, &window](const core::ReadImport& read, const core::VolumeGeometry& geometry) {
            auto* dialog = new MaskOrderDialog(read, geometry, &window);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            // The study may be closed while it stands open.
            QObject::connect(&importer, &MaskImporter::noLongerAsked, dialog, &QDialog::reject);
            QObject::connect(dialog, &QDialog::accepted, &importer,
                [&importer, dialog] { importer.import(dialog->ahead(), dialog->planes()); });
            QObject::connect(dialog, &QDialog::rejected, &importer, &MaskImporter::giveUp);
            dialog->open();
        });
}

} // namespace ui
