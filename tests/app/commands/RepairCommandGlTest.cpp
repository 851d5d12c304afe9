// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/defective/DefectiveSeries.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace repairCommandGlTest {

using test::burin;
using test::key;
using test::Outcome;
using test::toJson;

/// Repairs on the command line: listed, chosen, kept by session and recipe, written in exports.
class RepairCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    [[nodiscard]] QJsonObject info(const QStringList& more = {}) const
    {
        const Outcome outcome = burin(QStringList{key("info"), path("ct"), key("--json")} + more);
        return QJsonDocument::fromJson(outcome.output)
            .object()[key("studies")][0][key("series")][0]
            .toObject();
    }
    [[nodiscard]] static QJsonArray growth()
    {
        QJsonArray points;
        points.append(QJsonArray{0, -5, 50});
        return {QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Low")},
                    {key("color"), key("#336699")},
                    {key("code"), QJsonArray{key("SCT"), key("89546000"), key("Skull")}}},
            QJsonObject{
                {key("edit"), key("seed")}, {key("segment"), 1}, {key("pointsLps"), points}},
            QJsonObject{{key("edit"), key("grow")}, {key("lower"), -1000}, {key("upper"), -700},
                {key("connectivity"), 6}, {key("steps"), key("toClosure")}}};
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
        test::writeSeries(test::tiltedSeries(0.5), path("ct"));
    }

    void infoListsFindingsAndRepairs()
    {
        QVERIFY(QFile::remove(path("ct/") + test::SyntheticSeries::shuffledName(4)));
        const QJsonObject series = info();
        const QJsonArray findings = series[key("findings")].toArray();
        QCOMPARE(findings.size(), 2);
        const QJsonObject gap = findings[0].toObject();
        QCOMPARE(gap[key("slices")][0].toArray(), (QJsonArray{4, 5}));
        QCOMPARE(gap[key("repairs")][0][key("repair")].toString(), key("gap=fill"));
        QCOMPARE(gap[key("repairs")][0][key("size")].toArray(), (QJsonArray{24, 18, 10}));
        QCOMPARE(gap[key("repairs")][2][key("repair")].toString(), key("gap=split:2"));
        QCOMPARE(findings[1][key("repairs")][0][key("repair")].toString(), key("tilt"));
        QVERIFY(!series.contains(key("repair")));

        const QJsonObject repaired = info({key("--repair"), key("tilt,gap=fill")});
        QCOMPARE(repaired[key("repair")].toString(), key("gap=fill,tilt"));
        QCOMPARE(repaired[key("size")].toArray(), (QJsonArray{24, 22, 10}));
        for (const QJsonValue& finding : repaired[key("findings")].toArray())
            QVERIFY(!finding[key("repairedBy")].toString().isEmpty());

        const Outcome text = burin({key("info"), path("ct")});
        QVERIFY2(text.output.contains("--repair gap=fill"), text.output.constData());
    }

    void wrongWordsAreWrongArguments()
    {
        const QStringList mends{key("--repair"), key("mend")};
        for (const QStringList& words : {QStringList{key("info"), path("ct")},
                 QStringList{key("run"), path("x.json"), key("--study"), path("ct"),
                     key("--session"), path("x.burin")},
                 QStringList{
                     key("compare"), path("a.nii"), path("b.nii"), key("--study"), path("ct")},
                 QStringList{key("mesh"), path("a.nii"), key("--study"), path("ct"), key("--out"),
                     path("a.ply")}}) {
            const Outcome mend = burin(words + mends);
            QCOMPARE(mend.status, 2);
            QVERIFY2(mend.output.isEmpty(), mend.output.constData());
            QVERIFY2(mend.complaint.contains(key("--repair: 'mend' is no repair")),
                qPrintable(mend.complaint));
        }
    }

    void whatTheSeriesDoesNotNeedIsSaidOfIt()
    {
        const Outcome outcome =
            burin({key("info"), path("ct"), key("--spacing"), key("0.5,0.5,2")});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.startsWith(
                     QStringLiteral("burin: %1: the series itself says").arg(path("ct"))),
            qPrintable(outcome.complaint));
    }

    void sessionAndRecipeKeepTheRepair()
    {
        const QJsonArray exports{
            QJsonObject{{key("format"), key("dicom-seg")}, {key("file"), path("low.dcm")}}};
        const QString made =
            recipe("make.json", {{key("edits"), growth()}, {key("export"), exports}});
        const Outcome first = burin({key("run"), made, key("--study"), path("ct"), key("--repair"),
            key("tilt"), key("--session"), path("s.burin")});
        QVERIFY2(first.status == 0, qPrintable(first.complaint));
        QVERIFY2(first.complaint.contains(key("Repaired: tilt")), qPrintable(first.complaint));
        const auto seg = core::readSeg(path("low.dcm"));
        QVERIFY(seg);
        QCOMPARE(seg->rows, 18);

        const Outcome replayed = burin({key("replay"), path("s.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const Outcome appended =
            burin({key("run"), recipe("more.json", {{key("edits"), QJsonArray{}}}), key("--append"),
                key("--session"), path("s.burin")});
        QVERIFY2(appended.status == 0, qPrintable(appended.complaint));
        const Outcome other = burin({key("run"), made, key("--append"), key("--repair"),
            key("none"), key("--session"), path("s.burin")});
        QCOMPARE(other.status, 2);

        // A recipe knows it, too.
        const QString again = recipeOf("s.burin", "again.json");
        const Outcome second = burin(
            {key("run"), again, key("--study"), path("ct"), key("--session"), path("again.burin")});
        QVERIFY2(second.status == 0, qPrintable(second.complaint));
        QVERIFY(!lastHash("s.burin").isEmpty());
        QCOMPARE(lastHash("again.burin"), lastHash("s.burin"));
        const Outcome asIs = burin({key("run"), again, key("--study"), path("ct"), key("--repair"),
            key("none"), key("--session"), path("asis.burin")});
        QCOMPARE(asIs.status, 1);
        QVERIFY2(asIs.complaint.contains(key("repaired otherwise")), qPrintable(asIs.complaint));
    }
};

BURIN_TEST(RepairCommandGlTest)

} // namespace repairCommandGlTest

#include "RepairCommandGlTest.moc"
