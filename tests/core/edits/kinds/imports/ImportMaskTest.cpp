// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/masks/ReadImport.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace importMaskTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(40, 36, 34); // of the small study

VoxelRuns boxOf(const glm::ivec3& from, const glm::ivec3& to)
{
    return test::runsOfBox({from, to}, size);
}

/// Two boxes that share the voxels with x = 10 … 14.
ImportMask twoBoxes()
{
    ImportMask mask{.file = QStringLiteral("organs.seg.nrrd")};
    mask.size = size;
    mask.segments = {
        {.name = QStringLiteral("Liver"),
            .rgb = 0x804020,
            .code = {QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")},
            .voxels = packedRuns(boxOf({2, 3, 4}, {15, 9, 8}))},
        {.name = QStringLiteral("Rest"),
            .rgb = 0x102030,
            .code = {},
            .voxels = packedRuns(boxOf({10, 3, 4}, {20, 9, 8}))}};
    return mask;
}

ImportMask as(ImportMask mask, int number)
{
    mask.as = SegmentWord{.number = number, .name = {}};
    return mask;
}

ImportMask as(ImportMask mask, const char* name)
{
    mask.as = SegmentWord{.number = {}, .name = QString::fromLatin1(name)};
    return mask;
}

struct Bench : test::SessionBench {
    explicit Bench(const QString& file = {})
        : SessionBench(false, test::smallStudy(), file)
    {
    }
    [[nodiscard]] const std::vector<Segment>& segments() const
    {
        return session->document().segments;
    }
};

} // namespace

class ImportMaskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void newSegments()
    {
        Bench bench;
        QCOMPARE(bench.tried(twoBoxes()), QString());
        QCOMPARE(bench.session->history().rows().back().name,
            QStringLiteral("Import 2 segments of organs.seg.nrrd, 0.648 mL"));
        QCOMPARE(bench.segments().size(), std::size_t(2));
        QCOMPARE(bench.segments()[0].name, QStringLiteral("Liver"));
        QCOMPARE(bench.segments()[0].code.value, QStringLiteral("10200004"));
        QCOMPARE(bench.segments()[1].rgb, 0x102030U);
        // Where they overlap the first has it.
        QCOMPARE(bench.voxels(1), std::int64_t(13 * 6 * 4));
        QCOMPARE(bench.voxels(2), std::int64_t(5 * 6 * 4));
        QCOMPARE(bench.segments()[1].voxels, std::int64_t(5 * 6 * 4));
        const QByteArray after = bench.session->stateHash();
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.segments().size(), std::size_t(0));
        QCOMPARE(bench.voxels(1), std::int64_t(0));
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), after);
    }

    /// Where segments of the file overlap, those that are named ahead have the voxels.
    void theSecondGoesBeforeTheFirst()
    {
        Bench bench;
        ImportMask mask = twoBoxes();
        mask.ahead = std::vector<int>{2};
        QCOMPARE(bench.tried(mask), QString());
        QCOMPARE(bench.voxels(1), std::int64_t(8 * 6 * 4));
        QCOMPARE(bench.voxels(2), std::int64_t(10 * 6 * 4));
        QCOMPARE(bench.segments()[0].name, QStringLiteral("Liver")); // numbers are the file's
        QCOMPARE(bench.session->history().rows().back().name,
            QStringLiteral("Import 2 segments of organs.seg.nrrd, 0.648 mL"));
        const QByteArray after = bench.session->stateHash();
        Bench anew;
        const Result<Edit> again =
            editFromJson(editToJson(bench.session->history().rows().back().edit));
        QVERIFY(again);
        QCOMPARE(anew.tried(*again), QString());
        QCOMPARE(anew.session->stateHash(), after);
        Bench plain;
        QCOMPARE(plain.tried(twoBoxes()), QString());
        QVERIFY(plain.session->stateHash() != after);
        mask.ahead = std::vector<int>{1, 3};
        QVERIFY(plain.tried(mask).contains(QStringLiteral("importMask.ahead")));
        QCOMPARE(plain.rows().size(), std::size_t(1));
    }

    void intoASegment()
    {
        Bench bench;
        QCOMPARE(bench.tried(test::newSegment(QStringLiteral("All"), 1)), QString());
        QCOMPARE(bench.tried(as(twoBoxes(), 1)), QString());
        QCOMPARE(bench.session->history().rows().back().name,
            QStringLiteral("Import 2 segments of organs.seg.nrrd as 'All', 0.648 mL"));
        QCOMPARE(bench.voxels(1), std::int64_t(18 * 6 * 4));
        QCOMPARE(bench.segments().size(), std::size_t(1));
        // A name that is there is that segment; one that is not is made.
        QCOMPARE(bench.tried(as(twoBoxes(), "All")), QString());
        QCOMPARE(bench.rows().size(), std::size_t(2)); // it has all of it already
        ImportMask higher = twoBoxes();
        higher.segments = {{.name = QStringLiteral("Low"),
            .rgb = 7,
            .code = {},
            .voxels = packedRuns(boxOf({0, 0, 20}, {3, 3, 22}))}};
        QCOMPARE(bench.tried(as(higher, "Made")), QString());
        QCOMPARE(bench.segments().back().name, QStringLiteral("Made"));
        QCOMPARE(bench.voxels(2), std::int64_t(18));
    }

    void othersKeepTheirVoxels()
    {
        Bench bench;
        QCOMPARE(bench.tried(twoBoxes()), QString());
        ImportMask again = twoBoxes();
        std::reverse(again.segments->begin(), again.segments->end());
        QCOMPARE(bench.tried(again), QString());
        QCOMPARE(bench.rows().size(), std::size_t(1)); // no voxel was free: no segment came of it
        QCOMPARE(bench.segments().size(), std::size_t(2));
        QCOMPARE(bench.tried(test::lockSegment(1)), QString());
        again.overwriteUnlocked = true;
        QCOMPARE(bench.tried(again), QString());
        QCOMPARE(bench.voxels(1), std::int64_t(13 * 6 * 4)); // locked
        QCOMPARE(bench.voxels(2), std::int64_t(0));
        QCOMPARE(bench.voxels(3), std::int64_t(5 * 6 * 4));
        QVERIFY(!bench.tried(as(twoBoxes(), 1)).isEmpty());
    }

    void refusals()
    {
        Bench bench;
        QVERIFY(bench.tried(ImportMask{.file = QStringLiteral("a.nii")})
                    .contains(QStringLiteral("its file has not been read")));
        ImportMask other = twoBoxes();
        other.size = glm::ivec3(40, 36, 33);
        QVERIFY(bench.tried(other).contains(QStringLiteral("importMask.size")));
        QVERIFY(!bench.tried(as(twoBoxes(), 9)).isEmpty());
        ImportMask damaged = twoBoxes();
        damaged.segments->back().voxels.chop(3);
        QVERIFY(bench.tried(damaged).contains(QStringLiteral("its voxels are damaged")));
        ImportMask beyond = twoBoxes();
        VoxelRuns far;
        far.append(40 * 36 * 34 - 1, 2);
        beyond.segments->back().voxels = packedRuns(far);
        QVERIFY(bench.tried(beyond).contains(QStringLiteral("its voxels are damaged")));
        QCOMPARE(bench.rows().size(), std::size_t(0));
        QCOMPARE(bench.tried(twoBoxes()), QString()); // and all goes on
    }

    void theFormOfRecipes()
    {
        const Edit edit = as(twoBoxes(), "All");
        const Result<Edit> again = editFromJson(editToJson(edit));
        QVERIFY(again);
        QCOMPARE(editToJson(quantised(*again)), editToJson(edit));
        for (const char* wrong :
            {"{\"edit\":\"importMask\"}", "{\"edit\":\"importMask\",\"file\":\"a\",\"as\":0}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"as\":\"\"}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"size\":[1,2]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"segments\":[]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"ahead\":[]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"ahead\":[0]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"ahead\":[256]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"ahead\":[2,1,2]}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"ahead\":2}",
                "{\"edit\":\"importMask\",\"file\":\"a\",\"segments\":[{\"name\":\"A\",\"color\":"
                "\"#000000\",\"code\":[],\"voxels\":\"&\"}]}"})
            QVERIFY2(!editFromJson(QJsonDocument::fromJson(wrong).object()), wrong);
    }

    /// What a session holds needs no file.
    void theFileMayGo()
    {
        QTemporaryDir folder;
        const Volume volume = test::smallStudy().volume;
        const QString file = folder.filePath(QStringLiteral("part.nrrd"));
        writeMask(file, volume.geometry);
        const Result<ReadImport> read = readImport(ImportMask{.file = file}, volume, 0, {});
        QVERIFY(read);
        QVERIFY(read->notes.empty());
        QCOMPARE(read->edit.file, QStringLiteral("part.nrrd")); // no folder of the user's
        const QString sessionFile = folder.filePath(QStringLiteral("a.burin"));
        QByteArray hash;
        {
            Bench bench(sessionFile);
            QCOMPARE(bench.tried(read->edit), QString());
            QCOMPARE(bench.voxels(1), std::int64_t(4 * 3 * 2));
            QCOMPARE(bench.voxels(2), std::int64_t(3 * 2));
            hash = bench.session->stateHash();
        }
        QVERIFY(QFile::remove(file));
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), sessionFile);
        QVERIFY(opened);
        QCOMPARE((*opened)->stateHash(), hash);
        // Carried out again from what the row holds.
        Bench anew;
        QCOMPARE(anew.tried((*opened)->history().rows().front().edit), QString());
        QCOMPARE(anew.session->stateHash(), hash);
    }

    void recipesReadTheirFiles()
    {
        QTemporaryDir folder;
        const Volume volume = test::smallStudy().volume;
        writeMask(folder.filePath(QStringLiteral("part.nrrd")), volume.geometry);
        const QString path = folder.filePath(QStringLiteral("recipe.json"));
        const auto write = [&path](const QByteArray& text) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        write(R"({"edits": [{"edit": "importMask", "file": "part.nrrd", "as": "Part"}],
                 "export": [{"format": "dicom-seg", "file": "a.dcm"}]})");
        Result<Recipe> recipe = readRecipe(path);
        QVERIFY(recipe);
        QCOMPARE(masksOf(*recipe),
            (QStringList{
                QStringLiteral("part.nrrd"), folder.filePath(QStringLiteral("part.nrrd"))}));
        const auto notes = readMasks(*recipe, volume);
        QVERIFY(notes);
        QCOMPARE(masksOf(*recipe), QStringList()); // the edit holds what the file held
        const auto& mask = std::get<Edit>(recipe->steps.front()).get<ImportMask>();
        QCOMPARE(mask.segments->size(), std::size_t(2));
        QVERIFY(checkAgainst(initialDocument(volume), Edit(mask)));
        write(
            R"({"edits": [{"edit": "importMask", "file": ")" + folder.path().toUtf8() + R"("}]})");
        const Result<Recipe> ofFolder = readRecipe(path);
        QVERIFY(
            ofFolder && masksOf(*ofFolder).contains(folder.filePath(QStringLiteral("part.nrrd"))));
        write(R"({"edits": [{"edit": "importMask", "file": "gone.nrrd"}]})");
        recipe = readRecipe(path);
        QCOMPARE(readMasks(*recipe, volume).error().code, ErrorCode::FileNotFound);
    }

private:
    /// Label 1 in a box of 4 × 3 × 2, label 9 in its slice of x = 5.
    static void writeMask(const QString& path, const VolumeGeometry& geometry)
    {
        QByteArray bytes = "NRRD0004\ntype: uchar\nencoding: raw\nspace: left-posterior-superior\n"
                           "dimension: 3\nsizes: 40 36 34\nspace directions:";
        const auto vector = [](const glm::dvec4& part) {
            return QStringLiteral(" (%1,%2,%3)")
                .arg(part.x, 0, 'g', 17)
                .arg(part.y, 0, 'g', 17)
                .arg(part.z, 0, 'g', 17)
                .toLatin1();
        };
        for (int axis = 0; axis < 3; ++axis)
            bytes += vector(geometry.indexToWorld[axis]);
        bytes += "\nspace origin:" + vector(geometry.indexToWorld[3]) + "\n\n";
        QByteArray voxels(qsizetype(size.x) * size.y * size.z, '\0');
        for (int z = 3; z < 5; ++z) {
            for (int y = 2; y < 5; ++y) {
                for (int x = 1; x < 6; ++x)
                    voxels[(z * size.y + y) * size.x + x] = x == 5 ? 9 : 1;
            }
        }
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes + voxels);
    }
};

BURIN_TEST(ImportMaskTest)

} // namespace importMaskTest

#include "ImportMaskTest.moc"
