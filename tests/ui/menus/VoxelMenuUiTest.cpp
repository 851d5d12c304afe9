// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/VoxelMenu.h"

#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/InitialDisplay.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QPointer>
#include <QSignalSpy>
#include <QtTest>

namespace voxelMenuUiTest {

namespace {

/// A window that is clicked into with the right button.
class Fixture : public test::WindowFixture {
public:
    explicit Fixture(core::LoadedVolume volume)
        : WindowFixture(std::move(volume))
    {
    }
    /// Until every question is answered that an answer led to.
    void settle()
    {
        for (int round = 0; round < 5; ++round) {
            if (!session().settle())
                qFatal("not settled");
            session().poll();
        }
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    /// Null if none opens.
    [[nodiscard]] QMenu* clicked(QWidget& view, const QPoint& at)
    {
        QTest::mouseClick(&view, Qt::RightButton, {}, at);
        settle();
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
};

/// Two dabs of a segment in one axial slice, and two segments that are empty.
class Dabs : public Fixture {
public:
    Dabs()
        : Fixture(test::smallStudy())
    {
        for (const char* name : {"Parts", "Other", "Third"})
            apply(test::addSegment(name));
        apply(test::paintAt(1, {placeOf({10, 10, 10})}, 2.0));
        one = voxels(1);
        apply(test::paintAt(1, {placeOf({28, 24, 10})}, 3.0));
        other = voxels(1) - one;
        workspace.setCrosshairLps(placeOf({20, 17, 10}));
    }
    [[nodiscard]] glm::dvec3 placeOf(const glm::ivec3& voxel) const
    {
        return workspace.volume()->geometry.toWorld(glm::dvec3(voxel));
    }
    [[nodiscard]] QMenu* clickedAt(const glm::ivec3& voxel)
    {
        ui::SliceView& axial = window.views().axial();
        return clicked(axial, axial.context().toPixel(placeOf(voxel)).toPoint());
    }

    std::int64_t one = 0; ///< voxels of the first dab
    std::int64_t other = 0;
};

QStringList textsOf(const QMenu& menu)
{
    QStringList texts;
    for (const QAction* each : menu.actions())
        texts += each->text();
    return texts;
}

/// What is offered about the island comes first, before a line.
QList<QAction*> islandEntries(const QMenu& menu)
{
    QList<QAction*> entries;
    for (QAction* each : menu.actions()) {
        if (each->isSeparator())
            break;
        entries += each;
    }
    return entries;
}

QStringList islandTexts(const QMenu& menu)
{
    QStringList texts;
    for (const QAction* each : islandEntries(menu))
        texts += each->text();
    return texts;
}

QAction* entryOf(const QMenu& menu, const char* name)
{
    return menu.findChild<QAction*>(QLatin1String(name));
}

/// Chooses an entry, as a click into the menu does, which closes it.
void choose(QMenu& menu, QAction& entry)
{
    entry.trigger();
    menu.close();
}

} // namespace

class VoxelMenuUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aSlicesMenuRemovesTheIsland()
    {
        Dabs fixture;
        QVERIFY(fixture.one > 10 && fixture.other > fixture.one);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QMenu* menu = fixture.clickedAt({10, 11, 10});
        QVERIFY(menu);
        QCOMPARE(islandTexts(*menu),
            (QStringList{QStringLiteral("Remove this island of 'Parts'"),
                QStringLiteral("Keep only this island of 'Parts'"),
                QStringLiteral("Give this island of 'Parts' to")}));
        choose(*menu, *menu->actions().at(0));
        fixture.settle();
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Remove one island of 'Parts', −%1 voxels; Ctrl+Z takes it back")
                .arg(fixture.one));
        QCOMPARE(fixture.voxels(1), fixture.other);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.one + fixture.other);
    }

    void andKeepsItAlone()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        choose(*menu, *menu->actions().at(1));
        fixture.settle();
        QCOMPARE(fixture.voxels(1), fixture.one);
        // It is alone now, which is told instead of a step.
        const std::size_t rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        choose(*menu, *menu->actions().at(1));
        fixture.settle();
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Parts' is one island already"));
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void andGivesItToAnother()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({28, 24, 10});
        QVERIFY(menu);
        auto* give = menu->findChild<QMenu*>(QStringLiteral("giveIsland"));
        QVERIFY(give && give->menuAction()->isEnabled());
        QCOMPARE(textsOf(*give), (QStringList{QStringLiteral("Other"), QStringLiteral("Third")}));
        choose(*menu, *give->actions().at(1));
        fixture.settle();
        QCOMPARE(fixture.voxels(1), fixture.one);
        QCOMPARE(fixture.voxels(2), std::int64_t(0));
        QCOMPARE(fixture.voxels(3), fixture.other);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Give one island of 'Parts' to 'Third', −%1 voxels").arg(fixture.other));
        // Now it is the third one's.
        menu = fixture.clickedAt({28, 24, 10});
        QVERIFY(menu);
        QCOMPARE(menu->actions().front()->text(), QStringLiteral("Remove this island of 'Third'"));
        menu->close();
    }

    void whatCannotBeSaysWhy()
    {
        Dabs fixture;
        const auto grey = [](const QMenu& menu, const QString& why) {
            for (const QAction* each : islandEntries(menu)) {
                if (each->isEnabled() || each->toolTip() != why)
                    return false;
            }
            return menu.toolTipsVisible() && islandEntries(menu).size() == 3;
        };
        QMenu* menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        QCOMPARE(islandTexts(*menu),
            (QStringList{QStringLiteral("Remove this island"),
                QStringLiteral("Keep only this island"), QStringLiteral("Give this island to")}));
        QVERIFY(grey(*menu, QStringLiteral("no segment has a voxel there")));
        menu->close();

        fixture.apply(test::lockSegment(2));
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        auto* give = menu->findChild<QMenu*>(QStringLiteral("giveIsland"));
        QVERIFY(give && menu->actions().front()->isEnabled());
        QVERIFY(!give->actions().at(0)->isEnabled() && give->actions().at(1)->isEnabled());
        QCOMPARE(give->actions().at(0)->toolTip(), QStringLiteral("'Other' is locked"));
        menu->close();

        fixture.apply(test::lockSegment(1));
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QVERIFY(grey(*menu, QStringLiteral("'Parts' is locked")));
        menu->close();
    }

    void aSliceOffersToFlipAndTurnIt()
    {
        Dabs fixture;
        ui::SliceView& axial = fixture.window.views().axial();
        QMenu* menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        auto* turns = menu->findChild<QMenu*>(QStringLiteral("turnsOfView"));
        QVERIFY(turns);
        QCOMPARE(turns->actions().size(), 5);
        QVERIFY(!turns->actions().back()->isEnabled()); // it is upright
        choose(*menu, *turns->actions().front());
        QVERIFY((axial.turn() == ui::SliceTurn{true, 0}));
        // The menu is about what is seen there now.
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QCOMPARE(textsOf(*menu).front(), QStringLiteral("Remove this island of 'Parts'"));
        turns = menu->findChild<QMenu*>(QStringLiteral("turnsOfView"));
        QVERIFY(turns->actions().back()->isEnabled());
        choose(*menu, *turns->actions().back());
        QVERIFY(axial.turn().isUpright());
    }

    void aSliceOffersItsColours()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        auto* colours = menu->findChild<QMenu*>(QStringLiteral("coloursOfSlices"));
        QVERIFY(colours);
        QVERIFY(colours->actions().front()->isChecked()); // grey
        choose(*menu, *colours->actions()[1]);
        QVERIFY(fixture.workspace.viewOptions().colours == gpu::ColourMap::HotIron);
    }

    void aSliceOffersItsInterpolation()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        auto* ways = menu->findChild<QMenu*>(QStringLiteral("interpolationOfSlices"));
        QVERIFY(ways);
        QVERIFY(ways->actions().front()->isChecked()); // the usual way
        QVERIFY(!ways->actions().back()->isChecked());
        choose(*menu, *ways->actions().back());
        QVERIFY(fixture.workspace.viewOptions().interpolation == gpu::Interpolation::Cubic);
    }

    /// Outside of the volume no voxel can be meant, but the view can.
    void besideTheVolumeItIsAboutTheView()
    {
        Dabs fixture;
        ui::ViewGrid& views = fixture.window.views();
        ui::SliceView& axial = views.axial();
        const auto beside = [&fixture, &axial] {
            return fixture.clicked(axial, QPoint(3, axial.height() / 2));
        };
        QMenu* menu = beside();
        QVERIFY(menu);
        QCOMPARE(menu->objectName(), QStringLiteral("viewMenu"));
        QVERIFY(!entryOf(*menu, "crosshairHere") && !entryOf(*menu, "copyValue"));
        const auto presets = ui::windowPresets(*fixture.workspace.volume());
        auto* windows = menu->findChild<QMenu*>(QStringLiteral("windowPresets"));
        QVERIFY(windows && windows->actions().size() == qsizetype(presets.size()));
        choose(*menu, *windows->actions().at(1));
        QCOMPARE(fixture.workspace.windowLevel(), presets[1].window);

        menu = beside();
        QVERIFY(menu);
        auto* colours = menu->findChild<QMenu*>(QStringLiteral("coloursOfSlices"));
        QVERIFY(colours && menu->findChild<QMenu*>(QStringLiteral("turnsOfView")));
        choose(*menu, *colours->actions().at(1));
        QVERIFY(fixture.workspace.viewOptions().colours == gpu::ColourMap::HotIron);

        const double fitted = axial.context().mmPerPixel();
        const QPointF middle = axial.rect().toRectF().center();
        QWheelEvent wheel(middle, axial.mapToGlobal(middle), {}, {0, -240}, Qt::NoButton,
            Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&axial, &wheel);
        QVERIFY(axial.context().mmPerPixel() > fitted);
        menu = beside();
        QVERIFY(menu && entryOf(*menu, "resetThisView"));
        choose(*menu, *entryOf(*menu, "resetThisView"));
        QCOMPARE(axial.context().mmPerPixel(), fitted);

        menu = beside();
        QVERIFY(menu);
        auto* layouts = menu->findChild<QMenu*>(QStringLiteral("layoutOfViews"));
        QAction& coronalAlone = fixture.window.actionTable()[QStringLiteral("view.coronal")];
        QVERIFY(layouts && layouts->actions().contains(&coronalAlone));
        choose(*menu, coronalAlone);
        QVERIFY(views.maximised() == &views.coronal());
        // It is how the window looks, no step of the history.
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(5));
    }

    /// A drag is no click.
    void noMenuWhereNoneIsMeant()
    {
        Dabs fixture;
        ui::SliceView& axial = fixture.window.views().axial();
        const QPoint from = axial.context().toPixel(fixture.placeOf({10, 10, 10})).toPoint();
        QTest::mousePress(&axial, Qt::RightButton, {}, from);
        const QPointF to = QPointF(from) + QPointF(0.0, 20.0);
        QMouseEvent move(
            QEvent::MouseMove, to, axial.mapToGlobal(to), Qt::NoButton, Qt::RightButton, {});
        QApplication::sendEvent(&axial, &move);
        QTest::mouseRelease(&axial, Qt::RightButton, {}, to.toPoint());
        fixture.settle();
        QVERIFY(!QApplication::activePopupWidget());
    }

    /// The answer may take a while; who has begun something else by then is not interrupted.
    void noMenuForWhoHasGoneOn()
    {
        Dabs fixture;
        ui::SliceView& axial = fixture.window.views().axial();
        const QPoint at = axial.context().toPixel(fixture.placeOf({10, 10, 10})).toPoint();
        QTest::mouseClick(&axial, Qt::RightButton, {}, at);
        QVERIFY(!QApplication::activePopupWidget()); // the session has not answered yet
        QTest::mousePress(&axial, Qt::LeftButton, {}, at + QPoint(9, 9));
        fixture.settle();
        QVERIFY(!QApplication::activePopupWidget());
        QTest::mouseRelease(&axial, Qt::LeftButton, {}, at + QPoint(9, 9));
        fixture.settle();
        QVERIFY(!QApplication::activePopupWidget());
        // Of two clicks the second one counts.
        QTest::mouseClick(&axial, Qt::RightButton, {}, at);
        QMenu* menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        QCOMPARE(menu->actions().front()->text(), QStringLiteral("Remove this island"));
        menu->close();
        QTest::qWait(1);
        QVERIFY(!QApplication::activePopupWidget());
    }

    /// Its entries are about the voxels of the session that was open.
    void anotherSessionClosesIt()
    {
        Dabs fixture;
        QPointer<QMenu> menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QPointer<QAction> remove = menu->actions().front();
        fixture.workspace.setSession(nullptr);
        QVERIFY(!QApplication::activePopupWidget());
        if (remove)
            remove->trigger(); // what is chosen late does nothing
        // A request that waits is withdrawn, too.
        auto session = core::EditSession::create(fixture.engine, test::smallStudy(), {});
        QVERIFY(session);
        fixture.workspace.setSession(std::move(*session));
        QVERIFY(fixture.session().document().segments.empty());
        QVERIFY(fixture.session().history().rows().empty());
    }

    void aHiddenSegmentIsLeftAlone()
    {
        Dabs fixture;
        ui::Workspace::ViewOptions options = fixture.workspace.viewOptions();
        options.showSegments = false;
        fixture.workspace.setViewOptions(options);
        QMenu* menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        for (const QAction* each : islandEntries(*menu)) {
            QVERIFY(!each->isEnabled());
            QCOMPARE(each->toolTip(), QStringLiteral("'Parts' is hidden"));
        }
        menu->close();
    }

    /// Of a voxel of a segment: it becomes active, is locked, is shown alone.
    void itsSegmentIsAtHand()
    {
        Dabs fixture;
        fixture.workspace.setActiveSegment(2);
        QMenu* menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QAction* active = entryOf(*menu, "activateSegment");
        QVERIFY(active && active->isEnabled());
        QCOMPARE(active->text(), QStringLiteral("Make 'Parts' active"));
        choose(*menu, *active);
        QCOMPARE(fixture.workspace.activeSegment(), 1);

        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu && !entryOf(*menu, "activateSegment")->isEnabled());
        const auto shown = [&fixture] {
            QList<bool> visible;
            for (const core::Segment& each : fixture.session().document().segments)
                visible += each.visible;
            return visible;
        };
        QCOMPARE(shown(), (QList<bool>{true, true, true}));
        QCOMPARE(entryOf(*menu, "isolateSegment")->text(), QStringLiteral("Show only 'Parts'"));
        choose(*menu, *entryOf(*menu, "isolateSegment"));
        fixture.settle();
        QCOMPARE(shown(), (QList<bool>{true, false, false}));
        // And back.
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QCOMPARE(entryOf(*menu, "isolateSegment")->text(), QStringLiteral("Show all segments"));
        choose(*menu, *entryOf(*menu, "isolateSegment"));
        fixture.settle();
        QCOMPARE(shown(), (QList<bool>{true, true, true}));

        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QCOMPARE(entryOf(*menu, "lockSegment")->text(), QStringLiteral("Lock 'Parts'"));
        choose(*menu, *entryOf(*menu, "lockSegment"));
        fixture.settle();
        QVERIFY(fixture.session().document().segment(1)->locked);
        menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        QCOMPARE(entryOf(*menu, "lockSegment")->text(), QStringLiteral("Unlock 'Parts'"));
        choose(*menu, *entryOf(*menu, "lockSegment"));
        fixture.settle();
        QVERIFY(!fixture.session().document().segment(1)->locked);
        // Where there is no segment, nothing of one is offered.
        menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        for (const char* name : {"activateSegment", "lockSegment", "isolateSegment"})
            QVERIFY(!entryOf(*menu, name));
        menu->close();
    }

    /// Only the step that changed this very voxel goes; the one after it stays.
    void undoesTheLastStepHere()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({10, 10, 10});
        QVERIFY(menu);
        choose(*menu, *entryOf(*menu, "undoHere"));
        fixture.settle();
        QCOMPARE(fixture.voxels(1), fixture.other);
        // Between the dabs nothing was done, and nothing is.
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        menu = fixture.clickedAt({20, 5, 10});
        QVERIFY(menu);
        choose(*menu, *entryOf(*menu, "undoHere"));
        fixture.settle();
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("There is no step to undo here"));
        QCOMPARE(fixture.voxels(1), fixture.other);
    }

    void goesThereAndCopies()
    {
        Dabs fixture;
        QMenu* menu = fixture.clickedAt({12, 10, 10});
        QVERIFY(menu);
        choose(*menu, *entryOf(*menu, "crosshairHere"));
        // The voxel's centre, wherever in it the click was.
        const glm::dvec3 away = fixture.workspace.crosshairLps() - fixture.placeOf({12, 10, 10});
        QVERIFY(glm::length(away) < 1e-9);

        menu = fixture.clickedAt({12, 10, 10});
        QVERIFY(menu);
        const QString offered = entryOf(*menu, "copyValue")->text();
        choose(*menu, *entryOf(*menu, "copyValue"));
        const QString value = QGuiApplication::clipboard()->text();
        QVERIFY(!value.isEmpty());
        QCOMPARE(offered, QStringLiteral("Copy value: %1").arg(value));
        menu = fixture.clickedAt({12, 10, 10});
        QVERIFY(menu);
        choose(*menu, *entryOf(*menu, "copyPlace"));
        const QString both = QGuiApplication::clipboard()->text();
        QVERIFY2(both.startsWith(value) && both.endsWith(QStringLiteral("voxel 12, 10, 10")),
            qPrintable(both));

        menu = fixture.clickedAt({12, 10, 10});
        QVERIFY(menu);
        auto* windows = menu->findChild<QMenu*>(QStringLiteral("windowPresets"));
        const auto presets = ui::windowPresets(*fixture.workspace.volume());
        QVERIFY(windows && presets.size() > 1);
        QCOMPARE(windows->actions().size(), qsizetype(presets.size()));
        choose(*menu, *windows->actions().at(1));
        QCOMPARE(fixture.workspace.windowLevel(), presets[1].window);
    }

    /// In the 3D view it is about what is seen there: here segments alone.
    void the3dViewRemovesWhatIsSeen_data()
    {
        QTest::addColumn<gpu::Context>("context");
        QTest::newRow("segments only") << gpu::Context::Hidden;
        QTest::newRow("volume cut away") << gpu::Context::CutAway;
        QTest::newRow("volume translucent") << gpu::Context::Translucent;
    }

    void the3dViewRemovesWhatIsSeen()
    {
        QFETCH(gpu::Context, context);
        Fixture fixture(test::smallHead::volume());
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.apply(test::ballMask(glm::ivec3(test::smallHead::side), 6.0));
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        display.context = context;
        fixture.workspace.setVolumeDisplay(display);
        const core::Segment ball = fixture.session().document().segments.front();
        QVERIFY(ball.voxels > 100);
        QMenu* menu = fixture.clicked(view, view.rect().center());
        QVERIFY(menu);
        QCOMPARE(menu->actions().front()->text(),
            QStringLiteral("Remove this island of '%1'").arg(ball.name));
        choose(*menu, *menu->actions().front());
        fixture.settle();
        QCOMPARE(fixture.voxels(ball.label), std::int64_t(0));
        // Nothing is seen there any more: it is about the view.
        menu = fixture.clicked(view, view.rect().center());
        QVERIFY(menu);
        QCOMPARE(menu->objectName(), QStringLiteral("viewMenu"));
        QVERIFY(entryOf(*menu, "resetThisView") && !entryOf(*menu, "crosshairHere"));
        menu->close();
    }
};

BURIN_WINDOW_TEST(VoxelMenuUiTest)

} // namespace voxelMenuUiTest

#include "VoxelMenuUiTest.moc"
