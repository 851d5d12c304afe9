// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <cmath>
#include <limits>

namespace drillPathSamplerTest {

using namespace core;

namespace {

DrillStroke strokeIn(DrillMode mode)
{
    DrillStroke stroke = test::drillAt(0).get<DrillStroke>();
    stroke.mode = mode;
    stroke.samples.clear(); // by time, unless it says otherwise
    return stroke;
}

DrillCut cutOf(const DrillStroke& stroke)
{
    return *drillCut(stroke, initialDocument(test::smallStudy().volume));
}

/// A second of the same path as a device reports it so many times a second.
std::vector<PenSample> reported(int perSecond, double mmPerSecond)
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= perSecond; ++i) {
        const double t = double(i) / perSecond;
        samples.push_back({-10.0 + mmPerSecond * t, 3.0 - 0.5 * mmPerSecond * t, 1.0, t});
    }
    return quantised(samples);
}

std::int64_t sumOf(const std::vector<DrillSample>& path)
{
    std::int64_t sum = 0;
    for (const DrillSample& sample : path)
        sum += sample.depth;
    return sum;
}

} // namespace

class DrillPathSamplerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void reportRatesMakeNoDifference_data()
    {
        QTest::addColumn<bool>("rate");
        QTest::addColumn<double>("mmPerSecond");
        QTest::newRow("limit, resting") << false << 0.0;
        QTest::newRow("limit, moving") << false << 20.0;
        QTest::newRow("limit, fast") << false << 200.0;
        QTest::newRow("rate, resting") << true << 0.0;
        QTest::newRow("rate, moving") << true << 20.0;
        QTest::newRow("rate, fast") << true << 200.0;
    }
    void reportRatesMakeNoDifference()
    {
        QFETCH(bool, rate);
        QFETCH(double, mmPerSecond);
        DrillStroke stroke = strokeIn(rate ? DrillMode::Rate : DrillMode::Limit);
        const DrillCut cut = cutOf(stroke);
        stroke.samples = reported(30, mmPerSecond);
        const std::vector<DrillSample> expected = drillPath(stroke, cut);
        QVERIFY(!expected.empty());
        if (mmPerSecond > 0.0)
            QVERIFY(expected.size() >= 15);
        for (const int perSecond : {60, 120, 240, 250, 1000}) {
            stroke.samples = reported(perSecond, mmPerSecond);
            QVERIFY2(drillPath(stroke, cut) == expected, qPrintable(QString::number(perSecond)));
        }
        // What a second is worth, to the rounding of each piece of it.
        if (rate)
            QVERIFY(std::abs(sumOf(expected) - std::int64_t(5.0 * 65536 * 256)) < 2000);
    }

    void piecesAndRepetitionMakeNoDifference()
    {
        test::Random random(3);
        for (const DrillMode mode : {DrillMode::Limit, DrillMode::Rate}) {
            DrillStroke stroke = strokeIn(mode);
            const DrillCut cut = cutOf(stroke);
            stroke.samples = reported(250, 90.0);
            const std::vector<DrillSample> whole = drillPath(stroke, cut);
            DrillPathSampler sampler(stroke, cut);
            std::vector<DrillSample> told;
            const auto take = [&](const std::vector<DrillSample>& more) {
                told.insert(told.end(), more.begin(), more.end());
            };
            for (std::size_t i = 0; i < stroke.samples.size();) {
                std::vector<PenSample> piece;
                for (int n = test::randomInt(random, 0, 4); n >= 0 && i < stroke.samples.size();
                     --n, ++i)
                    piece.insert(piece.end(), 1 + random() % 3, stroke.samples[i]);
                take(sampler.add(piece));
            }
            take(sampler.finish());
            QVERIFY(told == whole);
        }
    }

    void theEndIsReached()
    {
        // Between two looks nothing is lost, and corners at one time are met.
        DrillStroke stroke = strokeIn(DrillMode::Limit);
        const DrillCut cut = cutOf(stroke);
        stroke.samples = {{0, 0, 1, 0.0}, {4, 0, 1, 0.0041}, {4, 8, 1, 0.0041}};
        const std::vector<DrillSample> path = drillPath(stroke, cut);
        QCOMPARE(path.front(), (DrillSample{0, 0, 5 * 65536}));
        QCOMPARE(path.back(), (DrillSample{4 * 65536, 8 * 65536, 5 * 65536}));
        stroke.samples.pop_back();
        QCOMPARE(drillPath(stroke, cut).back(), (DrillSample{4 * 65536, 0, 5 * 65536}));
        // A tap has no time.
        stroke.samples.resize(1);
        QCOMPARE(drillPath(stroke, cut).size(), std::size_t(1));
        stroke.mode = DrillMode::Rate;
        QVERIFY(drillPath(stroke, cutOf(stroke)).empty());
    }

    void recipesSayCorners()
    {
        DrillStroke stroke = strokeIn(DrillMode::Limit);
        stroke.byTime = false;
        const DrillCut cut = cutOf(stroke);
        stroke.samples = {{0, 0, 1, 0}, {9, 0, 0.5, 0}, {9, 9, 1, 0}};
        const std::vector<DrillSample> path = drillPath(stroke, cut);
        QCOMPARE(path.front(), (DrillSample{0, 0, 5 * 65536}));
        QCOMPARE(path.back(), (DrillSample{9 * 65536, 9 * 65536, 5 * 65536}));
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double dx = path[i].x - path[i - 1].x;
            const double dy = path[i].y - path[i - 1].y;
            QVERIFY(std::sqrt(dx * dx + dy * dy) <= cut.maskRadius / 4.0 + 2.0);
        }
    }

    void nonsenseIsLeftOut()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double infinite = std::numeric_limits<double>::infinity();
        const std::vector<PenSample> sound =
            soundSamples({{nan, 0, 1, 1}, {0, infinite, 1, 1}, {1, 0, nan, 1}, {2, 0, 7, 1},
                             {3, 0, -1, 0.5}, {4, 0, 1, nan}, {1e9, 0, 1, 2}, {5, 0, 0.5, 2}},
                0.25);
        QCOMPARE(sound.size(), std::size_t(3));
        QCOMPARE(sound[0].pressure, 1.0);
        QCOMPARE(sound[1].pressure, 0.0);
        QCOMPARE(sound[1].tSeconds, 1.0);
        QCOMPARE(sound[2].xMm, 5.0);
        QCOMPARE(soundSamples({{0, 0, 1, 0}}, 3.0).front().tSeconds, 3.0);
    }
};

BURIN_PLAIN_TEST(DrillPathSamplerTest)

} // namespace drillPathSamplerTest

#include "DrillPathSamplerTest.moc"
