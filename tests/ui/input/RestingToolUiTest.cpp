// SPDX-License-Identifier: Apache-2.0
#include "ui/input/RestingTool.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/views/ViewGrid.h"

#include <QSignalSpy>
#include <QTest>

namespace restingToolUiTest {

/// Whoever clicks where a tool does not work is told why.
class RestingToolUiTest : public QObject {
    Q_OBJECT

    /// What is said after a click, or a drag, into a view; empty: nothing.
    static QString saidAt(
        test::WindowFixture& fixture, ui::ImageView& view, const QPointF& at, bool drags = false)
    {
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.mouse(view, QEvent::MouseButtonPress, at);
        if (drags)
            fixture.mouse(view, QEvent::MouseMove, at + QPointF(30.0, 0.0));
        fixture.mouse(view, QEvent::MouseButtonRelease, at + QPointF(drags ? 30.0 : 0.0, 0.0));
        return said.isEmpty() ? QString() : said.last()[0].toString();
    }
    /// The same in its middle.
    static QString saidAfter(test::WindowFixture& fixture, ui::ImageView& view, bool drags = false)
    {
        return saidAt(fixture, view, QPointF(view.width(), view.height()) / 2.0, drags);
    }
    static void show(test::WindowFixture& fixture, gpu::Context context)
    {
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = context;
        fixture.workspace.setVolumeDisplay(display);
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aToolOfTheVolumeNeedsIt()
    {
        test::WindowFixture fixture(test::plainCt(test::headFirstSupine()));
        ui::DrillTool drill(fixture.workspace);
        fixture.workspace.setActiveTool(&drill);
        ui::ImageView& view = fixture.window.views().volume();
        show(fixture, gpu::Context::Hidden);
        const QString rests =
            QStringLiteral("Drill works on the volume: choose Volume or both in the view");
        QCOMPARE(saidAfter(fixture, view), rests);
        show(fixture, gpu::Context::CutAway);
        const QString cut = saidAfter(fixture, view);
        QVERIFY2(cut.contains(QStringLiteral("switch off cut away")), qPrintable(cut));
        // Whoever turns the view knows what the button does here.
        QVERIFY(saidAfter(fixture, view, true) != cut);
        show(fixture, gpu::Context::Opaque);
        QVERIFY(saidAfter(fixture, view) != rests);
        QCOMPARE(saidAfter(fixture, fixture.window.views().axial()),
            QStringLiteral("Drill works in the 3D view"));
    }

    /// The cube of the orientation works with any tool.
    void whatWorksAllTheSameIsNotCommentedOn()
    {
        test::WindowFixture fixture(test::plainCt(test::headFirstSupine()));
        ui::DrillTool drill(fixture.workspace);
        fixture.workspace.setActiveTool(&drill);
        ui::VolumeView& view = fixture.window.views().volume();
        show(fixture, gpu::Context::Hidden);
        view.turn(30.0, 20.0);
        const gpu::Scene before = view.context().scene;
        QCOMPARE(
            saidAt(fixture, view, QPointF(view.width() - 54.0, view.height() - 58.0)), QString());
        QVERIFY(view.context().scene != before);
    }

    void aToolOfSlicesNeedsOne()
    {
        test::WindowFixture fixture(test::plainCt(test::headFirstSupine()));
        ui::FloodFillTool fill(fixture.workspace);
        fixture.workspace.setActiveTool(&fill);
        const QString rests = fill.longName() + QStringLiteral(" works in the slices");
        for (const gpu::Context context : {gpu::Context::Opaque, gpu::Context::Hidden}) {
            show(fixture, context);
            QCOMPARE(saidAfter(fixture, fixture.window.views().volume()), rests);
        }
        fixture.workspace.setActiveTool(nullptr);
        QVERIFY(saidAfter(fixture, fixture.window.views().volume()) != rests);
    }
};

BURIN_WINDOW_TEST(RestingToolUiTest)

} // namespace restingToolUiTest

#include "RestingToolUiTest.moc"
