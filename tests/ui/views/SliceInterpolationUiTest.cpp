// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/menus/InterpolationEntries.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QMenu>
#include <QMenuBar>
#include <QTest>

#include <algorithm>

namespace sliceInterpolationUiTest {

using gpu::Interpolation;

namespace {

QAction& action(test::WindowFixture& fixture, const ui::InterpolationEntry& entry)
{
    return fixture.window.actionTable()[QLatin1String(entry.id)];
}

const ui::InterpolationEntry& entryOf(std::optional<Interpolation> interpolation)
{
    const auto& entries = ui::interpolationEntries();
    return *std::find_if(entries.begin(), entries.end(),
        [&](const ui::InterpolationEntry& each) { return each.interpolation == interpolation; });
}

Interpolation requested(const test::WindowFixture& fixture, const ui::SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene).interpolation;
}

const gpu::VolumeScene& stage(const test::WindowFixture& fixture)
{
    return std::get<gpu::VolumeScene>(
        fixture.frames.lastRequest(fixture.window.views().volume().viewId()).scene);
}

void showPlane(test::WindowFixture& fixture)
{
    ui::CuttingPlane::Look look = fixture.workspace.plane().look();
    look.shown = true;
    fixture.workspace.plane().setLook(look);
}

/// The entries of a submenu of the View menu.
QList<QAction*> entriesIn(const test::WindowFixture& fixture, const QString& submenu)
{
    const auto named = [](const QList<QAction*>& entries, const QString& name) -> QMenu* {
        for (QAction* each : entries) {
            if (each->menu() && each->text().remove(QLatin1Char('&')) == name)
                return each->menu();
        }
        return nullptr;
    };
    const QMenu* view =
        named(fixture.window.findChild<QMenuBar*>()->actions(), QStringLiteral("View"));
    const QMenu* found = view ? named(view->actions(), submenu) : nullptr;
    return found ? found->actions() : QList<QAction*>();
}

} // namespace

class SliceInterpolationUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oneWayAtATimeForAllViews();
    void theMenusOfferThem();
    void obliqueSlicesTakeIt();
    void whatMovesIsAskedFor();
    void theLensTakesIt();
    void anotherStudyKeepsIt();
};

void SliceInterpolationUiTest::oneWayAtATimeForAllViews()
{
    test::WindowFixture fixture(test::headFirstSupine());
    const ui::ViewGrid& views = fixture.window.views();
    showPlane(fixture);
    fixture.window.views().arrange(ui::ViewGrid::Layout::PenAndStage);
    QTRY_VERIFY(views.plane().isVisible());
    QVERIFY(action(fixture, entryOf(std::nullopt)).isChecked());
    for (const ui::InterpolationEntry& each : ui::interpolationEntries()) {
        action(fixture, each).trigger();
        for (const ui::SliceView* view : {&views.axial(), &views.sagittal(), &views.coronal()})
            QVERIFY(std::get<gpu::SliceScene>(view->context().scene).interpolation
                == each.interpolation.value_or(Interpolation::Linear));
        const Interpolation ofPlane = each.interpolation.value_or(Interpolation::Cubic);
        QVERIFY(requested(fixture, views.plane()) == ofPlane);
        QVERIFY(stage(fixture).plane.has_value());
        QVERIFY(stage(fixture).plane->interpolation == ofPlane);
        int checked = 0;
        for (const ui::InterpolationEntry& other : ui::interpolationEntries())
            checked += action(fixture, other).isChecked() ? 1 : 0;
        QCOMPARE(checked, 1);
        QVERIFY(action(fixture, each).isChecked());
    }
    // The one that is on stays on.
    action(fixture, entryOf(Interpolation::Cubic)).trigger();
    QVERIFY(action(fixture, entryOf(Interpolation::Cubic)).isChecked());
}

void SliceInterpolationUiTest::theMenusOfferThem()
{
    test::WindowFixture fixture(test::headFirstSupine());
    QList<QAction*> inView = entriesIn(fixture, QStringLiteral("Interpolation"));
    inView.removeIf([](const QAction* each) { return each->isSeparator(); });
    QCOMPARE(std::size_t(inView.size()), ui::interpolationEntries().size());
    for (std::size_t i = 0; i < ui::interpolationEntries().size(); ++i)
        QCOMPARE(inView[qsizetype(i)], &action(fixture, ui::interpolationEntries()[i]));

    action(fixture, entryOf(Interpolation::Nearest)).trigger();
    QMenu menu;
    ui::addInterpolations(menu, fixture.workspace);
    auto* ways = menu.findChild<QMenu*>(QStringLiteral("interpolationOfSlices"));
    QVERIFY(ways);
    QList<QAction*> entries = ways->actions();
    entries.removeIf([](const QAction* each) { return each->isSeparator(); });
    QCOMPARE(std::size_t(entries.size()), ui::interpolationEntries().size());
    for (const QAction* each : entries)
        QCOMPARE(each->isChecked(), each->text() == entryOf(Interpolation::Nearest).text);
    entries.back()->trigger();
    QVERIFY(fixture.workspace.viewOptions().interpolation == Interpolation::Cubic);
    QVERIFY(requested(fixture, fixture.window.views().axial()) == Interpolation::Cubic);
    entries.front()->trigger();
    QVERIFY(!fixture.workspace.viewOptions().interpolation);
    QVERIFY(requested(fixture, fixture.window.views().axial()) == Interpolation::Linear);
}

/// Turned slices, and slabs, are no exception.
void SliceInterpolationUiTest::obliqueSlicesTakeIt()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& views = fixture.window.views();
    action(fixture, entryOf(Interpolation::Nearest)).trigger();
    views.planes().turnOthers(ui::SliceOrientation::Axial, 0.4);
    QVERIFY(requested(fixture, views.coronal()) == Interpolation::Nearest);
    fixture.window.actionTable()[QStringLiteral("view.slabMip")].trigger();
    QVERIFY(requested(fixture, views.coronal()) == Interpolation::Nearest);
    QVERIFY(requested(fixture, views.axial()) == Interpolation::Nearest);
}

/// Cubics wait until nothing moves: the request says that something does, and is made anew.
void SliceInterpolationUiTest::whatMovesIsAskedFor()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::SliceView& axial = fixture.window.views().axial();
    const auto moves = [&] { return fixture.frames.lastRequest(axial.viewId()).interacting; };
    axial.goToSlice(axial.sliceNumber() + 1);
    QVERIFY(!moves()); // linear pictures are final at once
    action(fixture, entryOf(Interpolation::Cubic)).trigger();
    QVERIFY(!moves());
    for (int step = 0; step < 3; ++step) {
        axial.goToSlice(axial.sliceNumber() + 1);
        QVERIFY(moves());
        QVERIFY(requested(fixture, axial) == Interpolation::Cubic);
    }
    QTRY_VERIFY(!moves());
    QVERIFY(requested(fixture, axial) == Interpolation::Cubic);
    // A slab is never cubic.
    fixture.window.actionTable()[QStringLiteral("view.slabMean")].trigger();
    axial.goToSlice(axial.sliceNumber() + 1);
    QVERIFY(!moves());
}

void SliceInterpolationUiTest::theLensTakesIt()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::SliceView& axial = fixture.window.views().axial();
    action(fixture, entryOf(Interpolation::Nearest)).trigger();
    test::WindowFixture::hover(axial, fixture.pixel(axial, {20, 20, 20}));
    QTest::keyPress(&axial, Qt::Key_Z);
    QVERIFY(axial.showsLens());
    QVERIFY(std::get<gpu::SliceScene>(
                fixture.frames.lastRequest(ui::Lens::nameOver(axial.viewId())).scene)
                .interpolation
        == Interpolation::Nearest);
    QTest::keyRelease(&axial, Qt::Key_Z);
}

void SliceInterpolationUiTest::anotherStudyKeepsIt()
{
    test::WindowFixture fixture(test::headFirstSupine());
    action(fixture, entryOf(Interpolation::Nearest)).trigger();
    reference::ReferenceEngine other;
    auto session = core::EditSession::create(other, test::plainCt(test::oblique()), {});
    QVERIFY(session);
    fixture.workspace.setSession(std::move(*session));
    QVERIFY(action(fixture, entryOf(Interpolation::Nearest)).isChecked());
    QVERIFY(requested(fixture, fixture.window.views().axial()) == Interpolation::Nearest);
    fixture.workspace.setSession(nullptr); // before the engine goes
}

BURIN_WINDOW_TEST(SliceInterpolationUiTest)

} // namespace sliceInterpolationUiTest

#include "SliceInterpolationUiTest.moc"
