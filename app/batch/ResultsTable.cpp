// SPDX-License-Identifier: Apache-2.0
#include "app/batch/ResultsTable.h"

#include <QDir>
#include <QJsonArray>
#include <QMap>

#include <algorithm>

namespace app {

namespace {

/// The columns that every table had.
constexpr const char* firstColumns = "name,study,state,";

/// A spreadsheet takes a text that begins like a formula for one.
QByteArray cell(QString text)
{
    if (!text.isEmpty() && QStringLiteral("=+-@").contains(text.front()))
        text.prepend(QLatin1Char('\''));
    QByteArray bytes = text.toUtf8();
    if (!bytes.contains(',') && !bytes.contains('"') && !bytes.contains('\n')
        && !bytes.contains('\r'))
        return bytes;
    return '"' + bytes.replace("\"", "\"\"") + '"';
}

/// Numbers of the segments, by "SEGMENT NUMBER"; of segments that share a name, by "SEGMENT (LABEL)
/// NUMBER".
QMap<QString, QString> numbersOf(const QJsonObject& record, const QString& folder)
{
    QMap<QString, QString> numbers;
    const QJsonArray exports = record.value(QStringLiteral("exports")).toArray();
    for (const QJsonValue& each : exports) {
        const QString name = each.toObject().value(QStringLiteral("file")).toString();
        QFile file(QDir(folder).absoluteFilePath(name));
        if (!name.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)
            || !file.open(QIODevice::ReadOnly))
            continue;
        const auto rows = readTable(QString::fromUtf8(file.readAll()), QLatin1Char(','));
        if (!rows || rows->size() < 2)
            continue;
        const QStringList& columns = rows->front();
        const qsizetype segment = columns.indexOf(QStringLiteral("name"));
        const qsizetype label = columns.indexOf(QStringLiteral("label"));
        const qsizetype first = columns.indexOf(QStringLiteral("unit")) + 1;
        if (segment < 0 || first == 0)
            continue;
        QMap<QString, int> segmentsOfName;
        for (auto row = rows->begin() + 1; row != rows->end(); ++row)
            ++segmentsOfName[row->value(segment)];
        for (auto row = rows->begin() + 1; row != rows->end(); ++row) {
            QString about = row->value(segment);
            if (segmentsOfName.value(about) > 1)
                about += QStringLiteral(" (%1)").arg(row->value(label));
            for (qsizetype i = first; i < std::min(columns.size(), row->size()); ++i)
                numbers[about + QLatin1Char(' ') + columns[i]] = (*row)[i];
        }
    }
    return numbers;
}

} // namespace

QByteArray resultsTable(const std::vector<StudyTask>& tasks)
{
    struct Line {
        QJsonObject record;
        QMap<QString, QString> numbers;
    };
    std::vector<Line> lines;
    QMap<QString, bool> columns;
    for (const StudyTask& task : tasks) {
        Line line{StudyResults::record(task.folder), {}};
        if (line.record.value(QStringLiteral("state")).toString() == QLatin1String("done")) {
            // What the batch refuses to take for its own is nothing to count with.
            if (const QString why = whyOther(task, line.record); !why.isEmpty())
                line.record = {{QStringLiteral("state"), QStringLiteral("other")},
                    {QStringLiteral("failure"), why}};
            else
                line.numbers = numbersOf(line.record, task.folder);
        }
        for (auto number = line.numbers.constBegin(); number != line.numbers.constEnd(); ++number)
            columns[number.key()] = true;
        lines.push_back(std::move(line));
    }
    QByteArray text = QByteArray(firstColumns) + "stateHash,seconds,attempts,failure";
    for (auto column = columns.constBegin(); column != columns.constEnd(); ++column)
        text += ',' + cell(column.key());
    text += "\r\n";
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const QJsonObject& record = lines[i].record;
        const auto word = [&record](const char* key) {
            return cell(record.value(QLatin1String(key)).toString());
        };
        text += cell(tasks[i].study.name) + ',' + cell(tasks[i].study.path) + ','
            + (record.isEmpty() ? QByteArray("waiting") : word("state")) + ',' + word("stateHash");
        // A record of an earlier version counts only the attempts of its last start.
        const QJsonValue attempts = record.value(QStringLiteral("attempts"));
        const QJsonValue inAll = record.value(QStringLiteral("attemptsInAll"));
        for (const QJsonValue& value :
            {record.value(QStringLiteral("seconds")), inAll.isDouble() ? inAll : attempts})
            text += ',' + (value.isDouble() ? QByteArray::number(value.toDouble()) : QByteArray());
        text += ',' + word("failure");
        // A number is written as it stands, minus sign and all.
        for (auto column = columns.constBegin(); column != columns.constEnd(); ++column)
            text += ',' + lines[i].numbers.value(column.key()).toUtf8();
        text += "\r\n";
    }
    return text;
}

bool isResultsTable(const QByteArray& text)
{
    return text.startsWith(firstColumns);
}

} // namespace app
