// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourEvolution.h"

#include "core/export/common/SegmentMeter.h"
#include "tests/reference/filling/Contour.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace contourEvolutionTest {

using namespace core;

namespace {

std::size_t placeIn(const glm::ivec3& size, const glm::ivec3& at)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

template <class Visit> void visitVoxels(const VoxelBox& box, Visit&& visit)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

/// A volume of so many voxels; codes are 0.
LoadedVolume emptyVolume(const glm::ivec3& size, const glm::dvec3& spacing)
{
    LoadedVolume study;
    study.volume.geometry.size = size;
    for (int axis = 0; axis < 3; ++axis)
        study.volume.geometry.indexToWorld[axis][axis] = spacing[axis];
    study.codes.assign(study.volume.geometry.voxelCount(), 0);
    return study;
}

/// What core works on, of what the oracle has: only the box that so many generations can reach.
ContourGround groundOf(const reference::Contour& contour, int generations)
{
    const glm::ivec3 size = contour.study->volume.geometry.size;
    VoxelBox start;
    visitVoxels({glm::ivec3(0), size}, [&](const glm::ivec3& voxel) {
        const VoxelBox its{voxel, voxel + 1};
        if (contour.inside[placeIn(size, voxel)])
            start = start.empty() ? its : start.united(its);
    });
    ContourGround ground{
        .volumeSize = size, .box = contourBox(start, generations, contour.rule.kernel, size)};
    visitVoxels(ground.box, [&](const glm::ivec3& voxel) {
        const std::size_t at = placeIn(size, voxel);
        std::uint8_t flags = contour.open[at] ? ContourGround::open : std::uint8_t(0);
        if (contour.inside[at])
            flags |= ContourGround::inside | ContourGround::own;
        ground.voxels.push_back(flags);
        ground.codes.push_back(contour.study->codes[at]);
    });
    return ground;
}

/// Of the whole volume.
std::vector<bool> insideOf(
    const ContourEvolution& evolution, const VoxelBox& box, const glm::ivec3& size)
{
    std::vector<bool> inside(placeIn(size, size - 1) + 1, false);
    visitVoxels(box,
        [&](const glm::ivec3& voxel) { inside[placeIn(size, voxel)] = evolution.isInside(voxel); });
    return inside;
}

/// Voxels at or within a distance of a place belong to the contour.
void addBall(reference::Contour& contour, const glm::ivec3& middle, double radius)
{
    const VolumeGeometry& geometry = contour.study->volume.geometry;
    visitVoxels({glm::ivec3(0), geometry.size}, [&](const glm::ivec3& voxel) {
        const std::size_t at = placeIn(geometry.size, voxel);
        if (contour.open[at]
            && glm::length(glm::dvec3(voxel - middle) * geometry.spacingMm()) <= radius)
            contour.inside[at] = true;
    });
}

reference::Contour contourIn(const LoadedVolume& study, const ContourRule& rule)
{
    const std::size_t voxels = study.volume.geometry.voxelCount();
    reference::Contour contour{.study = &study,
        .rule = rule,
        .inside = std::vector<bool>(voxels, false),
        .open = std::vector<bool>(voxels, true)};
    contour.rule.kernel = contourKernel(study.volume.geometry);
    return contour;
}

double diceOf(const std::vector<bool>& one, const std::vector<bool>& other)
{
    double both = 0.0;
    double each = 0.0;
    for (std::size_t at = 0; at < one.size(); ++at) {
        both += one[at] && other[at] ? 1.0 : 0.0;
        each += (one[at] ? 1.0 : 0.0) + (other[at] ? 1.0 : 0.0);
    }
    return 2.0 * both / each;
}

/// What hangs together by faces with what is inside and has a code in the interval: a plain growth.
std::vector<bool> grownFrom(const reference::Contour& contour)
{
    const glm::ivec3 size = contour.study->volume.geometry.size;
    std::vector<bool> grown(contour.inside.size(), false);
    std::vector<glm::ivec3> due;
    const auto reach = [&](const glm::ivec3& voxel) {
        const std::size_t at = placeIn(size, voxel);
        const int code = contour.study->codes[at];
        if (grown[at] || code < contour.rule.lowCode || code > contour.rule.highCode)
            return;
        grown[at] = true;
        due.push_back(voxel);
    };
    visitVoxels({glm::ivec3(0), size}, [&](const glm::ivec3& voxel) {
        if (contour.inside[placeIn(size, voxel)])
            reach(voxel);
    });
    while (!due.empty()) {
        const glm::ivec3 voxel = due.back();
        due.pop_back();
        for (int axis = 0; axis < 3; ++axis) {
            for (const int to : {-1, 1}) {
                glm::ivec3 next = voxel;
                next[axis] += to;
                if (next == glm::clamp(next, glm::ivec3(0), size - 1))
                    reach(next);
            }
        }
    }
    return grown;
}

} // namespace

class ContourEvolutionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Weights fall with the millimetres, alike on both sides.
    void kernelsFollowTheSpacing_data()
    {
        QTest::addColumn<glm::dvec3>("spacing");
        QTest::addColumn<glm::ivec3>("extent");
        QTest::newRow("even") << glm::dvec3(1.0) << glm::ivec3(2);
        QTest::newRow("fine") << glm::dvec3(0.3) << glm::ivec3(2);
        QTest::newRow("thick") << glm::dvec3(1.0, 1.0, 3.0) << glm::ivec3(3, 3, 1);
        QTest::newRow("thicker") << glm::dvec3(1.0, 1.0, 5.0) << glm::ivec3(3, 3, 0);
        QTest::newRow("rows") << glm::dvec3(1.5, 0.75, 1.5) << glm::ivec3(1, 2, 1);
    }
    void kernelsFollowTheSpacing()
    {
        QFETCH(const glm::dvec3, spacing);
        QFETCH(const glm::ivec3, extent);
        const ContourKernel kernel = contourKernel(emptyVolume({9, 9, 9}, spacing).volume.geometry);
        QVERIFY(kernel.extent == extent);
        std::set<std::tuple<int, int, int, int>> steps;
        int total = 0;
        for (const ContourKernel::Step& step : kernel.steps) {
            steps.insert({step.to.x, step.to.y, step.to.z, step.weight});
            total += step.weight;
            QVERIFY(step.weight >= 1 && step.weight <= 256);
        }
        QCOMPARE(total, kernel.total);
        for (const ContourKernel::Step& step : kernel.steps)
            QVERIFY(steps.contains({-step.to.x, -step.to.y, -step.to.z, step.weight}));
    }

    void speedsAndEdges()
    {
        const ContourRule soft{.lowCode = 100, .highCode = 200, .softness = 10};
        QCOMPARE(regionSpeed(soft, 150), 256);
        QCOMPARE(regionSpeed(soft, 110), 256); // as far within as softness says
        QCOMPARE(regionSpeed(soft, 100), 256 / 21); // the first that is within
        QCOMPARE(regionSpeed(soft, 99), -(256 / 21));
        QCOMPARE(regionSpeed(soft, 200), 256 / 21);
        QCOMPARE(regionSpeed(soft, 201), -(256 / 21));
        QCOMPARE(regionSpeed(soft, 300), -256);
        const ContourRule hard{.lowCode = -noContourBound, .highCode = 200};
        QCOMPARE(regionSpeed(hard, 0), 256);
        QCOMPARE(regionSpeed(hard, 200), 256);
        QCOMPARE(regionSpeed(hard, 201), -256);
        const ContourRule edges{.edge = 100, .halfGradient = 50};
        QCOMPARE(edgeWeight(edges, 0), 255);
        QCOMPARE(edgeWeight(edges, 2500), 1 + 127);
        QCOMPARE(edgeWeight(edges, std::uint64_t(3) * 32767 * 32767), 1);
        QCOMPARE(edgeWeight({.edge = 0, .halfGradient = 1}, 1'000'000), 255);
    }

    /// Against the oracle, generation by generation, forwards and backwards; each lowers E.
    void noiseEvolvesAsTheOracleSays_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= 12; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void noiseEvolvesAsTheOracleSays()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
        const std::vector<glm::dvec3> spacings{
            glm::dvec3(1.0), glm::dvec3(0.7, 0.7, 2.0), glm::dvec3(1.0, 1.0, 5.0)};
        const glm::ivec3 size(13 + below(6), 12 + below(5), 9 + below(5));
        LoadedVolume study = emptyVolume(size, spacings[seed % spacings.size()]);
        if (seed % 4 == 0) // a tilted gantry
            study.volume.geometry.indexToWorld[2][1] = 0.4;
        for (std::uint16_t& code : study.codes)
            code = std::uint16_t(900 + below(200));
        const ContourRule rule{.lowCode = 900 + below(60),
            .highCode = 1000 + below(120),
            .softness = below(40),
            .region = below(101),
            .edge = seed % 3 == 0 ? 0 : 1 + below(100),
            .smoothness = 20 + below(81),
            .gradientWeights = glm::ivec3(1024, 900, 400),
            .halfGradient = 20 + below(100),
            .round = seed % 2 == 1};
        reference::Contour contour = contourIn(study, rule);
        for (std::size_t at = 0; at < contour.open.size(); ++at)
            contour.open[at] = below(12) > 0;
        const glm::ivec3 middle(3 + below(6), 3 + below(6), 3 + below(4));
        addBall(contour, middle, 3.2 + 0.01 * below(150));

        constexpr int generations = 8;
        ContourGround ground = groundOf(contour, generations);
        const VoxelBox box = ground.box;
        ContourEvolution evolution(contour.rule, std::move(ground));
        std::vector<std::vector<bool>> states{contour.inside};
        double energy = contour.energy();
        std::size_t sum = 0;
        const glm::ivec3 extent = box.maximum - box.minimum;
        for (int generation = 0; generation < generations; ++generation) {
            const std::size_t changed = contour.step();
            const std::weak_ptr<const std::vector<std::uint32_t>> before = evolution.lastChanged();
            QCOMPARE(evolution.step(Progress()), changed > 0);
            QVERIFY(insideOf(evolution, box, size) == contour.inside);
            QCOMPARE(evolution.rests(), changed == 0);
            if (changed == 0)
                break;
            QCOMPARE(evolution.lastChanges(), changed);
            QCOMPARE(evolution.generation(), generation + 1);
            QVERIFY(before.expired()); // whoever wants it has it
            std::vector<bool> passed = states.back();
            for (const std::uint32_t place : *evolution.lastChanged()) {
                const glm::ivec3 step(int(place) % extent.x, int(place) / extent.x % extent.y,
                    int(place) / extent.x / extent.y);
                const std::size_t at = placeIn(size, box.minimum + step);
                passed[at] = !passed[at];
            }
            QVERIFY(passed == contour.inside);
            const double lower = contour.energy();
            QVERIFY(lower < energy);
            energy = lower;
            states.push_back(contour.inside);
            sum += changed;
        }
        QVERIFY2(sum > 0, "it must not rest at once, or this shows nothing");
        const ShapeChange change = evolution.change();
        std::uint64_t differs = 0;
        for (std::size_t at = 0; at < states.front().size(); ++at)
            differs += states.front()[at] != states.back()[at] ? 1 : 0;
        QCOMPARE(change.given.voxelCount() + change.taken.voxelCount(), differs);
        for (const VoxelRun& run : change.given.runs())
            QVERIFY(!states.front()[run.first] && states.back()[run.first]);
    }

    /// Evolving by 3 generations and then anew by 4 is evolving by 7.
    void itGoesOnWhereItStopped()
    {
        std::mt19937 random(5);
        LoadedVolume study = emptyVolume({24, 22, 20}, glm::dvec3(1.0));
        for (std::uint16_t& code : study.codes)
            code = std::uint16_t(random() % 300);
        reference::Contour contour =
            contourIn(study, {.lowCode = 0, .highCode = 200, .softness = 60, .smoothness = 40});
        addBall(contour, {12, 11, 10}, 4.0);
        const auto evolved = [&](int generations) {
            ContourGround ground = groundOf(contour, generations);
            const VoxelBox box = ground.box;
            ContourEvolution evolution(contour.rule, std::move(ground));
            while (evolution.generation() < generations && evolution.step(Progress())) { }
            return insideOf(evolution, box, study.volume.geometry.size);
        };
        const std::vector<bool> whole = evolved(7);
        QVERIFY(whole != evolved(6)); // it had not come to rest
        contour.inside = evolved(3);
        QVERIFY(evolved(4) == whole);
    }

    /// With `round`, after an even number of generations.
    void aRoundOneGoesOnAfterAnEvenNumber()
    {
        std::mt19937 random(5);
        LoadedVolume study = emptyVolume({24, 22, 20}, glm::dvec3(1.0));
        for (std::uint16_t& code : study.codes)
            code = std::uint16_t(random() % 300);
        reference::Contour contour = contourIn(study,
            {.lowCode = 0, .highCode = 200, .softness = 60, .smoothness = 40, .round = true});
        addBall(contour, {12, 11, 10}, 4.0);
        const auto evolved = [&](int generations) {
            ContourGround ground = groundOf(contour, generations);
            const VoxelBox box = ground.box;
            ContourEvolution evolution(contour.rule, std::move(ground));
            while (evolution.generation() < generations && evolution.step(Progress())) { }
            return insideOf(evolution, box, study.volume.geometry.size);
        };
        const std::vector<bool> whole = evolved(7);
        contour.rule.round = false;
        QVERIFY(evolved(7) != whole);
        contour.rule.round = true;
        contour.inside = evolved(2);
        QVERIFY(evolved(5) == whole);
    }

    /// Where nothing holds it: the volume of the ball of its width, and rounder than an octahedron.
    void aFreeBubbleIsRound()
    {
        constexpr int generations = 16;
        constexpr double first = 2.0;
        constexpr double radius = first + generations;
        const glm::ivec3 size(43);
        const glm::ivec3 middle(21);
        const LoadedVolume study = emptyVolume(size, glm::dvec3(1.0));
        struct Body {
            double voxels = 0.0;
            double sphericity = 0.0;
            VoxelBox box{};
        };
        const auto body = [&](bool round) {
            reference::Contour contour =
                contourIn(study, {.lowCode = 0, .highCode = 0, .round = round});
            addBall(contour, middle, first);
            ContourGround ground = groundOf(contour, generations);
            const VoxelBox box = ground.box;
            ContourEvolution evolution(contour.rule, std::move(ground));
            while (evolution.generation() < generations && evolution.step(Progress())) { }
            const std::vector<bool> inside = insideOf(evolution, box, size);
            const std::vector<std::uint8_t> labels(inside.begin(), inside.end());
            SegmentMeter meter(study.volume.geometry, study.volume.encoding, {.label = 1}, labels);
            meter.count({.maximum = size}, study.codes);
            const SegmentStatistics measured = meter.statistics();
            return Body{.voxels = double(measured.voxels),
                .sphericity = measured.sphericity,
                .box = {measured.first, measured.last + 1}};
        };
        const Body plain = body(false);
        const Body round = body(true);
        // Both come as far along the axes.
        for (const Body* each : {&plain, &round}) {
            QVERIFY(each->box.minimum == middle - int(radius));
            QVERIFY(each->box.maximum == middle + int(radius) + 1);
        }
        double ball = 0.0;
        visitVoxels({glm::ivec3(0), size}, [&](const glm::ivec3& voxel) {
            ball += glm::length(glm::dvec3(voxel - middle)) <= radius ? 1.0 : 0.0;
        });
        qInfo("%.3f of the ball and sphericity %.3f, else %.3f and %.3f", round.voxels / ball,
            round.sphericity, plain.voxels / ball, plain.sphericity);
        QVERIFY(round.voxels >= 0.85 * ball && round.voxels <= 1.1 * ball);
        QVERIFY(plain.voxels < 0.5 * ball);
        QVERIFY(round.sphericity > plain.sphericity + 0.03);
    }

    /// What only corners and edges join is reached by wide generations alone, also when the others
    /// have come to rest.
    void wideGenerationsReachAcrossEdges()
    {
        const glm::ivec3 size(9);
        LoadedVolume study = emptyVolume(size, glm::dvec3(1.0));
        for (int step = 2; step < 7; ++step) // a stair whose steps share edges
            study.codes[placeIn(size, {step, step, 4})] = 100;
        for (const bool round : {false, true}) {
            reference::Contour contour = contourIn(
                study, {.lowCode = 100, .highCode = 100, .smoothness = 0, .round = round});
            contour.inside[placeIn(size, {2, 2, 4})] = true;
            ContourEvolution evolution(contour.rule, groundOf(contour, 20));
            while (evolution.generation() < 20 && evolution.step(Progress())) { }
            QVERIFY(evolution.rests());
            QCOMPARE(evolution.generation(), round ? 4 : 0);
            QCOMPARE(evolution.isInside({6, 6, 4}), round);
        }
    }

    /// Noisy shapes: closer to the truth than what hangs together by the interval.
    void noisyShapesAreFound_data()
    {
        QTest::addColumn<bool>("isVentricle");
        QTest::addColumn<double>("thickness");
        QTest::addColumn<int>("edge");
        for (const bool isVentricle : {false, true}) {
            for (const double thickness : {1.0, 2.5}) {
                for (const int edge : {0, 100})
                    QTest::addRow("%s, slices of %.1f mm, edges %d",
                        isVentricle ? "ventricle" : "ball", thickness, edge)
                        << isVentricle << thickness << edge;
            }
        }
    }
    void noisyShapesAreFound()
    {
        QFETCH(const bool, isVentricle);
        QFETCH(const double, thickness);
        QFETCH(const int, edge);
        const glm::ivec3 size(48, 48, int(48.0 / thickness));
        LoadedVolume study = emptyVolume(size, glm::dvec3(1.0, 1.0, thickness));
        const glm::dvec3 spacing = study.volume.geometry.spacingMm();
        const glm::dvec3 middle = glm::dvec3(size / 2) * spacing;
        // A horn that is bent and tapers to both ends, or a ball.
        const auto isTrue = [&](const glm::dvec3& at) {
            if (!isVentricle)
                return glm::length(at - middle) <= 14.0;
            const double along = at.y - middle.y;
            const glm::dvec2 axis{middle.x + 0.02 * along * along, middle.z};
            return std::abs(along) <= 18.0
                && glm::length(glm::dvec2(at.x, at.z) - axis) <= 7.0 - 0.12 * std::abs(along);
        };
        std::mt19937 random(11);
        std::vector<bool> truth;
        visitVoxels({glm::ivec3(0), size}, [&](const glm::ivec3& voxel) {
            truth.push_back(isTrue(glm::dvec3(voxel) * spacing));
            // A bell of 12 dice with a standard deviation of 150; the contrast is 400.
            int noise = -12 * 149 / 2;
            for (int die = 0; die < 12; ++die)
                noise += int(random() % 150);
            study.codes[placeIn(size, voxel)] = std::uint16_t((truth.back() ? 4000 : 4400) + noise);
        });
        reference::Contour contour = contourIn(study,
            {.lowCode = -noContourBound,
                .highCode = 4200,
                .softness = 200,
                .edge = edge,
                .smoothness = 50,
                .gradientWeights = glm::ivec3(1024, 1024, int(1024 / thickness)),
                .halfGradient = 600});
        addBall(contour, size / 2, 5.0);
        const double plain = diceOf(grownFrom(contour), truth);
        constexpr int generations = 400;
        ContourGround ground = groundOf(contour, generations);
        const VoxelBox box = ground.box;
        ContourEvolution evolution(contour.rule, std::move(ground));
        while (evolution.generation() < generations && evolution.step(Progress())) { }
        const double dice = diceOf(insideOf(evolution, box, size), truth);
        qInfo(
            "Dice %.4f after %d generations, %.4f by growth", dice, evolution.generation(), plain);
        QVERIFY(evolution.rests());
        QVERIFY(plain > 0.5); // growth is a peer here, no straw man
        QVERIFY(dice >= plain);
    }

    /// Two rooms and a channel of one voxel between them: what is smooth does not leak.
    void smoothnessStopsALeak()
    {
        const glm::ivec3 size(36, 15, 15);
        LoadedVolume study = emptyVolume(size, glm::dvec3(1.0));
        const VoxelBox one{{2, 2, 2}, {13, 13, 13}};
        const VoxelBox other{{23, 2, 2}, {34, 13, 13}};
        for (const VoxelBox& room : {one, VoxelBox{{13, 7, 7}, {23, 8, 8}}, other})
            visitVoxels(
                room, [&](const glm::ivec3& voxel) { study.codes[placeIn(size, voxel)] = 100; });
        for (const int smoothness : {0, 100}) {
            reference::Contour contour =
                contourIn(study, {.lowCode = 100, .highCode = 100, .smoothness = smoothness});
            visitVoxels(
                one, [&](const glm::ivec3& voxel) { contour.inside[placeIn(size, voxel)] = true; });
            ContourEvolution evolution(contour.rule, groundOf(contour, 100));
            while (evolution.generation() < 100 && evolution.step(Progress())) { }
            QVERIFY(evolution.rests());
            int leaked = 0;
            visitVoxels(
                other, [&](const glm::ivec3& voxel) { leaked += evolution.isInside(voxel); });
            QCOMPARE(leaked, smoothness == 0 ? 11 * 11 * 11 : 0);
        }
    }

    /// Smoothness alone: a speck goes, a hole closes, a segment of another stays out.
    void specksGoAndHolesClose()
    {
        const glm::ivec3 size(20, 20, 20);
        const LoadedVolume study = emptyVolume(size, glm::dvec3(1.0));
        reference::Contour contour = contourIn(study, {.region = 0, .smoothness = 100});
        addBall(contour, {10, 10, 10}, 6.0);
        contour.inside[placeIn(size, {10, 10, 10})] = false; // a hole
        contour.inside[placeIn(size, {11, 10, 6})] = false; // another one, which nobody may take
        contour.open[placeIn(size, {11, 10, 6})] = false;
        contour.inside[placeIn(size, {1, 1, 1})] = true; // a speck
        ContourEvolution evolution(contour.rule, groundOf(contour, 5));
        QVERIFY(evolution.step(Progress()));
        QVERIFY(evolution.isInside({10, 10, 10}));
        QVERIFY(!evolution.isInside({11, 10, 6}));
        QVERIFY(!evolution.isInside({1, 1, 1}));
    }

    /// A generation that was cancelled is as if it had not begun.
    void cancelledInTheMidst()
    {
        const LoadedVolume study = emptyVolume({40, 40, 40}, glm::dvec3(1.0));
        reference::Contour contour =
            contourIn(study, {.lowCode = 0, .highCode = 0, .smoothness = 10});
        addBall(contour, {20, 20, 20}, 15.0); // whose front has more voxels than are asked at once
        ContourGround ground = groundOf(contour, 3);
        const VoxelBox box = ground.box;
        ContourEvolution evolution(contour.rule, std::move(ground));
        QVERIFY(evolution.step(Progress()));
        const std::vector<bool> before = insideOf(evolution, box, study.volume.geometry.size);
        Progress cancelled;
        cancelled.cancel();
        QVERIFY(!evolution.step(cancelled));
        QVERIFY(!evolution.rests());
        QCOMPARE(evolution.generation(), 1);
        QVERIFY(insideOf(evolution, box, study.volume.geometry.size) == before);
        QVERIFY(evolution.step(Progress()));
        QCOMPARE(evolution.generation(), 2);
        // Before the front is known, too.
        ContourEvolution anew(contour.rule, groundOf(contour, 3));
        QVERIFY(!anew.step(cancelled));
        QVERIFY(anew.step(Progress()));
    }
};

BURIN_TEST(ContourEvolutionTest)

} // namespace contourEvolutionTest

#include "ContourEvolutionTest.moc"
