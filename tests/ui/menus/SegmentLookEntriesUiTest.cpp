// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentLookEntries.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/overlays/ColourBar.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QMenu>
#include <QSlider>
#include <QTest>

namespace segmentLookEntriesUiTest {

namespace {

using Drawing = ui::Workspace::SegmentDrawing;
using Look = ui::Workspace::SegmentLook;

class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        if (!session().apply(test::newSegment(QStringLiteral("Liver"))) || !session().settle())
            qFatal("no segment");
    }
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    [[nodiscard]] ui::SliceView& axial() { return window.views().axial(); }
    [[nodiscard]] ui::SliceView& coronal() { return window.views().coronal(); }
    [[nodiscard]] const gpu::SegmentDisplay& drawn(const ui::ImageView& view)
    {
        return frames.lastRequest(view.viewId()).segments;
    }
    /// How the axial slice draws segments, by its context menu; null: there is none.
    [[nodiscard]] QMenu* menuOfAxial()
    {
        QTest::mouseClick(&axial(), Qt::RightButton, {}, axial().rect().center());
        for (int round = 0; round < 5; ++round) {
            if (!session().settle())
                qFatal("not settled");
            session().poll();
        }
        QWidget* menu = QApplication::activePopupWidget();
        return menu ? menu->findChild<QMenu*>(QStringLiteral("segmentsOfView")) : nullptr;
    }
    [[nodiscard]] ui::SegmentLookButton& button(ui::SliceView& view)
    {
        return *view.findChild<ui::SegmentLookButton*>();
    }
    void setAll(Drawing drawing, int fillPercent)
    {
        ui::Workspace::ViewOptions options = workspace.viewOptions();
        options.segmentDrawing = drawing;
        options.segmentFillPercent = fillPercent;
        workspace.setViewOptions(options);
    }
    void setColours(gpu::ColourMap colours)
    {
        ui::Workspace::ViewOptions options = workspace.viewOptions();
        options.colours = colours;
        workspace.setViewOptions(options);
    }
};

QAction& entry(const QMenu& menu, const char* name)
{
    return *menu.findChild<QAction*>(QLatin1String(name));
}

/// Chooses an entry, as a click into the menu does, which closes all of it.
void choose(QAction& chosen)
{
    chosen.trigger();
    while (QWidget* open = QApplication::activePopupWidget())
        open->close();
}

} // namespace

class SegmentLookEntriesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void oneViewDrawsOutlines()
    {
        Fixture fixture;
        fixture.setAll(Drawing::FillAndOutline, 35);
        const std::size_t rows = fixture.session().history().rows().size();
        QVERIFY(!fixture.button(fixture.axial()).isVisible());
        QMenu* menu = fixture.menuOfAxial();
        QVERIFY(menu);
        QVERIFY(entry(*menu, "fillAndOutlineHere").isChecked());
        QVERIFY(!entry(*menu, "lookAsInAllViews").isEnabled());
        choose(entry(*menu, "outlineHere"));
        QCOMPARE(fixture.drawn(fixture.axial()).fillOpacity, 0.0f);
        QVERIFY(fixture.drawn(fixture.axial()).outlineWidthPixels > 0.0f);
        QCOMPARE(fixture.drawn(fixture.coronal()).fillOpacity, 0.35f);
        QVERIFY(fixture.button(fixture.axial()).isVisible());
        QCOMPARE(fixture.button(fixture.axial()).text(), QStringLiteral("Outline"));
        QVERIFY(!fixture.button(fixture.coronal()).isVisible());

        // What all views do is nothing to it, as far as it has its own way.
        fixture.setAll(Drawing::Fill, 80);
        QCOMPARE(fixture.drawn(fixture.coronal()).outlineWidthPixels, 0.0f);
        QCOMPARE(fixture.drawn(fixture.coronal()).fillOpacity, 0.8f);
        QCOMPARE(fixture.drawn(fixture.axial()).fillOpacity, 0.0f);
        QVERIFY(fixture.drawn(fixture.axial()).outlineWidthPixels > 0.0f);

        menu = fixture.menuOfAxial();
        QVERIFY(menu);
        QVERIFY(entry(*menu, "outlineHere").isChecked());
        QVERIFY(!menu->findChild<QSlider*>()->isEnabled()); // there is no fill
        choose(entry(*menu, "fillAndOutlineHere"));
        QCOMPARE(fixture.drawn(fixture.axial()).fillOpacity, 0.8f);
        QVERIFY(fixture.drawn(fixture.axial()).outlineWidthPixels > 0.0f);
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void theSliderFillsThisViewOnly()
    {
        Fixture fixture;
        fixture.setAll(Drawing::FillAndOutline, 35);
        QMenu* menu = fixture.menuOfAxial();
        QVERIFY(menu);
        auto* slider = menu->findChild<QSlider*>(QStringLiteral("fillPercentHere"));
        QVERIFY(slider && slider->isEnabled());
        QCOMPARE(slider->value(), 35);
        slider->setValue(60);
        QCOMPARE(fixture.drawn(fixture.axial()).fillOpacity, 0.6f);
        QCOMPARE(fixture.drawn(fixture.coronal()).fillOpacity, 0.35f);
        QVERIFY(fixture.axial().segmentLook() == (Look{.fillPercent = 60}));
        QCOMPARE(fixture.button(fixture.axial()).text(), QStringLiteral("Fill and outline, 60 %"));
        QVERIFY(entry(*menu, "lookAsInAllViews").isEnabled());
        choose(entry(*menu, "lookAsInAllViews"));
        QCOMPARE(fixture.drawn(fixture.axial()).fillOpacity, 0.35f);
        QVERIFY(!fixture.button(fixture.axial()).isVisible());
        // None is lost from sight.
        fixture.axial().setSegmentLook({.fillPercent = -3});
        QCOMPARE(*fixture.axial().segmentLook().fillPercent, ui::Workspace::leastSegmentFill);
    }

    void theButtonHasTheSameMenu()
    {
        Fixture fixture;
        fixture.setAll(Drawing::FillAndOutline, 35);
        fixture.coronal().setSegmentLook({.drawing = Drawing::Fill});
        ui::SegmentLookButton& button = fixture.button(fixture.coronal());
        QVERIFY(button.isVisible());
        QVERIFY(fixture.coronal().rect().contains(button.geometry()));
        // Scale bar, slice number and the bar of colours with its numbers are beside it.
        const QRect view = fixture.coronal().rect();
        constexpr QSize corner(126, 56);
        QVERIFY(!button.geometry().intersects(
            QRect(view.bottomRight() - QPoint(corner.width(), corner.height()), corner)));
        fixture.setColours(gpu::ColourMap::HotIron);
        constexpr int numbers = 60;
        QVERIFY(fixture.coronal().rect().contains(button.geometry()));
        QVERIFY(
            !button.geometry().intersects(ui::colourBarPlace(view).adjusted(-numbers, 0, 0, 0)));
        fixture.setColours(gpu::ColourMap::Grey);
        QTest::mouseClick(&button, Qt::LeftButton);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        QCOMPARE(menu->objectName(), QStringLiteral("segmentLookMenu"));
        QVERIFY(entry(*menu, "fillHere").isChecked());
        choose(entry(*menu, "lookAsInAllViews"));
        QVERIFY(fixture.coronal().segmentLook().isUsual());
        QVERIFY(!button.isVisible());
        // It keeps its corner when the view becomes larger.
        fixture.coronal().setSegmentLook({.drawing = Drawing::Outline});
        fixture.window.views().maximise(&fixture.coronal());
        QTRY_VERIFY(button.geometry().right() > fixture.coronal().width() - 60);
        QVERIFY(fixture.coronal().rect().contains(button.geometry()));
    }

    void anotherStudyIsDrawnAsAll()
    {
        Fixture fixture;
        fixture.axial().setSegmentLook({.drawing = Drawing::Outline, .fillPercent = 50});
        fixture.workspace.setSession(nullptr);
        QVERIFY(fixture.axial().segmentLook().isUsual());
        QVERIFY(!fixture.button(fixture.axial()).isVisible());
    }
};

BURIN_WINDOW_TEST(SegmentLookEntriesUiTest)

} // namespace segmentLookEntriesUiTest

#include "SegmentLookEntriesUiTest.moc"
