// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/HitsTree.h"

#include "ui/StudyTexts.h"
#include "ui/Theme.h"

#include <QHeaderView>

namespace ui {

namespace {

enum Column { Name, Id, Date, Type, Description, Images, Here, ColumnCount };

QString countText(int number)
{
    return number < 0 ? QStringLiteral("?") : QString::number(number);
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
    setHeaderLabels({QStringLiteral("Patient"), QStringLiteral("ID"), QStringLiteral("Study date"),
        QStringLiteral("Type"), QStringLiteral("Description"), QStringLiteral("Images"),
        QStringLiteral("Here")});
    setAllColumnsShowFocus(true);
    setUniformRowHeights(true);
    setExpandsOnDoubleClick(false);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Description, QHeaderView::Stretch);
    header()->setMinimumSectionSize(40);
    const int widths[ColumnCount] = {210, 100, 92, 70, 0, 104, 48};
    for (int column = 0; column < ColumnCount; ++column) {
        if (column != Description)
            setColumnWidth(column, widths[column]);
    }
    headerItem()->setTextAlignment(Images, Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &HitsTree::choiceChanged);
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
        if (choiceOf(item))
            Q_EMIT openAsked();
    });
    connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) {
        const int row = indexOfTopLevelItem(item);
        if (row >= 0 && m_series[std::size_t(row)].empty())
            Q_EMIT seriesAsked(m_studies[std::size_t(row)].studyUid);
    });
}

void HitsTree::showStudies(const std::vector<core::StudyHit>& studies)
{
    clear();
    m_studies = studies;
    m_series.assign(studies.size(), {});
    for (const core::StudyHit& study : studies) {
        auto* row = new QTreeWidgetItem(this);
        const QString name = personName(study.patientName);
        row->setText(Name, name.isEmpty() ? QStringLiteral("not named") : name);
        if (name.isEmpty())
            row->setForeground(Name, theme::secondary);
        row->setText(Id, study.patientId);
        row->setText(Date, study.studyDate);
        row->setText(Type, study.modalities.join(u'/'));
        row->setText(Description, study.description);
        row->setText(Images,
            QStringLiteral("%1 in %2").arg(countText(study.instances), countText(study.series)));
        row->setTextAlignment(Images, Qt::AlignRight | Qt::AlignVCenter);
        row->setToolTip(Images,
            QStringLiteral("%1 images in %2 series")
                .arg(countText(study.instances), countText(study.series)));
        QStringList more{name};
        if (!study.birthDate.isEmpty())
            more += QStringLiteral("born %1").arg(study.birthDate);
        if (!study.accessionNumber.isEmpty())
            more += QStringLiteral("accession %1").arg(study.accessionNumber);
        row->setToolTip(Name, more.join(QStringLiteral(" · ")));
        row->setToolTip(Description, study.description);
        note(row, QStringLiteral("Asking for the series …"));
    }
    if (studies.size() == 1)
        topLevelItem(0)->setExpanded(true);
}

QTreeWidgetItem* HitsTree::rowOf(const QString& studyUid) const
{
    for (std::size_t row = 0; row < m_studies.size(); ++row) {
        if (m_studies[row].studyUid == studyUid)
            return topLevelItem(int(row));
    }
    return nullptr;
}

void HitsTree::showSeries(const QString& studyUid, const std::vector<core::SeriesHit>& series)
{
    QTreeWidgetItem* parent = rowOf(studyUid);
    if (!parent)
        return;
    m_series[std::size_t(indexOfTopLevelItem(parent))] = series;
    qDeleteAll(parent->takeChildren());
    if (series.empty())
        note(parent, QStringLiteral("The source lists no series of it."));
    for (const core::SeriesHit& one : series) {
        auto* row = new QTreeWidgetItem(parent);
        row->setText(Name,
            one.number.isEmpty() ? QStringLiteral("Series")
                                 : QStringLiteral("Series %1").arg(one.number));
        row->setText(Type, one.modality);
        QStringList words{one.description, one.bodyPart};
        words.removeAll(QString());
        row->setText(Description, words.join(QStringLiteral(" · ")));
        row->setToolTip(Description, row->text(Description));
        row->setText(Images, countText(one.instances));
        row->setTextAlignment(Images, Qt::AlignRight | Qt::AlignVCenter);
    }
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
    const int row = indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(top));
    if (row < 0)
        return std::nullopt;
    Choice choice{.study = m_studies[std::size_t(row)], .series = {}};
    if (top == item)
        return choice;
    const auto& series = m_series[std::size_t(row)];
    const auto place = std::size_t(top->indexOfChild(const_cast<QTreeWidgetItem*>(item)));
    if (place >= series.size())
        return std::nullopt;
    choice.series = series[place];
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
        item->setToolTip(Here, here ? QStringLiteral("A copy is on this computer") : QString());
    };
    for (int row = 0; row < topLevelItemCount(); ++row) {
        mark(topLevelItem(row));
        for (int child = 0; child < topLevelItem(row)->childCount(); ++child)
            mark(topLevelItem(row)->child(child));
    }
}

} // namespace ui
