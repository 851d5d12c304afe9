// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace referenceDrillTest {

using namespace core;
using reference::ReferenceEngine;
using test::Codes;
using test::lastResult;

namespace {

/// A view along an index axis of a box of 1 mm voxels, target in the middle.
struct StraightView {
    Document document;
    DrillStroke stroke;

    explicit StraightView(const glm::ivec3& size)
    {
        Volume volume;
        volume.geometry.size = size;
        document.volumes.push_back(volume);
        stroke.view.targetLps = glm::dvec3(size) / 2.0;
        stroke.view.eyeLps = stroke.view.targetLps - glm::dvec3(0, 0, 300);
        stroke.view.up = {0.0, 1.0, 0.0};
        stroke.mask.radiusMm = 6.0;
        stroke.depthMm = 5.0;
        stroke.pressureExponent = 1;
        stroke.surfaceThreshold = test::tissueCode / 2;
        stroke.samples = {{.pressure = 1.0}};
    }

    EngineResult drill(EditEngine& engine) const
    {
        const DrillCut cut = test::drillCutOf(stroke, document);
        submitWhole(engine, cut, {DrillPath{test::drillSamplesOf(stroke, cut)}});
        return lastResult(engine);
    }
};

} // namespace

class ReferenceDrillTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void reachesItsDepth_data();
    void reachesItsDepth();
    void stopsAtAGap();
    void staysUnderItsMask();
    void leavesWhatItDoesNotSee();
    void ignoresItsOwnCut();
    void seesThroughAMutedLayer();
    void obliqueOnesCutBetweenTwoPlanes();
    void portionsMakeNoDifference();
};

void ReferenceDrillTest::reachesItsDepth_data()
{
    QTest::addColumn<double>("pressure");
    QTest::addColumn<int>("exponent");
    QTest::addRow("full") << 1.0 << 1;
    QTest::addRow("half") << 0.5 << 1;
    QTest::addRow("half, squared") << 0.5 << 2;
    QTest::addRow("none") << 0.0 << 1;
}

void ReferenceDrillTest::reachesItsDepth()
{
    QFETCH(double, pressure);
    QFETCH(int, exponent);
    const glm::ivec3 size(32, 32, 32);
    constexpr int surface = 8; // the first voxel of tissue
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, surface, 31).values));
    StraightView view(size);
    view.stroke.depthMm = 12.0;
    view.stroke.pressureExponent = exponent;
    view.stroke.samples.front().pressure = pressure;
    const EngineResult result = view.drill(engine);
    QVERIFY(!result.error);
    const double depth = 12.0 * std::pow(pressure, exponent);
    QCOMPARE(result.changes.empty(), depth == 0.0);
    // Linear interpolation meets half the code half a voxel before the first voxel of tissue.
    const double first = surface - 0.5;
    reference::DenseFields fields = engine.fields();
    for (int z = 0; z < size.z; ++z) {
        const bool cut = fields.coverage(1).at({16, 16, z}) >= 128;
        // Sixteenths of half a voxel and the middle of the ramp: 0.1 voxel is undecided.
        if (std::abs(z - (first + depth)) > 0.1 && z >= surface)
            QCOMPARE(cut, z < first + depth);
        else if (z < surface - 2)
            QVERIFY(!cut);
    }
}

void ReferenceDrillTest::stopsAtAGap()
{
    const glm::ivec3 size(32, 32, 48);
    Codes codes = test::slab(size, 2, 5, 9);
    for (int z = 20; z < 26; ++z)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                codes.at({x, y, z}) = test::tissueCode;
    for (const bool throughGaps : {false, true}) {
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, codes.values));
        StraightView view(size);
        view.stroke.depthMm = 40.0;
        view.stroke.throughGaps = throughGaps;
        (void)view.drill(engine);
        reference::DenseFields fields = engine.fields();
        for (int z = 5; z < 26; ++z) {
            if (codes.at({16, 16, z}) == 0)
                continue;
            QCOMPARE(fields.coverage(1).at({16, 16, z}) >= 128, z < 10 || throughGaps);
        }
    }
}

void ReferenceDrillTest::staysUnderItsMask()
{
    const glm::ivec3 size(40, 40, 20);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, 4, 19).values));
    StraightView view(size);
    view.stroke.samples = {{.xMm = 3.0, .yMm = -4.0}};
    (void)view.drill(engine);
    reference::DenseFields fields = engine.fields();
    // Seen along +z with +y up, right is −x. The path has one point: a disc.
    const glm::dvec2 centre(20.0 - 3.0, 20.0 - 4.0);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const double r = glm::length(glm::dvec2(x, y) - centre);
            const bool cut = fields.coverage(1).at({x, y, 5}) >= 128;
            if (r < 5.0)
                QVERIFY2(cut, qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
            if (r > 7.0)
                QVERIFY2(!cut, qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
        }
    }
}

void ReferenceDrillTest::leavesWhatItDoesNotSee()
{
    const glm::ivec3 size(20, 20, 20);
    for (const auto& [code, threshold] :
        {std::pair{0, 1.0}, std::pair{65535, 70000.0}, std::pair{499, 500.0}}) {
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, test::constantVolume(size, std::uint16_t(code)).values));
        StraightView view(size);
        view.stroke.surfaceThreshold = threshold;
        QVERIFY(view.drill(engine).changes.empty());
    }
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::constantVolume(size, 0).values));
    StraightView view(size);
    view.stroke.surfaceThreshold = -5.0; // code 0 and above: all of it is seen
    QVERIFY(!view.drill(engine).changes.empty());
    view.stroke.samples.front().xMm = 100.0;
    QVERIFY(view.drill(engine).changes.empty());
}

void ReferenceDrillTest::ignoresItsOwnCut()
{
    const glm::ivec3 size(32, 32, 32);
    const auto depthAfter = [&](int strokes, std::size_t repeats, std::uint8_t layerStep) {
        ReferenceEngine engine;
        (void)engine.openVolume(size, test::slab(size, 2, 4, 31).values);
        StraightView view(size);
        view.stroke.samples.assign(repeats, view.stroke.samples.front());
        int deepest = -1;
        for (int i = 0; i < strokes; ++i) {
            view.stroke.layer = 1 + i * layerStep;
            (void)view.drill(engine);
        }
        reference::DenseFields fields = engine.fields();
        const auto carved = fields.composedCoverage({});
        for (int z = 0; z < size.z; ++z)
            deepest = carved.at({16, 16, z}) >= 128 ? z : deepest;
        return deepest;
    };
    const int once = depthAfter(1, 1, 0);
    QVERIFY(once > 5);
    QCOMPARE(depthAfter(1, 9, 0), once); // within a stroke the surface stays what it was
    const int twice = depthAfter(2, 1, 0);
    QVERIFY(twice >= once + 4 && twice <= once + 6); // the next one starts from the cut
    QCOMPARE(depthAfter(2, 1, 1), twice); // whatever layer holds it
}

/// With layer 1 muted a stroke into layer 2 is what it is where there is no layer 1; unmuted, it
/// starts from the cut in layer 1.
void ReferenceDrillTest::seesThroughAMutedLayer()
{
    const glm::ivec3 size(32, 32, 32);
    const auto second = [&](bool first, std::initializer_list<std::size_t> muted) {
        ReferenceEngine engine;
        (void)engine.openVolume(size, test::slab(size, 2, 4, 31).values);
        StraightView view(size);
        if (first)
            (void)view.drill(engine);
        MuteLayers mute;
        for (const std::size_t layer : muted)
            mute.muted.set(layer);
        engine.submit(mute);
        view.stroke.layer = 2;
        (void)view.drill(engine);
        reference::DenseFields fields = engine.fields();
        return fields.coverage(2).values;
    };
    const auto alone = second(false, {});
    QVERIFY(second(true, {1}) == alone);
    QVERIFY(second(true, {1, 2}) == alone); // a muted layer can be cut all the same
    QVERIFY(second(true, {}) != alone);
    QVERIFY(second(true, {2}) != alone);
}

void ReferenceDrillTest::obliqueOnesCutBetweenTwoPlanes()
{
    const glm::ivec3 size(40, 40, 40);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, 10, 39).values));
    StraightView view(size);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.5, 0.3, 1.0));
    view.stroke.view.targetLps = {20.0, 20.0, 9.5};
    view.stroke.view.eyeLps = view.stroke.view.targetLps - 200.0 * towards;
    view.stroke.depthMm = 8.0;
    (void)view.drill(engine);
    reference::DenseFields fields = engine.fields();
    int inside = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 p = glm::dvec3(x, y, z) - view.stroke.view.targetLps;
                // Along the view direction from the plane z = 9.5 to the voxel, and off the axis.
                const double below = p.z / towards.z;
                const double off = glm::length(p - glm::dot(p, towards) * towards);
                const bool cut = fields.coverage(1).at({x, y, z}) >= 128;
                if (off < 5.0 && below > 0.5 && below < 7.0) {
                    QVERIFY(cut);
                    ++inside;
                }
                // An element is half a voxel wide and meets the slope at one height.
                if (off > 7.0 || below > 9.0 || below < -3.0)
                    QVERIFY(!cut);
            }
        }
    }
    QVERIFY(inside > 100);
}

void ReferenceDrillTest::portionsMakeNoDifference()
{
    test::Random random(77);
    for (int i = 0; i < (test::longRun() ? 60 : 8); ++i) {
        const glm::ivec3 size(30, 25, 20);
        const Codes codes = test::balls(size, 5, random);
        const Document document = test::randomDocument(size, random, i % 2);
        const Edit stroke = test::randomDrill(document, random);
        const DrillCut cut = test::drillCutOf(stroke, document);
        std::vector<DrillSample> path = test::drillSamplesOf(stroke, cut);
        ReferenceEngine whole;
        ReferenceEngine parts;
        QVERIFY(whole.openVolume(size, codes.values));
        QVERIFY(parts.openVolume(size, codes.values));
        submitWhole(whole, cut, {DrillPath{path}});
        std::shuffle(path.begin(), path.end(), random);
        std::vector<EngineExtension> extensions;
        for (const DrillSample& sample : path)
            extensions.push_back(DrillPath{{sample}});
        submitWhole(parts, cut, std::move(extensions));
        QVERIFY(reference::DenseFields::changes(whole.fields(), parts.fields()).empty());
    }
}

BURIN_TEST(ReferenceDrillTest)

} // namespace referenceDrillTest

#include "ReferenceDrillTest.moc"
