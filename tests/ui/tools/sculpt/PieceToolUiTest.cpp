// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionDisplay.h"
#include "ui/tools/sculpt/PieceTool.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/frame/PanelSection.h"
#include "ui/models/PieceListModel.h"
#include "ui/panels/lists/PiecesPanel.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/PieceActions.h"
#include "ui/window/display/DisplayState.h"
#include "ui/workspace/Pieces.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListView>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace pieceToolUiTest {

namespace {

/// The small head seen from the front, its upper half cut off by a brush in layer 1.
class PieceFixture : public test::WindowFixture {
public:
    PieceFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , view(window.views().volume())
        , panel(new ui::PiecesPanel(workspace, view))
    {
        ui::addPieceActions(window);
        window.addPanel(panel);
        window.showPanels(true);
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
        QCoreApplication::sendPostedEvents(); // layouts and frames are posted events
        apply(test::carveAt({{-6, 0, 14}, {6, 0, 14}}, 8.0));
    }
    void apply(const core::Edit& edit)
    {
        if (!workspace.session()->apply(edit))
            qFatal("refused");
        settle();
    }
    void settle()
    {
        // What an answer asks for is asked after it came.
        for (int i = 0; i < 5; ++i) {
            const auto measured = [this] { return !workspace.pieces().isMeasuring(); };
            if (!workspace.session()->settle() || !QTest::qWaitFor(measured, 60000))
                qFatal("not settled");
        }
    }
    template <class Widget> [[nodiscard]] Widget& part(const char* name) const
    {
        auto* found = panel->findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    [[nodiscard]] const core::Document& document() const { return workspace.session()->document(); }
    [[nodiscard]] std::vector<std::uint8_t> coverage(int layer)
    {
        reference::DenseFields fields = engine.fields();
        return fields.coverage(std::uint8_t(layer)).values;
    }
    /// How many voxels a layer carves.
    [[nodiscard]] int carvedBy(int layer)
    {
        const std::vector<std::uint8_t> values = coverage(layer);
        return int(std::count_if(
            values.begin(), values.end(), [](std::uint8_t value) { return value >= 128; }));
    }
    [[nodiscard]] std::size_t rows() const { return workspace.session()->history().rows().size(); }
    void lift()
    {
        workspace.pieces().lift(1);
        settle();
    }
    [[nodiscard]] QPointF middle() const
    {
        const core::Piece& piece = document().pieces.front();
        return view.context().toPixel(*piece.pivotLps + piece.pose.offsetMm);
    }
    void pull(const QPointF& from, const QPointF& by, test::DrawnBy with = test::DrawnBy::Pen)
    {
        test::drawStroke(with, view, {from, from + by * 0.5, from + by});
        settle();
    }
    void save(const char* name)
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            window.grab().save(folder + QLatin1String(name));
    }

    ui::PieceTool tool;
    ui::VolumeView& view;
    ui::PiecesPanel* panel;
};

} // namespace

class PieceToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aLayerIsLifted()
    {
        PieceFixture fixture;
        QVERIFY(fixture.window.actionTable()[QStringLiteral("pieces.lift")].isEnabled());
        fixture.window.actionTable()[QStringLiteral("pieces.lift")].trigger();
        fixture.settle();
        QCOMPARE(fixture.document().pieces.size(), std::size_t(1));
        const core::Piece& piece = fixture.document().pieces.front();
        QCOMPARE(piece.layer, 1);
        // It turns about the middle of what was cut; voxels are 1.5 mm high.
        QVERIFY(piece.pivotLps && glm::distance(*piece.pivotLps, glm::dvec3(0, 0, 14)) < 1.5);
        // What is carved next is another layer's.
        QCOMPARE(fixture.workspace.activeLayer(), 2);
        QCOMPARE(fixture.workspace.pieces().active(), piece.id);
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1 piece"));
        // An empty layer has nothing to lift.
        fixture.workspace.pieces().lift(2);
        fixture.settle();
        QCOMPARE(fixture.document().pieces.size(), std::size_t(1));
        const std::vector<gpu::ScenePiece> scene = fixture.workspace.pieces().scene();
        QCOMPARE(scene.size(), std::size_t(1));
        QVERIFY(scene.front().shownFromTrue == glm::dmat4(1.0));
    }

    /// Not all that the layer has carved: what one cut has.
    void oneCutIsLifted()
    {
        PieceFixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        const QByteArray before = session.stateHash();
        const std::vector<std::uint8_t> first = fixture.coverage(1);
        QCOMPARE(fixture.workspace.pieces().lastCut(1), core::RowId(0)); // all of the layer
        fixture.apply(test::carveAt({{-6, 0, -12}, {6, 0, -12}}, 5.0));
        const QByteArray both = session.stateHash();
        QCOMPARE(fixture.workspace.pieces().lastCut(1), core::RowId(2));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.window.actionTable()[QStringLiteral("pieces.lift")].trigger();
        fixture.settle();
        const QString words = said.back().front().toString();
        QVERIFY2(words.contains(session.history().row(2).name), qPrintable(words));
        QCOMPARE(fixture.document().pieces.size(), std::size_t(1));
        const core::Piece& piece = fixture.document().pieces.front();
        QCOMPARE(piece.layer, 2);
        QVERIFY(piece.pivotLps && std::abs(piece.pivotLps->z + 12.0) < 2.0);
        QVERIFY(fixture.coverage(1) == first);
        QVERIFY(fixture.carvedBy(2) > 50);
        QCOMPARE(fixture.workspace.activeLayer(), 1); // carving goes on where it was

        // The other one, which is all that the first layer still holds, from the history.
        QVERIFY(fixture.workspace.pieces().canLift(1));
        QVERIFY(!fixture.workspace.pieces().canLift(2)); // it is a piece
        fixture.workspace.pieces().liftCut(1);
        fixture.settle();
        QCOMPARE(fixture.document().pieces.size(), std::size_t(2));
        QCOMPARE(fixture.carvedBy(1), 0);
        QVERIFY(fixture.coverage(fixture.document().pieces.back().layer) == first);

        const auto undo = [&](int steps) {
            for (int i = 0; i < steps; ++i)
                QVERIFY(session.undo());
            fixture.settle();
        };
        undo(6); // each lift is a layer, the cut that moves there, and the piece
        QCOMPARE(session.stateHash(), both);
        undo(1);
        QCOMPARE(session.stateHash(), before);
    }

    /// While a lifted cut is measured, the user takes it back, and one more step.
    void anUndoOvertakesALift()
    {
        PieceFixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        fixture.apply(test::carveAt({{-6, 0, -12}, {6, 0, -12}}, 5.0));
        const std::size_t rows = fixture.rows();
        // Nothing that waits for the event loop is delivered meanwhile.
        const auto work = [&] {
            for (int i = 0; i < 300 && !session.idle(); ++i) {
                session.poll();
                QTest::qSleep(10);
            }
            session.poll();
        };
        fixture.workspace.pieces().liftCut(2);
        work();
        QCOMPARE(fixture.rows(), rows + 2); // the layer, and the cut that moves there
        QVERIFY(fixture.document().layer(2));
        QTest::qSleep(300); // it is measured, and to be told so
        QVERIFY(session.undo());
        QVERIFY(session.undo());
        work();
        QVERIFY(!fixture.document().layer(2));
        QVERIFY(session.undo());
        fixture.settle();
        QVERIFY(fixture.document().pieces.empty());
        QCOMPARE(session.history().position(), core::RowId(1));
    }

    /// What is still waiting when a lift is asked for may be the reason why its cut cannot be told
    /// from the rest any more.
    void aRefusedLiftLeavesNothing()
    {
        for (const bool isStepOnTop : {false, true}) {
            PieceFixture fixture;
            core::EditSession& session = *fixture.workspace.session();
            fixture.apply(test::newSegment(QStringLiteral("A")));
            fixture.apply(test::paintAt(1, {{0, 0, -12}}));
            QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
            QVERIFY(session.apply(core::SegmentToLayer{.segment = 1, .layer = 1}));
            fixture.workspace.pieces().liftCut(1);
            if (isStepOnTop)
                QVERIFY(session.apply(test::carveAt({{0, 0, 0}}, 3.0)));
            for (int i = 0; i < 4; ++i) {
                static_cast<void>(session.settle()); // it tells the refusal
                QVERIFY(QTest::qWaitFor(
                    [&] { return !fixture.workspace.pieces().isMeasuring(); }, 60000));
            }
            QCOMPARE(failed.count(), 1);
            QCOMPARE(fixture.document().layers.size(), std::size_t(1));
            QVERIFY(fixture.document().pieces.empty());
            QCOMPARE(fixture.workspace.activeLayer(), 1);
            const core::History& history = session.history();
            QVERIFY(history.row(history.position()).edit.is<core::SegmentToLayer>() != isStepOnTop);
        }
    }

    /// What was filled again since would be open, if its cut were another layer's.
    void whatWasRestoredIsNotLiftedAlone()
    {
        PieceFixture fixture;
        fixture.apply(test::carveAt({{-6, 0, -12}, {6, 0, -12}}, 5.0));
        core::BrushStroke back;
        back.path = {.radiusMm = 3.0, .pointsLps = {{0, 0, -12}}};
        back.restore = true;
        fixture.apply(back);
        QVERIFY(!fixture.workspace.pieces().canLift(1));
        QVERIFY(!fixture.workspace.pieces().canLift(2));
        QCOMPARE(fixture.workspace.pieces().lastCut(1), core::RowId(0));
        fixture.workspace.pieces().liftLast(1); // all of it then
        fixture.settle();
        QCOMPARE(fixture.document().pieces.size(), std::size_t(1));
        QCOMPARE(fixture.document().pieces.front().layer, 1);
    }

    void theMiddleMovesIt_data() { test::addMouseAndPen(); }
    void theMiddleMovesIt()
    {
        QFETCH(const test::DrawnBy, by);
        PieceFixture fixture;
        fixture.lift();
        const std::size_t before = fixture.rows();
        const int carved = fixture.carvedBy(1);
        const QByteArray lifted = fixture.workspace.session()->stateHash();
        fixture.pull(fixture.middle(), {40, -25}, by);
        QCOMPARE(fixture.rows(), before + 1); // one step a drag
        const QString name = fixture.workspace.session()->history().rows().back().name;
        QVERIFY2(name.startsWith(QStringLiteral("Move piece '")), qPrintable(name));
        QCOMPARE(fixture.carvedBy(1), carved); // where it is shown decides no voxel
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        const double mm = fixture.view.context().mmPerPixel();
        const glm::dvec3 moved = fixture.document().pieces.front().pose.offsetMm;
        // From the front the patient's left is right in the picture.
        QVERIFY2(glm::distance(moved, glm::dvec3(40 * mm, 0, 25 * mm)) < 0.01,
            qPrintable(QStringLiteral("%1 %2 %3").arg(moved.x).arg(moved.y).arg(moved.z)));
        QVERIFY(fixture.panel->summary() == QStringLiteral("1 of 1 moved"));
        fixture.save("/piece-moved.png");
        QVERIFY(fixture.workspace.session()->undo());
        fixture.settle();
        QVERIFY(fixture.document().pieces.front().pose.isHome());
        QCOMPARE(fixture.workspace.session()->stateHash(), lifted);
        // Beside the handles the view turns.
        const auto camera = fixture.view.camera().towardsViewer;
        fixture.pull(fixture.middle() + QPointF(110, 60), {20, 0}, by);
        QVERIFY(fixture.document().pieces.front().pose.isHome());
        QVERIFY(fixture.view.camera().towardsViewer != camera);
    }

    void ringAndKnobsTurnIt_data() { test::addMouseAndPen(); }
    void ringAndKnobsTurnIt()
    {
        QFETCH(const test::DrawnBy, by);
        PieceFixture fixture;
        fixture.lift();
        const double ring = ui::PieceTool::ringPixels;
        const double diagonal = ring * std::sqrt(0.5);
        // A quarter turn in the picture, counter-clockwise: about the direction to the viewer.
        fixture.pull(fixture.middle() + QPointF(diagonal, diagonal), {0, -2.0 * diagonal}, by);
        glm::dvec3 turn = fixture.document().pieces.front().pose.rotationDegrees;
        QVERIFY2(glm::distance(turn, glm::dvec3(0, -90, 0)) < 1.0,
            qPrintable(QStringLiteral("%1 %2 %3").arg(turn.x).arg(turn.y).arg(turn.z)));
        fixture.workspace.pieces().setPose(1, {});
        fixture.settle();
        fixture.pull(fixture.middle() + QPointF(ring, 0), {50, 0}, by);
        turn = fixture.document().pieces.front().pose.rotationDegrees;
        QVERIFY(glm::distance(turn, glm::dvec3(0, 0, 30)) < 1.0);
        // Escape takes back.
        test::Pen pen(fixture.view);
        pen.press(fixture.middle(), 1.0, 1000);
        pen.move(fixture.middle() + QPointF(30, 30), 1.0, 1010);
        const std::size_t before = fixture.rows();
        fixture.tool.cancel();
        fixture.settle();
        QCOMPARE(fixture.rows(), before);
        QVERIFY(fixture.workspace.pieces().pose(fixture.document().pieces.front()).offsetMm
            == glm::dvec3(0.0));
        pen.release(fixture.middle(), 1040);
    }

    void numbersMoveIt()
    {
        PieceFixture fixture;
        const QAbstractItemModelTester tester(fixture.part<QListView>("pieceList").model(),
            QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.lift();
        fixture.part<QDoubleSpinBox>("pieceOffset0").setValue(42.0);
        fixture.settle();
        QCOMPARE(fixture.document().pieces.front().pose.offsetMm, glm::dvec3(42, 0, 0));
        fixture.part<QDoubleSpinBox>("pieceZoom").setValue(1.5);
        fixture.settle();
        QCOMPARE(fixture.document().pieces.front().pose.zoom, 1.5);
        const QAbstractItemModel& model = *fixture.part<QListView>("pieceList").model();
        QCOMPARE(model.index(0, 0).data(ui::PieceListModel::BadgeRole).toString(),
            QStringLiteral("42 mm · 1.5×"));
        fixture.part<QToolButton>("piecesHome").click();
        fixture.settle();
        QVERIFY(fixture.document().pieces.front().pose.isHome());
        QVERIFY(!fixture.part<QToolButton>("piecesHome").isEnabled());
    }

    void aLidOpensOutwards()
    {
        PieceFixture fixture;
        fixture.lift();
        fixture.part<QToolButton>("pieceLid").click();
        fixture.settle();
        const core::Piece& lid = fixture.document().pieces.front();
        const glm::dmat4 shown = core::shownFromTrue(lid, fixture.workspace.volume()->geometry);
        // It faces up, so the hinge lies behind: the front edge comes up, the back edge stays low.
        const glm::dvec3 front(shown * glm::dvec4(*lid.pivotLps + glm::dvec3(0, -7, 0), 1.0));
        const glm::dvec3 back(shown * glm::dvec4(*lid.pivotLps + glm::dvec3(0, 7, -6), 1.0));
        QVERIFY2(front.z > lid.pivotLps->z + 2.0, qPrintable(QString::number(front.z)));
        QVERIFY2(glm::distance(back, *lid.pivotLps + glm::dvec3(0, 7, -6)) < 6.0,
            qPrintable(QString::number(back.z)));
        QVERIFY(std::abs(glm::length(lid.pose.rotationDegrees) - 105.0) < 0.1);
        fixture.save("/piece-lid.png");
    }

    void looksAreKeptWithTheSession()
    {
        PieceFixture fixture;
        fixture.lift();
        ui::DisplayState state(fixture.workspace, fixture.window.views(), {});
        const std::size_t before = fixture.rows();
        fixture.part<QSlider>("pieceOpacity").setValue(40);
        QListView& list = fixture.part<QListView>("pieceList");
        QVERIFY(list.model()->setData(
            list.model()->index(0, 0), false, ui::PieceListModel::VisibleRole));
        QCOMPARE(fixture.workspace.pieces().scene().front().opacity, 0.0f);
        QCOMPARE(fixture.rows(), before); // no step
        state.keep();
        const QJsonObject kept = fixture.workspace.session()->display().kept();
        ui::PieceLook look;
        fixture.workspace.pieces().setLook(1, look);
        state.apply(kept);
        look = fixture.workspace.pieces().look(1);
        QVERIFY(!look.visible);
        QCOMPARE(look.opacity, 0.4);
    }

    void seedsOnAMovedPieceMeanItsTruePlace_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(gpu::RenderMode::Surface);
        QTest::newRow("DVR") << int(gpu::RenderMode::Dvr);
        QTest::newRow("MIP") << int(gpu::RenderMode::Mip);
    }
    void seedsOnAMovedPieceMeanItsTruePlace()
    {
        QFETCH(int, mode);
        PieceFixture fixture;
        fixture.lift();
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.mode = gpu::RenderMode(mode);
        display.surfaceThreshold = 300.0;
        display.transferFunction.points = {{300.0, 0xFFFFFF, 0.0}, {600.0, 0xFFFFFF, 0.9}};
        fixture.workspace.setVolumeDisplay(display);
        core::PiecePose pose;
        pose.offsetMm = {34, 3, 0};
        pose.zoom = 1.5;
        fixture.workspace.pieces().setPose(1, pose);
        fixture.settle();
        ui::SeedTool seeds(fixture.workspace);
        fixture.workspace.setActiveTool(&seeds);
        // In the picture 6 mm to the right of its middle: 4 mm at its true place.
        const glm::dvec3 middle = *fixture.document().pieces.front().pivotLps;
        test::Pen pen(fixture.view);
        const QPointF at =
            fixture.view.context().toPixel(middle + pose.offsetMm + glm::dvec3(6, 0, 0));
        pen.press(at, 1.0, 5000);
        pen.release(at, 5010);
        fixture.settle();
        const auto* stroke =
            fixture.workspace.session()->history().rows().back().edit.as<core::SeedStroke>();
        QVERIFY(stroke && stroke->pointsLps.size() == 1);
        const glm::dvec3 seed = stroke->pointsLps.front();
        QVERIFY2(std::abs(seed.x - middle.x - 4.0) < 1.0 && std::abs(seed.z - middle.z) < 1.2,
            qPrintable(QStringLiteral("%1 %2 %3").arg(seed.x).arg(seed.y).arg(seed.z)));
        // On the bone that was cut out, on the side towards the viewer unless brightness decides.
        QVERIFY(glm::length(seed) > 12.0 && glm::length(seed) < 17.0);
        QVERIFY(mode == int(gpu::RenderMode::Mip) || seed.y < 0.0);
        // Where nothing is at home and nothing is shown: no seed.
        const std::size_t before = fixture.rows();
        const QPointF beside =
            fixture.view.context().toPixel(middle + pose.offsetMm + glm::dvec3(0, 0, -30));
        pen.press(beside, 1.0, 6000);
        pen.release(beside, 6010);
        fixture.settle();
        if (mode != int(gpu::RenderMode::Mip))
            QCOMPARE(fixture.rows(), before);
    }

    void aSegmentIsPasted()
    {
        PieceFixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Tooth"), 0x40C080));
        fixture.apply(test::paintAt(1, {{4, 0, -6}}, 5.0));
        fixture.workspace.pieces().paste(1);
        fixture.settle();
        QCOMPARE(fixture.document().pieces.size(), std::size_t(1));
        const core::Piece& piece = fixture.document().pieces.front();
        QCOMPARE(piece.name, QStringLiteral("Tooth"));
        QVERIFY(glm::distance(*piece.pivotLps, glm::dvec3(4, 0, -6)) < 1.0);
        QVERIFY(piece.pose.offsetMm.x > 15.0); // beside the head
        gpu::ScenePiece drawn = fixture.workspace.pieces().scene().front();
        QVERIFY(drawn.solid && drawn.rgb == 0x40C080);
        QComboBox& map = fixture.part<QComboBox>("pieceMap");
        QCOMPARE(map.currentIndex(), 1);
        map.setCurrentIndex(0);
        Q_EMIT map.activated(0);
        drawn = fixture.workspace.pieces().scene().front();
        QVERIFY(!drawn.solid && drawn.rgb == 0xFFFFFF);
        fixture.apply(core::RemoveSegment{.segment = 1});
        QVERIFY(fixture.document().pieces.empty());
        QCOMPARE(fixture.workspace.pieces().active(), 0);
    }
};

BURIN_WINDOW_TEST(PieceToolUiTest)

} // namespace pieceToolUiTest

#include "PieceToolUiTest.moc"
