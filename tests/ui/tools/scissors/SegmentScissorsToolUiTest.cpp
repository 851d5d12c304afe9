// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/scissors/SegmentScissorsTool.h"

#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/SessionDisplay.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/views/ViewGrid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace segmentScissorsToolUiTest {

namespace {

using Does = ui::SegmentScissorsTool::Does;
using Shape = ui::SegmentScissorsTool::Shape;
using Voxels = std::set<std::array<int, 3>>;

/// The real window with the small head, whose bone is segment 1 and whose brain segment 2; the 3D
/// view looks at it from the front, along y.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , view(window.views().volume())
    {
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
        apply(test::newSegment(QStringLiteral("Bone"), 0xE0D0B0));
        apply(test::newSegment(QStringLiteral("Brain"), 0xB05060));
        apply(core::ThresholdSegment{.segment = 1, .lower = 300.0});
        apply(core::ThresholdSegment{.segment = 2, .lower = 0.0, .upper = 100.0});
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] const core::HistoryRow& lastRow() { return session().history().rows().back(); }
    [[nodiscard]] const core::SegmentScissors& lastEdit()
    {
        return lastRow().edit.get<core::SegmentScissors>();
    }
    [[nodiscard]] const core::SplitByCurve& lastSplit()
    {
        return lastRow().edit.get<core::SplitByCurve>();
    }
    /// As the window shows it.
    [[nodiscard]] QString volume(int label)
    {
        return ui::millilitreText(session().document().segment(label)->voxels,
            workspace.volume()->geometry.voxelVolumeMm3());
    }
    [[nodiscard]] glm::dvec3 place(const std::array<int, 3>& voxel) const
    {
        return workspace.volume()->geometry.toWorld(glm::dvec3(voxel[0], voxel[1], voxel[2]));
    }
    [[nodiscard]] QPointF middle() const { return QPointF(view.width(), view.height()) / 2.0; }
    /// So many millimetres right of and above the middle of the view.
    [[nodiscard]] QPointF at(double right, double up) const
    {
        return middle() + QPointF(right, -up) / view.context().mmPerPixel();
    }

    void mouse(QEvent::Type type, const QPointF& where, Qt::KeyboardModifiers modifiers = {})
    {
        WindowFixture::mouse(view, type, where, modifiers);
    }
    void drag(const std::vector<QPointF>& way, Qt::KeyboardModifiers modifiers = {})
    {
        for (std::size_t i = 0; i < way.size(); ++i)
            mouse(i == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, way[i], modifiers);
        mouse(QEvent::MouseButtonRelease, way.back(), modifiers);
        QVERIFY(session().settle());
    }
    void dragPen(const std::vector<QPointF>& way, test::Pen::End end = test::Pen::End::Tip)
    {
        test::Pen pen(view, end);
        pen.press(way.front(), 0.5, m_milliseconds += 8);
        for (std::size_t i = 1; i < way.size(); ++i)
            pen.move(way[i], 0.5, m_milliseconds += 8);
        pen.release(way.back(), m_milliseconds += 8);
        QVERIFY(session().settle());
    }
    /// A ring that is not quite closed.
    [[nodiscard]] std::vector<QPointF> ring(const glm::dvec2& centre, double radiusMm) const
    {
        std::vector<QPointF> way;
        for (int i = 0; i < 48; ++i) {
            const double angle = 2.0 * M_PI * i / 48.0;
            way.push_back(
                at(centre.x + radiusMm * std::cos(angle), centre.y + radiusMm * std::sin(angle)));
        }
        return way;
    }

    /// Compares with whether voxels lie in the shape, by their distance from its border in
    /// millimetres, inside below 0. The border itself is half a voxel wide.
    template <class Distance>
    void changedJustWhere(const Voxels& less, const Voxels& more, Distance distance)
    {
        int inside = 0;
        for (const auto& voxel : more) {
            const glm::dvec3 lps = place(voxel);
            const QPointF pixel = view.context().toPixel(lps);
            const double far = distance(view.context().toViewPlaneMm(pixel), lps);
            if (std::abs(far) < 1.2)
                continue;
            QCOMPARE(less.count(voxel) == 0, far < 0.0);
            inside += far < 0.0;
        }
        QVERIFY(inside > 20);
        QVERIFY(std::includes(more.begin(), more.end(), less.begin(), less.end()));
    }

    ui::SegmentScissorsTool tool;
    ui::VolumeView& view;

private:
    quint64 m_milliseconds = 50000;
};

/// From the border of a rectangle around the view's middle.
auto rectangle(double halfWidth, double halfHeight)
{
    return [=](const glm::dvec2& plane, const glm::dvec3&) {
        return std::max(std::abs(plane.x) - halfWidth, std::abs(plane.y) - halfHeight);
    };
}

auto disc(const glm::dvec2& centre, double radius)
{
    return [=](const glm::dvec2& plane, const glm::dvec3&) {
        return glm::distance(plane, centre) - radius;
    };
}

} // namespace

class SegmentScissorsToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aRectangleErasesWhatLiesUnderIt()
    {
        Fixture fixture;
        const Voxels bone = fixture.voxels(1);
        const Voxels brain = fixture.voxels(2);
        const std::size_t rows = fixture.rows();
        fixture.tool.setSettings({.shape = Shape::Rectangle});
        fixture.drag({fixture.at(-7.0, 5.0), fixture.at(0.0, 0.0), fixture.at(7.0, -5.0)});
        QCOMPARE(fixture.rows(), rows + 1);
        fixture.changedJustWhere(fixture.voxels(1), bone, rectangle(7.0, 5.0));
        QVERIFY(fixture.voxels(2) == brain);
        QCOMPARE(fixture.lastEdit().polygonMm.size(), std::size_t(4));
        QVERIFY(fixture.lastEdit().erase && !fixture.lastEdit().outside);
        QVERIFY(!fixture.lastEdit().depthMm && !fixture.lastEdit().others);
        QVERIFY(
            fixture.lastRow().name.startsWith(QStringLiteral("Scissors erase 'Bone' inside, −")));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.voxels(1) == bone);
    }

    void aPenDrawsFreehandAndKeepsWhatIsInside()
    {
        Fixture fixture;
        const Voxels bone = fixture.voxels(1);
        fixture.tool.setSettings({.does = Does::EraseOutside});
        const std::vector<QPointF> ring = fixture.ring({2.0, 1.0}, 9.0);
        fixture.dragPen(ring);
        QVERIFY(fixture.lastEdit().outside && fixture.lastEdit().polygonMm.size() > 40);
        // What is inside is what is left.
        const Voxels left = fixture.voxels(1);
        fixture.changedJustWhere(left, bone, [](const glm::dvec2& plane, const glm::dvec3& lps) {
            return -disc({2.0, 1.0}, 9.0)(plane, lps);
        });
        QVERIFY(left.size() > 20);
    }

    /// Ctrl and the pen's eraser end do the other of filling and erasing.
    void controlAndTheEraserEndInvert()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(2);
        fixture.tool.setSettings({.shape = Shape::Ellipse});
        const std::vector<QPointF> corners{fixture.at(-4.0, 4.0), fixture.at(4.0, -4.0)};
        const Voxels before = fixture.voxels(2);
        fixture.drag(corners, Qt::ControlModifier);
        QVERIFY(!fixture.lastEdit().erase);
        QVERIFY(
            fixture.lastRow().name.startsWith(QStringLiteral("Scissors fill 'Brain' inside, +")));
        const Voxels filled = fixture.voxels(2);
        // All the air before and behind the head, and nothing of the bone.
        QVERIFY(filled.size() > before.size() + 100);
        for (const auto& voxel : filled) {
            if (before.count(voxel) == 0)
                QVERIFY(glm::length(fixture.place(voxel)) > 15.0);
        }
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        fixture.dragPen(corners, test::Pen::End::Eraser);
        QVERIFY(!fixture.lastEdit().erase);
        QVERIFY(fixture.voxels(2) == filled);
        fixture.tool.setSettings({.does = Does::FillInside, .shape = Shape::Ellipse});
        fixture.drag(corners, Qt::ControlModifier);
        QVERIFY(fixture.lastEdit().erase);
        fixture.changedJustWhere(fixture.voxels(2), filled, disc({0.0, 0.0}, 4.0));
    }

    /// The near wall of the bone goes, and the far one stays.
    void aDepthEndsBehindWhatIsSeenFirst()
    {
        Fixture fixture;
        QWidget bar;
        const std::unique_ptr<QWidget> options(fixture.tool.createOptions(&bar));
        auto* depth = options->findChild<QDoubleSpinBox*>(QStringLiteral("segmentScissorsDepth"));
        QCOMPARE(depth->text(), QStringLiteral("through all"));
        depth->setValue(6.0);
        QCOMPARE(fixture.tool.settings().depthMm, 6.0);
        fixture.tool.changeDepth(2); // Ctrl + Shift + wheel
        QCOMPARE(depth->value(), 8.0);
        fixture.tool.changeDepth(-2);
        const Voxels bone = fixture.voxels(1);
        fixture.dragPen(fixture.ring({0.0, 0.0}, 6.0));
        QCOMPARE(fixture.lastEdit().depthMm.value_or(0.0), 6.0);
        fixture.changedJustWhere(
            fixture.voxels(1), bone, [](const glm::dvec2& plane, const glm::dvec3& lps) {
                const double around = disc({0.0, 0.0}, 6.0)(plane, lps);
                return lps.y < 0.0 ? around : std::abs(around) + 2.0;
            });
        auto* does = options->findChild<QComboBox*>(QStringLiteral("segmentScissorsDoes"));
        does->setCurrentIndex(does->findData(int(Does::EraseOutside)));
        Q_EMIT does->activated(does->currentIndex());
        QVERIFY(fixture.tool.settings().does == Does::EraseOutside);
        QVERIFY(!depth->isEnabled()); // there is none outside
        fixture.dragPen(fixture.ring({0.0, 0.0}, 12.0));
        QVERIFY(!fixture.lastEdit().depthMm);
    }

    /// By mouse: one row, a new segment of its own name and colour, and both volumes are told.
    void whatIsInsideIsSplitOff()
    {
        Fixture fixture;
        QWidget bar;
        const std::unique_ptr<QWidget> options(fixture.tool.createOptions(&bar));
        auto* does = options->findChild<QComboBox*>(QStringLiteral("segmentScissorsDoes"));
        does->setCurrentIndex(does->findText(QStringLiteral("split off inside")));
        Q_EMIT does->activated(does->currentIndex());
        QVERIFY(fixture.tool.settings().does == Does::SplitInside);
        QVERIFY(!options->findChild<QCheckBox*>(QStringLiteral("segmentScissorsAllShown"))
                     ->isEnabled());
        QVERIFY(options->findChild<QDoubleSpinBox*>(QStringLiteral("segmentScissorsDepth"))
                    ->isEnabled());
        fixture.tool.setSettings({.does = Does::SplitInside, .shape = Shape::Rectangle});
        QCOMPARE(fixture.tool.target(), QStringLiteral("splits off Bone inside"));
        const Voxels bone = fixture.voxels(1);
        const Voxels brain = fixture.voxels(2);
        const std::size_t rows = fixture.rows();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.drag({fixture.at(-7.0, 5.0), fixture.at(0.0, 0.0), fixture.at(7.0, -5.0)});
        QCOMPARE(fixture.rows(), rows + 1);
        fixture.changedJustWhere(fixture.voxels(1), bone, rectangle(7.0, 5.0));
        const Voxels part = fixture.voxels(3);
        QCOMPARE(part.size() + fixture.voxels(1).size(), bone.size());
        QVERIFY(std::includes(bone.begin(), bone.end(), part.begin(), part.end()));
        QVERIFY(fixture.voxels(2) == brain);
        const core::Segment& made = fixture.session().document().segments.back();
        QCOMPARE(made.name, QStringLiteral("Bone 1"));
        QVERIFY(made.rgb != fixture.session().document().segment(1)->rgb);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        const core::SplitByCurve& edit = fixture.lastSplit();
        QVERIFY(!edit.open && edit.side == core::SplitByCurve::Side::Inside && !edit.depthMm);
        QCOMPARE(edit.curveMm.size(), std::size_t(4));
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral(
                "Split 'Bone' by a curve, −%1 voxels. Bone: %2 · Bone 1: %3; Ctrl+Z takes "
                "it back")
                .arg(ui::countText(qlonglong(part.size())), fixture.volume(1), fixture.volume(3)));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.voxels(1) == bone);
        QVERIFY(!fixture.session().document().segment(3));
    }

    /// The pen, and its eraser end, which means the other side.
    void theEraserEndSplitsTheOutsideOff()
    {
        Fixture fixture;
        const Voxels bone = fixture.voxels(1);
        fixture.tool.setSettings({.does = Does::SplitInside, .depthMm = 6.0});
        const std::vector<QPointF> ring = fixture.ring({0.0, 0.0}, 6.0);
        fixture.dragPen(ring);
        QCOMPARE(fixture.lastSplit().depthMm.value_or(0.0), 6.0);
        QVERIFY(fixture.lastRow().name.startsWith(
            QStringLiteral("Split 'Bone' by a curve, 6.0 mm deep, −")));
        // The near wall alone.
        fixture.changedJustWhere(
            fixture.voxels(1), bone, [](const glm::dvec2& plane, const glm::dvec3& lps) {
                const double around = disc({0.0, 0.0}, 6.0)(plane, lps);
                return lps.y < 0.0 ? around : std::abs(around) + 2.0;
            });
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        fixture.dragPen(ring, test::Pen::End::Eraser);
        QVERIFY(fixture.lastSplit().side == core::SplitByCurve::Side::Outside);
        QVERIFY(!fixture.lastSplit().depthMm);
        fixture.changedJustWhere(fixture.voxels(3), bone, disc({0.0, 0.0}, 6.0));
    }

    /// A line goes on to both sides of the picture. While it is drawn, both volumes are told, and
    /// the side that is split off is tinted.
    void aLineSplitsAcross()
    {
        Fixture fixture;
        const Voxels bone = fixture.voxels(1);
        fixture.tool.setSettings({.does = Does::SplitAlong, .shape = Shape::Rectangle});
        QCOMPARE(fixture.tool.target(), QStringLiteral("splits off the smaller side of Bone"));
        QCOMPARE(fixture.tool.partsLine(), QString());
        const std::size_t rows = fixture.rows();
        test::Pen pen(fixture.view);
        pen.press(fixture.at(-6.0, 4.0), 0.5, 1000);
        pen.move(fixture.at(0.0, 4.0), 0.5, 1008);
        pen.move(fixture.at(6.0, 4.0), 0.5, 1016);
        QTRY_VERIFY((fixture.session().poll(), !fixture.tool.partsLine().isEmpty()));
        pen.move(fixture.at(7.0, 4.0), 0.5, 1024);
        QTRY_VERIFY((fixture.session().poll(), !fixture.tool.partsLine().isEmpty()));
        const QString told = fixture.tool.partsLine();
        QCOMPARE(fixture.rows(), rows);
        const auto isTinted = [&fixture](double right, double up) {
            QImage picture(fixture.view.size(), QImage::Format_ARGB32_Premultiplied);
            picture.fill(Qt::transparent);
            QPainter painter(&picture);
            fixture.tool.paintOverlay(painter, fixture.view.context());
            painter.end();
            return picture.pixelColor(fixture.at(right, up).toPoint()).alpha() > 0;
        };
        QVERIFY(isTinted(-11.0, 8.0) && isTinted(0.0, 8.0));
        QVERIFY(!isTinted(-11.0, 0.0) && !isTinted(0.0, -6.0));
        pen.release(fixture.at(7.0, 4.0), 1032);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastSplit().open);
        QVERIFY(fixture.lastRow().name.startsWith(QStringLiteral("Split 'Bone' along a line, −")));
        const auto above = [](const glm::dvec2& plane, const glm::dvec3&) { return 4.0 - plane.y; };
        fixture.changedJustWhere(fixture.voxels(1), bone, above);
        QCOMPARE(told,
            QStringLiteral("Bone: %1 · Bone 1: %2").arg(fixture.volume(1), fixture.volume(3)));
        QCOMPARE(fixture.tool.partsLine(), QString());
        // With Ctrl the larger side, by mouse; drawn the other way it is the same.
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        fixture.drag({fixture.at(6.0, 4.0), fixture.at(0.0, 4.0), fixture.at(-6.0, 4.0)},
            Qt::ControlModifier);
        QVERIFY(fixture.lastSplit().side == core::SplitByCurve::Side::Larger);
        fixture.changedJustWhere(fixture.voxels(3), bone, above);
    }

    /// What may not change does not, and then nothing is counted that would not come to be.
    void whatIsSplitOffKeepsToLimits()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(2);
        fixture.tool.setSettings({.does = Does::SplitInside, .shape = Shape::Rectangle});
        ui::Workspace::BrushSettings limits =
            fixture.workspace.brushSettings(ui::Workspace::Brush::Paint);
        limits.onlyBetween = true;
        limits.lower = 200.0;
        limits.upper = -100.0;
        fixture.workspace.setBrushSettings(ui::Workspace::Brush::Paint, limits);
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -300.0, .upper = 150.0});
        fixture.mouse(QEvent::MouseButtonPress, fixture.at(-4.0, 4.0));
        fixture.mouse(QEvent::MouseMove, fixture.at(4.0, -4.0));
        QVERIFY(fixture.session().settle());
        QTest::qWait(50);
        QCOMPARE(fixture.tool.partsLine(), QString());
        fixture.mouse(QEvent::MouseButtonRelease, fixture.at(4.0, -4.0));
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastSplit().editable);
        QCOMPARE(fixture.lastSplit().editable->lower.value_or(0.0), -100.0);
        QCOMPARE(fixture.lastSplit().editable->upper.value_or(0.0), 150.0);
        // No value is in both.
        const std::size_t rows = fixture.rows();
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = 300.0, .upper = 400.0});
        fixture.drag({fixture.at(-3.0, 3.0), fixture.at(3.0, -3.0)});
        QCOMPARE(fixture.rows(), rows);
    }

    void whatCannotBeSplitSaysWhy()
    {
        Fixture fixture;
        fixture.tool.setSettings({.does = Does::SplitAlong});
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        fixture.drag({fixture.at(-1.0, 30.0), fixture.at(1.0, 30.0)});
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("all of 'Bone' lies on one side of the line"));
        const double step = 0.3 * fixture.view.context().mmPerPixel();
        fixture.drag({fixture.at(0.0, 0.0), fixture.at(step, 0.0)});
        QVERIFY(said.back().front().toString().contains(QStringLiteral("Draw a line")));
        fixture.workspace.setActiveSegment(0);
        QCOMPARE(fixture.tool.target(), QStringLiteral("no segment to split"));
        fixture.drag({fixture.at(-5.0, 0.0), fixture.at(5.0, 0.0)});
        QVERIFY(said.back().front().toString().contains(QStringLiteral("no segment to split")));
        QCOMPARE(fixture.rows(), rows);
        // Esc drops the line, and what is told of it.
        fixture.workspace.setActiveSegment(1);
        fixture.mouse(QEvent::MouseButtonPress, fixture.at(-5.0, 0.0));
        fixture.mouse(QEvent::MouseMove, fixture.at(5.0, 0.0));
        QTRY_VERIFY((fixture.session().poll(), !fixture.tool.partsLine().isEmpty()));
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QCOMPARE(fixture.tool.partsLine(), QString());
        fixture.mouse(QEvent::MouseButtonRelease, fixture.at(5.0, 0.0));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
    }

    void allThatAreShownAreErasedTogether()
    {
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Locked"), 0x102030));
        fixture.apply(core::ThresholdSegment{.segment = 3, .upper = -900.0});
        fixture.apply(test::lockSegment(3));
        fixture.workspace.setActiveSegment(2);
        fixture.tool.setSettings({.shape = Shape::Rectangle, .allShown = true});
        const std::vector<QPointF> corners{fixture.at(-3.0, 3.0), fixture.at(3.0, -3.0)};
        const Voxels bone = fixture.voxels(1);
        const Voxels brain = fixture.voxels(2);
        const Voxels air = fixture.voxels(3);
        QCOMPARE(fixture.tool.target(), QStringLiteral("erases 2 segments inside"));
        fixture.drag(corners);
        QCOMPARE(fixture.lastEdit().segment, 2);
        QVERIFY(fixture.lastEdit().others == (std::vector<int>{1}));
        fixture.changedJustWhere(fixture.voxels(1), bone, rectangle(3.0, 3.0));
        fixture.changedJustWhere(fixture.voxels(2), brain, rectangle(3.0, 3.0));
        QVERIFY(fixture.voxels(3) == air);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        // What is hidden stays.
        fixture.session().display().setSegmentVisible(2, false);
        QCOMPARE(fixture.tool.target(), QStringLiteral("erases Bone inside"));
        fixture.drag(corners);
        QCOMPARE(fixture.lastEdit().segment, 1);
        QVERIFY(!fixture.lastEdit().others);
        QVERIFY(fixture.voxels(2) == brain);
        fixture.session().display().setSegmentVisible(1, false);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        fixture.drag(corners);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(said.back().front().toString().contains(QStringLiteral("no segment")));
    }

    void theLimitsOfPaintHold()
    {
        Fixture fixture;
        fixture.tool.setSettings({.does = Does::FillInside, .shape = Shape::Rectangle});
        ui::Workspace::BrushSettings limits =
            fixture.workspace.brushSettings(ui::Workspace::Brush::Paint);
        limits.onlyBetween = true;
        limits.lower = 200.0;
        limits.upper = -100.0; // the other way round
        limits.overwriteUnlocked = true;
        fixture.workspace.setBrushSettings(ui::Workspace::Brush::Paint, limits);
        const Voxels brain = fixture.voxels(2);
        fixture.drag({fixture.at(-4.0, 4.0), fixture.at(4.0, -4.0)});
        QCOMPARE(fixture.lastEdit().lower.value_or(0.0), -100.0);
        QCOMPARE(fixture.lastEdit().upper.value_or(0.0), 200.0);
        QVERIFY(fixture.lastEdit().overwriteUnlocked);
        fixture.changedJustWhere(fixture.voxels(2), brain, rectangle(4.0, 4.0));
    }

    void whatIsNotMeantChangesNothing()
    {
        Fixture fixture;
        int failures = 0;
        connect(&fixture.workspace, &ui::Workspace::failed, this, [&failures] { ++failures; });
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        fixture.dragPen(fixture.ring({0.0, 0.0}, 0.2 * fixture.view.context().mmPerPixel()));
        QVERIFY(said.back().front().toString().contains(QStringLiteral("Draw a curve")));
        QCOMPARE(fixture.rows(), rows);
        // Esc drops the curve.
        const std::vector<QPointF> ring = fixture.ring({0.0, 0.0}, 6.0);
        test::Pen pen(fixture.view);
        pen.press(ring[0], 0.5, 1000);
        for (std::size_t i = 1; i < 30; ++i)
            pen.move(ring[i], 0.5, 1000 + 8 * quint64(i));
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        pen.release(ring[30], 2000);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(failures, 0);
        fixture.apply(test::lockSegment(1));
        QCOMPARE(fixture.tool.target(), QStringLiteral("Bone is locked"));
        fixture.dragPen(ring);
        QCOMPARE(failures, 1);
        QCOMPARE(fixture.rows(), rows + 1); // the lock
    }

    /// To fill, the first segment is made, as a step of its own; to erase there must be one.
    void theFirstSegmentIsMade()
    {
        test::WindowFixture window(test::smallHead::volume());
        ui::SegmentScissorsTool tool(window.workspace);
        window.workspace.setActiveTool(&tool);
        ui::VolumeView& view = window.window.views().volume();
        QSignalSpy said(&window.workspace, &ui::Workspace::said);
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        const auto draw = [&] {
            test::Pen pen(view);
            pen.press(middle - QPointF(30.0, 20.0), 0.5, 1000);
            pen.move(middle, 0.5, 1010);
            pen.release(middle + QPointF(30.0, 20.0), 1020);
            QVERIFY(window.workspace.session()->settle());
        };
        tool.setSettings({.shape = Shape::Rectangle});
        draw();
        QVERIFY(said.back().front().toString().contains(QStringLiteral("no segment")));
        QVERIFY(window.workspace.session()->history().rows().empty());
        tool.setSettings({.does = Does::FillInside, .shape = Shape::Rectangle});
        QCOMPARE(tool.target(), QStringLiteral("fills a new segment"));
        draw();
        QCOMPARE(window.workspace.session()->history().rows().size(), std::size_t(2));
    }

    /// What is drawn shows what would change, as far as the editable range has a box for it.
    void whatMayNotChangeIsNotTinted()
    {
        Fixture fixture;
        fixture.tool.setSettings({.does = Does::FillInside, .shape = Shape::Rectangle});
        fixture.mouse(QEvent::MouseButtonPress, fixture.at(-12.0, 12.0));
        fixture.mouse(QEvent::MouseMove, fixture.at(12.0, -12.0));
        const auto isTinted = [&fixture](int i) {
            QImage picture(fixture.view.size(), QImage::Format_ARGB32_Premultiplied);
            picture.fill(Qt::transparent);
            QPainter painter(&picture);
            fixture.tool.paintOverlay(painter, fixture.view.context());
            painter.end();
            const QPointF at = fixture.view.context().toPixel(fixture.place({i, 20, 24}));
            return picture.pixelColor(at.toPoint()).alpha() > 0;
        };
        for (const int i : {14, 20, 21, 26})
            QVERIFY(isTinted(i));
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.maximum.x = 20.5;
        fixture.workspace.setClip(clip);
        fixture.workspace.setEditableSettings({.on = true, .boxed = true});
        QVERIFY(isTinted(14) && isTinted(20));
        QVERIFY(!isTinted(21) && !isTinted(26));
        // Values lie somewhere along the line of sight: what they limit is told, not shown.
        fixture.workspace.setEditableSettings({.on = true, .byValue = true, .upper = 100.0});
        QVERIFY(isTinted(14) && isTinted(26));
        // Inside of a segment that is gone there is nothing.
        fixture.workspace.setEditableSettings(
            {.on = true, .where = ui::EditableSettings::Where::Inside, .segment = 9});
        QVERIFY(!isTinted(14) && !isTinted(26));
        fixture.workspace.setEditableSettings({});
        QVERIFY(isTinted(14) && isTinted(26));
        fixture.tool.cancel();
        QVERIFY(!isTinted(14));
    }

    void settingsAreKept()
    {
        Fixture fixture;
        const ui::SegmentScissorsTool::Settings set{
            .does = Does::FillOutside, .shape = Shape::Ellipse, .depthMm = 12.5, .allShown = true};
        fixture.tool.setSettings(set);
        ui::SegmentScissorsTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QVERIFY(other.settings() == set);
        other.applySettings({{QStringLiteral("does"), 9}, {QStringLiteral("shape"), -3},
            {QStringLiteral("depthMm"), 1e9}, {QStringLiteral("allShown"), 7}});
        QVERIFY(other.settings().does == set.does && other.settings().shape == set.shape);
        QCOMPARE(other.settings().depthMm, ui::SegmentScissorsTool::maximumDepthMm);
        QVERIFY(other.settings().allShown);
        QVERIFY(fixture.window.minimumSizeHint().width() <= 1280);
    }
};

BURIN_WINDOW_TEST(SegmentScissorsToolUiTest)

} // namespace segmentScissorsToolUiTest

#include "SegmentScissorsToolUiTest.moc"
