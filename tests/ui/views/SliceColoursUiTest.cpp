// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/menus/ColourMapEntries.h"
#include "ui/overlays/ColourBar.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QCoreApplication>
#include <QMenu>
#include <QTest>

namespace sliceColoursUiTest {

using gpu::ColourMap;

namespace {

/// With the picture that was requested last.
QImage seen(ui::ImageView& view)
{
    QCoreApplication::processEvents();
    return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

QAction& action(test::WindowFixture& fixture, ColourMap map)
{
    return fixture.window.actionTable()[QLatin1String(ui::colourMapEntries()[std::size_t(map)].id)];
}

ColourMap requested(const test::WindowFixture& fixture, const ui::SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene).colours;
}

const gpu::VolumeScene& stage(const test::WindowFixture& fixture)
{
    return std::get<gpu::VolumeScene>(
        fixture.frames.lastRequest(fixture.window.views().volume().viewId()).scene);
}

QRgb entry(ColourMap map, std::size_t grey)
{
    return 0xFF000000U | gpu::entriesOf(map)[grey];
}

} // namespace

class SliceColoursUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oneMapAtATimeForAllSlices();
    void mipAndPlaneTakeThem();
    void theContextMenuOffersThem();
    void aBarSaysWhichColourIsWhichValue();
    void theBarKeepsBelowTheLetter();
    void aLowViewHasNoBar();
    void anotherStudyIsGrey();
};

void SliceColoursUiTest::oneMapAtATimeForAllSlices()
{
    test::WindowFixture fixture(test::headFirstSupine());
    const ui::ViewGrid& views = fixture.window.views();
    QVERIFY(action(fixture, ColourMap::Grey).isChecked());
    for (const ui::ColourMapEntry& each : ui::colourMapEntries()) {
        action(fixture, each.map).trigger();
        for (const ui::SliceView* view : {&views.axial(), &views.sagittal(), &views.coronal()})
            QVERIFY(requested(fixture, *view) == each.map);
        int checked = 0;
        for (const ui::ColourMapEntry& other : ui::colourMapEntries())
            checked += action(fixture, other.map).isChecked() ? 1 : 0;
        QCOMPARE(checked, 1);
        QVERIFY(action(fixture, each.map).isChecked());
    }
    // The one that is on stays on.
    action(fixture, ColourMap::EvenLightness).trigger();
    QVERIFY(action(fixture, ColourMap::EvenLightness).isChecked());
    QVERIFY(requested(fixture, views.axial()) == ColourMap::EvenLightness);
    // Inverting goes before, and is a switch of its own.
    fixture.window.actionTable()[QStringLiteral("view.inverted")].trigger();
    const auto& scene =
        std::get<gpu::SliceScene>(fixture.frames.lastRequest(views.axial().viewId()).scene);
    QVERIFY(scene.inverted && scene.colours == ColourMap::EvenLightness);
}

void SliceColoursUiTest::mipAndPlaneTakeThem()
{
    test::WindowFixture fixture(test::headFirstSupine());
    action(fixture, ColourMap::HotIron).trigger();
    QVERIFY(stage(fixture).mipColours == ColourMap::Grey);
    fixture.window.actionTable()[QStringLiteral("view.mip")].trigger();
    QVERIFY(stage(fixture).mipColours == ColourMap::HotIron);
    fixture.window.actionTable()[QStringLiteral("view.xray")].trigger();
    QVERIFY(stage(fixture).mipColours == ColourMap::Grey);
    ui::CuttingPlane::Look look = fixture.workspace.plane().look();
    look.shown = true;
    fixture.workspace.plane().setLook(look);
    QVERIFY(stage(fixture).plane.has_value());
    QVERIFY(stage(fixture).plane->colours == ColourMap::HotIron);
}

void SliceColoursUiTest::theContextMenuOffersThem()
{
    test::WindowFixture fixture(test::headFirstSupine());
    action(fixture, ColourMap::HotMetalBlue).trigger();
    QMenu menu;
    ui::addColourMaps(menu, fixture.workspace);
    auto* colours = menu.findChild<QMenu*>(QStringLiteral("coloursOfSlices"));
    QVERIFY(colours);
    const QList<QAction*> entries = colours->actions();
    QCOMPARE(std::size_t(entries.size()), gpu::colourMaps);
    for (const QAction* each : entries)
        QCOMPARE(each->isChecked(), each->text() == QStringLiteral("Hot metal blue"));
    entries[1]->trigger();
    QVERIFY(fixture.workspace.viewOptions().colours == ColourMap::HotIron);
    QVERIFY(requested(fixture, fixture.window.views().axial()) == ColourMap::HotIron);
}

void SliceColoursUiTest::aBarSaysWhichColourIsWhichValue()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::SliceView& axial = fixture.window.views().axial();
    const QRect place = ui::colourBarPlace(axial.rect());
    QVERIFY(!place.isEmpty());
    const QPoint top(place.center().x(), place.top());
    const QPoint bottom(place.center().x(), place.bottom());
    const QImage before = seen(axial);
    for (const ColourMap map : {ColourMap::HotIron, ColourMap::Pet20Step}) {
        action(fixture, map).trigger();
        const QImage image = seen(axial);
        QCOMPARE(image.pixel(top), entry(map, 255));
        QCOMPARE(image.pixel(bottom), entry(map, 0));
        // In between, as many colours as the table has there.
        const QPoint middle(top.x(), place.top() + place.height() / 2);
        const std::size_t up =
            std::size_t((place.bottom() - middle.y()) * 255 / (place.height() - 1));
        QCOMPARE(image.pixel(middle), entry(map, up));
    }
    fixture.window.actionTable()[QStringLiteral("view.inverted")].trigger();
    const QImage inverted = seen(axial);
    QCOMPARE(inverted.pixel(top), entry(ColourMap::Pet20Step, 0));
    QCOMPARE(inverted.pixel(bottom), entry(ColourMap::Pet20Step, 255));
    fixture.window.actionTable()[QStringLiteral("view.inverted")].trigger();
    // Without colours the view is as it was.
    action(fixture, ColourMap::Grey).trigger();
    QCOMPARE(seen(axial), before);
}

/// Which goes down where something covers the top of the view.
void SliceColoursUiTest::theBarKeepsBelowTheLetter()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::SliceView& axial = fixture.window.views().axial();
    action(fixture, ColourMap::HotIron).trigger();
    for (const int covered : {0, 40}) {
        axial.setCoveredTop(covered);
        const QRect place = ui::colourBarPlace(axial.rect().adjusted(0, covered, 0, 0));
        QVERIFY(!place.isEmpty());
        const QImage image = seen(axial);
        QCOMPARE(image.pixel(place.center().x(), place.top()), entry(ColourMap::HotIron, 255));
        QCOMPARE(image.pixel(place.center().x(), place.bottom()), entry(ColourMap::HotIron, 0));
    }
}

void SliceColoursUiTest::aLowViewHasNoBar()
{
    QVERIFY(ui::colourBarPlace(QRect(0, 0, 160, 120)).isEmpty());
    const QRect view(0, 0, 900, 900);
    QVERIFY(view.contains(ui::colourBarPlace(view)));
    QVERIFY(ui::colourBarPlace(view).height() <= 160);
}

void SliceColoursUiTest::anotherStudyIsGrey()
{
    test::WindowFixture fixture(test::headFirstSupine());
    action(fixture, ColourMap::HotIron).trigger();
    reference::ReferenceEngine other;
    auto session = core::EditSession::create(other, test::plainCt(test::oblique()), {});
    QVERIFY(session);
    fixture.workspace.setSession(std::move(*session));
    QVERIFY(fixture.workspace.viewOptions().colours == ColourMap::Grey);
    QVERIFY(action(fixture, ColourMap::Grey).isChecked());
    fixture.workspace.setSession(nullptr); // before the engine goes
}

BURIN_WINDOW_TEST(SliceColoursUiTest)

} // namespace sliceColoursUiTest

#include "SliceColoursUiTest.moc"
