// SPDX-License-Identifier: Apache-2.0
#include "ui/models/StatisticsModel.h"

#include "core/export/common/StatisticsText.h"
#include "core/measure/MeasuredSize.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/measure/LiveStatistics.h"
#include "ui/workspace/Workspace.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ui {

namespace {

/// What kind of number stands in a column.
enum class NumberKind {
    Millilitres,
    ChangedMl, ///< since an import
    Value,
    MeanValue,
    SquareMm,
    Mm,
    Ratio, ///< of sizes in millimetres
    Share, ///< of voxels
    Count
};

struct StatisticsColumn {
    const char* key; ///< in an exported table
    const char* title;
    const char* longName;
    NumberKind kind;
};

constexpr std::array<StatisticsColumn, 20> statisticsColumns{{
    {"volumeMl", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Volume"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Volume"), NumberKind::Millilitres},
    {"mean", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Mean"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Mean"), NumberKind::MeanValue},
    {"standardDeviation", QT_TRANSLATE_NOOP("ui::StatisticsModel", "± SD"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Standard deviation"), NumberKind::MeanValue},
    {"minimum", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Min"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Minimum"), NumberKind::Value},
    {"maximum", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Max"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Maximum"), NumberKind::Value},
    {"percentile5", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P5"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 5"), NumberKind::Value},
    {"percentile10", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P10"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 10"), NumberKind::Value},
    {"percentile25", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P25"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 25"), NumberKind::Value},
    {"median", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Median"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Median"), NumberKind::Value},
    {"percentile75", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P75"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 75"), NumberKind::Value},
    {"percentile90", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P90"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 90"), NumberKind::Value},
    {"percentile95", QT_TRANSLATE_NOOP("ui::StatisticsModel", "P95"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Percentile 95"), NumberKind::Value},
    {"surfaceMm2", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Surface"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Surface"), NumberKind::SquareMm},
    {"sphericity", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Sphericity"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Sphericity"), NumberKind::Ratio},
    {"longestDiameterMm", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Longest"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Longest diameter"), NumberKind::Mm},
    {"acrossDiameterMm", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Across"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Longest diameter across the longest one"),
        NumberKind::Mm},
    {"voxels", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Voxels"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Number of voxels"), NumberKind::Count},
    {"importAddedMl", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Added"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Added since its import"), NumberKind::ChangedMl},
    {"importTakenMl", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Taken"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Taken since its import"), NumberKind::ChangedMl},
    {"importDice", QT_TRANSLATE_NOOP("ui::StatisticsModel", "Dice"),
        QT_TRANSLATE_NOOP("ui::StatisticsModel", "Dice with what was imported"), NumberKind::Share},
}};

/// The columns after the name.
const StatisticsColumn& factsOfColumn(int column)
{
    return statisticsColumns[std::size_t(column - 1)];
}

QString translatedColumn(const char* text)
{
    return QCoreApplication::translate("ui::StatisticsModel", text);
}

QPixmap colourSwatch(const QColor& colour)
{
    QPixmap swatch(12, 12);
    swatch.fill(Qt::transparent);
    QPainter painter(&swatch);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(1, 1, 10, 10), 2, 2);
    return swatch;
}

/// Three digits or so.
QString sizeNumber(double size)
{
    const int decimals = size < 0.1 ? 4 : size < 10.0 ? 2 : size < 1000.0 ? 1 : 0;
    return decimals == 0 ? countText(std::llround(size)) : numberText(size, decimals);
}

} // namespace

StatisticsModel::StatisticsModel(
    Workspace& workspace, const LiveStatistics& statistics, QObject* parent)
    : SegmentRows(parent)
    , m_workspace(workspace)
    , m_statistics(statistics)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        clearRows();
        refresh();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                refresh();
        });
    connect(&statistics, &LiveStatistics::changed, this, &StatisticsModel::refresh);
    refresh();
}

int StatisticsModel::columnOf(const QString& key)
{
    const auto found = std::find_if(statisticsColumns.begin(), statisticsColumns.end(),
        [&key](const StatisticsColumn& each) { return key == QLatin1String(each.key); });
    return found == statisticsColumns.end() ? -1 : int(found - statisticsColumns.begin()) + 1;
}

void StatisticsModel::refresh()
{
    const core::EditSession* session = m_workspace.session();
    followSegments(session ? &session->document() : nullptr);
    if (labels().empty())
        return;
    const int last = int(labels().size()) - 1;
    Q_EMIT dataChanged(index(0, 0), index(last, columnCount() - 1));
    Q_EMIT headerDataChanged(Qt::Vertical, 0, last);
}

int StatisticsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(statisticsColumns.size()) + 1;
}

const core::Segment* StatisticsModel::segmentAt(int row) const
{
    const core::EditSession* session = m_workspace.session();
    return session && row >= 0 && row < int(labels().size())
        ? session->document().segment(labels()[std::size_t(row)])
        : nullptr;
}

bool StatisticsModel::isInVoxels() const
{
    const core::Volume* volume = m_workspace.volume();
    return volume && core::unknownSpacing(*volume) != core::UnknownSpacing::Nothing;
}

/// Where the spacing is unknown, what an export writes are millimetres that nobody has measured.
std::optional<double> StatisticsModel::numberAt(int row, int column) const
{
    const core::SegmentStatistics* measured = m_statistics.of(labels()[std::size_t(row)]);
    if (!measured)
        return std::nullopt;
    const StatisticsColumn& facts = factsOfColumn(column);
    const char* key = facts.key;
    if (isInVoxels()) {
        if (facts.kind == NumberKind::Millilitres)
            key = "voxels";
        else if (facts.kind == NumberKind::ChangedMl || facts.kind == NumberKind::SquareMm
            || facts.kind == NumberKind::Mm || facts.kind == NumberKind::Ratio)
            return std::nullopt;
    }
    for (const core::StatisticsNumber& number : core::numbersOf(*measured)) {
        if (QLatin1String(number.name) == QLatin1String(key))
            return number.value;
    }
    return std::nullopt;
}

QString StatisticsModel::textOf(double number, int column) const
{
    const core::Volume* volume = m_workspace.volume();
    const double span = volume ? volume->maximum - volume->minimum : 0.0;
    switch (factsOfColumn(column).kind) {
    case NumberKind::Millilitres:
        return isInVoxels() ? countText(std::llround(number)) : sizeNumber(number);
    case NumberKind::ChangedMl:
        return number == 0.0 ? countText(0) : sizeNumber(number);
    case NumberKind::Value:
        return valueText(number, QString(), span);
    case NumberKind::MeanValue:
        return valueText(number, QString(), span / 10.0);
    case NumberKind::SquareMm:
        return sizeNumber(number);
    case NumberKind::Mm:
        return numberText(number, 1);
    case NumberKind::Ratio:
    case NumberKind::Share:
        return numberText(number, 3);
    case NumberKind::Count:
        return countText(std::llround(number));
    }
    return {};
}

QVariant StatisticsModel::data(const QModelIndex& index, int role) const
{
    const core::Segment* segment = index.isValid() ? segmentAt(index.row()) : nullptr;
    if (!segment)
        return {};
    const bool isBehind = m_statistics.isBehind(segment->label);
    switch (role) {
    case LabelRole:
        return int(segment->label);
    case BehindRole:
        return isBehind;
    case Qt::ToolTipRole:
        return isBehind ? tr("%1\nIt has changed, and is being measured").arg(segment->name)
                        : segment->name;
    case Qt::ForegroundRole:
        return isBehind ? QVariant(theme::faint) : QVariant();
    case Qt::TextAlignmentRole:
        return int((index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
        break;
    }
    if (index.column() == 0)
        return role == Qt::DisplayRole || role == NumberRole ? QVariant(segment->name) : QVariant();
    const std::optional<double> number = numberAt(index.row(), index.column());
    if (role == NumberRole)
        return number ? QVariant(*number) : QVariant();
    if (role == Qt::DisplayRole)
        return number ? textOf(*number, index.column()) : QStringLiteral("—");
    return {};
}

/// "Mean (HU)".
QString StatisticsModel::headingOf(int column) const
{
    const StatisticsColumn& facts = factsOfColumn(column);
    const core::Volume* volume = m_workspace.volume();
    QString unit;
    switch (facts.kind) {
    case NumberKind::Millilitres:
        unit = isInVoxels() ? tr("voxels") : tr("mL");
        break;
    case NumberKind::ChangedMl:
        unit = tr("mL");
        break;
    case NumberKind::Value:
    case NumberKind::MeanValue:
        unit = volume ? volume->unit : QString();
        break;
    case NumberKind::SquareMm:
        unit = tr("mm²");
        break;
    case NumberKind::Mm:
        unit = tr("mm");
        break;
    case NumberKind::Ratio:
    case NumberKind::Share:
    case NumberKind::Count:
        break;
    }
    const QString title = translatedColumn(facts.title);
    return unit.isEmpty() ? title : tr("%1 (%2)").arg(title, unit);
}

QVariant StatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical)
        return rowHeader(section, role);
    if (section < 0 || section >= columnCount())
        return {};
    switch (role) {
    case Qt::DisplayRole: // the unit below the name: so more columns are seen at once
        return section == 0 ? tr("Segment")
                            : headingOf(section).replace(QLatin1String(" ("), QLatin1String("\n("));
    case Qt::EditRole:
        return section == 0 ? tr("Segment") : headingOf(section);
    case LongNameRole:
    case Qt::ToolTipRole:
        return section == 0 ? tr("Segment") : translatedColumn(factsOfColumn(section).longName);
    case KeyRole:
        return section == 0 ? QStringLiteral("name") : QLatin1String(factsOfColumn(section).key);
    case Qt::TextAlignmentRole:
        return int((section == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
        return {};
    }
}

QVariant StatisticsModel::rowHeader(int row, int role) const
{
    const core::Segment* segment = segmentAt(row);
    if (!segment)
        return {};
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return segment->name;
    case Qt::DecorationRole:
        return colourSwatch(QColor(segment->rgb));
    default:
        return {};
    }
}

} // namespace ui
