// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ToleranceScene.h"

#include <QElapsedTimer>
#include <QtTest>

#include <algorithm>

namespace toleranceGlTest {

using namespace core;
using reference::DenseArray;
namespace seedWord = core::seedWord;

/// Tracing in pieces, and what pictures are drawn from while a segment is shown at a tolerance.
/// That fields equal the oracle's, word for word: EngineConformanceGlTest.
class ToleranceGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY2(m_gpu.isReady(), m_gpu.why());
        qInfo("%s", m_gpu.rendererName().constData());
    }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }

    void inPiecesAsInOneGo();
    void segmentationMapFollows_data();
    void segmentationMapFollows();
    void howLongItTakes();

private:
    EngineResult ask(EngineCommand command)
    {
        m_gpu.engine().submit(std::move(command));
        return test::lastResult(m_gpu.engine());
    }

    test::EditEngineFixture m_gpu;
};

void ToleranceGlTest::inPiecesAsInOneGo()
{
    test::Random random(5);
    const test::Codes codes = test::noiseVolume({130, 100, 90}, 400, random);
    EditEngine& engine = m_gpu.engine();
    QVERIFY(engine.openVolume(codes.size, codes.values));
    submitWhole(engine, SeedPlacement{.label = 2, .voxels = {{60, 50, 40}}});
    const TraceTolerance piece{.rule = {.label = 2}, .toTheEnd = false};
    int pieces = 0;
    EngineResult result;
    do {
        result = ask(piece);
        QVERIFY(!result.error);
        if (++pieces == 2)
            (void)ask(ProbeVoxels{{{1, 2, 3}}}); // other questions are served between
    } while (!result.tolerance && pieces < 100000);
    QVERIFY(result.tolerance);
    QVERIFY(pieces > 1);
    const EngineResult probed = ask(ProbeVoxels{{{60, 50, 40}, {0, 0, 0}}});
    QCOMPARE(probed.probes[0].tolerance, std::optional(0));

    // An edit on the way: what was worked out so far counts for nothing.
    submitWhole(engine, SeedPlacement{.label = 2, .voxels = {{10, 10, 10}}});
    QVERIFY(!ask(ProbeVoxels{{{60, 50, 40}}}).probes[0].tolerance);
    (void)ask(piece);
    submitWhole(engine, SeedPlacement{.label = 2, .voxels = {{120, 90, 80}}});
    const EngineResult whole = ask(TraceTolerance{.rule = {.label = 2}});
    QVERIFY(whole.tolerance);

    reference::ReferenceEngine oracle;
    QVERIFY(oracle.openVolume(codes.size, codes.values));
    submitWhole(oracle, SeedPlacement{.label = 2, .voxels = {{60, 50, 40}}});
    oracle.submit(TraceTolerance{.rule = {.label = 2}});
    QVERIFY(oracle.collect().back().tolerance == result.tolerance);
    submitWhole(oracle, SeedPlacement{.label = 2, .voxels = {{10, 10, 10}, {120, 90, 80}}});
    oracle.submit(TraceTolerance{.rule = {.label = 2}});
    QVERIFY(oracle.collect().back().tolerance == whole.tolerance);
}

/// Moves all that is done to a label plane, and puts labels that stay as they are into the first
/// one.
static void moveTo(std::uint8_t plane, test::ToleranceScene& scene, test::Random& random)
{
    if (plane == 0)
        return;
    for (EngineCommand& command : scene.commands) {
        if (auto* begin = std::get_if<BeginEdit>(&command)) {
            if (auto* seeds = std::get_if<SeedPlacement>(&begin->edit))
                seeds->plane = plane;
            else
                std::get<GrowBurst>(begin->edit).plane = plane;
        } else if (auto* swap = std::get_if<SwapBricks>(&command)) {
            for (BrickImage& image : swap->bricks)
                image.key.plane = image.key.field == Field::Coverage ? image.key.plane : plane;
        }
    }
    scene.rule.plane = plane;
    DenseArray<std::uint8_t> labels{
        scene.codes.size, std::vector<std::uint8_t>(scene.codes.values.size())};
    for (std::uint8_t& label : labels.values)
        label = random() % 50 == 0 ? 1 : 0;
    scene.commands.push_back(SwapBricks{test::bricksOf(labels, Field::Labels, 0)});
}

void ToleranceGlTest::segmentationMapFollows_data()
{
    QTest::addColumn<int>("number");
    for (int number = 0; number < (test::longRun() ? 200 : 12); ++number)
        QTest::addRow("volume %d", number) << number;
}

/// Radiation of what the segment would be, whichever way the tolerance goes; and of what is, once
/// nothing is asked for or the field is gone.
void ToleranceGlTest::segmentationMapFollows()
{
    QFETCH(int, number);
    const auto plane = std::uint8_t(number % 3);
    test::Random random(std::uint32_t(43000 + number));
    const glm::ivec3 size{test::randomInt(random, 4, 60), test::randomInt(random, 4, 40),
        test::randomInt(random, 4, 34)};
    test::ToleranceScene scene = test::randomToleranceScene(size, random);
    moveTo(plane, scene, random);
    reference::ReferenceEngine oracle;
    EditEngine& engine = m_gpu.engine();
    m_gpu.showGrowth(plane);
    std::bitset<256> shown;
    shown.set(2).set(random() % 2 ? 1 : 255);
    m_gpu.showSegments(shown);
    for (EditEngine* each : {static_cast<EditEngine*>(&oracle), &engine}) {
        QVERIFY(each->openVolume(size, scene.codes.values));
        for (const EngineCommand& command : scene.commands)
            each->submit(command);
        each->submit(TraceTolerance{scene.rule});
    }
    ProbeVoxels everywhere;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                everywhere.voxels.emplace_back(x, y, z);
    oracle.submit(everywhere);
    const std::vector<ProbedVoxel> probes = oracle.collect().back().probes;
    reference::DenseFields fields = oracle.fields();
    const DenseArray<std::uint32_t>& words = fields.seedWords(plane);

    const auto expected = [&](std::optional<int> tolerance) {
        DenseArray<std::uint8_t> members = fields.labels(plane);
        const DenseArray<std::uint8_t>& first = fields.labels(0);
        for (std::size_t i = 0; i < members.values.size(); ++i) {
            std::uint8_t& value = members.values[i];
            const std::uint32_t word = words.values[i];
            const std::uint32_t direction = seedWord::direction(word);
            const bool grown = seedWord::isMember(word) && seedWord::label(word) == 2
                && seedWord::generation(word) > 0 && direction != 29 && direction != 30;
            if (tolerance && probes[i].tolerance && *probes[i].tolerance <= *tolerance)
                value = 2;
            else if (tolerance && value == 2 && grown)
                value = 0;
            const bool isShown = shown.test(value) || (plane > 0 && shown.test(first.values[i]));
            value = isShown ? 255 : 0;
        }
        return reference::radiation(members).values;
    };
    engine.finish();
    const auto seen = [&] { return m_gpu.read(gpu::VolumeField::Segmentation).values; };
    QVERIFY(seen() == expected({}));
    for (int move = 0; move < 5; ++move) {
        const int tolerance =
            probes[random() % probes.size()].tolerance.value_or(int(random() % 2000));
        m_gpu.showAtTolerance(gpu::ToleranceDisplay{.label = 2, .tolerance = tolerance});
        QVERIFY2(seen() == expected(tolerance), qPrintable(QString::number(tolerance)));
    }
    // Another segment's tolerance shows nothing.
    m_gpu.showAtTolerance(gpu::ToleranceDisplay{.label = 1, .tolerance = 65533});
    QVERIFY(seen() == expected({}));
    m_gpu.showAtTolerance(gpu::ToleranceDisplay{.label = 2, .tolerance = 30});
    QVERIFY(seen() == expected(30));
    engine.submit(DropTolerance{});
    engine.finish();
    QVERIFY(seen() == expected({}));
    engine.submit(TraceTolerance{scene.rule});
    engine.finish();
    QVERIFY(seen() == expected(30));
    // Nor is anything shown while another plane's growth is.
    m_gpu.showGrowth(3);
    QVERIFY(seen() == expected({}));
    m_gpu.showGrowth(plane);
    QVERIFY(seen() == expected(30));
    m_gpu.showAtTolerance({});
    QVERIFY(seen() == expected({}));
    m_gpu.showGrowth(0);
}

/// Told, not judged.
void ToleranceGlTest::howLongItTakes()
{
    test::Random random(6);
    const int side = test::longRun() ? 256 : 96;
    test::Codes codes = test::balls({side, side, side}, side / 4, random);
    for (std::uint16_t& code : codes.values)
        code = std::uint16_t(code + random() % 60); // grain, as scanners make it
    EditEngine& engine = m_gpu.engine();
    QVERIFY(engine.openVolume(codes.size, codes.values));
    submitWhole(engine,
        SeedPlacement{.label = 2, .voxels = {{side / 2, side / 2, side / 2}, {side / 3, 9, 9}}});
    engine.finish();
    QElapsedTimer timer;
    timer.start();
    const EngineResult first = ask(TraceTolerance{.rule = {.label = 2}});
    const qint64 whole = timer.restart();
    const EngineResult again = ask(TraceTolerance{.rule = {.label = 2}});
    qInfo("%d³: traced in %lld ms, found to be the same in %lld ms", side, qlonglong(whole),
        qlonglong(timer.elapsed()));
    QVERIFY(first.tolerance && first.tolerance == again.tolerance);
    const std::vector<std::int64_t> members = membersOf(*first.tolerance);
    QCOMPARE(members.back(), std::int64_t(codes.values.size()));
}

BURIN_TEST(ToleranceGlTest)

} // namespace toleranceGlTest

#include "ToleranceGlTest.moc"
