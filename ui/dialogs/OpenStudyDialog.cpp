// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/OpenStudyDialog.h"

#include "ui/ErrorText.h"
#include "ui/StudyTexts.h"
#include "ui/Theme.h"
#include "ui/dialogs/ThumbnailLoader.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QMap>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

namespace {

enum Column { Picture, Patient, Date, Modality, Description, Slices, Problems, ColumnCount };
constexpr int pictureSize = 60;

QString dashed(const QString& value)
{
    return value.isEmpty() ? QStringLiteral("—") : value;
}

QString descriptionOf(const core::SeriesEntry& entry)
{
    QString text = seriesText(entry.identity);
    if (!entry.part.isEmpty())
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + entry.part;
    return text.isEmpty() ? entry.key : text;
}

QString sizeOf(const core::SeriesEntry& entry)
{
    const glm::ivec3 size = entry.geometry.size;
    const glm::dvec3 spacing = entry.geometry.spacingMm();
    return QStringLiteral("%1\n%2 × %3, every %4 mm")
        .arg(size.z)
        .arg(size.x)
        .arg(size.y)
        .arg(spacing.z, 0, 'g', 3);
}

QString problemsOf(const core::SeriesEntry& entry)
{
    QStringList sentences;
    for (const core::VolumeProblem& problem : entry.problems)
        sentences += problem.text;
    return sentences.join(QStringLiteral("\n"));
}

/// What lies in the folder beside the volumes, in one sentence; empty if nothing does.
QString othersIn(const core::StudyListing& listing)
{
    QMap<QString, int> kinds;
    for (const core::ForeignObject& object : listing.foreign)
        ++kinds[object.kind];
    QStringList parts;
    for (auto kind = kinds.cbegin(); kind != kinds.cend(); ++kind)
        parts += QStringLiteral("%1 × %2").arg(kind.value()).arg(kind.key());
    if (!listing.unreadable.empty()) {
        parts += QStringLiteral("%1 unreadable (%2)")
                     .arg(listing.unreadable.size())
                     .arg(errorText(listing.unreadable.front().error));
    }
    return parts.isEmpty() ? QString()
                           : QStringLiteral("Also found: ") + parts.join(QStringLiteral(", "));
}

} // namespace

OpenStudyDialog::OpenStudyDialog(const core::StudyListing& listing, QWidget* parent)
    : QDialog(parent)
    , m_list(new QTreeWidget(this))
    , m_open(nullptr)
{
    setWindowTitle(QStringLiteral("Choose a volume"));
    resize(1080, 560);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    const auto candidates = listing.candidates();
    auto* heading = new QLabel(
        QStringLiteral("%1 holds %2 volumes. Which one?").arg(listing.path).arg(candidates.size()),
        this);
    heading->setTextFormat(Qt::PlainText);
    heading->setWordWrap(true);
    layout->addWidget(heading);

    m_list->setColumnCount(ColumnCount);
    m_list->setHeaderLabels(
        {QString(), QStringLiteral("Patient"), QStringLiteral("Study date"), QStringLiteral("Type"),
            QStringLiteral("Series"), QStringLiteral("Slices"), QStringLiteral("Problems")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(false);
    m_list->setIconSize(QSize(pictureSize, pictureSize));
    m_list->setAllColumnsShowFocus(true);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QStringList files;
    for (const core::SeriesEntry* entry : candidates) {
        addRow(*entry);
        files += entry->files.value(entry->files.size() / 2);
    }
    const int widths[ColumnCount] = {pictureSize + 16, 190, 96, 56, 240, 190, 0};
    for (int column = 0; column < Problems; ++column)
        m_list->setColumnWidth(column, widths[column]);
    m_list->header()->setStretchLastSection(true);
    layout->addWidget(m_list, 1);

    if (const QString others = othersIn(listing); !others.isEmpty()) {
        auto* label = new QLabel(others, this);
        label->setProperty("role", QStringLiteral("secondary"));
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        layout->addWidget(label);
    }

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_open = buttons->addButton(QStringLiteral("Open"), QDialogButtonBox::AcceptRole);
    m_open->setEnabled(false);
    m_open->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this,
        [this] { m_open->setEnabled(!chosenKey().isEmpty()); });
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);

    m_pictures = std::make_unique<ThumbnailLoader>(files, pictureSize);
    connect(m_pictures.get(), &ThumbnailLoader::ready, this, &OpenStudyDialog::showPicture);
}

OpenStudyDialog::~OpenStudyDialog() = default;

void OpenStudyDialog::addRow(const core::SeriesEntry& entry)
{
    auto* row = new QTreeWidgetItem(m_list);
    row->setData(0, Qt::UserRole, entry.key);
    row->setSizeHint(Picture, QSize(pictureSize + 16, pictureSize + 12));
    QStringList lines = patientLines(entry.identity);
    row->setText(Patient, lines.join(QStringLiteral("\n")));
    row->setText(Date, dashed(entry.identity.studyDate));
    row->setText(Modality, dashed(entry.identity.modality));
    row->setText(Description, descriptionOf(entry));
    row->setText(Slices, sizeOf(entry));
    row->setText(Problems, problemsOf(entry));
    row->setForeground(Problems, theme::caution);
    for (int column = 0; column < ColumnCount; ++column)
        row->setToolTip(column, row->text(column));
}

void OpenStudyDialog::showPicture(int row, const QImage& picture)
{
    if (QTreeWidgetItem* item = m_list->topLevelItem(row))
        item->setIcon(Picture, QIcon(QPixmap::fromImage(picture)));
}

QString OpenStudyDialog::chosenKey() const
{
    const auto chosen = m_list->selectedItems();
    return chosen.isEmpty() ? QString() : chosen.front()->data(0, Qt::UserRole).toString();
}

} // namespace ui
