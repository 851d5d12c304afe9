// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace replayCommandGlTest {

using namespace core;
using test::burin;
using test::goTo;
using test::key;
using test::Outcome;
using test::toJson;

/// `burin replay`.
class ReplayCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    /// The values of an exported file; empty if it cannot be read.
    [[nodiscard]] std::vector<std::uint16_t> voxels(const char* file) const
    {
        const Result<LoadedVolume> volume = loadVolume(path(file));
        return volume ? volume->codes : std::vector<std::uint16_t>();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void replayExportsAPastState()
    {
        QJsonArray steps = toJson(test::manyEdits());
        steps.append(goTo(4));
        QCOMPARE(run(recipe("r.json",
                         {{key("edits"), steps},
                             {key("export"),
                                 QJsonArray{QJsonObject{{key("format"), key("nifti")},
                                     {key("file"), path("at4.nii.gz")}}}}}),
                     "a.burin")
                     .status,
            0);
        const auto exported = [this](const char* row, const char* file) {
            return burin({key("replay"), path("a.burin"), key("--to"), key(row), key("--export"),
                path(file)});
        };
        const Outcome fourth = exported("4", "replayed4.nii.gz");
        QVERIFY2(fourth.status == 0, qPrintable(fourth.complaint));
        QCOMPARE(exported("10", "replayed10.nii.gz").status, 0);
        QVERIFY(!voxels("at4.nii.gz").empty());
        QCOMPARE(voxels("replayed4.nii.gz"), voxels("at4.nii.gz"));
        QVERIFY(voxels("replayed10.nii.gz") != voxels("at4.nii.gz"));
        const Outcome slicer = exported("4", "replayed4.seg.nrrd");
        QVERIFY2(slicer.status == 0, qPrintable(slicer.complaint));
        QVERIFY(slicer.lines.last()[key("written")].toString().contains(key("3D Slicer")));
        QCOMPARE(slicer.lines.last()[key("sha256")].toString().size(), 64);
        QCOMPARE(voxels("replayed4.seg.nrrd"), voxels("at4.nii.gz"));
        // Axes are named as the help names them.
        const Outcome surface = burin({key("replay"), path("a.burin"), key("--export"),
            path("a.stl"), key("--space"), key("ras")});
        QVERIFY2(surface.status == 0, qPrintable(surface.complaint));
        QCOMPARE(exported("4", "replayed4.nrrd").status, 2);
        QCOMPARE(exported("12", "no.nii.gz").status, 2);
        QCOMPARE(exported("4", "replayed4.nii.gz").status, 1); // exists
    }

    /// An export does not make less of the verification: branches, and what is lost.
    void everyRowIsVerifiedBesidesAnExport()
    {
        QJsonArray steps = toJson(test::manyEdits());
        steps.append(goTo(4));
        for (const QJsonValue& each : toJson({test::growBrain(), test::drillAt(3)}))
            steps.append(each);
        steps.append(goTo(4));
        const QJsonObject mask{{key("format"), key("nifti")}, {key("file"), path("at4.nii.gz")}};
        const Outcome made =
            run(recipe("r.json", {{key("edits"), steps}, {key("export"), QJsonArray{mask}}}),
                "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        QVERIFY(test::runSql(
            path("a.burin"), QStringLiteral("UPDATE row SET name='Another' WHERE id=13")));

        const Outcome both = burin({key("replay"), path("a.burin"), key("--verify"),
            key("--export"), path("both.nii.gz")});
        QCOMPARE(both.status, 1); // row 13 is lost
        QList<int> rows;
        for (const QJsonObject& line : both.lines) {
            if (line.contains(key("row")))
                rows += line[key("row")].toInt();
        }
        QCOMPARE(rows, (QList<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
        QVERIFY(!voxels("at4.nii.gz").empty());
        QCOMPARE(voxels("both.nii.gz"), voxels("at4.nii.gz"));

        // Who asks for one state asks for nothing else.
        const Outcome to12 = burin({key("replay"), path("a.burin"), key("--verify"), key("--to"),
            key("12"), key("--export"), path("at12.nii.gz")});
        QVERIFY2(to12.status == 0, qPrintable(to12.complaint));
        QVERIFY(voxels("at12.nii.gz") != voxels("at4.nii.gz"));
        const Outcome only =
            burin({key("replay"), path("a.burin"), key("--export"), path("only.nii.gz")});
        QVERIFY2(only.status == 0, qPrintable(only.complaint));
        QCOMPARE(voxels("only.nii.gz"), voxels("at4.nii.gz"));
    }

    void replayExportsWhatWasCarved()
    {
        const QJsonArray exports{QJsonObject{{key("format"), key("coverage")}, {key("layer"), 1},
                                     {key("file"), path("coverage.nii.gz")}},
            QJsonObject{{key("format"), key("carved-volume")}, {key("file"), path("carved.nii")},
                {key("fill"), -2000}}};
        const QString first = recipe(
            "r.json", {{key("edits"), toJson({test::drillAt(0)})}, {key("export"), exports}});
        QCOMPARE(run(first, "a.burin").status, 0);
        const QString more = recipe("s.json", {{key("edits"), toJson({test::drillAt(5)})}});
        QCOMPARE(run(more, "a.burin", {key("--append")}).status, 0);

        const auto exported = [this](const char* file, const QStringList& words) {
            return burin(
                QStringList{key("replay"), path("a.burin"), key("--export"), path(file)} + words);
        };
        const QStringList coverage{key("--format"), key("coverage"), key("--layer"), key("1")};
        const QStringList carved{
            key("--format"), key("carved-volume"), key("--fill"), key("-2000")};
        const QStringList toFirst{key("--to"), key("1")};
        for (const Outcome& outcome : {exported("coverage1.nii.gz", coverage + toFirst),
                 exported("coverage2.nii", coverage), exported("carved1.nii", carved + toFirst)})
            QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY(!voxels("coverage.nii.gz").empty() && !voxels("carved.nii").empty());
        QCOMPARE(voxels("coverage1.nii.gz"), voxels("coverage.nii.gz"));
        QVERIFY(voxels("coverage2.nii") != voxels("coverage.nii.gz"));
        QCOMPARE(voxels("carved1.nii"), voxels("carved.nii"));

        const auto named = [](const Outcome& outcome, int status, const char* words) {
            return outcome.status == status && outcome.complaint.contains(key(words));
        };
        QVERIFY(named(exported("x.nii", {key("--format"), key("coverage")}), 2, "--layer"));
        QVERIFY(named(exported("x.nii", {key("--format"), key("cover")}), 2, "--format"));
        QVERIFY(named(exported("x.nii", {key("--layer"), key("1")}), 2, "--layer"));
        QVERIFY(named(exported("x.nii", carved + QStringList{key("--layer"), key("1")}), 2,
            "--layer means nothing to --format carved-volume"));
        for (const char* fill : {"nan", "inf", "nothing"})
            QVERIFY(named(exported("x.nii",
                              {key("--format"), key("carved-volume"), key("--fill"), key(fill)}),
                2, "--fill: must be a number"));
        QVERIFY(named(exported("x.dcm", coverage), 1, ".nii"));
        QVERIFY(named(exported("coverage1.nii.gz", coverage), 1, "--force"));
        QVERIFY(
            named(exported("x.nii", {key("--format"), key("coverage"), key("--layer"), key("9")}),
                1, "x.nii: nothing to export: there is no sculpt layer 9"));
        QVERIFY(
            named(burin(QStringList{key("replay"), path("a.burin"), key("--verify")} + coverage), 2,
                "--export"));
    }
};

BURIN_TEST(ReplayCommandGlTest)

} // namespace replayCommandGlTest

#include "ReplayCommandGlTest.moc"
