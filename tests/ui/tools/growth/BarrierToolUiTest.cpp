// SPDX-License-Identifier: Apache-2.0
#include "core/brick/ThreadWithoutVoxels.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/tools/growth/BarrierTool.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <algorithm>
#include <limits>

namespace barrierToolUiTest {

namespace {

using Brush = ui::Workspace::Brush;
namespace head = test::smallHead;

constexpr double radiusMm = 3.0;

/// The real window with the small head and the barrier brush in hand; a segment is there, seeded
/// where a test wants it.
class BarrierFixture : public test::WindowFixture {
public:
    explicit BarrierFixture(const glm::dvec3& seedLps = glm::dvec3(0.0))
        : test::WindowFixture(head::volume())
        , tool(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setBrushSettings(Brush::Barrier, {.radiusMm = radiusMm});
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
        apply(test::newSegment(QStringLiteral("Segment"), 1));
        apply(test::seedAt(1, {seedLps}));
    }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("an edit was refused");
    }
    /// To closure, between two values.
    void grow(double lower, double upper) { apply(test::growBetween(lower, upper)); }
    /// A straight stroke; offsets from the view's middle, mm.
    void draw(ui::ImageView& where, const QPointF& fromMm, const QPointF& toMm,
        test::Pen::End end = test::Pen::End::Tip)
    {
        const double perMm = 1.0 / where.context().mmPerPixel();
        const QPointF middle = QPointF(where.width(), where.height()) / 2.0;
        test::Pen pen(where, end);
        pen.press(middle + fromMm * perMm, 0.5, 100);
        session().poll();
        for (int part = 1; part <= 8; ++part) {
            pen.move(
                middle + (fromMm + (toMm - fromMm) * (part / 8.0)) * perMm, 0.5, 100 + 8 * part);
            session().poll();
        }
        pen.release(middle + toMm * perMm, 200);
        session().poll();
        if (!session().settle())
            qFatal("the stroke failed");
    }
    [[nodiscard]] const core::BarrierStroke* lastBarrier()
    {
        const core::History& history = session().history();
        return history.row(history.position()).edit.as<core::BarrierStroke>();
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segments[0].voxels; }
    /// Of voxels that the segment holds, the least distance to a path; then of voxels in a range of
    /// values that it does not hold, the greatest.
    struct Distances {
        double nearestHeldMm = std::numeric_limits<double>::max();
        double farthestLeftMm = 0.0;
    };
    [[nodiscard]] Distances distancesTo(const core::BrushPath& path, double lower, double upper)
    {
        const auto labels = *session().questions().labels(0);
        const core::LoadedVolume loaded = head::volume();
        Distances found;
        for (int i = 0; i < int(labels.size()); ++i) {
            const double value = loaded.volume.encoding.value(loaded.codes[std::size_t(i)]);
            if (value < lower || value > upper)
                continue;
            const glm::dvec3 index(
                i % head::side, i / head::side % head::side, i / head::side / head::side);
            const glm::dvec3 place = loaded.volume.geometry.toWorld(index);
            double distance = std::numeric_limits<double>::max();
            for (std::size_t p = 0; p + 1 < path.pointsLps.size() || p == 0; ++p) {
                const glm::dvec3 from = path.pointsLps[p];
                const glm::dvec3 along =
                    path.pointsLps[std::min(p + 1, path.pointsLps.size() - 1)] - from;
                const double part = glm::dot(along, along) > 0.0
                    ? std::clamp(glm::dot(place - from, along) / glm::dot(along, along), 0.0, 1.0)
                    : 0.0;
                distance = std::min(distance, glm::distance(place, from + along * part));
            }
            if (labels[std::size_t(i)] != 0)
                found.nearestHeldMm = std::min(found.nearestHeldMm, distance);
            else
                found.farthestLeftMm = std::max(found.farthestLeftMm, distance);
        }
        return found;
    }
    [[nodiscard]] std::int64_t shut()
    {
        const core::BrickGrid grid{workspace.volume()->geometry.size};
        std::vector<core::BrickKey> keys;
        for (int brick = 0; brick < grid.brickCount(); ++brick)
            keys.push_back({core::Field::SeedWords, 0, std::uint32_t(brick)});
        std::int64_t count = 0;
        const core::VoxelsAllowed counts; // a test has the time
        session().questions().bricks(
            std::move(keys), [&count](const core::Result<std::vector<core::BrickImage>>& bricks) {
                for (const core::BrickImage& brick : *bricks) {
                    for (std::size_t at = 0; at + 4 <= brick.bytes.size(); at += 4) {
                        std::uint32_t word = 0;
                        for (std::size_t byte = 0; byte < 4; ++byte)
                            word |= std::uint32_t(brick.bytes.read()[at + byte]) << (8 * byte);
                        count += word == core::seedWord::barrier ? 1 : 0;
                    }
                }
            });
        session().poll();
        return count;
    }

    ui::BarrierTool tool;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

} // namespace

class BarrierToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aStrokeOnASliceStopsGrowth()
    {
        BarrierFixture fixture;
        const std::size_t rows = fixture.rows();
        const QByteArray before = fixture.session().stateHash();
        fixture.draw(fixture.slice, {4.0, -4.0}, {4.0, 4.0});
        QCOMPARE(fixture.rows(), rows + 1);
        const core::BarrierStroke* stroke = fixture.lastBarrier();
        QVERIFY(stroke && !stroke->erase);
        QCOMPARE(stroke->path.radiusMm, radiusMm);
        QVERIFY(stroke->path.shape == core::BrushPath::Shape::Ball);
        QVERIFY(fixture.shut() > 100);
        const core::BrushPath path = stroke->path;

        fixture.grow(0.0, 20.0);
        const auto distances = fixture.distancesTo(path, 0.0, 20.0);
        QVERIFY2(distances.nearestHeldMm > radiusMm - 0.1,
            qPrintable(QString::number(distances.nearestHeldMm)));
        QVERIFY2(distances.farthestLeftMm < radiusMm + 0.1,
            qPrintable(QString::number(distances.farthestLeftMm)));
        QVERIFY(fixture.voxels() > 100);
        QVERIFY(fixture.voxels() < head::voxelsOf(head::ventricleHu));

        // The same as a recipe.
        test::WorkspaceFixture recipe;
        for (const core::HistoryRow& row : fixture.session().history().rows())
            recipe.apply(row.edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());

        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), before);
        QCOMPARE(fixture.shut(), std::int64_t(0));
    }

    void aStrokeIn3dLiesOnWhatIsSeen()
    {
        // Bone, at the head's back: the barrier lies on its front.
        BarrierFixture fixture({0.0, 14.0, 0.0});
        fixture.draw(fixture.view, {-6.0, 2.0}, {6.0, -2.0});
        const core::BarrierStroke* stroke = fixture.lastBarrier();
        QVERIFY(stroke);
        const core::BrushPath path = stroke->path;
        QVERIFY(path.pointsLps.size() > 4);
        for (const glm::dvec3& point : path.pointsLps) {
            QVERIFY2(std::abs(glm::length(point) - 15.7) < 1.2,
                qPrintable(QString::number(glm::length(point))));
            QVERIFY(point.y < 0.0);
        }
        fixture.grow(800.0, 1000.0);
        const auto distances = fixture.distancesTo(path, 800.0, 1000.0);
        QVERIFY(distances.nearestHeldMm > radiusMm - 0.1);
        QVERIFY(distances.farthestLeftMm < radiusMm + 0.1);
        QVERIFY(fixture.voxels() < head::voxelsOf(head::boneHu));
    }

    void whatHadGrownThereGoes()
    {
        BarrierFixture fixture;
        fixture.grow(0.0, 20.0);
        QCOMPARE(fixture.voxels(), head::voxelsOf(head::ventricleHu));
        const QByteArray grown = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        fixture.draw(fixture.slice, {4.0, -4.0}, {4.0, 4.0});
        QCOMPARE(fixture.rows(), rows + 1);
        const core::BrushPath path = fixture.lastBarrier()->path;
        QVERIFY(fixture.voxels() < head::voxelsOf(head::ventricleHu));
        QVERIFY(fixture.distancesTo(path, 0.0, 20.0).nearestHeldMm > radiusMm - 0.1);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), grown);
    }

    void controlAndTheEraserOpenAgain()
    {
        BarrierFixture fixture;
        fixture.draw(fixture.slice, {4.0, -4.0}, {4.0, 4.0});
        const QByteArray walled = fixture.session().stateHash();
        std::size_t rows = fixture.rows();
        // The eraser over half of it, Ctrl over the other.
        const std::int64_t all = fixture.shut();
        fixture.draw(fixture.slice, {4.0, -4.0}, {4.0, 0.0}, test::Pen::End::Eraser);
        QCOMPARE(fixture.rows(), ++rows);
        QVERIFY(fixture.lastBarrier()->erase);
        const std::int64_t half = fixture.shut();
        QVERIFY(half > 0 && half < all);
        const double perMm = 1.0 / fixture.slice.context().mmPerPixel();
        const QPointF middle = QPointF(fixture.slice.width(), fixture.slice.height()) / 2.0;
        const auto at = [&](double x, double y) {
            return (middle + QPointF(x, y) * perMm).toPoint();
        };
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, at(4.0, -1.0));
        QTest::mouseMove(&fixture.slice, at(4.0, 2.0));
        QTest::mouseMove(&fixture.slice, at(4.0, 5.0));
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, at(4.0, 5.0));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), ++rows);
        QVERIFY(fixture.lastBarrier()->erase);
        QCOMPARE(fixture.shut(), std::int64_t(0));
        fixture.grow(0.0, 20.0);
        QCOMPARE(fixture.voxels(), head::voxelsOf(head::ventricleHu));
        for (int step = 0; step < 3; ++step)
            QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), walled);
        QCOMPARE(fixture.shut(), all);
    }

    void whereNothingIsShutNothingIsOpened()
    {
        BarrierFixture fixture;
        const std::size_t rows = fixture.rows();
        fixture.draw(fixture.slice, {-5.0, 0.0}, {5.0, 0.0}, test::Pen::End::Eraser);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(!fixture.session().transactionOpen());
    }

    void escapeTakesTheStrokeBack()
    {
        BarrierFixture fixture;
        const QByteArray before = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        const QPointF middle = QPointF(fixture.slice.width(), fixture.slice.height()) / 2.0;
        test::Pen pen(fixture.slice);
        pen.press(middle, 0.5, 1);
        pen.move(middle + QPointF(12, 3), 0.5, 9);
        fixture.session().poll();
        QVERIFY(fixture.shut() > 0); // it shows while the pen is down
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        pen.release(middle + QPointF(12, 3), 20);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), before);
        QCOMPARE(fixture.shut(), std::int64_t(0));
    }
};

BURIN_WINDOW_TEST(BarrierToolUiTest)

} // namespace barrierToolUiTest

#include "BarrierToolUiTest.moc"
