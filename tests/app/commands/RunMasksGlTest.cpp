// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOnVolume.h"
#include "core/nrrd/NrrdWriter.h"
#include "core/sessionfile/SessionFile.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
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

    void nothingToExportIsSaid()
    {
        const Outcome outcome =
            run(recipe("empty.json",
                    {{key("edits"), toJson({test::addSegment("A")})},
                        {key("export"), QJsonArray{exportTo("nifti", "none.nii.gz")}}}),
                "a.burin");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("none.nii.gz: nothing to export: no segment that "
                                                "is shown has a voxel")),
            qPrintable(outcome.complaint));
        QVERIFY(!QFile::exists(path("none.nii.gz")));
    }

    void codesOfNobodyAreRefused()
    {
        QJsonObject target = exportTo("seg-nrrd", "coded.seg.nrrd");
        target[key("codes")] = QJsonObject{{key("Nobody"),
            QJsonObject{{key("region"), QJsonArray{key("SCT"), key("64033007"), key("Kidney")}}}}};
        const Outcome outcome = run(
            recipe("coded.json",
                {{key("edits"), toJson(test::manyEdits())}, {key("export"), QJsonArray{target}}}),
            "a.burin");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("coded.seg.nrrd: "))
                && outcome.complaint.contains(key("'Nobody'")),
            qPrintable(outcome.complaint));
    }

    /// A mask that lacks one of a session's segments is not written without a word.
    void whatIsHiddenIsLeftOutAndTold()
    {
        const QString made = recipe("made.json",
            {{key("edits"),
                toJson({test::addSegment("Bone"), test::addSegment("Brain"),
                    test::thresholdOf(1, 900.0, 1100.0), test::thresholdOf(2, 0.0, 100.0)})}});
        QCOMPARE(run(made, "a.burin").status, 0);
        {
            const auto file = SessionFile::open(path("a.burin"), SessionFile::Access::ReadWrite);
            QVERIFY(file);
            (*file)->setHiddenSegments({1});
            QVERIFY((*file)->flush());
        }
        const Outcome outcome = burin({key("run"),
            recipe("export.json",
                {{key("edits"), QJsonArray()},
                    {key("export"), QJsonArray{exportTo("nifti", "out.nii.gz")}}}),
            key("--session"), path("a.burin"), key("--append")});
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY2(outcome.complaint.contains(
                     key("out.nii.gz: left out, as the session hides them: Bone")),
            qPrintable(outcome.complaint));
        const QString written = outcome.lines.last()[key("written")].toString();
        QVERIFY2(written.contains(key("2 Brain")) && !written.contains(key("Bone")),
            qPrintable(written));
    }

    /// Names are not unique: none of those that have it is left without.
    void codesOfSegmentsThatShareAName()
    {
        const QJsonObject cyst{{key("edit"), key("addSegment")}, {key("name"), key("Cyst")},
            {key("color"), key("#e8dcc0")},
            {key("code"), QJsonArray{key("SCT"), key("367643001"), key("Cyst")}}};
        QJsonArray edits{cyst, cyst};
        for (const QJsonValue& edit :
            toJson({test::thresholdOf(1, 900.0, 1100.0), test::thresholdOf(2, 0.0, 100.0)}))
            edits.append(edit);
        QJsonObject target = exportTo("seg-nrrd", "coded.seg.nrrd");
        target[key("codes")] = QJsonObject{{key("Cyst"),
            QJsonObject{{key("region"), QJsonArray{key("SCT"), key("64033007"), key("Kidney")}}}}};
        const Outcome outcome =
            run(recipe("coded.json", {{key("edits"), edits}, {key("export"), QJsonArray{target}}}),
                "a.burin");
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QCOMPARE(test::bytesOf(path("coded.seg.nrrd")).count("SCT^64033007^Kidney"), 2);
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

    /// Segments that overlap, through a session, a replay of it and a .seg.nrrd.
    void overlapsComeBackAsTheyWere()
    {
        const Result<LoadedVolume> loaded = loadVolume(study());
        QVERIFY(loaded);
        const VolumeGeometry& geometry = loaded->volume.geometry;
        const std::size_t slice = std::size_t(geometry.size.x) * std::size_t(geometry.size.y);
        std::vector<std::uint8_t> layers(2 * geometry.voxelCount(), 0);
        for (std::size_t voxel = 0; voxel < geometry.voxelCount(); ++voxel) {
            const std::size_t k = voxel / slice;
            layers[2 * voxel] = k >= 2 && k < 6 ? 1 : 0;
            layers[2 * voxel + 1] = k >= 4 && k < 9 ? 1 : 0;
        }
        QVERIFY(writeNrrdAt(path("two.seg.nrrd"),
            {.geometry = geometry,
                .voxels = layers,
                .keyValues = {{"Segment0_ID", "a"}, {"Segment0_Name", "Low"},
                    {"Segment0_LabelValue", "1"}, {"Segment0_Layer", "0"}, {"Segment1_ID", "b"},
                    {"Segment1_Name", "High"}, {"Segment1_LabelValue", "1"},
                    {"Segment1_Layer", "1"}},
                .layers = 2}));
        const QJsonObject import{
            {key("edit"), key("importMask")}, {key("file"), path("two.seg.nrrd")}};
        const Outcome taken =
            run(recipe("take.json",
                    {{key("edits"), QJsonArray{import}},
                        {key("export"), QJsonArray{exportTo("seg-nrrd", "out.seg.nrrd")}}}),
                "a.burin");
        QVERIFY2(taken.status == 0, qPrintable(taken.complaint));
        const Result<MaskOnVolume> first = readMask(path("two.seg.nrrd"), loaded->volume, {});
        const Result<MaskOnVolume> second = readMask(path("out.seg.nrrd"), loaded->volume, {});
        QVERIFY(first && second);
        QCOMPARE(core::voxelsOf(first->overlaps), std::uint64_t(2 * slice));
        QCOMPARE(second->overlaps, first->overlaps);
        QCOMPARE(second->segments.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(second->segments[i].name, first->segments[i].name);
            QCOMPARE(second->segments[i].voxels, first->segments[i].voxels);
        }
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        // One map cannot hold both.
        const Outcome refused =
            run(recipe("map.json",
                    {{key("edits"), QJsonArray{import}},
                        {key("export"), QJsonArray{exportTo("nifti", "map.nii.gz")}}}),
                "b.burin");
        QVERIFY(refused.status != 0);
        QVERIFY2(refused.complaint.contains(key("'Low' and 'High' overlap in")),
            qPrintable(refused.complaint));
        QVERIFY(!QFile::exists(path("map.nii.gz")));
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
