// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/engine/EngineCommands.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace capsuleEditsTest {

using namespace core;

namespace {

double distanceToPath(const glm::dvec3& point, const std::vector<glm::dvec3>& path)
{
    double nearest = glm::distance(point, path.front());
    for (std::size_t i = 1; i < path.size(); ++i) {
        const glm::dvec3 along = path[i] - path[i - 1];
        const double squared = glm::dot(along, along);
        const double t = squared > 0.0
            ? std::clamp(glm::dot(point - path[i - 1], along) / squared, 0.0, 1.0)
            : 0.0;
        nearest = std::min(nearest, glm::distance(point, path[i - 1] + t * along));
    }
    return nearest;
}

/// A document with one segment, and an oracle that is told what a session would tell it.
struct Bench {
    Document document;
    reference::ReferenceEngine engine;

    explicit Bench(const glm::ivec3& size, const glm::dmat3& perVoxel)
    {
        Volume volume;
        volume.geometry.size = size;
        volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(perVoxel[0], 0),
            glm::dvec4(perVoxel[1], 0), glm::dvec4(perVoxel[2], 0), glm::dvec4(-20, 30, 5, 1));
        document = initialDocument(volume);
        document.segments.push_back({.label = 1, .name = QStringLiteral("Liver")});
        document.segments.push_back({.label = 2, .name = QStringLiteral("Kidney")});
        const std::vector<std::uint16_t> codes(std::size_t(size.x) * size.y * size.z, 100);
        if (!engine.openVolume(size, codes))
            qFatal("no volume");
    }
    [[nodiscard]] const VolumeGeometry& geometry() const
    {
        return document.volumes.front().geometry;
    }

    void paint(const PaintStroke& stroke)
    {
        const auto edit = paintLabel(stroke, document);
        if (!edit)
            qFatal("%s", qPrintable(edit.error().arguments.join(u' ')));
        submitWhole(engine, *edit, {CapsulePath{capsules(stroke.path, geometry())}});
    }
    void carve(const BrushStroke& stroke)
    {
        submitWhole(engine, *capsuleCut(stroke, document),
            {CapsulePath{capsules(stroke.path, geometry())}});
    }
    [[nodiscard]] std::vector<glm::ivec3> voxels(int label = 1) const
    {
        reference::DenseFields fields = engine.fields();
        const auto& labels = fields.labels(0);
        std::vector<glm::ivec3> found;
        for (int z = 0; z < labels.size.z; ++z)
            for (int y = 0; y < labels.size.y; ++y)
                for (int x = 0; x < labels.size.x; ++x)
                    if (labels.at({x, y, z}) == label)
                        found.emplace_back(x, y, z);
        return found;
    }
};

const glm::dmat3 straight{glm::dvec3(0.7, 0, 0), glm::dvec3(0, 0.7, 0), glm::dvec3(0, 0, 5)};
const glm::dmat3 tilted{glm::dvec3(0.7, 0, 0), glm::dvec3(0, 0.7, 0), glm::dvec3(0, 1.5, 3)};
const glm::dmat3 oblique{
    glm::dvec3(0.6, 0.3, 0.1), glm::dvec3(-0.3, 0.6, 0.1), glm::dvec3(-0.2, -0.5, 2)};

} // namespace

class CapsuleEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void holdsWhatLiesWithinTheRadius_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 40; ++number)
            QTest::addRow("%d", number) << number;
    }
    /// Against distances in double precision, all voxels that are not on the very edge.
    void holdsWhatLiesWithinTheRadius()
    {
        QFETCH(int, number);
        test::Random random(std::uint32_t(300 + number));
        const glm::dmat3 perVoxel =
            number % 3 == 0 ? straight : (number % 3 == 1 ? tilted : oblique);
        Bench bench({28, 26, 14}, perVoxel);
        PaintStroke stroke{.segment = 1, .path = test::randomPath(bench.document, random)};
        stroke.path.shape = BrushPath::Shape::Ball;
        stroke.path.lifts.clear();
        stroke.path.pressures.reset();
        stroke.path.radiusMm = number % 7 == 0 ? 60.0 : 0.5 + 9.0 * test::randomUnit(random);
        bench.paint(stroke);
        reference::DenseFields fields = bench.engine.fields();
        const double edge = stroke.path.radiusMm / 2000.0 + 0.005;
        for (int z = 0; z < 14; ++z) {
            for (int y = 0; y < 26; ++y) {
                for (int x = 0; x < 28; ++x) {
                    const double distance =
                        distanceToPath(bench.geometry().toWorld({x, y, z}), stroke.path.pointsLps);
                    if (std::abs(distance - stroke.path.radiusMm) < edge)
                        continue;
                    QCOMPARE(int(fields.labels(0).at({x, y, z})),
                        distance < stroke.path.radiusMm ? 1 : 0);
                }
            }
        }
    }

    void aDiscKeepsToItsSlice_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("form");
        for (int axis = 0; axis < 3; ++axis) {
            QTest::addRow("straight, axis %d", axis) << axis << 0;
            QTest::addRow("tilted, axis %d", axis) << axis << 1;
            QTest::addRow("oblique, axis %d", axis) << axis << 2;
        }
    }
    void aDiscKeepsToItsSlice()
    {
        QFETCH(int, axis);
        QFETCH(int, form);
        const glm::dmat3 perVoxel = form == 0 ? straight : (form == 1 ? tilted : oblique);
        for (const double between : {0.0, 0.49, -0.49, 0.2}) {
            Bench bench({40, 36, 20}, perVoxel);
            PaintStroke stroke{.segment = 1};
            stroke.path.shape = BrushPath::Shape::Disc;
            stroke.path.radiusMm = 6.0;
            stroke.path.normalLps = glm::cross(perVoxel[(axis + 1) % 3], perVoxel[(axis + 2) % 3]);
            glm::dvec3 from(9.3, 11.7, 8.2);
            glm::dvec3 to(30.1, 20.9, 12.6);
            from[axis] = to[axis] = 10.0 + between;
            stroke.path.pointsLps = {bench.geometry().toWorld(from), bench.geometry().toWorld(to)};
            bench.paint(stroke);
            const std::vector<glm::ivec3> voxels = bench.voxels();
            QVERIFY(voxels.size() > 20);
            for (const glm::ivec3& voxel : voxels)
                QCOMPARE(voxel[axis], 10);
            // All of the slice that is near, measured in the plane.
            const glm::dvec3 normal = glm::normalize(*stroke.path.normalLps);
            const auto flat = [&](const glm::dvec3& point) {
                return point - normal * glm::dot(normal, point);
            };
            const std::vector<glm::dvec3> path{
                flat(stroke.path.pointsLps[0]), flat(stroke.path.pointsLps[1])};
            std::size_t expected = 0;
            for (int z = 0; z < 20; ++z)
                for (int y = 0; y < 36; ++y)
                    for (int x = 0; x < 40; ++x)
                        if (glm::ivec3(x, y, z)[axis] == 10
                            && distanceToPath(flat(bench.geometry().toWorld({x, y, z})), path)
                                <= 6.0)
                            ++expected;
            QVERIFY(std::abs(double(voxels.size()) - double(expected)) <= 2.0);
        }
    }

    /// Off the axes of the volume a disc is one voxel thick: every column along the steepest axis
    /// has one voxel, at most two where the plane passes just between.
    void anObliqueDiscIsOneVoxelThick()
    {
        Bench bench({40, 40, 30}, glm::dmat3(1.0));
        PaintStroke stroke{.segment = 1};
        stroke.path.shape = BrushPath::Shape::Disc;
        stroke.path.radiusMm = 9.0;
        stroke.path.normalLps = glm::dvec3(0.3, 0.45, 1.0);
        stroke.path.pointsLps = {bench.geometry().toWorld({19.3, 20.1, 14.6})};
        bench.paint(stroke);
        std::map<std::pair<int, int>, int> columns;
        for (const glm::ivec3& voxel : bench.voxels())
            ++columns[{voxel.x, voxel.y}];
        QVERIFY(columns.size() > 150);
        std::size_t doubled = 0;
        for (const auto& column : columns)
            doubled += column.second > 1 ? 1 : 0;
        QVERIFY(doubled * 50 < columns.size());
        for (int y = 15; y < 26; ++y)
            for (int x = 15; x < 24; ++x)
                QVERIFY2(columns.count({x, y}) != 0, "a hole");
    }

    void aSquareHoldsWhatItCovers_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 40; ++number)
            QTest::addRow("%d", number) << number;
    }
    /// Against distances in double precision along the sides, all voxels that are not on the edge.
    void aSquareHoldsWhatItCovers()
    {
        QFETCH(int, number);
        test::Random random(std::uint32_t(900 + number));
        const glm::dmat3 perVoxel =
            number % 3 == 0 ? straight : (number % 3 == 1 ? tilted : oblique);
        const bool flat = number % 2 != 0;
        Bench bench({28, 26, 14}, perVoxel);
        PaintStroke stroke{.segment = 1, .path = test::randomPath(bench.document, random)};
        BrushPath& path = stroke.path;
        path.lifts.clear();
        path.pressures.reset();
        path.radiusMm = 0.5 + 9.0 * test::randomUnit(random);
        path.shape = flat ? BrushPath::Shape::Square : BrushPath::Shape::Cube;
        path.normalLps = flat ? glm::cross(perVoxel[0], perVoxel[1]) : glm::dvec3(0.3, -0.2, 1.0);
        path.sideLps = glm::dvec3(1.0, 0.4, 0.2);
        path.pointsLps.front() = bench.geometry().toWorld({14, 13, 7});
        bench.paint(stroke);
        const glm::dvec3 normal = glm::normalize(*path.normalLps);
        const glm::dvec3 side =
            glm::normalize(*path.sideLps - normal * glm::dot(normal, *path.sideLps));
        const glm::dvec3 other = glm::cross(normal, side);
        // Which half side reaches the voxel from a place of the path.
        const auto half = [&](const glm::dvec3& way) {
            const double inPlane =
                std::max(std::abs(glm::dot(way, side)), std::abs(glm::dot(way, other)));
            return flat ? inPlane : std::max(inPlane, std::abs(glm::dot(way, normal)));
        };
        // It has one least value along a straight way.
        const auto least = [&](const glm::dvec3& place, const glm::dvec3& a, const glm::dvec3& b) {
            double from = 0.0;
            double to = 1.0;
            for (int step = 0; step < 80; ++step) {
                const double one = from + (to - from) / 3.0;
                const double two = to - (to - from) / 3.0;
                if (half(place - (a + one * (b - a))) <= half(place - (a + two * (b - a))))
                    to = two;
                else
                    from = one;
            }
            return half(place - (a + from * (b - a)));
        };
        const std::vector<glm::ivec3> voxels = bench.voxels();
        std::set<std::array<int, 3>> painted;
        for (const glm::ivec3& voxel : voxels)
            painted.insert({voxel.x, voxel.y, voxel.z});
        const double edge = path.radiusMm / 1000.0 + 0.005;
        std::size_t inside = 0;
        for (int z = 0; z < 14; ++z) {
            for (int y = 0; y < 26; ++y) {
                for (int x = 0; x < 28; ++x) {
                    if (flat && z != 7) {
                        QVERIFY(!painted.count({x, y, z}));
                        continue;
                    }
                    const glm::dvec3 place = bench.geometry().toWorld({x, y, z});
                    double nearest = half(place - path.pointsLps.front());
                    for (std::size_t i = 1; i < path.pointsLps.size(); ++i)
                        nearest = std::min(
                            nearest, least(place, path.pointsLps[i - 1], path.pointsLps[i]));
                    if (std::abs(nearest - path.radiusMm) < edge)
                        continue;
                    QCOMPARE(painted.count({x, y, z}) > 0, nearest < path.radiusMm);
                    inside += nearest < path.radiusMm ? 1 : 0;
                }
            }
        }
        QVERIFY(inside > 0);
        // More than the circle or ball of its radius, which it holds; but for what is on the edge.
        Bench round({28, 26, 14}, perVoxel);
        path.radiusMm -= edge;
        path.shape = flat ? BrushPath::Shape::Disc : BrushPath::Shape::Ball;
        round.paint(stroke);
        for (const glm::ivec3& voxel : round.voxels())
            QVERIFY(painted.count({voxel.x, voxel.y, voxel.z}));
        QVERIFY(round.voxels().size() <= painted.size());
    }

    void aSquareNeedsItsSides()
    {
        Bench bench({30, 30, 10}, straight);
        for (const auto shape : {BrushPath::Shape::Square, BrushPath::Shape::Cube}) {
            PaintStroke stroke{.segment = 1};
            stroke.path.shape = shape;
            stroke.path.pointsLps = {bench.geometry().toWorld({12, 15, 5})};
            const auto lacks = [&] {
                const auto refused = paintLabel(stroke, bench.document);
                return refused ? QString() : refused.error().arguments.value(0);
            };
            QCOMPARE(lacks(), QStringLiteral("paint.normalLps"));
            stroke.path.normalLps = glm::dvec3(0, 0, 2);
            QCOMPARE(lacks(), QStringLiteral("paint.sideLps"));
            stroke.path.sideLps = glm::dvec3(0.0);
            QCOMPARE(lacks(), QStringLiteral("paint.sideLps"));
            stroke.path.sideLps = glm::dvec3(0, 0, -1);
            QCOMPARE(lacks(), QStringLiteral("paint.sideLps"));
            stroke.path.sideLps = glm::dvec3(0, 1, 1);
            QCOMPARE(lacks(), QString());
        }
    }

    /// The pen reports at some rate, and the path is told at once or point by point.
    void doesNotDependOnHowThePathIsTold()
    {
        for (const bool disc : {false, true}) {
            std::vector<std::vector<glm::ivec3>> results;
            for (const int pieces : {1, 4, 30, 240}) {
                Bench bench({60, 40, 20}, oblique);
                PaintStroke stroke{.segment = 1};
                stroke.path.radiusMm = 2.0;
                if (disc) {
                    stroke.path.shape = BrushPath::Shape::Disc;
                    stroke.path.normalLps = glm::cross(oblique[0], oblique[1]);
                }
                const glm::dvec3 from = bench.geometry().toWorld({5, 6, 9});
                const glm::dvec3 to = bench.geometry().toWorld({52, 30, 9});
                for (int i = 0; i <= pieces; ++i)
                    stroke.path.pointsLps.push_back(from + (to - from) * (double(i) / pieces));
                bench.paint(stroke);
                results.push_back(bench.voxels());
                QVERIFY(results.back().size() > 100);
            }
            for (const auto& result : results)
                QVERIFY(std::abs(double(result.size()) - double(results[0].size())) <= 3.0);
        }
        // To the bit where the points are the same.
        test::Random random(9);
        Bench bench({60, 40, 20}, oblique);
        BrushPath path = test::randomPath(bench.document, random);
        path.lifts.clear();
        for (const bool pressed : {false, true}) {
            path.pressures.reset();
            if (pressed)
                path.pressures.emplace(path.pointsLps.size(), 0.75);
            if (pressed)
                path.pressures->front() = 0.25;
            const auto whole = capsules(path, bench.geometry());
            std::vector<Capsule> told;
            for (std::size_t i = 0; i < path.pointsLps.size(); ++i) {
                PartPressures part;
                if (pressed)
                    part.atPoints = {(*path.pressures)[i]};
                if (pressed && i > 0)
                    part.before = (*path.pressures)[i - 1];
                const auto more = capsules(path, bench.geometry(),
                    i > 0 ? &path.pointsLps[i - 1] : nullptr, {path.pointsLps[i]}, part);
                told.insert(told.end(), more.begin(), more.end());
            }
            QCOMPARE(told.size(), whole.size());
            for (std::size_t i = 0; i < told.size(); ++i)
                QVERIFY(told[i].from == whole[i].from && told[i].direction == whole[i].direction
                    && told[i].length == whole[i].length && told[i].less == whole[i].less);
            QCOMPARE(std::any_of(whole.begin(), whole.end(),
                         [](const Capsule& capsule) { return capsule.less != 0; }),
                pressed);
        }
    }

    /// The radius runs evenly from one pressure to the next, in steps of at most a quarter of a
    /// voxel; the voxels are those of the cone, but for such a step.
    void theRadiusFollowsThePressure()
    {
        Bench bench({60, 40, 20}, straight);
        PaintStroke stroke{.segment = 1};
        stroke.path.radiusMm = 8.0;
        const auto at = [&](double x) { return bench.geometry().toWorld({x, 20.0, 10.0}); };
        stroke.path.pointsLps = {at(15.0), at(45.0)};
        stroke.path.pressures = std::vector<double>{0.25, 1.0};
        const std::vector<Capsule> pieces = capsules(stroke.path, bench.geometry());
        const glm::dvec3 spacing = bench.geometry().spacingMm();
        const double quarter = 0.25 * std::min({spacing.x, spacing.y, spacing.z}) * 65536.0;
        QVERIFY(pieces.size() > 3);
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            const double narrower = double(pieces[i - 1].less) - double(pieces[i].less);
            QVERIFY(narrower >= 0.0 && narrower <= quarter + 2.0);
        }
        bench.paint(stroke);
        std::set<std::array<int, 3>> painted;
        for (const glm::ivec3& voxel : bench.voxels())
            painted.insert({voxel.x, voxel.y, voxel.z});
        QVERIFY(painted.size() > 500);
        const glm::dvec3 from = stroke.path.pointsLps[0];
        const glm::dvec3 way = stroke.path.pointsLps[1] - from;
        for (int z = 0; z < 20; ++z) {
            for (int y = 0; y < 40; ++y) {
                for (int x = 0; x < 60; ++x) {
                    // How deep it lies within the balls along the way, whose radius changes.
                    const glm::dvec3 place = bench.geometry().toWorld({x, y, z});
                    double deepest = -1e9;
                    for (int step = 0; step <= 400; ++step) {
                        const double share = step / 400.0;
                        deepest = std::max(deepest,
                            8.0 * (0.25 + 0.75 * share) - glm::distance(place, from + share * way));
                    }
                    const bool isIn = painted.count({x, y, z}) > 0;
                    const double slack = 0.3 * std::min({spacing.x, spacing.y, spacing.z});
                    QVERIFY2(isIn ? deepest > -slack : deepest < slack,
                        qPrintable(QString::number(deepest)));
                }
            }
        }
    }

    /// A pen that hardly moves while it is pressed harder, or less: the larger ball holds the rest.
    void aShortWayIsItsLargerEnd()
    {
        for (const bool disc : {false, true}) {
            for (const bool harder : {true, false}) {
                Bench bench({60, 40, 20}, straight);
                PaintStroke stroke{.segment = 1};
                stroke.path.radiusMm = 8.0;
                if (disc) {
                    stroke.path.shape = BrushPath::Shape::Disc;
                    stroke.path.normalLps = glm::dvec3(0.0, 0.0, 1.0);
                }
                const glm::dvec3 from = bench.geometry().toWorld({28.0, 20.0, 10.0});
                // 6 mm of radius come or go on the way.
                const auto pressed = [&](double wayMm) {
                    stroke.path.pointsLps = {from, from + glm::dvec3(wayMm, 0.0, 0.0)};
                    stroke.path.pressures =
                        harder ? std::vector<double>{0.25, 1.0} : std::vector<double>{1.0, 0.25};
                    return capsules(stroke.path, bench.geometry());
                };
                const std::vector<Capsule> made = pressed(5.5);
                QCOMPARE(made.size(), std::size_t(2)); // one of the first point, one of the way
                QCOMPARE(made.back().less, 0);
                QCOMPARE(made.back().length, 0);
                QVERIFY((made.back().from == made.front().from) == !harder);
                QVERIFY(pressed(6.5).size() > 5);
                static_cast<void>(pressed(5.5));
                bench.paint(stroke);
                std::set<std::array<int, 3>> painted;
                for (const glm::ivec3& voxel : bench.voxels())
                    painted.insert({voxel.x, voxel.y, voxel.z});
                Bench other({60, 40, 20}, straight);
                PaintStroke whole = stroke;
                whole.path.pointsLps = {stroke.path.pointsLps[harder ? 1 : 0]};
                whole.path.pressures.reset();
                other.paint(whole);
                std::set<std::array<int, 3>> expected;
                for (const glm::ivec3& voxel : other.voxels())
                    expected.insert({voxel.x, voxel.y, voxel.z});
                QVERIFY(expected.size() > 50 && painted == expected);
            }
        }
    }

    void aPathHasAsManyPressuresAsPoints()
    {
        Bench bench({30, 30, 10}, straight);
        PaintStroke stroke{.segment = 1};
        stroke.path.radiusMm = 4.0;
        stroke.path.pointsLps = {
            bench.geometry().toWorld({12, 15, 5}), bench.geometry().toWorld({15, 15, 5})};
        stroke.path.pressures = std::vector<double>{0.5};
        const auto refused = paintLabel(stroke, bench.document);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        QVERIFY(refused.error().arguments.front().endsWith(QLatin1String(".pressures")));
        stroke.path.pressures = std::vector<double>{0.5, 1.0};
        QVERIFY(paintLabel(stroke, bench.document));
    }

    /// Where the pen is lifted nothing lies between.
    void aLiftedPathIsTwo()
    {
        Bench bench({60, 40, 20}, straight);
        PaintStroke stroke{.segment = 1};
        stroke.path.radiusMm = 2.0;
        const auto at = [&](int x) { return bench.geometry().toWorld({x, 20, 10}); };
        stroke.path.pointsLps = {at(8), at(14), at(44), at(50)};
        stroke.path.lifts = {2};
        bench.paint(stroke);
        bool before = false;
        bool behind = false;
        for (const glm::ivec3& voxel : bench.voxels()) {
            QVERIFY(voxel.x < 18 || voxel.x > 40);
            before = before || voxel.x == 11;
            behind = behind || voxel.x == 47;
        }
        QVERIFY(before && behind);
        // Places that are not there change nothing.
        const std::size_t voxels = bench.voxels().size();
        stroke.path.lifts = {2, 4, 900};
        bench.paint(stroke);
        QCOMPARE(bench.voxels().size(), voxels);
    }

    void aLongWayCostsNoMoreThanTheVolumeHolds()
    {
        Bench bench({40, 36, 20}, straight);
        BrushPath path{.radiusMm = 0.01};
        path.pointsLps = {glm::dvec3(-99000, 99000, -99000), glm::dvec3(99000, -99000, 99000)};
        QVERIFY(capsules(path, bench.geometry()).size() < 100);
        path.pointsLps = {glm::dvec3(99000, 0, 0), glm::dvec3(99000, 5, 0)};
        QVERIFY(capsules(path, bench.geometry()).empty());
    }

    void paintTakesOnlyWhatItMay()
    {
        Bench bench({30, 30, 10}, straight);
        PaintStroke stroke{.segment = 1};
        stroke.path.radiusMm = 4.0;
        stroke.path.pointsLps = {bench.geometry().toWorld({12, 15, 5})};
        bench.paint(stroke);
        const std::size_t liver = bench.voxels(1).size();
        PaintStroke other = stroke;
        other.segment = 2;
        other.path.pointsLps = {bench.geometry().toWorld({15, 15, 5})};
        bench.paint(other);
        QCOMPARE(bench.voxels(1).size(), liver);
        QVERIFY(!bench.voxels(2).empty());
        other.overwriteUnlocked = true;
        bench.paint(other);
        QVERIFY(bench.voxels(1).size() < liver);
        // Erasing takes the one segment only.
        const std::size_t kidney = bench.voxels(2).size();
        stroke.erase = true;
        stroke.path.radiusMm = 40.0;
        bench.paint(stroke);
        QCOMPARE(bench.voxels(1).size(), std::size_t(0));
        QCOMPARE(bench.voxels(2).size(), kidney);

        bench.document.segment(2)->locked = true;
        PaintStroke locked = other;
        QCOMPARE(paintLabel(locked, bench.document).error().code, ErrorCode::SegmentLocked);
        PaintStroke over = stroke;
        over.erase = false;
        over.overwriteUnlocked = true;
        bench.paint(over);
        QCOMPARE(bench.voxels(2).size(), kidney);
        over.segment = 7;
        QCOMPARE(paintLabel(over, bench.document).error().code, ErrorCode::UnknownSegment);
        over.segment = 1;
        over.path.shape = BrushPath::Shape::Disc;
        QCOMPARE(paintLabel(over, bench.document).error().arguments.value(0),
            QStringLiteral("paint.normalLps"));
        over.lower = 5.0;
        over.upper = 4.0;
        QCOMPARE(paintLabel(over, bench.document).error().arguments.value(0),
            QStringLiteral("paint.upper"));
    }

    /// What is painted as seeds is there before any growth: no burst counts it, none takes it back.
    void growthGoesOnFromPaint()
    {
        Bench bench({30, 30, 10}, straight);
        PaintStroke stroke{.segment = 1};
        stroke.path.radiusMm = 2.0;
        stroke.path.pointsLps = {bench.geometry().toWorld({12, 15, 5})};
        for (const bool seeds : {false, true}) {
            stroke.seeds = seeds;
            bench.paint(stroke);
            const std::size_t painted = bench.voxels().size();
            static_cast<void>(bench.engine.collect());
            submitWhole(bench.engine, GrowBurst{.lowCode = 0, .highCode = 200}, {GrowAdvance{1}});
            const EngineResult grown = bench.engine.collect().back();
            QCOMPARE(grown.statistics.voxelsChanged > 0, seeds);
            QCOMPARE(grown.generation, seeds ? 1u : 0u);
            QCOMPARE(bench.voxels().size() > painted, seeds);
            reference::DenseFields fields = bench.engine.fields();
            std::size_t before = 0;
            for (const std::uint32_t word : fields.seedWords(0).values)
                before += seedWord::isMember(word) && seedWord::generation(word) == 0 ? 1 : 0;
            QCOMPARE(before, seeds ? painted : std::size_t(0));
        }
    }

    void carvingAndRestoringMeet()
    {
        Bench bench({40, 36, 20}, oblique);
        BrushStroke stroke;
        stroke.path.radiusMm = 5.0;
        stroke.path.pointsLps = {
            bench.geometry().toWorld({12, 15, 8}), bench.geometry().toWorld({28, 20, 10})};
        bench.carve(stroke);
        reference::DenseFields carved = bench.engine.fields();
        const auto& coverage = carved.coverage(1);
        for (int z = 0; z < 20; ++z) {
            for (int y = 0; y < 36; ++y) {
                for (int x = 0; x < 40; ++x) {
                    const double inside = 5.0
                        - distanceToPath(
                            bench.geometry().toWorld({x, y, z}), stroke.path.pointsLps);
                    const int value = coverage.at({x, y, z});
                    if (inside > 0.36)
                        QCOMPARE(value, 255);
                    else if (inside < -0.36)
                        QCOMPARE(value, 0);
                    else
                        QVERIFY(std::abs(value - (inside + 0.34) / 0.68 * 255.0) < 12.0);
                }
            }
        }
        stroke.restore = true;
        bench.carve(stroke);
        reference::DenseFields restored = bench.engine.fields();
        for (const std::uint8_t value : restored.coverage(1).values)
            QVERIFY(value < 128);
    }
};

BURIN_TEST(CapsuleEditsTest)

} // namespace capsuleEditsTest

#include "CapsuleEditsTest.moc"
