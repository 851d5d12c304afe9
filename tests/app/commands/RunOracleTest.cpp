// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SharedData.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace runOracleTest {

using namespace core;

namespace {

/// What is grown: where from is found in the volume itself.
struct Input {
    QString study;
    QString series;
    double lower = 0.0;
    double upper = 0.0;
};

/// Voxels within the bounds, spread over the volume by a random walk through it.
std::vector<glm::ivec3> seedsWithin(const LoadedVolume& loaded, int low, int high, int count)
{
    test::Random random(19);
    const test::Codes codes{loaded.volume.geometry.size, loaded.codes};
    std::vector<glm::ivec3> seeds;
    for (int tries = 0; tries < 1000000 && int(seeds.size()) < count; ++tries) {
        const glm::ivec3 voxel = test::randomVoxel(random, codes.size);
        if (low <= codes.at(voxel) && codes.at(voxel) <= high)
            seeds.push_back(voxel);
    }
    return seeds;
}

} // namespace

/// `burin run`, grown to closure and drilled, prints the hashes that the oracle reaches with the
/// same recipe. (The voxels are compared with ITK's in GrowItkGlTest.)
class RunOracleTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void runsAlike_data();
    void runsAlike();

private:
    QTemporaryDir m_folder;
};

void RunOracleTest::runsAlike_data()
{
    QTest::addColumn<Input>("input");
    const auto addReal = [](const char* name, double lower, double upper) {
        const test::SharedCase real = test::sharedCase(QLatin1String(name));
        const QString series =
            real.expected[QStringLiteral("series")][0][QStringLiteral("series_instance_uid")]
                .toString();
        // Without shared data the row says so when it runs.
        QTest::addRow("%s", name) << Input{
            real.unpacked.isEmpty() ? real.source : real.unpacked, series, lower, upper};
    };
    addReal("ct_cranium_inv3", 226, 3071); // bone
    addReal("ct_abdomen_j2k_organs", -20, 180); // soft tissue
    addReal("mr_t1_sag_mprage", 120, 600);
    if (test::longRun())
        addReal("ct_lidc0314_lower", -950, -500); // lung
    test::Random random(4);
    for (int number = 0; number < 5; ++number) {
        const glm::ivec3 size{test::randomInt(random, 20, 90), test::randomInt(random, 20, 90),
            test::randomInt(random, 20, 70)};
        Document document = test::randomDocument(size, random, false);
        const test::Codes codes = number % 2 ? test::balls(size, 12, random)
                                             : test::noiseVolume(size, test::tissueCode, random);
        const std::vector<std::int16_t> values(codes.values.begin(), codes.values.end());
        const QString file = m_folder.filePath(QStringLiteral("random%1.nii").arg(number));
        const auto written = writeNifti(file,
            {.geometry = document.volumes.front().geometry, .voxels = values, .description = {}});
        QVERIFY(written);
        // Of noise a third is open, near where clusters begin to reach through the volume.
        QTest::addRow("random %d", number)
            << Input{file, {}, number % 2 ? 0.0 : 333.0, number % 2 ? 240.0 : 680.0};
    }
}

void RunOracleTest::runsAlike()
{
    QFETCH(Input, input);
    if (input.study.isEmpty())
        QSKIP("the shared test data are not there");
    Result<LoadedVolume> loaded = loadVolume(input.study, input.series);
    QVERIFY2(loaded, loaded ? "" : qPrintable(loaded.error().arguments.join(QStringLiteral(": "))));
    const VolumeGeometry geometry = loaded->volume.geometry;
    const int low = loaded->volume.encoding.lowestCodeAtLeast(input.lower);
    const int high = loaded->volume.encoding.highestCodeAtMost(input.upper);
    const std::vector<glm::ivec3> seeds = seedsWithin(*loaded, low, high, 3);
    QCOMPARE(seeds.size(), std::size_t(3));

    std::vector<glm::dvec3> seedsLps;
    for (const glm::ivec3& seed : seeds)
        seedsLps.push_back(geometry.toWorld(glm::dvec3(seed)));
    OrthographicView view;
    view.targetLps = geometry.toWorld(glm::dvec3(geometry.size) / 2.0);
    view.eyeLps = view.targetLps + glm::dvec3(-150.0, -210.0, 60.0);
    const std::vector<PenSample> path{
        {.xMm = -6.0, .yMm = 3.0, .pressure = 0.8}, {.xMm = 8.0, .yMm = -5.0}};
    const Edit drill = test::drillWith({.view = view,
        .radiusMm = 9.0,
        .depthMm = 12.0,
        .surfaceThreshold = input.lower,
        .samples = path});
    const std::vector<Edit> edits{quantised(test::newSegment(QStringLiteral("Grown"), 0x40C080)),
        quantised(test::seedAt(1, seedsLps)),
        quantised(test::growBetween(input.lower, input.upper)), quantised(drill)};

    const QTemporaryDir folder;
    QJsonArray json;
    for (const Edit& edit : edits)
        json.push_back(editToJson(edit));
    QFile recipe(folder.filePath(QStringLiteral("recipe.json")));
    QVERIFY(recipe.open(QIODevice::WriteOnly));
    recipe.write(QJsonDocument(QJsonObject{{QStringLiteral("edits"), json}}).toJson());
    recipe.close();
    QStringList arguments{QStringLiteral("run"), recipe.fileName(), QStringLiteral("--study"),
        input.study, QStringLiteral("--session"), folder.filePath(QStringLiteral("grown.burin"))};
    if (!input.series.isEmpty())
        arguments << QStringLiteral("--series") << input.series;
    QProcess burin;
    burin.start(QStringLiteral(BURIN_PROGRAM), arguments);
    QVERIFY(burin.waitForFinished(300000));
    QVERIFY2(burin.exitCode() == 0, burin.readAllStandardError().constData());
    const QList<QByteArray> lines = burin.readAllStandardOutput().trimmed().split('\n');
    QCOMPARE(std::size_t(lines.size()), edits.size());

    reference::ReferenceEngine oracle;
    const auto session = EditSession::create(oracle, *std::move(loaded), {});
    QVERIFY(session);
    for (std::size_t i = 0; i < edits.size(); ++i) {
        QVERIFY((*session)->apply(edits[i]));
        QVERIFY((*session)->settle());
        // The hash covers labels and every seed word: generation, label and direction.
        QCOMPARE(QString::fromLatin1((*session)->stateHash()),
            QJsonDocument::fromJson(lines[int(i)]).object()[QStringLiteral("hash")].toString());
    }
    const Result<std::vector<std::uint8_t>> labels = (*session)->questions().labels(0);
    QVERIFY(labels);
    const auto grown = std::size_t(std::count(labels->begin(), labels->end(), 1));
    QVERIFY(grown >= 3);
    QVERIFY((*session)->history().rows().back().statistics.voxelsChanged > 100);
}

BURIN_TEST(RunOracleTest)

} // namespace runOracleTest

#include "RunOracleTest.moc"
