// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/RulerTool.h"

#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Pieces.h"

#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <memory>

namespace rulerToolUiTest {

namespace {

class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&tool);
    }
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    [[nodiscard]] const std::vector<core::Measurement>& measurements()
    {
        return session().document().measurements;
    }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("refused");
    }
    void drag(ui::ImageView& view, const QPointF& from, const QPointF& to)
    {
        test::Pen pen(view);
        pen.press(from, 0.5, 100);
        pen.move((from + to) / 2.0, 0.7, 108);
        pen.move(to, 0.7, 116);
        pen.release(to, 124);
        settle();
    }
    void settle()
    {
        // What an answer asks for is asked after it came.
        for (int i = 0; i < 4; ++i) {
            session().poll();
            if (!session().settle())
                qFatal("not settled");
        }
    }

    ui::RulerTool tool;
};

QPointF middleOf(const ui::ImageView& view)
{
    return QPointF(view.width(), view.height()) / 2.0;
}

} // namespace

class RulerToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aDragOnASliceIsADistance()
    {
        Fixture fixture;
        ui::SliceView& view = fixture.window.views().sagittal();
        const QPointF from = middleOf(view) + QPointF(-30, -10);
        const QPointF to = middleOf(view) + QPointF(10, 20);
        const double mm = view.context().mmPerPixel() * 50.0;
        fixture.drag(view, from, to);
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QVERIFY(std::abs(fixture.measurements()[0].lengthMm() - mm) < 0.01);
        QCOMPARE(fixture.measurements()[0].piece, 0);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Measure %1 mm").arg(QString::number(mm, 'f', 1)));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.measurements().empty());
        QVERIFY(fixture.session().redo());
        fixture.settle();
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
    }

    void clicksAndDroppedLinesMeasureNothing()
    {
        Fixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.drag(view, middleOf(view), middleOf(view) + QPointF(1, 1));
        test::Pen pen(view);
        pen.press(middleOf(view), 0.5, 1);
        pen.move(middleOf(view) + QPointF(30, 0), 0.5, 2);
        QTest::keyClick(&view, Qt::Key_Escape);
        pen.release(middleOf(view) + QPointF(30, 0), 3);
        // Beside all that is seen.
        ui::VolumeView& volume = fixture.window.views().volume();
        fixture.drag(volume, QPointF(6, 6), middleOf(volume));
        QVERIFY(fixture.session().history().rows().empty());
    }

    void inThreeDimensionsItIsMeasuredOnWhatIsSeen()
    {
        Fixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        const double mmPerPixel = view.context().mmPerPixel();
        const QPointF reach(10.0 / mmPerPixel, 0.0);
        fixture.drag(view, middleOf(view) - reach, middleOf(view) + reach);
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        const core::Measurement& measured = fixture.measurements()[0];
        QVERIFY2(std::abs(measured.lengthMm() - 20.0) < 1.5,
            qPrintable(QString::number(measured.lengthMm())));
        // Both ends lie on the bone, 16 mm from the middle, on the viewer's side.
        for (const glm::dvec3& end : {measured.fromLps, measured.toLps})
            QVERIFY(std::abs(glm::length(end) - 16.0) < 1.6 && end.y < 0.0);
    }

    /// Far from home and twice as large: the length is that of the patient.
    void onAPieceItIsTheTrueLength()
    {
        Fixture fixture;
        fixture.apply(test::carveAt({{0, 0, 0}}, 26.0));
        core::CutPiece lift;
        lift.name = QStringLiteral("Ball");
        lift.pivotLps = glm::dvec3(0.0);
        fixture.apply(lift);
        core::ChangePiece move;
        move.piece = 1;
        move.offsetMm = glm::dvec3(8, 0, 4);
        move.zoom = 2.0;
        fixture.apply(move);
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        const QPointF at = view.context().toPixel({8, 0, 4});
        const QPointF reach(8.0 / view.context().mmPerPixel(), 0.0);
        fixture.drag(view, at - reach, at + reach); // 16 mm as shown
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        const core::Measurement measured = fixture.measurements()[0];
        QVERIFY2(std::abs(measured.lengthMm() - 8.0) < 1.5,
            qPrintable(QString::number(measured.lengthMm())));
        QCOMPARE(measured.piece, 1);
        QVERIFY(std::abs(glm::length(measured.fromLps) - 16.0) < 1.6);
        // Without the piece it stays, at its true place.
        fixture.apply(core::RemovePiece{.piece = 1});
        QCOMPARE(fixture.measurements()[0].piece, 0);
        QCOMPARE(fixture.measurements()[0].fromLps, measured.fromLps);
    }

    void theListTakesThemAway()
    {
        Fixture fixture;
        const std::unique_ptr<QWidget> options(fixture.tool.createOptions(nullptr));
        auto* button = options->findChild<QToolButton*>(QStringLiteral("measurements"));
        QVERIFY(button && !button->isEnabled());
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {3, 4, 0}, .piece = {}});
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {0, 0, 9}, .piece = {}});
        QCOMPARE(button->text(), QStringLiteral("2 measurements"));
        Q_EMIT button->menu()->aboutToShow();
        QCOMPARE(button->menu()->actions().size(), 2);
        QCOMPARE(button->menu()->actions()[0]->text(), QStringLiteral("Remove 1: 5.0 mm"));
        button->menu()->actions()[0]->trigger();
        fixture.settle();
        QCOMPARE(fixture.measurements().size(), std::size_t(1));
        QCOMPARE(fixture.measurements()[0].id, 2);
        QCOMPARE(button->text(), QStringLiteral("1 measurement"));
    }
};

BURIN_WINDOW_TEST(RulerToolUiTest)

} // namespace rulerToolUiTest

#include "RulerToolUiTest.moc"
