// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/HitsTree.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"

#include <QHeaderView>

namespace ui {

namespace {

enum Column { Name, Id, Date, Modality, Description, Series, Images, Here, ColumnCount };
constexpr int placeRole = Qt::UserRole; ///< in the source's order

QString imageCountText(int number)
{
    return number < 0 ? QStringLiteral("?") : QString::number(number);
}

class Row : public QTreeWidgetItem {
public:
    Row(QTreeWidget* tree, std::size_t place)
        : QTreeWidgetItem(tree)
    {
        setData(Name, placeRole, int(place));
    }
    Row(QTreeWidgetItem* study, std::size_t place)
        : QTreeWidgetItem(study)
    {
        setData(Name, placeRole, int(place));
    }

    bool operator<(const QTreeWidgetItem& other) const override
    {
        const int place = data(Name, placeRole).toInt();
        const int otherPlace = other.data(Name, placeRole).toInt();
        const QHeaderView& header = *treeWidget()->header();
        const bool ascends = header.sortIndicatorOrder() == Qt::AscendingOrder;
        if (parent())
            return ascends ? place < otherPlace : place > otherPlace;
        const int column = header.sortIndicatorSection();
        if (column == Series || column == Images)
            return text(column).toInt() < other.text(column).toInt();
        return text(column).localeAwareCompare(other.text(column)) < 0;
    }
};

void putCount(QTreeWidgetItem& row, Column column, int count)
{
    row.setText(column, imageCountText(count));
    row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

QTreeWidgetItem* note(QTreeWidgetItem* parent, const QString& text)
{
    auto* row = new QTreeWidgetItem(parent, {text});
    row->setFirstColumnSpanned(true);
    row->setFlags(Qt::ItemIsEnabled);
    row->setForeground(Name, theme::secondary);
    return row;
}

} // namespace

HitsTree::HitsTree(QWidget* parent)
    : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("pacsHits"));
    setColumnCount(ColumnCount);
    setHeaderLabels({tr("Patient"), QStringLiteral("ID"), tr("Study date"), tr("Modality"),
        tr("Description"), tr("Series"), tr("Images"), tr("Here")});
    headerItem()->setToolTip(Here, tr("Whether a copy is on this computer"));
    setAllColumnsShowFocus(true);
    setUniformRowHeights(true);
    setExpandsOnDoubleClick(false);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Description, QHeaderView::Stretch);
    header()->setMinimumSectionSize(40);
    const int widths[ColumnCount] = {190, 96, 100, 80, 0, 64, 70, 54};
    for (int column = 0; column < ColumnCount; ++column) {
        if (column != Description)
            setColumnWidth(column, widths[column]);
    }
    for (const Column column : {Series, Images})
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    sortByColumn(Date, Qt::DescendingOrder);
    setSortingEnabled(true);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &HitsTree::choiceChanged);
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
        if (choiceOf(item))
            Q_EMIT openRequested();
    });
    connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) {
        const auto place = std::size_t(item->data(Name, placeRole).toInt());
        if (!item->parent() && m_series[place].empty())
            Q_EMIT seriesRequested(m_studies[place].studyUid);
    });
}

void HitsTree::showStudies(const std::vector<core::StudyHit>& studies)
{
    clear();
    m_studies = studies;
    m_series.assign(studies.size(), {});
    setSortingEnabled(false);
    for (std::size_t place = 0; place < studies.size(); ++place) {
        const core::StudyHit& study = studies[place];
        auto* row = new Row(this, place);
        const QString name = personName(study.patientName);
        row->setText(Name, name.isEmpty() ? tr("not named") : name);
        if (name.isEmpty())
            row->setForeground(Name, theme::secondary);
        row->setText(Id, study.patientId);
        row->setText(Date, study.studyDate);
        row->setText(Modality, study.modalities.join(u'/'));
        row->setText(Description, study.description);
        putCount(*row, Series, study.series);
        putCount(*row, Images, study.instances);
        QStringList more{name};
        if (!study.birthDate.isEmpty())
            more += tr("born %1").arg(study.birthDate);
        if (!study.accessionNumber.isEmpty())
            more += tr("accession %1").arg(study.accessionNumber);
        row->setToolTip(Name, more.join(QStringLiteral(" · ")));
        row->setToolTip(Description, study.description);
        note(row, tr("Asking for the series …"));
    }
    setSortingEnabled(true);
    if (studies.size() == 1)
        topLevelItem(0)->setExpanded(true);
}

QTreeWidgetItem* HitsTree::rowOf(const QString& studyUid) const
{
    for (int row = 0; row < topLevelItemCount(); ++row) {
        const auto place = std::size_t(topLevelItem(row)->data(Name, placeRole).toInt());
        if (m_studies[place].studyUid == studyUid)
            return topLevelItem(row);
    }
    return nullptr;
}

void HitsTree::showSeries(const QString& studyUid, const std::vector<core::SeriesHit>& series)
{
    QTreeWidgetItem* parent = rowOf(studyUid);
    if (!parent)
        return;
    m_series[std::size_t(parent->data(Name, placeRole).toInt())] = series;
    qDeleteAll(parent->takeChildren());
    // Rows are put in order once they are whole.
    setSortingEnabled(false);
    if (series.empty())
        note(parent, tr("The source lists no series of it."));
    for (std::size_t place = 0; place < series.size(); ++place) {
        const core::SeriesHit& one = series[place];
        auto* row = new Row(parent, place);
        row->setText(Name, one.number.isEmpty() ? tr("Series") : tr("Series %1").arg(one.number));
        row->setText(Modality, one.modality);
        QStringList words{one.description, one.bodyPart};
        words.removeAll(QString());
        row->setText(Description, words.join(QStringLiteral(" · ")));
        row->setToolTip(Description, row->text(Description));
        putCount(*row, Images, one.instances);
    }
    setSortingEnabled(true);
}

void HitsTree::showTrouble(const QString& studyUid, const QString& sentence)
{
    if (QTreeWidgetItem* parent = rowOf(studyUid)) {
        qDeleteAll(parent->takeChildren());
        note(parent, sentence)->setForeground(Name, theme::bad);
    }
}

std::optional<HitsTree::Choice> HitsTree::choiceOf(const QTreeWidgetItem* item) const
{
    if (!item)
        return std::nullopt;
    const QTreeWidgetItem* top = item->parent() ? item->parent() : item;
    const auto study = std::size_t(top->data(Name, placeRole).toInt());
    Choice choice{.study = m_studies[study], .series = {}};
    if (top == item)
        return choice;
    // A note in place of series has none.
    const QVariant place = item->data(Name, placeRole);
    const auto& series = m_series[study];
    if (!place.isValid() || std::size_t(place.toInt()) >= series.size())
        return std::nullopt;
    choice.series = series[std::size_t(place.toInt())];
    return choice;
}

std::optional<HitsTree::Choice> HitsTree::chosen() const
{
    const auto items = selectedItems();
    return items.isEmpty() ? std::nullopt : choiceOf(items.front());
}

void HitsTree::markHere(const std::function<bool(const Choice&)>& isHere)
{
    const auto mark = [&](QTreeWidgetItem* item) {
        const std::optional<Choice> choice = choiceOf(item);
        const bool here = choice && isHere(*choice);
        item->setText(Here, here ? QStringLiteral("✓") : QString());
        item->setForeground(Here, theme::good);
        item->setTextAlignment(Here, Qt::AlignCenter);
        item->setToolTip(Here, here ? tr("A copy is on this computer") : QString());
    };
    for (int row = 0; row < topLevelItemCount(); ++row) {
        mark(topLevelItem(row));
        for (int child = 0; child < topLevelItem(row)->childCount(); ++child)
            mark(topLevelItem(row)->child(child));
    }
}

} // namespace ui
