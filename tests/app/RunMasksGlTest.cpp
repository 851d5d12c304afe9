// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace runMasksGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;
using test::toJson;

/// `burin run` with masks of other programs.
class RunMasksGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    [[nodiscard]] QJsonObject exportTo(const char* format, const char* file) const
    {
        return {{key("format"), key(format)}, {key("file"), path(file)}};
    }
    [[nodiscard]] QByteArray voxelsOf(const char* file) const
    {
        const Result<LoadedVolume> loaded = loadVolume(path(file));
        return loaded ? loaded->volume.voxelsSha256 : QByteArray();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void whatWasExportedComesBackAsItWas_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow(".seg.nrrd") << key("out.seg.nrrd");
        QTest::newRow("NIfTI") << key("out.nii.gz");
    }
    void whatWasExportedComesBackAsItWas()
    {
        QFETCH(QString, file);
        const QJsonArray exports{
            exportTo("nifti", "out.nii.gz"), exportTo("seg-nrrd", "out.seg.nrrd")};
        const Outcome made =
            run(recipe("make.json",
                    {{key("edits"), toJson(test::manyEdits())}, {key("export"), exports}}),
                "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const QByteArray voxels = voxelsOf("out.nii.gz");
        QVERIFY(!voxels.isEmpty());

        // Beside the recipe, without its folder.
        const QJsonObject import{{key("edit"), key("importMask")}, {key("file"), file}};
        const Outcome taken =
            run(recipe("take.json",
                    {{key("edits"), QJsonArray{import}},
                        {key("export"), QJsonArray{exportTo("nifti", "back.nii.gz")}}}),
                "b.burin");
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        QCOMPARE(voxelsOf("back.nii.gz"), voxels);
        QCOMPARE(taken.lines.first()[key("edit")].toString(), key("importMask"));

        // The session needs the file no more.
        QVERIFY(QFile::remove(path(qPrintable(file))));
        const Outcome replayed = burin({key("replay"), path("b.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const QString again = recipeOf("b.burin", "again.json");
        const Outcome repeated = run(again, "c.burin");
        QVERIFY2(repeated.status == 0, qPrintable(repeated.complaint));
        QVERIFY(!lastHash("b.burin").isEmpty());
        QCOMPARE(lastHash("c.burin"), lastHash("b.burin"));
    }

    void aNamedSegmentReceivesAll()
    {
        const QJsonArray exports{exportTo("seg-nrrd", "out.seg.nrrd")};
        QCOMPARE(run(recipe("make.json",
                         {{key("edits"), toJson(test::manyEdits())}, {key("export"), exports}}),
                     "a.burin")
                     .status,
            0);
        const QJsonObject import{{key("edit"), key("importMask")},
            {key("file"), path("out.seg.nrrd")}, {key("as"), key("Head")}};
        const Outcome taken =
            run(recipe("take.json",
                    {{key("edits"), QJsonArray{import}},
                        {key("export"), QJsonArray{exportTo("nifti", "head.nii.gz")}}}),
                "b.burin");
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        QVERIFY2(taken.lines.first()[key("name")].toString().contains(key("Head")),
            qPrintable(taken.lines.first()[key("name")].toString()));
        const Result<LoadedVolume> head = loadVolume(path("head.nii.gz"));
        QVERIFY(head);
        QCOMPARE(head->volume.minimum, 0.0);
        QCOMPARE(head->volume.maximum, 1.0);
    }

    void aFileThatIsNoMaskIsNamedWithTheReason()
    {
        const QJsonObject import{{key("edit"), key("importMask")}, {key("file"), path("no.nii")}};
        QFile file(path("no.nii"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("nothing of a mask") > 0);
        file.close();
        const Outcome outcome =
            run(recipe("take.json", {{key("edits"), QJsonArray{import}}}), "b.burin");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("no.nii")), qPrintable(outcome.complaint));
        QVERIFY(!QFile::exists(path("b.burin")));
    }
};

BURIN_TEST(RunMasksGlTest)

} // namespace runMasksGlTest

#include "RunMasksGlTest.moc"
