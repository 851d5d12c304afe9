// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/RowText.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditNames.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/titles/TitleJson.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <utility>

namespace core {

namespace {

constexpr QLatin1String tellsHeld("tellsHeld"); // GrowthSchema.h

QString sha256OfLines(const QStringList& lines)
{
    const QByteArray message = lines.join(QLatin1Char('\n')).toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(message, QCryptographicHash::Sha256).toHex());
}

QString toText(const EditStatistics& statistics)
{
    QJsonObject json{
        {QStringLiteral("voxelsChanged"), qint64(statistics.voxelsChanged)},
        {QStringLiteral("bricks"), statistics.bricks},
        {QStringLiteral("generations"), statistics.generations},
        {QStringLiteral("milliseconds"), statistics.milliseconds},
    };
    if (statistics.verticesChanged > 0)
        json[QStringLiteral("verticesChanged")] = qint64(statistics.verticesChanged);
    if (statistics.searchedTo)
        json[QStringLiteral("searchedTo")] = *statistics.searchedTo;
    if (statistics.surfaceMaskChanged)
        json[QStringLiteral("surfaceMaskChanged")] = true;
    if (statistics.followsInterval)
        json[QStringLiteral("followsInterval")] = true;
    if (!statistics.intervalsLeft.empty()) {
        QJsonArray labels;
        for (const int label : statistics.intervalsLeft)
            labels.append(label);
        json[QStringLiteral("intervalsLeft")] = labels;
    }
    return compact(json);
}

EditStatistics statisticsFrom(const QString& text)
{
    const QJsonObject json = parsed(text);
    EditStatistics statistics{
        .voxelsChanged = json.value(QStringLiteral("voxelsChanged")).toInteger(),
        .verticesChanged = json.value(QStringLiteral("verticesChanged")).toInteger(),
        .bricks = json.value(QStringLiteral("bricks")).toInt(),
        .generations = json.value(QStringLiteral("generations")).toInt(),
        .milliseconds = json.value(QStringLiteral("milliseconds")).toDouble(),
        .surfaceMaskChanged = json.value(QStringLiteral("surfaceMaskChanged")).toBool(),
        .followsInterval = json.value(QStringLiteral("followsInterval")).toBool()};
    const QJsonArray left = json.value(QStringLiteral("intervalsLeft")).toArray();
    for (const QJsonValue& label : left)
        statistics.intervalsLeft.push_back(label.toInt());
    if (const QJsonValue depth = json.value(QStringLiteral("searchedTo")); depth.isDouble())
        statistics.searchedTo = std::int32_t(depth.toInteger());
    return statistics;
}

} // namespace

RowText RowText::of(const HistoryRow& row)
{
    return {.id = row.id,
        .parent = row.parent,
        .name = row.name,
        .edit = compact(editToJson(row.edit)),
        .statistics = toText(row.statistics),
        .growthGeneration = row.growthGeneration,
        .at = row.origin.at.toUTC().toString(Qt::ISODateWithMs),
        .author = row.origin.author,
        .program = row.origin.program,
        .title = row.title ? titleText(*row.title) : QString()};
}

Result<HistoryRow> RowText::row() const
{
    Result<Edit> known = editFromJson(parsed(edit));
    if (!known)
        return tl::unexpected(known.error());
    // Sessions of schema 3 and before do not say so: they grew by the other rule.
    if (auto* grow = known->as<GrowSteps>(); grow && !parsed(edit).contains(tellsHeld))
        grow->tellsHeld = false;
    // Rows from before there was a choice took samples for the corners of the path.
    if (bool* byTime = byTimeOf(*known); byTime && !parsed(edit).contains(QLatin1String("byTime")))
        *byTime = false;
    HistoryRow row;
    row.id = id;
    row.parent = parent;
    row.name = name;
    row.edit = *std::move(known);
    row.statistics = statisticsFrom(statistics);
    row.growthGeneration = std::uint32_t(growthGeneration);
    row.origin = {.at = QDateTime::fromString(at, Qt::ISODateWithMs).toUTC(),
        .author = author,
        .program = program};
    row.title = titleFromText(title, name);
    return row;
}

QString RowText::chain(const QString& previous) const
{
    QStringList lines{previous, QString::number(id), QString::number(parent), name, edit,
        statistics, QString::number(growthGeneration)};
    if (!at.isEmpty())
        lines += {at, author, program};
    return sha256OfLines(lines);
}

bool namesNoEarlierRow(RowId id, const Edit& edit)
{
    const std::vector<RowId> rows = rowsNamedBy(edit).rows;
    return !std::all_of(rows.begin(), rows.end(), [id](RowId row) { return row > 0 && row < id; });
}

QString firstChain(const QString& source)
{
    return sha256OfLines({QStringLiteral("BurinSession1"), source});
}

QString seal(const QString& chain, const QString& stateHash, const QString& deltaSha256)
{
    return sha256OfLines({chain, stateHash, deltaSha256});
}

QString sha256(const BrickDelta& delta)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const QByteArray& piece : delta.pieces)
        hash.addData(piece);
    return QString::fromLatin1(hash.result().toHex());
}

QString compact(const QJsonObject& object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

QJsonObject parsed(const QString& text)
{
    return QJsonDocument::fromJson(text.toUtf8()).object();
}

} // namespace core
