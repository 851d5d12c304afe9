// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/views/ContextSwitch.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Refinement.h"

#include <QAction>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace contextSwitchUiTest {

using gpu::Context;

namespace {

/// The real window with the small head and a ball as segment 1.
class ContextFixture : public test::WindowFixture {
public:
    explicit ContextFixture(const QSize& size = QSize(1200, 800))
        : test::WindowFixture(test::smallHead::volume(), size)
        , view(window.views().volume())
    {
        apply(test::ballMask(glm::ivec3(test::smallHead::side), 10.0));
        workspace.setActiveSegment(1);
    }
    void apply(const core::Edit& edit)
    {
        if (!workspace.session()->apply(edit) || !workspace.session()->settle())
            qFatal("the edit fails");
        // Updates of the surface come in line with other events.
        QCoreApplication::processEvents();
    }
    void step(void (*how)(core::EditSession&))
    {
        how(*workspace.session());
        static_cast<void>(workspace.session()->settle());
        QCoreApplication::processEvents();
    }
    void show(Context context)
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.context = context;
        workspace.setVolumeDisplay(display);
    }
    [[nodiscard]] Context shown() const { return workspace.volumeDisplay().context; }
    [[nodiscard]] gpu::VolumeScene asked() const
    {
        return std::get<gpu::VolumeScene>(frames.lastRequest(view.viewId()).scene);
    }
    [[nodiscard]] ui::ContextSwitch& control() const
    {
        return *view.findChild<ui::ContextSwitch*>();
    }
    [[nodiscard]] QToolButton& button(const char* name) const
    {
        return *control().findChild<QToolButton*>(QLatin1String(name));
    }
    [[nodiscard]] QSlider& opacity() const
    {
        return *control().findChild<QSlider*>(QStringLiteral("contextOpacity"));
    }
    /// What the window does when keys are pressed.
    void key(QKeyCombination keys)
    {
        const QKeySequence pressed(keys);
        for (QAction* action : window.actionTable().all()) {
            if (action->shortcuts().contains(pressed))
                return action->trigger();
        }
        qFatal("no action has this key");
    }

    ui::VolumeView& view;
};

} // namespace

class ContextSwitchUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itChoosesWhatIsSeen()
    {
        ContextFixture fixture;
        QVERIFY(fixture.button("contextOpaque").isChecked());
        QVERIFY(!fixture.opacity().isVisible());
        const std::size_t rows = fixture.workspace.session()->history().rows().size();
        QTest::mouseClick(&fixture.button("contextBoth"), Qt::LeftButton);
        QCOMPARE(fixture.shown(), Context::Translucent);
        QCOMPARE(fixture.asked().context, Context::Translucent);
        QVERIFY(fixture.opacity().isVisible());
        fixture.opacity().setValue(60);
        QCOMPARE(fixture.asked().contextOpacity, 0.6f);
        QTest::mouseClick(&fixture.button("contextCutAway"), Qt::LeftButton);
        QCOMPARE(fixture.asked().context, Context::CutAway);
        QVERIFY(!fixture.opacity().isEnabled());
        QTest::mouseClick(&fixture.button("contextHidden"), Qt::LeftButton);
        QCOMPARE(fixture.asked().context, Context::Hidden);
        QVERIFY(!fixture.opacity().isVisible());
        // "Both" comes back as it was.
        QTest::mouseClick(&fixture.button("contextBoth"), Qt::LeftButton);
        QCOMPARE(fixture.asked().context, Context::CutAway);
        QTest::mouseClick(&fixture.button("contextCutAway"), Qt::LeftButton);
        QCOMPARE(fixture.asked().context, Context::Translucent);
        QCOMPARE(fixture.asked().contextOpacity, 0.6f);
        // It is how the window looks, no step of the history.
        QCOMPARE(fixture.workspace.session()->history().rows().size(), rows);
    }

    void keysChooseToo()
    {
        ContextFixture fixture;
        fixture.key(Qt::AltModifier | Qt::Key_8);
        QCOMPARE(fixture.shown(), Context::Hidden);
        QVERIFY(fixture.button("contextHidden").isChecked());
        fixture.key(Qt::AltModifier | Qt::Key_6);
        QCOMPARE(fixture.shown(), Context::Translucent);
        fixture.key(Qt::AltModifier | Qt::Key_7);
        QCOMPARE(fixture.shown(), Context::CutAway);
        QVERIFY(fixture.button("contextBoth").isChecked());
        QVERIFY(fixture.button("contextCutAway").isChecked());
        fixture.key(Qt::AltModifier | Qt::Key_5);
        QCOMPARE(fixture.shown(), Context::Opaque);
        // The control itself: Tab reaches it, Space chooses.
        fixture.button("contextHidden").setFocus(Qt::TabFocusReason);
        QTest::keyClick(&fixture.button("contextHidden"), Qt::Key_Space);
        QCOMPARE(fixture.shown(), Context::Hidden);
    }

    /// A click leaves the keyboard with whom it was.
    void itTakesNoFocus()
    {
        ContextFixture fixture;
        fixture.view.setFocus();
        QTest::mouseClick(&fixture.button("contextHidden"), Qt::LeftButton);
        QVERIFY(!fixture.button("contextHidden").hasFocus());
        QCOMPARE(fixture.view.camera().heightMm, fixture.asked().heightMm); // nothing turned
    }

    void refiningStepsBack()
    {
        ContextFixture fixture;
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        QCOMPARE(fixture.asked().context, Context::Hidden);
        QVERIFY(fixture.asked().surface.has_value());
        QCOMPARE(fixture.asked().bodiless, 1);
        // In its segment's colour, whose marks cover it only where something was judged.
        QCOMPARE(fixture.asked().surface->colours.rgb,
            fixture.workspace.session()->document().segment(1)->rgb);
        QCOMPARE(fixture.asked().surface->colours.yellowShare, 0.0f);
        fixture.apply(core::DropSurface{});
        QCOMPARE(fixture.asked().context, Context::Opaque);
        QCOMPARE(fixture.asked().bodiless, 0);
        // Undo brings the surface back, and the end of it.
        fixture.step([](core::EditSession& session) { QVERIFY(session.undo()); });
        QCOMPARE(fixture.shown(), Context::Hidden);
        fixture.step([](core::EditSession& session) { QVERIFY(session.undo()); });
        QCOMPARE(fixture.shown(), Context::Opaque);
    }

    void whatWasThereComesBack()
    {
        ContextFixture fixture;
        fixture.show(Context::CutAway);
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        QCOMPARE(fixture.shown(), Context::Hidden);
        fixture.apply(core::DropSurface{});
        QCOMPARE(fixture.shown(), Context::CutAway);
    }

    /// What the user chooses while a surface is refined, he chooses for good.
    void whoChoosesIsNotOverruled()
    {
        ContextFixture fixture;
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        fixture.show(Context::Translucent);
        fixture.apply(core::DropSurface{});
        QCOMPARE(fixture.shown(), Context::Translucent);
        fixture.show(Context::Hidden);
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        fixture.apply(core::DropSurface{});
        QCOMPARE(fixture.shown(), Context::Hidden);
    }

    /// With edges alone the body stays, to compare.
    void aWireframeKeepsTheBody()
    {
        ContextFixture fixture;
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        ui::Refinement::Look look = fixture.workspace.refinement().look();
        look.style = gpu::SurfaceStyle::Wireframe;
        fixture.workspace.refinement().setLook(look);
        QCOMPARE(fixture.asked().bodiless, 0);
        look.style = gpu::SurfaceStyle::Shaded;
        look.opacity = 0.0f;
        fixture.workspace.refinement().setLook(look);
        QCOMPARE(fixture.asked().bodiless, 0);
    }

    /// The mask on the cutting plane is that of the surface, however it is drawn, also where
    /// another segment has the same colour.
    void thePlaneKnowsWhoseSurfaceItIs()
    {
        ContextFixture fixture;
        const std::uint32_t rgb = fixture.workspace.session()->document().segment(1)->rgb;
        fixture.apply(core::AddSegment{.name = QStringLiteral("Other"), .rgb = rgb});
        const int other = fixture.workspace.session()->document().segments.back().label;
        fixture.workspace.plane().setLook({.shown = true});
        QCOMPARE(fixture.asked().plane->mask, 0);
        fixture.apply(test::paintAt(other, {{14, 0, 0}}));
        fixture.apply(core::LaySurface{.segment = other, .vertices = 800});
        QCOMPARE(fixture.asked().plane->mask, other);
        ui::Refinement::Look look = fixture.workspace.refinement().look();
        look.style = gpu::SurfaceStyle::Wireframe;
        look.contours = true;
        fixture.workspace.refinement().setLook(look);
        QCOMPARE(fixture.asked().plane->mask, other);
        look.contours = false;
        fixture.workspace.refinement().setLook(look);
        QCOMPARE(fixture.asked().plane->mask, other);
        look.opacity = 0.0f; // nothing stands out from it any more
        fixture.workspace.refinement().setLook(look);
        QCOMPARE(fixture.asked().plane->mask, 0);
    }

    /// Shift+H hides the outline of carving on the plane as in slices.
    void thePlaneHidesCarvingAsSlicesDo()
    {
        ContextFixture fixture;
        fixture.workspace.plane().setLook({.shown = true});
        QVERIFY(fixture.asked().plane->showCarved);
        fixture.key(Qt::ShiftModifier | Qt::Key_H);
        QVERIFY(!fixture.asked().plane->showCarved);
        fixture.key(Qt::ShiftModifier | Qt::Key_H);
        QVERIFY(fixture.asked().plane->showCarved);
    }

    /// A stored display tells that the volume has stepped back, but the session has no surface:
    /// then nothing is refined, and the volume comes back at once.
    void withoutASurfaceNothingStaysHidden()
    {
        ContextFixture fixture;
        fixture.show(Context::Hidden);
        fixture.control().setBefore(Context::CutAway);
        QCOMPARE(fixture.shown(), Context::CutAway);
        QVERIFY(!fixture.control().before());
        QVERIFY(fixture.button("contextCutAway").isChecked());
        // Who has chosen segments alone still sees them alone.
        fixture.show(Context::Hidden);
        fixture.control().setBefore(std::nullopt);
        QCOMPARE(fixture.shown(), Context::Hidden);
    }

    /// What cannot be seen is not worked on: tools for the volume rest in the 3D view. Paint works
    /// on what segments show there.
    void toolsForTheVolumeRest()
    {
        ContextFixture fixture;
        ui::DrillTool drill(fixture.workspace);
        ui::PaintTool paint(fixture.workspace);
        ui::BarrierTool barrier(fixture.workspace);
        ui::RefineTool refine(fixture.workspace);
        fixture.show(Context::Translucent);
        QVERIFY(drill.worksIn(fixture.view.context()));
        fixture.show(Context::Hidden);
        QVERIFY(!drill.worksIn(fixture.view.context()));
        QVERIFY(!barrier.worksIn(fixture.view.context()));
        QVERIFY(paint.worksIn(fixture.view.context()));
        QVERIFY(paint.worksIn(fixture.window.views().axial().context()));
        QVERIFY(refine.worksIn(fixture.view.context()));
    }

    /// It ends where its last visible part does.
    void itIsNoWiderThanWhatItShows()
    {
        ContextFixture fixture;
        for (const Context context : {Context::Opaque, Context::Translucent, Context::Hidden}) {
            fixture.show(context);
            QCoreApplication::processEvents();
            const bool both = context == Context::Translucent;
            const QToolButton& last = fixture.button(both ? "contextCutAway" : "contextHidden");
            const int right = last.mapTo(&fixture.control(), QPoint(last.width(), 0)).x();
            const int blank = fixture.control().width() - right;
            QVERIFY2(blank >= 0 && blank <= 2, qPrintable(QString::number(blank)));
            QCOMPARE(fixture.opacity().isVisible(), both);
        }
    }

    void itHasRoom_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small window") << QSize(1280, 720);
        QTest::newRow("usual window") << QSize(1920, 1080);
    }
    void itHasRoom()
    {
        QFETCH(QSize, size);
        ContextFixture fixture(size);
        fixture.show(Context::Translucent);
        QCoreApplication::processEvents();
        const QRect own = fixture.control().geometry();
        QVERIFY(fixture.view.rect().contains(own));
        // Orientation cube at the right, letter at the foot, lines of text below.
        QVERIFY2(
            own.right() < fixture.view.width() - 100, qPrintable(QString::number(own.right())));
        QVERIFY(own.bottom() <= fixture.view.height() - 26);
        QVERIFY(own.height() <= 28);
        // With panels beside it the 3D view of the small window is 472 pixels wide.
        QVERIFY2(own.right() < 472 - 100, qPrintable(QString::number(own.right())));
    }
};

BURIN_WINDOW_TEST(ContextSwitchUiTest)

} // namespace contextSwitchUiTest

#include "ContextSwitchUiTest.moc"
