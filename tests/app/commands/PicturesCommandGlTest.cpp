// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/records/SessionImages.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/OpenedVolume.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace picturesCommandGlTest {

using test::burin;
using test::key;
using test::Outcome;

namespace {

constexpr int side = 24;
constexpr int slices = 12;

} // namespace

/// A folder of pictures on the command line: told of, opened with its spacing, kept by session and
/// recipe, exported in place.
class PicturesCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    /// A bright box in a dark volume, so that growing has something to find.
    void writeSlice(int k, const char* folder = "slices") const
    {
        test::PictureBytes slice{.columns = side, .rows = side, .bits = 8};
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const bool inside =
                    k >= 3 && k < 9 && row >= 8 && row < 16 && column >= 4 && column < 10;
                slice.bytes.append(char(inside ? 200 : 20 + k));
            }
        }
        QFile file(path(folder) + QStringLiteral("/slice%1.png").arg(k + 1));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(test::png(slice));
    }
    [[nodiscard]] QString growth(const char* name) const
    {
        QJsonArray points;
        // In the box: 0.5 × 0.5 × 2 mm from voxel (0, 0, 0).
        points.append(QJsonArray{3.0, 5.5, 10.0});
        return recipe(name,
            {{key("edits"),
                 QJsonArray{QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Box")},
                                {key("color"), key("#336699")}},
                     QJsonObject{{key("edit"), key("seed")}, {key("segment"), 1},
                         {key("pointsLps"), points}},
                     QJsonObject{{key("edit"), key("grow")}, {key("lower"), 150},
                         {key("upper"), 255}, {key("connectivity"), 6},
                         {key("steps"), key("toClosure")}}}},
                {key("export"),
                    QJsonArray{
                        QJsonObject{{key("format"), key("nifti")}, {key("file"), path("box.nii")}},
                        QJsonObject{
                            {key("format"), key("csv")}, {key("file"), path("box.csv")}}}}});
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
        QVERIFY(QDir().mkpath(path("slices")));
        for (int k = 0; k < slices; ++k)
            writeSlice(k);
    }

    void infoTellsThemApart()
    {
        const Outcome without = burin({key("info"), path("slices"), key("--json")});
        QCOMPARE(without.status, 0);
        const QJsonObject series = QJsonDocument::fromJson(without.output)
                                       .object()[key("studies")][0][key("series")][0]
                                       .toObject();
        QCOMPARE(series[key("seriesUid")].toString(), key("slices"));
        QCOMPARE(series[key("size")].toArray(), (QJsonArray{side, side, slices}));
        QVERIFY(!series.contains(key("min")));
        const QString problems =
            QJsonDocument(series[key("problems")].toArray()).toJson(QJsonDocument::Compact);
        QVERIFY2(problems.contains(key("how far apart their voxels are")), qPrintable(problems));
        QVERIFY2(problems.contains(key("columns are taken to run")), qPrintable(problems));

        const Outcome given =
            burin({key("info"), path("slices"), key("--spacing"), key("0.5,0.5,2"), key("--json")});
        QVERIFY2(given.status == 0, qPrintable(given.complaint));
        const QJsonObject placed = QJsonDocument::fromJson(given.output)
                                       .object()[key("studies")][0][key("series")][0]
                                       .toObject();
        QCOMPARE(placed[key("spacingMm")].toArray(), (QJsonArray{0.5, 0.5, 2}));
        QCOMPARE(placed[key("repair")].toString(), key("spacing=0.5x0.5x2"));
        QCOMPARE(placed[key("min")].toDouble(), 20.0);
        QCOMPARE(placed[key("max")].toDouble(), 200.0);
        QCOMPARE(placed[key("voxelsSha256")].toString().size(), 64);
        QCOMPARE(
            placed[key("findings")][0][key("repairedBy")].toString(), key("spacing=0.5x0.5x2"));

        const Outcome wrong =
            burin({key("info"), path("slices"), key("--spacing"), key("0.5,0.5")});
        QCOMPARE(wrong.status, 2);
        QVERIFY2(
            wrong.complaint.contains(key("'0.5,0.5' is no spacing")), qPrintable(wrong.complaint));
    }

    void runNeedsTheSpacing()
    {
        const Outcome without = burin({key("run"), growth("grow.json"), key("--study"),
            path("slices"), key("--session"), path("s.burin")});
        QCOMPARE(without.status, 1);
        QVERIFY2(
            without.complaint.contains(key("--spacing gives it")), qPrintable(without.complaint));
        QVERIFY(!QFile::exists(path("s.burin")));
    }

    void sessionAndRecipeKeepTheSpacing()
    {
        const Outcome first = burin({key("run"), growth("grow.json"), key("--study"),
            path("slices"), key("--spacing"), key("0.5,0.5,2"), key("--session"), path("s.burin")});
        QVERIFY2(first.status == 0, qPrintable(first.complaint));
        const core::LoadedVolume mask = test::openVolume(path("box.nii"));
        QCOMPARE(mask.volume.geometry.size, glm::ivec3(side, side, slices));
        QVERIFY(glm::length(mask.volume.geometry.spacingMm() - glm::dvec3(0.5, 0.5, 2)) < 1e-6);
        QVERIFY(glm::length(mask.volume.geometry.originLps()) < 1e-6);
        QCOMPARE(test::valueAt(mask, {4, 8, 3}), 1.0);
        QCOMPARE(test::valueAt(mask, {9, 15, 8}), 1.0);
        QCOMPARE(test::valueAt(mask, {10, 15, 8}), 0.0);
        QFile numbers(path("box.csv"));
        QVERIFY(numbers.open(QIODevice::ReadOnly));
        // 6 × 8 × 6 voxels of half a cubic millimetre.
        const QByteArray text = numbers.readAll();
        QVERIFY2(text.contains("0.144"), text.constData());

        const Outcome replayed = burin({key("replay"), path("s.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const auto contents = core::checkSession(path("s.burin"));
        QVERIFY(contents);
        QCOMPARE(contents->source.repair, key("spacing=0.5x0.5x2"));
        const QString more = recipe("more.json", {{key("edits"), QJsonArray{}}});
        const Outcome appended =
            burin({key("run"), more, key("--append"), key("--session"), path("s.burin")});
        QVERIFY2(appended.status == 0, qPrintable(appended.complaint));
        const Outcome other = burin({key("run"), more, key("--append"), key("--spacing"),
            key("1,1,1"), key("--session"), path("s.burin")});
        QCOMPARE(other.status, 2);

        // A recipe knows it, too.
        const QString again = recipeOf("s.burin", "again.json");
        const Outcome second = burin({key("run"), again, key("--study"), path("slices"),
            key("--session"), path("again.burin")});
        QVERIFY2(second.status == 0, qPrintable(second.complaint));

        // Other pictures are not the session's.
        QVERIFY(QFile::remove(path("slices") + key("/slice3.png")));
        const Outcome fewer = burin({key("replay"), path("s.burin"), key("--verify")});
        QVERIFY(fewer.status != 0);
    }

    void imagesInTheSessionNeedNoFiles()
    {
        const Outcome made = burin(
            {key("run"), growth("grow.json"), key("--study"), path("slices"), key("--spacing"),
                key("0.5,0.5,2"), key("--session"), path("s.burin"), key("--with-images")});
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        QVERIFY(QDir(path("slices")).removeRecursively());
        const auto images = core::loadSessionImages(path("s.burin"));
        QVERIFY2(images, images ? "" : qPrintable(test::errorText(images.error())));
        QCOMPARE(images->volume.repair, key("spacing=0.5x0.5x2"));
        const Outcome exported = burin(
            {key("replay"), path("s.burin"), key("--verify"), key("--export"), path("again.nii")});
        QVERIFY2(exported.status == 0, qPrintable(exported.complaint));
        const core::LoadedVolume mask = test::openVolume(path("again.nii"));
        QVERIFY(glm::length(mask.volume.geometry.spacingMm() - glm::dvec3(0.5, 0.5, 2)) < 1e-6);
    }
};

BURIN_TEST(PicturesCommandGlTest)

} // namespace picturesCommandGlTest

#include "PicturesCommandGlTest.moc"
