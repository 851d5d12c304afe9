// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/StatisticsPanel.h"

#include "ui/base/Theme.h"
#include "ui/models/StatisticsModel.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QStyle>
#include <QStyleOptionHeader>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int mostStatisticsRows = 8;
constexpr int widestName = 96; // of the panel's 266 pixels: three numbers have room beside it
constexpr int narrowestColumn = 24;

/// The header of the numbers. Only the column by which the table is sorted has room for the arrow:
/// in a header of two lines it would make all columns half as wide again.
class NarrowHeader : public QHeaderView {
public:
    explicit NarrowHeader(QWidget* parent)
        : QHeaderView(Qt::Horizontal, parent)
    {
        setSectionsClickable(true);
        setFont(theme::smallFont());
        setMinimumSectionSize(narrowestColumn);
    }

protected:
    [[nodiscard]] QSize sectionSizeFromContents(int column) const override
    {
        QStyleOptionHeader option;
        initStyleOption(&option);
        option.section = column;
        option.text = model()->headerData(column, orientation()).toString();
        QSize size = style()->sizeFromContents(QStyle::CT_HeaderSection, &option, QSize(), this);
        if (sortIndicatorSection() == column)
            size.rwidth() += size.height() / 2 + style()->pixelMetric(QStyle::PM_HeaderMargin);
        return size;
    }
};

QString hiddenColumnsKey()
{
    return QStringLiteral("statistics/hiddenColumns");
}

QStringList hiddenAtFirst()
{
    return {QStringLiteral("percentile10"), QStringLiteral("percentile25"),
        QStringLiteral("percentile75"), QStringLiteral("percentile90"), QStringLiteral("voxels"),
        QStringLiteral("importAddedMl"), QStringLiteral("importTakenMl"),
        QStringLiteral("importDice")};
}

/// As short as brings the same number back, as in an exported table.
QString wholeNumber(const QVariant& number)
{
    if (number.userType() != QMetaType::Double)
        return number.toString();
    return QString::number(number.toDouble(), 'g', QLocale::FloatingPointShortest);
}

/// A name could have what parts columns and rows.
QString inOneCell(QString text)
{
    for (const char16_t parting : {u'\t', u'\n', u'\r'})
        text.replace(QChar(parting), QChar(u' '));
    return text;
}

} // namespace

StatisticsPanel::StatisticsPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_statistics(workspace)
    , m_model(new StatisticsModel(workspace, m_statistics, this))
    , m_sorted(new QSortFilterProxyModel(this))
    , m_table(new QTableView(this))
    , m_empty(new QLabel(tr("Nothing to measure yet. Add a segment and paint, or sketch seeds and "
                            "grow them."),
          this))
    , m_export(new QPushButton(tr("Export …"), this))
{
    buildTable();
    addColumnChoice();
    m_empty->setObjectName(QStringLiteral("noStatistics"));
    m_empty->setProperty("role", QStringLiteral("secondary"));
    m_empty->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    m_empty->setWordWrap(true);
    m_export->setObjectName(QStringLiteral("exportStatistics"));
    m_export->setToolTip(tr("Writes all numbers as CSV, JSON or DICOM SR, and checks the file"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, theme::smallPadding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_empty);
    layout->addWidget(m_table);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(theme::padding, 0, theme::padding, 0);
    buttons->addWidget(m_export);
    buttons->addStretch();
    layout->addLayout(buttons);

    connect(m_export, &QPushButton::clicked, this, &StatisticsPanel::exportRequested);
    connect(&m_statistics, &LiveStatistics::failed, &workspace, &Workspace::fail);
    connect(&m_statistics, &LiveStatistics::changed, this, &StatisticsPanel::refresh);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &StatisticsPanel::refresh);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, &StatisticsPanel::refresh);
    connect(m_model, &QAbstractItemModel::modelReset, this, &StatisticsPanel::refresh);
    refresh();
}

void StatisticsPanel::buildTable()
{
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(StatisticsModel::NumberRole);
    m_sorted->setSortCaseSensitivity(Qt::CaseInsensitive);
    m_table->setObjectName(QStringLiteral("segmentStatistics"));
    m_table->setAccessibleName(tr("Statistics of segments"));
    m_table->setHorizontalHeader(new NarrowHeader(m_table));
    m_table->setModel(m_sorted);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setCornerButtonEnabled(false);
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    // Names stay where they are while the numbers scroll.
    m_table->setColumnHidden(0, true);
    QHeaderView* names = m_table->verticalHeader();
    names->setSectionResizeMode(QHeaderView::Fixed);
    names->setMinimumSectionSize(theme::rowHeight);
    names->setDefaultSectionSize(theme::rowHeight);
    names->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    names->setMaximumWidth(widestName);
    names->setHighlightSections(false);
    QHeaderView* columns = m_table->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::ResizeToContents);
    columns->setHighlightSections(false);
    // A third click brings the order of the segments back.
    columns->setSortIndicatorClearable(true);
    columns->setSortIndicator(-1, Qt::AscendingOrder);
    m_table->setSortingEnabled(true);

    auto* copy = new QAction(tr("Copy as text"), m_table);
    copy->setObjectName(QStringLiteral("copyStatistics"));
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, this,
        [this] { QGuiApplication::clipboard()->setText(asText()); });
    m_table->addAction(copy);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

/// The menu of the header: what is shown, and orders that no click on a column gives.
void StatisticsPanel::addColumnChoice()
{
    QHeaderView* header = m_table->horizontalHeader();
    header->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto addOrder = [this, header](const QString& text, const char* name, int column) {
        auto* action = new QAction(text, header);
        action->setObjectName(QLatin1String(name));
        connect(action, &QAction::triggered, this,
            [this, column] { m_table->sortByColumn(column, Qt::AscendingOrder); });
        header->addAction(action);
    };
    addOrder(tr("Sort by name"), "sortStatisticsByName", 0);
    addOrder(tr("In the order of the segments"), "sortStatisticsAsListed", -1);
    auto* parting = new QAction(header);
    parting->setSeparator(true);
    header->addAction(parting);
    const QStringList hidden =
        QSettings().value(hiddenColumnsKey(), hiddenAtFirst()).toStringList();
    for (int column = 1; column < m_model->columnCount(); ++column) {
        const auto told = [this, column](int role) {
            return m_model->headerData(column, Qt::Horizontal, role).toString();
        };
        auto* action = new QAction(told(StatisticsModel::LongNameRole), header);
        action->setObjectName(QStringLiteral("statisticsColumn.") + told(StatisticsModel::KeyRole));
        action->setCheckable(true);
        action->setChecked(!hidden.contains(told(StatisticsModel::KeyRole)));
        header->addAction(action);
        m_columns.push_back(action);
        connect(action, &QAction::toggled, this, [this] {
            QStringList without;
            for (std::size_t i = 0; i < m_columns.size(); ++i) {
                if (!m_columns[i]->isChecked())
                    without +=
                        m_model->headerData(int(i) + 1, Qt::Horizontal, StatisticsModel::KeyRole)
                            .toString();
            }
            QSettings().setValue(hiddenColumnsKey(), without);
            chooseColumns();
        });
    }
    chooseColumns();
}

void StatisticsPanel::chooseColumns()
{
    const auto shown = std::count_if(m_columns.begin(), m_columns.end(),
        [](const QAction* action) { return action->isChecked(); });
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const bool isShown = m_columns[i]->isChecked();
        m_table->setColumnHidden(int(i) + 1, !isShown);
        // Without any column there would be no header to bring one back.
        m_columns[i]->setEnabled(!isShown || shown > 1);
    }
}

QString StatisticsPanel::title() const
{
    return tr("Statistics");
}

QString StatisticsPanel::summary() const
{
    return m_statistics.isLooking() ? tr("measuring …") : QString();
}

void StatisticsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    m_statistics.setWatched(true);
}

void StatisticsPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    m_statistics.setWatched(false);
}

void StatisticsPanel::refresh()
{
    const int rows = m_model->rowCount();
    m_empty->setVisible(rows == 0);
    m_table->setVisible(rows > 0);
    m_export->setEnabled(rows > 0);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height()
        + std::clamp(rows, 1, mostStatisticsRows) * theme::rowHeight + 2 * m_table->frameWidth()
        + m_table->horizontalScrollBar()->sizeHint().height());
    Q_EMIT summaryChanged(summary());
}

QString StatisticsPanel::asText() const
{
    std::vector<int> columns;
    QStringList cells;
    for (int column = 0; column < m_sorted->columnCount(); ++column) {
        if (column > 0 && m_table->isColumnHidden(column))
            continue;
        columns.push_back(column);
        cells += m_sorted->headerData(column, Qt::Horizontal, Qt::EditRole).toString();
    }
    QStringList lines{cells.join(QLatin1Char('\t'))};
    const bool isChoice = m_table->selectionModel()->hasSelection();
    for (int row = 0; row < m_sorted->rowCount(); ++row) {
        if (isChoice && !m_table->selectionModel()->isRowSelected(row))
            continue;
        cells.clear();
        for (const int column : columns)
            cells += inOneCell(
                wholeNumber(m_sorted->index(row, column).data(StatisticsModel::NumberRole)));
        lines += cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace ui
