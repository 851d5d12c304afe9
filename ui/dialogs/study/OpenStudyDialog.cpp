// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/study/OpenStudyDialog.h"

#include "ui/base/ErrorText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/tasks/ThumbnailLoader.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/ProblemTexts.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMap>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

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
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + clauseText(entry.part);
    return text.isEmpty() ? entry.key : text;
}

QString sizeOf(const core::SeriesEntry& entry)
{
    const glm::ivec3 size = entry.geometry.size;
    const QString times = entry.times.isEmpty()
        ? QString()
        : QObject::tr(", %1 points in time").arg(entry.times.size());
    const QString every =
        entry.needsSpacing() ? QString() : QStringLiteral(", ") + slicesApartText(entry.geometry);
    return QStringLiteral("%1%2\n%3 × %4%5")
        .arg(size.z)
        .arg(times)
        .arg(size.x)
        .arg(size.y)
        .arg(every);
}

QString question(const QString& path, const std::vector<const core::SeriesEntry*>& candidates)
{
    if (candidates.size() == 1) {
        return QObject::tr("%1 holds a series of %2 points in time. Which one?")
            .arg(path)
            .arg(candidates.front()->times.size());
    }
    return QObject::tr("%1 holds %2 volumes. Which one?").arg(path).arg(candidates.size());
}

QString problemsOf(const core::SeriesEntry& entry)
{
    QStringList sentences;
    for (const core::VolumeProblem& problem : entry.problems)
        sentences += problemText(problem.said);
    return sentences.join(QStringLiteral("\n"));
}

/// What lies in the folder beside the volumes, in one sentence; empty if nothing does.
QString othersIn(const core::StudyListing& listing, std::size_t offered)
{
    std::size_t singles = 0;
    for (const core::StudyEntry& study : listing.studies)
        singles += study.series.size();
    singles -= offered;
    QMap<QString, qsizetype> kinds;
    for (const core::ForeignObject& object : listing.foreign)
        kinds[clauseText(object.kind)] += std::max<qsizetype>(1, object.files.size());
    QStringList parts;
    if (singles > 0)
        parts += QObject::tr("%1 × single image (open its file)").arg(singles);
    for (auto kind = kinds.cbegin(); kind != kinds.cend(); ++kind)
        parts += QStringLiteral("%1 × %2").arg(kind.value()).arg(kind.key());
    if (!listing.unreadable.empty()) {
        parts += QObject::tr("%1 unreadable (%2)")
                     .arg(listing.unreadable.size())
                     .arg(errorText(listing.unreadable.front().error));
    }
    return parts.isEmpty() ? QString()
                           : QObject::tr("Also found: ") + parts.join(QStringLiteral(", "));
}

/// Words keep their colour in the row that is chosen.
class ColouredDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->palette.setColor(QPalette::HighlightedText, option->palette.color(QPalette::Text));
    }
};

} // namespace

OpenStudyDialog::OpenStudyDialog(const core::StudyListing& listing, QWidget* parent)
    : QDialog(parent)
    , m_list(new QTreeWidget(this))
    , m_timeRow(new QWidget(this))
    , m_time(new QComboBox(m_timeRow))
    , m_open(nullptr)
{
    setWindowTitle(tr("Choose a volume"));
    resize(1080, 560);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    const auto candidates = listing.candidates();
    auto* heading = new QLabel(question(listing.path, candidates), this);
    heading->setTextFormat(Qt::PlainText);
    heading->setWordWrap(true);
    layout->addWidget(heading);

    m_list->setColumnCount(ColumnCount);
    m_list->setHeaderLabels({QString(), tr("Patient"), tr("Study date"), tr("Modality"),
        tr("Series"), tr("Slices"), tr("Problems")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(false);
    m_list->setIconSize(QSize(pictureSize, pictureSize));
    m_list->setAllColumnsShowFocus(true);
    m_list->setWordWrap(true);
    m_list->setItemDelegateForColumn(Problems, new ColouredDelegate(m_list));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QStringList files;
    for (const core::SeriesEntry* entry : candidates) {
        addRow(*entry);
        files += entry->files.value(entry->files.size() / 2);
    }
    const int widths[ColumnCount] = {pictureSize + 18, 170, 100, 76, 226, 194, 0};
    for (int column = 0; column < Problems; ++column)
        m_list->setColumnWidth(column, widths[column]);
    m_list->header()->setStretchLastSection(true);
    layout->addWidget(m_list, 1);

    auto* time = new QHBoxLayout(m_timeRow);
    time->setContentsMargins(0, 0, 0, 0);
    time->setSpacing(8);
    auto* timeLabel = new QLabel(tr("Point in &time:"), m_timeRow);
    timeLabel->setBuddy(m_time);
    time->addWidget(timeLabel);
    time->addWidget(m_time);
    time->addStretch(1);
    layout->addWidget(m_timeRow);
    m_timeRow->setVisible(false);

    if (const QString others = othersIn(listing, candidates.size()); !others.isEmpty()) {
        auto* label = new QLabel(others, this);
        label->setProperty("role", QStringLiteral("secondary"));
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        layout->addWidget(label);
    }

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_open = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
    m_open->setEnabled(false);
    m_open->setDefault(true);
    layout->addWidget(buttons);
    tabAsLaidOut(*this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, [this] {
        offerTimes();
        m_open->setEnabled(!chosenKey().isEmpty());
    });
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);

    m_pictures = std::make_unique<ThumbnailLoader>(files, pictureSize);
    connect(m_pictures.get(), &ThumbnailLoader::ready, this, &OpenStudyDialog::showPicture);
    if (candidates.size() == 1)
        m_list->topLevelItem(0)->setSelected(true);
}

OpenStudyDialog::~OpenStudyDialog() = default;

void OpenStudyDialog::addRow(const core::SeriesEntry& entry)
{
    auto* row = new QTreeWidgetItem(m_list);
    row->setData(0, Qt::UserRole, int(m_entries.size()));
    m_entries.push_back(entry);
    row->setSizeHint(Picture, QSize(pictureSize + 16, pictureSize + 12));
    QStringList lines = patientLines(entry.identity);
    row->setText(Patient, lines.join(QStringLiteral("\n")));
    row->setText(Date, dashed(entry.identity.studyDate));
    row->setText(Modality, dashed(entry.identity.modality));
    row->setText(Description, descriptionOf(entry));
    row->setText(Slices, sizeOf(entry));
    row->setText(Problems, problemsOf(entry));
    const bool caution = std::any_of(entry.problems.begin(), entry.problems.end(),
        [](const core::VolumeProblem& problem) { return problem.caution; });
    row->setForeground(Problems, caution ? theme::caution : theme::secondary);
    for (int column = 0; column < ColumnCount; ++column)
        row->setToolTip(column, row->text(column));
}

void OpenStudyDialog::showPicture(int row, const QImage& picture)
{
    if (QTreeWidgetItem* item = m_list->topLevelItem(row))
        item->setIcon(Picture, QIcon(QPixmap::fromImage(picture)));
}

/// The points in time of the chosen row.
void OpenStudyDialog::offerTimes()
{
    m_time->clear();
    const auto chosen = m_list->selectedItems();
    if (!chosen.isEmpty()) {
        const core::SeriesEntry& entry =
            m_entries.at(std::size_t(chosen.front()->data(0, Qt::UserRole).toInt()));
        for (qsizetype time = 0; time < entry.times.size(); ++time) {
            const QString number = tr("%1 of %2").arg(time + 1).arg(entry.times.size());
            m_time->addItem(entry.times[time].isEmpty()
                    ? number
                    : QStringLiteral("%1: %2").arg(number, clauseText(entry.times[time])));
        }
    }
    m_timeRow->setVisible(m_time->count() > 0);
}

QString OpenStudyDialog::chosenKey() const
{
    const auto chosen = m_list->selectedItems();
    if (chosen.isEmpty())
        return {};
    return m_entries.at(std::size_t(chosen.front()->data(0, Qt::UserRole).toInt()))
        .keyAtTime(std::max(0, m_time->currentIndex()));
}

} // namespace ui
