// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/defective/HostileStudy.h"
#include "tests/support/program/FileBytes.h"

#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/defective/HostileDicom.h"
#include "tests/support/servers/Python.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace test {

namespace {

/// A small image of a series of its own.
QByteArray honestImage()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.size = {16, 12, 1};
    series.seriesUid = QStringLiteral("2.25.666");
    return bytesOf(writeSeries(series, folder.path()).front());
}

} // namespace

std::vector<HostileFile> hostileFiles()
{
    std::vector<HostileFile> all;
    for (const auto& kind : {hostileDicoms(honestImage()), hiddenNests()}) {
        for (const HostileDicom& hostile : kind)
            all.push_back({QString::fromUtf8(hostile.name), hostile.bytes});
    }
    all.push_back({QStringLiteral("bomb in an image"), deflatedBomb(12, 16)});
    return all;
}

QString honestSeriesUid()
{
    return SyntheticSeries().seriesUid;
}

QStringList writeHonestSeries(const QString& folder)
{
    SyntheticSeries series;
    series.size.z = honestSlices;
    series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.70");
    return writeSeries(series, folder);
}

WatchedRun watchedBurin(const QStringList& arguments)
{
    const ScriptOutput watched = runScript(QStringLiteral("watched.py"),
        QStringList{QString::number(hangsAfter.count()), QStringLiteral(BURIN_PROGRAM)}
            + arguments);
    const QJsonObject told = QJsonDocument::fromJson(watched.output).object();
    return {.hung = told[QStringLiteral("hung")].toBool(true),
        .status = told[QStringLiteral("status")].toInt(-1),
        .cpuSeconds = told[QStringLiteral("seconds")].toDouble(),
        .peakKb = long(told[QStringLiteral("kb")].toDouble()),
        .output = told[QStringLiteral("out")].toString().toUtf8(),
        .complaint = told[QStringLiteral("errors")].toString()};
}

} // namespace test
