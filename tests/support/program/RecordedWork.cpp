// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/RecordedWork.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <map>

namespace test {

namespace {

using Recorded = std::map<QByteArray, std::map<QByteArray, std::int64_t>>; ///< step, count

Recorded recordedIn(const QByteArray& text)
{
    Recorded recorded;
    for (const QByteArray& line : text.split('\n')) {
        const QList<QByteArray> parts = line.split('|');
        if (parts.size() < 2)
            continue;
        auto& counts = recorded[parts.front().trimmed()];
        for (const QByteArray& part : parts.mid(1)) {
            const QByteArray told = part.trimmed();
            const qsizetype space = told.lastIndexOf(' ');
            counts[told.left(space)] = told.mid(space + 1).toLongLong();
        }
    }
    return recorded;
}

} // namespace

QByteArray recordOf(const std::vector<CountedStep>& steps)
{
    QByteArray text;
    for (const CountedStep& step : steps) {
        text += step.name;
        for (const auto& [what, count] : step.counts)
            text += " | " + what + ' ' + QByteArray::number(qlonglong(count));
        text += '\n';
    }
    return text;
}

QStringList grownSince(const QByteArray& record, const std::vector<CountedStep>& steps)
{
    Recorded recorded = recordedIn(record);
    QStringList grown;
    for (const CountedStep& step : steps) {
        const auto before = recorded.find(step.name);
        if (before == recorded.end()) {
            grown += QStringLiteral("%1 is not recorded").arg(QString::fromUtf8(step.name));
            continue;
        }
        for (const auto& [what, count] : step.counts) {
            const auto most = before->second.find(what);
            if (most == before->second.end() || count > most->second)
                grown += QStringLiteral("%1: %2 %3, recorded were %4")
                             .arg(QString::fromUtf8(step.name))
                             .arg(qlonglong(count))
                             .arg(QString::fromUtf8(what))
                             .arg(most == before->second.end() ? QStringLiteral("none")
                                                               : QString::number(most->second));
        }
        recorded.erase(before);
    }
    for (const auto& [name, counts] : recorded)
        grown += QStringLiteral("%1 is recorded, and no step").arg(QString::fromUtf8(name));
    return grown;
}

QStringList grownSinceRecorded(const QString& file, const std::vector<CountedStep>& steps)
{
    QFile record(QStringLiteral(BURIN_TEST_DATA_DIR "/work/") + file);
    if (qEnvironmentVariableIsSet("BURIN_RECORD_WORK")) {
        if (!QDir().mkpath(QFileInfo(record).path()) || !record.open(QIODevice::WriteOnly)
            || record.write(recordOf(steps)) < 0)
            qFatal("cannot write %s", qUtf8Printable(record.fileName()));
        return {};
    }
    if (!record.open(QIODevice::ReadOnly))
        return {QStringLiteral("there is no %1; packaging/bench.sh --smoke --record writes it")
                    .arg(record.fileName())};
    return grownSince(record.readAll(), steps);
}

TooMuch::TooMuch(const QByteArray& step, const char* where)
    : m_step(step)
    , m_where(where)
{
}

void TooMuch::demand(const char* what, std::int64_t found, std::int64_t most)
{
    if (found > most)
        m_sentences += QStringLiteral("%1 in %2: %3 %4, at most %5 are right")
                           .arg(QLatin1String(m_step), QLatin1String(m_where))
                           .arg(qlonglong(found))
                           .arg(QLatin1String(what))
                           .arg(qlonglong(most));
}

} // namespace test
