// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace edgeStrokesTest {

using namespace core;
using test::Random;

namespace {

using Voxels = std::set<std::array<int, 3>>;
using Shape = BrushPath::Shape;

constexpr std::array<Shape, 4> shapes{Shape::Ball, Shape::Disc, Shape::Square, Shape::Cube};
const glm::ivec3 size(40, 36, 20);

/// A volume of 0.7 × 0.7 × 2 mm with one segment, whose values are its codes less 1000.
struct Bench {
    Document document;
    std::vector<std::uint16_t> codes;

    explicit Bench(const std::function<int(const glm::ivec3&)>& code)
    {
        Volume volume;
        volume.geometry.size = size;
        volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(0.7, 0, 0, 0),
            glm::dvec4(0, 0.7, 0, 0), glm::dvec4(0, 0, 2, 0), glm::dvec4(-20, 30, 5, 1));
        volume.encoding.rescaleIntercept = -1000.0;
        document = initialDocument(volume);
        document.segments.push_back({.label = 1, .name = QStringLiteral("Liver")});
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    codes.push_back(std::uint16_t(code({x, y, z})));
    }
    [[nodiscard]] const VolumeGeometry& geometry() const
    {
        return document.volumes.front().geometry;
    }
    /// A stroke through these places, given as indices.
    [[nodiscard]] PaintStroke stroke(Shape shape, const std::vector<glm::dvec3>& places) const
    {
        PaintStroke made{.segment = 1, .edgeTolerance = 50.0};
        made.path.radiusMm = 6.0;
        made.path.shape = shape;
        if (shape != Shape::Ball)
            made.path.normalLps = glm::dvec3(0, 0, 1);
        if (isSquare(shape))
            made.path.sideLps = glm::dvec3(1, 0.2, 0);
        for (const glm::dvec3& place : places)
            made.path.pointsLps.push_back(geometry().toWorld(place));
        return made;
    }
    /// What is painted by a stroke that is told in these pieces.
    [[nodiscard]] Voxels painted(const PaintStroke& stroke, std::vector<EngineExtension> path) const
    {
        reference::ReferenceEngine engine;
        if (!engine.openVolume(size, codes))
            qFatal("no volume");
        const auto edit = paintLabel(stroke, document);
        if (!edit)
            qFatal("%s", qPrintable(edit.error().arguments.join(u' ')));
        submitWhole(engine, *edit, std::move(path));
        reference::DenseFields fields = engine.fields();
        Voxels found;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    if (fields.labels(0).at({x, y, z}) == 1)
                        found.insert({x, y, z});
        return found;
    }
    [[nodiscard]] Voxels painted(const PaintStroke& stroke) const
    {
        return painted(stroke, {paintPath(stroke, geometry())});
    }
};

PaintStroke withoutEdges(PaintStroke stroke)
{
    stroke.edgeTolerance.reset();
    stroke.toleranceByPressure.reset();
    return stroke;
}

PaintStroke withoutPressures(PaintStroke stroke)
{
    stroke.path.pressures.reset();
    stroke.toleranceByPressure.reset();
    return stroke;
}

} // namespace

class EdgeStrokesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Where there is no edge the brush takes all that it sweeps.
    void withoutAnEdgeItIsAPlainBrush()
    {
        const Bench bench([](const glm::ivec3&) { return 1100; });
        Random random(5);
        for (const Shape shape : shapes) {
            for (int turn = 0; turn < 4; ++turn) {
                std::vector<glm::dvec3> places;
                for (int i = 0; i <= turn; ++i)
                    places.emplace_back(5.0 + 29.0 * test::randomUnit(random),
                        5.0 + 25.0 * test::randomUnit(random), 9.0);
                PaintStroke stroke = bench.stroke(shape, places);
                if (turn == 3)
                    stroke.path.lifts = {2};
                const Voxels plain = bench.painted(withoutEdges(stroke));
                QVERIFY(plain.size() > 100);
                QVERIFY(bench.painted(stroke) == plain);
                // An oblique plane holds together, but for voxels on the very edge of the brush.
                if (shape == Shape::Ball)
                    continue;
                stroke.path.normalLps = glm::dvec3(0.6, 0.4, 1.0);
                const Voxels oblique = bench.painted(withoutEdges(stroke));
                const Voxels joined = bench.painted(stroke);
                QVERIFY(
                    std::includes(oblique.begin(), oblique.end(), joined.begin(), joined.end()));
                QVERIFY2(100 * joined.size() >= 97 * oblique.size(),
                    qPrintable(QStringLiteral("%1 of %2").arg(joined.size()).arg(oblique.size())));
            }
        }
    }

    void aWallHoldsItBack()
    {
        // Its values on both sides are those of the start.
        const Bench bench([](const glm::ivec3& at) { return at.x == 22 ? 1300 : 1100 + at.y; });
        for (const Shape shape : shapes) {
            PaintStroke stroke = bench.stroke(shape, {{17, 12, 9}, {18, 20, 9}});
            const Voxels plain = bench.painted(withoutEdges(stroke));
            Voxels expected;
            for (const auto& voxel : plain) {
                if (voxel[0] < 22)
                    expected.insert(voxel);
            }
            QVERIFY(expected.size() + 40 < plain.size());
            QVERIFY(bench.painted(stroke) == expected);
            // The value is the one of where it begins: 1112; rows further off are no longer alike.
            stroke.edgeTolerance = 5.0;
            for (auto voxel = expected.begin(); voxel != expected.end();)
                voxel = std::abs((*voxel)[1] - 12) <= 5 ? std::next(voxel) : expected.erase(voxel);
            QVERIFY(bench.painted(stroke) == expected);
            // A tolerance of half a code is none of a code.
            stroke.edgeTolerance = 0.5;
            for (const auto& voxel : bench.painted(stroke))
                QCOMPARE(voxel[1], 12);
            stroke.edgeTolerance = 1000.0;
            QVERIFY(bench.painted(stroke) == plain);
            // Where the pen crosses the wall, both sides are under it.
            stroke.edgeTolerance = 50.0;
            stroke.path.pointsLps.push_back(bench.geometry().toWorld({30, 20, 9}));
            const Voxels both = bench.painted(stroke);
            QVERIFY(
                std::any_of(both.begin(), both.end(), [](const auto& at) { return at[0] > 22; }));
            QVERIFY(
                std::none_of(both.begin(), both.end(), [](const auto& at) { return at[0] == 22; }));
        }
    }

    /// A single voxel of another value where it begins does not decide.
    void noiseAtTheStartDoesNotDecide()
    {
        const Bench bench(
            [](const glm::ivec3& at) { return at == glm::ivec3(17, 12, 9) ? 1700 : 1100; });
        for (const Shape shape : shapes) {
            const PaintStroke stroke = bench.stroke(shape, {{17, 12, 9}, {19, 12, 9}});
            Voxels expected = bench.painted(withoutEdges(stroke));
            QCOMPARE(expected.erase({17, 12, 9}), std::size_t(1));
            QVERIFY(bench.painted(stroke) == expected);
        }
    }

    /// Point by point, in any order, or at once: it comes to the same. Limits are honoured.
    void doesNotDependOnHowThePathIsTold()
    {
        Random random(77);
        std::vector<int> noise;
        for (int i = 0; i < size.x * size.y * size.z; ++i)
            noise.push_back(test::randomInt(random, 1000, 1160));
        const Bench bench([&](const glm::ivec3& at) {
            return noise[std::size_t(at.x + size.x * (at.y + size.y * at.z))];
        });
        std::vector<std::pair<Shape, bool>> ways;
        for (const Shape shape : shapes) {
            for (const bool ofTolerance : {false, true})
                ways.emplace_back(shape, ofTolerance);
        }
        for (const auto& [shape, ofTolerance] : ways) {
            PaintStroke stroke = bench.stroke(shape,
                {{12, 12, 9}, {20, 14, 9.2}, {14, 22, 8.8}, {30, 30, 9}, {30, 12, 9}, {-9, 3, 9}});
            stroke.toleranceByPressure = ofTolerance;
            stroke.path.lifts = {3};
            stroke.path.pressures = std::vector<double>{1.0, 0.5, 1.0, 0.7, 0.9, 1.0};
            stroke.edgeTolerance = 30.0;
            stroke.upper = 105.0;
            const Voxels whole = bench.painted(stroke);
            QVERIFY(whole.size() > 10);
            QVERIFY(whole.size() < bench.painted(withoutEdges(stroke)).size());
            for (const auto& voxel : whole)
                QVERIFY(
                    noise[std::size_t(voxel[0] + size.x * (voxel[1] + size.y * voxel[2]))] <= 1105);
            const BrushPath& path = stroke.path;
            std::vector<EngineExtension> pieces;
            for (std::size_t i = 0; i < path.pointsLps.size(); ++i) {
                const glm::dvec3* from = i == 0 || i == 3 ? nullptr : &path.pointsLps[i - 1];
                const double before = i == 0 ? 1.0 : (*path.pressures)[i - 1];
                pieces.push_back(
                    CapsulePath{capsules(path, bench.geometry(), from, {path.pointsLps[i]},
                                    {.atPoints = {(*path.pressures)[i]},
                                        .before = before,
                                        .ofTolerance = ofTolerance}),
                        voxelsUnder(path, bench.geometry(), from, {path.pointsLps[i]})});
            }
            QVERIFY(bench.painted(stroke, pieces) == whole);
            std::reverse(pieces.begin(), pieces.end());
            QVERIFY(bench.painted(stroke, pieces) == whole);
        }
    }

    /// The radius stays whole, the tolerance is the share of it that the pen is pressed.
    void theToleranceFollowsThePressure()
    {
        // The value is 1112; each row differs by one more.
        const Bench bench([](const glm::ivec3& at) { return 1100 + at.y; });
        for (const Shape shape : shapes) {
            PaintStroke pressed = bench.stroke(shape, {{17, 12, 9}});
            pressed.edgeTolerance = 10.0;
            pressed.toleranceByPressure = true;
            PaintStroke plain = withoutPressures(pressed);
            for (const auto& [pressure, tolerance] : {std::pair(1.0, 10.0), std::pair(0.5, 5.0),
                     std::pair(0.35, 3.0), std::pair(0.0, 0.0)}) {
                pressed.path.pressures = std::vector<double>{pressure};
                plain.edgeTolerance = tolerance;
                const Voxels expected = bench.painted(plain);
                QVERIFY(!expected.empty());
                QVERIFY(bench.painted(pressed) == expected);
            }
            // Where a stroke is pressed more it takes more, to the last voxel of its whole radius.
            pressed = bench.stroke(shape, {{14, 12, 9}, {30, 12, 9}});
            pressed.path.pressures = std::vector<double>{0.1, 1.0};
            pressed.edgeTolerance = 10.0;
            pressed.toleranceByPressure = true;
            plain = withoutPressures(pressed);
            const Voxels all = bench.painted(plain);
            const Voxels some = bench.painted(pressed);
            QVERIFY(some.size() < all.size());
            QVERIFY(std::includes(all.begin(), all.end(), some.begin(), some.end()));
            const auto rowsAt = [&some](int x) {
                std::set<int> rows;
                for (const auto& voxel : some) {
                    if (voxel[0] == x && voxel[2] == 9)
                        rows.insert(voxel[1]);
                }
                return rows.size();
            };
            QVERIFY(rowsAt(10) < rowsAt(30));
            QVERIFY(rowsAt(30) >= std::size_t(15));
        }
        PaintStroke without = bench.stroke(Shape::Ball, {{17, 12, 9}});
        without.edgeTolerance.reset();
        without.toleranceByPressure = true;
        const auto refused = paintLabel(without, bench.document);
        QVERIFY(!refused);
        QCOMPARE(refused.error().arguments.value(0), QStringLiteral("paint.toleranceByPressure"));
    }

    void aToleranceBelowNoneIsRefused()
    {
        const Bench bench([](const glm::ivec3&) { return 1100; });
        PaintStroke stroke = bench.stroke(Shape::Ball, {{17, 12, 9}});
        stroke.edgeTolerance = -1.0;
        const auto refused = paintLabel(stroke, bench.document);
        QVERIFY(!refused);
        QCOMPARE(refused.error().arguments.value(0), QStringLiteral("paint.edgeTolerance"));
        // It begins at the nearest voxel where the pen is put down outside.
        stroke = bench.stroke(Shape::Disc, {{-200, 12, 9}});
        QCOMPARE(paintLabel(stroke, bench.document)->edges->start, glm::ivec3(0, 12, 9));
    }
};

BURIN_TEST(EdgeStrokesTest)

} // namespace edgeStrokesTest

#include "EdgeStrokesTest.moc"
