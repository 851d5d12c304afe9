// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/NudgeDisc.h"

#include "core/edits/EditQuantise.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nudgeDiscTest {

using namespace core;
using test::Bytes;
using test::Random;
using Shape = BrushPath::Shape;

namespace {

const glm::ivec3 size(40, 36, 20);
constexpr double roundingMm = 0.02; ///< between real numbers and the integers of the rule

/// A volume with four segments in one plane.
struct Bench {
    Document document;

    explicit Bench(const glm::dmat4& indexToWorld)
    {
        Volume volume;
        volume.geometry.size = size;
        volume.geometry.indexToWorld = indexToWorld;
        document = initialDocument(volume);
        for (int label = 1; label <= 4; ++label)
            document.segments.push_back(
                {.label = std::uint8_t(label), .name = QString::number(label)});
    }
    [[nodiscard]] const VolumeGeometry& geometry() const
    {
        return document.volumes.front().geometry;
    }
    [[nodiscard]] double finestMm() const
    {
        const glm::dvec3 spacing = geometry().spacingMm();
        return std::min({spacing.x, spacing.y, spacing.z});
    }
    /// A nudge that begins here, outwards; it would take other segments' voxels, too.
    [[nodiscard]] PaintStroke nudge(
        const glm::dvec3& index, const glm::dvec3& normal, double radiusMm) const
    {
        PaintStroke made{.segment = 1, .overwriteUnlocked = true};
        made.path.radiusMm = radiusMm;
        made.path.shape = Shape::Disc;
        made.path.normalLps = normal;
        made.path.pointsLps = {geometry().toWorld(index)};
        made.tool = PaintStroke::Tool::Nudge;
        return quantised(Edit(made)).get<PaintStroke>();
    }
    /// Asked of the bricks that are named, and of all.
    [[nodiscard]] NudgeStart start(const PaintStroke& nudge, const Bytes& labels) const
    {
        const auto disc = nudgeDisc(nudge.path, geometry(), QStringLiteral("paint"));
        if (!disc)
            qFatal("%s", qPrintable(disc.error().arguments.join(u' ')));
        const BrickGrid grid{size};
        const std::vector<BrickImage> all = test::bricksOf(labels, Field::Labels, 0);
        std::vector<BrickImage> near;
        for (const std::uint32_t brick : disc->bricks)
            near.push_back(all[brick]);
        const auto label = std::uint8_t(nudge.segment);
        const NudgeStart found = nudgeStart(disc->frame, disc->centre, grid, label, near);
        if (!disc->bricks.empty()
            && found != nudgeStart(disc->frame, disc->centre, grid, label, all))
            qFatal("a brick is missing");
        return found;
    }
    [[nodiscard]] Bytes after(const PaintStroke& stroke, const Bytes& labels) const
    {
        reference::ReferenceEngine engine;
        const std::vector<std::uint16_t> codes(geometry().voxelCount(), 1000);
        const auto edit = paintLabel(stroke, document);
        if (!edit || !engine.openVolume(size, codes))
            qFatal("no stroke");
        engine.submit(SwapBricks{test::bricksOf(labels, Field::Labels, 0)});
        submitWhole(engine, *edit, {paintPath(stroke, geometry())});
        reference::DenseFields fields = engine.fields();
        return fields.labels(0);
    }
    /// How far a voxel is from where a stroke begins, along its slice.
    [[nodiscard]] double awayMm(const glm::ivec3& voxel, const PaintStroke& stroke) const
    {
        const glm::dvec3 normal = glm::normalize(*stroke.path.normalLps);
        const glm::dvec3 way =
            geometry().toWorld(glm::dvec3(voxel)) - stroke.path.pointsLps.front();
        return glm::length(way - normal * glm::dot(way, normal));
    }
};

Bytes nothing()
{
    return {size, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * size.z, 0)};
}

template <class Does> void eachVoxel(Does does)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                does(glm::ivec3(x, y, z));
}

/// Segment 1 in columns 10 … 19 of slice 9.
Bytes block()
{
    Bytes labels = nothing();
    eachVoxel([&](const glm::ivec3& voxel) {
        if (voxel.z == 9 && voxel.x >= 10 && voxel.x < 20)
            labels.at(voxel) = 1;
    });
    return labels;
}

glm::dmat4 axial()
{
    return {{0.7, 0, 0, 0}, {0, 0.7, 0, 0}, {0, 0, 2, 0}, {-20, 30, 5, 1}};
}

/// Turned about an axis that is none of the volume's.
glm::dmat4 turned()
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    const double angle = 0.6;
    const auto turn = [&](const glm::dvec3& v) {
        return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle)
            + axis * glm::dot(axis, v) * (1.0 - std::cos(angle));
    };
    return {glm::dvec4(turn({1.1, 0, 0}), 0.0), glm::dvec4(turn({0, 0.8, 0}), 0.0),
        glm::dvec4(turn({0, 0, 1.5}), 0.0), glm::dvec4(12, -7, 40, 1)};
}

double radiusOf(const NudgeStart& start)
{
    return fittingRadiusMm(start);
}

} // namespace

class NudgeDiscTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itFitsBetweenTheBorders()
    {
        const Bench bench(axial());
        const Bytes labels = block();
        const glm::dvec3 up(0, 0, 1);
        const auto at = [&](double column, double radiusMm) {
            return bench.start(bench.nudge({column, 15, 9}, up, radiusMm), labels);
        };
        // Column 9 is five columns away, 20 is six; on the other side of the border 19 is five.
        for (const double column : {14.0, 24.0}) {
            const NudgeStart start = at(column, 8.0);
            QCOMPARE(start.isInside, column == 14.0);
            QVERIFY2(radiusOf(start) < 3.5 && radiusOf(start) > 3.5 - roundingMm,
                qPrintable(QString::number(radiusOf(start), 'f', 4)));
            QCOMPARE(start.fittingRadius % 64, 0); // as an edit has it
            QCOMPARE(at(column, 2.0).fittingRadius, 2 << 16); // it is no larger than was chosen
            QCOMPARE(at(column, 2.0).isInside, column == 14.0);
        }
        // Close to the border it is small, on either side, but never nothing.
        QVERIFY(at(19.4, 8.0).isInside);
        QVERIFY(radiusOf(at(19.4, 8.0)) < 0.42 && radiusOf(at(19.4, 8.0)) > 0.38);
        QVERIFY(!at(19.6, 8.0).isInside);
        QVERIFY(radiusOf(at(19.6, 8.0)) < 0.42 && radiusOf(at(19.6, 8.0)) > 0.38);
        // Other slices have no say, nor has what lies beyond the disc.
        for (const glm::dvec3& index : {glm::dvec3(14, 15, 8), glm::dvec3(30, 15, 9)}) {
            const NudgeStart start = bench.start(bench.nudge(index, up, 5.0), labels);
            QVERIFY(!start.isInside);
            QCOMPARE(start.fittingRadius, 5 << 16);
        }
        // Beside the volume it is beside the segment, too.
        const NudgeStart beyond = bench.start(bench.nudge({-900, 15, 9}, up, 5.0), labels);
        QVERIFY(!beyond.isInside);
        QCOMPARE(beyond.fittingRadius, 5 << 16);
    }

    /// In any slice, against distances in real numbers; and where it is pressed nothing changes
    /// with the radius that fits, but does with a slightly larger one.
    void nothingChangesAtTheFirstTouch()
    {
        Random random(41);
        int inside = 0;
        int outside = 0;
        int limited = 0;
        for (const glm::dmat4& affine : {axial(), turned()}) {
            const Bench bench(affine);
            const glm::dmat3 axes = bench.geometry().direction();
            for (int turn = 0; turn < 24; ++turn) {
                const Bytes labels = test::labelBoxes(size, 7, random);
                const glm::dvec3 normal = turn % 4 < 3
                    ? axes[turn % 4]
                    : axes[0] * 0.4 - axes[1] * test::randomUnit(random) + axes[2];
                const glm::dvec3 index{3.0 + 33.0 * test::randomUnit(random),
                    3.0 + 29.0 * test::randomUnit(random), 2.0 + 15.0 * test::randomUnit(random)};
                PaintStroke nudge = bench.nudge(index, normal, 3.0 + turn % 3);
                nudge.segment = test::randomInt(random, 1, 4);
                const int here = labels.at(glm::ivec3(glm::floor(index + 0.5)));
                if (turn % 2 == 0 && here != 0)
                    nudge.segment = here;
                const NudgeStart start = bench.start(nudge, labels);

                // The voxels of the slice are those that a disc over all of it paints.
                PaintStroke whole = nudge;
                whole.path.radiusMm = 150.0;
                const Bytes slice = bench.after(whole, nothing());
                double own = std::numeric_limits<double>::infinity();
                double others = own;
                eachVoxel([&](const glm::ivec3& voxel) {
                    if (slice.at(voxel) != 0) {
                        double& least = labels.at(voxel) == nudge.segment ? own : others;
                        least = std::min(least, bench.awayMm(voxel, nudge));
                    }
                });
                if (std::abs(own - others) < 2.0 * roundingMm)
                    continue; // rounding decides
                QCOMPARE(start.isInside, own < others);
                const double across = start.isInside ? others : own;
                const double least = bench.finestMm() / 4.0;
                const double fitting = std::min(nudge.path.radiusMm, std::max(across, least));
                QVERIFY2(std::abs(radiusOf(start) - fitting) < roundingMm,
                    qPrintable(QStringLiteral("%1: %2 instead of %3")
                                   .arg(turn)
                                   .arg(radiusOf(start))
                                   .arg(fitting)));
                ++(start.isInside ? inside : outside);
                if (across < least + roundingMm)
                    continue;
                nudge.erase = !start.isInside;
                nudge.overwriteUnlocked = start.isInside;
                nudge.path.radiusMm = radiusOf(start);
                QVERIFY(bench.after(nudge, labels).values == labels.values);
                if (across + 2.0 * roundingMm > 3.0 + turn % 3)
                    continue;
                ++limited;
                nudge.path.radiusMm = across + roundingMm;
                QVERIFY(bench.after(nudge, labels).values != labels.values);
            }
        }
        QVERIFY2(inside >= 5 && outside >= 10 && limited >= 8,
            qPrintable(QStringLiteral("%1, %2, %3").arg(inside).arg(outside).arg(limited)));
    }

    /// The border goes as far as the edge of the disc, in its slice alone.
    void theBorderGoesWithTheDisc()
    {
        const Bench bench(axial());
        const Bytes labels = block();
        for (const bool outwards : {true, false}) {
            PaintStroke nudge =
                bench.nudge({outwards ? 14.0 : 24.0, 15, 9}, glm::dvec3(0, 0, 1), 8.0);
            const NudgeStart start = bench.start(nudge, labels);
            QCOMPARE(start.isInside, outwards);
            nudge.path.radiusMm = radiusOf(start);
            nudge.erase = !outwards;
            nudge.overwriteUnlocked = outwards;
            nudge.path.pointsLps.push_back(
                bench.geometry().toWorld({outwards ? 22.0 : 16.0, 15, 9}));
            nudge = quantised(Edit(nudge)).get<PaintStroke>();
            const Bytes pushed = bench.after(nudge, labels);
            const double ends[2] = {outwards ? 14.0 : 16.0, outwards ? 22.0 : 24.0};
            int moved = 0;
            eachVoxel([&](const glm::ivec3& voxel) {
                const double beyond = std::max({ends[0] - voxel.x, 0.0, double(voxel.x) - ends[1]});
                const double away = 0.7 * std::hypot(beyond, double(voxel.y - 15));
                if (std::abs(away - nudge.path.radiusMm) < 0.005)
                    return; // rounding decides
                const bool isSwept = voxel.z == 9 && away < nudge.path.radiusMm;
                const int expected = isSwept ? (outwards ? 1 : 0) : labels.at(voxel);
                QCOMPARE(int(pushed.at(voxel)), expected);
                moved += expected != labels.at(voxel);
            });
            QVERIFY(moved > 20);
        }
    }

    void onlyAPlainDiscIsANudge()
    {
        const Bench bench(axial());
        const PaintStroke nudge = bench.nudge({14, 15, 9}, glm::dvec3(0, 0, 1), 3.0);
        QVERIFY(paintLabel(nudge, bench.document));
        PaintStroke ball = nudge;
        ball.path.shape = Shape::Ball;
        PaintStroke edges = nudge;
        edges.edgeTolerance = 20.0;
        for (const PaintStroke& wrong : {ball, edges}) {
            const auto refused = paintLabel(wrong, bench.document);
            QVERIFY(!refused);
            QCOMPARE(refused.error().arguments.value(0), QStringLiteral("paint.tool"));
            PaintStroke brush = wrong;
            brush.tool.reset();
            QVERIFY(paintLabel(brush, bench.document));
        }
        const auto disc = nudgeDisc(ball.path, bench.geometry(), QStringLiteral("paint"));
        QVERIFY(!disc);
        QCOMPARE(disc.error().arguments.value(0), QStringLiteral("paint.shape"));
    }

    /// Where a pen is pressed less the disc is smaller, as a brush is.
    void aPressedNudgeIsAPressedDisc()
    {
        const Bench bench(axial());
        const Bytes labels = block();
        PaintStroke whole = bench.nudge({14, 15, 9}, glm::dvec3(0, 0, 1), 3.0);
        whole.path.pointsLps.push_back(bench.geometry().toWorld({20, 15, 9}));
        PaintStroke pressed = whole;
        pressed.path.pressures = std::vector<double>{0.25, 0.5};
        pressed = quantised(Edit(pressed)).get<PaintStroke>();
        PaintStroke brush = pressed;
        brush.tool.reset();
        const Bytes after = bench.after(pressed, labels);
        QVERIFY(after.values == bench.after(brush, labels).values);
        QVERIFY(after.values != labels.values);
        int missing = 0;
        const Bytes most = bench.after(whole, labels);
        eachVoxel([&](const glm::ivec3& voxel) {
            QVERIFY(most.at(voxel) == 1 || after.at(voxel) != 1);
            missing += most.at(voxel) != after.at(voxel);
        });
        QVERIFY(missing > 5);
    }
};

BURIN_TEST(NudgeDiscTest)

} // namespace nudgeDiscTest

#include "NudgeDiscTest.moc"
