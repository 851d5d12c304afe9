// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/CutTexts.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/frame/PanelColumn.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/ClippingPanel.h"
#include "ui/panels/VolumePanel.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/panels/lists/LayersPanel.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/views/ViewGrid.h"

#include <QGuiApplication>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

#include <initializer_list>

namespace panelsUiTest {

namespace {

/// The window with the panels that the program has.
struct PanelsFixture : test::WindowFixture {
    explicit PanelsFixture(const QSize& size)
        : WindowFixture(test::headFirstSupine(), size)
    {
        for (ui::Panel* panel : std::initializer_list<ui::Panel*>{new ui::SegmentsPanel(workspace),
                 new ui::GrowthPanel(workspace), new ui::HistoryPanel(workspace),
                 new ui::LayersPanel(workspace), new ui::VolumePanel(workspace),
                 new ui::ClippingPanel(workspace, window.views().volume())})
            window.addPanel(panel);
        window.showPanels(true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
    }
    [[nodiscard]] ui::PanelSection& section(const char* id)
    {
        auto* found = window.findChild<ui::PanelSection*>(QLatin1String(id));
        if (!found)
            qFatal("no panel %s", id);
        return *found;
    }
    [[nodiscard]] ui::PanelColumn& column() { return *window.findChild<ui::PanelColumn*>(); }
    void trigger(const char* action) { window.actionTable()[QLatin1String(action)].trigger(); }
    [[nodiscard]] bool isChecked(const char* action)
    {
        return window.actionTable()[QLatin1String(action)].isChecked();
    }
    void clickPlace(const char* id)
    {
        auto* button = section(id).findChild<QToolButton*>(QStringLiteral("floatPanel"));
        QTest::mouseClick(button, Qt::LeftButton);
        QCoreApplication::sendPostedEvents();
    }
    /// Top to bottom.
    [[nodiscard]] QStringList docked()
    {
        QMap<int, QString> byHeight;
        for (const auto* each : window.findChildren<ui::PanelSection*>()) {
            if (!each->isFloating() && each->isVisible())
                byHeight.insert(each->y(), each->id());
        }
        return byHeight.values();
    }
};

QStringList ids(std::initializer_list<const char*> names)
{
    QStringList list;
    for (const char* name : names)
        list += QLatin1String(name);
    return list;
}

} // namespace

class PanelsUiTest : public QObject {
    Q_OBJECT

private:
    test::OwnSettings m_settings;

private Q_SLOTS:
    void init() { m_settings.clear(); }

    void picturesTakeThreeQuarters()
    {
        PanelsFixture fixture(QSize(1920, 1080));
        QCOMPARE(fixture.window.size(), QSize(1920, 1080));
        double area = 0.0;
        for (const ui::ImageView* view : fixture.window.views().views())
            area += double(view->width()) * view->height();
        const double share = area / (1920.0 * 1080.0);
        QVERIFY2(share >= 0.75, qPrintable(QString::number(share)));
    }

    void nothingIsClippedInALowWindow()
    {
        PanelsFixture fixture(QSize(1280, 720));
        QCOMPARE(fixture.window.size(), QSize(1280, 720));
        QTRY_COMPARE(test::cutTexts(fixture.window), QStringList());
    }

    void theHistoryKeepsItsRowsInALowWindow()
    {
        PanelsFixture fixture(QSize(1280, 720));
        core::EditSession& session = *fixture.workspace.session();
        for (const char* name : {"Left ventricle with its papillary muscles", "Skull"})
            QVERIFY(session.apply(test::newSegment(QLatin1String(name), 0x4a9bff)));
        for (int place = 1; place < 4; ++place)
            QVERIFY(session.apply(
                test::renameSegment(1, QStringLiteral("Left ventricle, version %1").arg(place))));
        QVERIFY(session.settle());
        QCoreApplication::sendPostedEvents();
        QCOMPARE(fixture.window.size(), QSize(1280, 720));
        QTRY_COMPARE(test::cutTexts(fixture.window), QStringList());
        const auto* list = fixture.window.findChild<QListView*>(QStringLiteral("historyList"));
        QVERIFY2(list->height() >= 3 * list->sizeHintForRow(0),
            qPrintable(QString::number(list->height())));
        // Where there is room, the timeline is there.
        fixture.window.resize(1280, 1000);
        const auto* timeline =
            fixture.window.findChild<QWidget*>(QStringLiteral("historyTimeline"));
        QTRY_VERIFY(timeline->isVisible());
    }

    /// Lists that are folded stretch no more than other panels that are.
    void foldedPanelsTakeNoRoom()
    {
        PanelsFixture fixture(QSize(1280, 1000));
        const auto sections = fixture.column().findChildren<ui::PanelSection*>();
        QVERIFY(sections.size() > 5);
        for (ui::PanelSection* section : sections)
            section->setFolded(true);
        for (const ui::PanelSection* section : sections)
            QTRY_COMPARE(section->height(), section->sizeHint().height());
    }

    /// With more than fits the column scrolls, and its bar takes nothing from the panels.
    void panelsKeepTheirWidthWhenTheyScroll()
    {
        PanelsFixture fixture(QSize(1280, 720));
        for (const char* name : {"One", "Two", "Three", "Four", "Five"})
            QVERIFY(fixture.workspace.session()->apply(
                test::newSegment(QLatin1String(name), 0x4a9bff)));
        QVERIFY(fixture.workspace.session()->settle());
        fixture.trigger("view.dvr");
        QCoreApplication::sendPostedEvents();
        QTRY_VERIFY(fixture.column().verticalScrollBar()->isVisible());
        QCOMPARE(fixture.window.size(), QSize(1280, 720));
        QVERIFY(fixture.column().widget()->width() <= fixture.column().viewport()->width());
        QTRY_COMPARE(test::cutTexts(fixture.window), QStringList());
    }

    void panelsLeaveAndComeBack()
    {
        PanelsFixture fixture(QSize(1200, 800));
        const QStringList all = ids({"SegmentsPanel", "GrowthPanel", "HistoryPanel", "LayersPanel",
            "VolumePanel", "ClippingPanel"});
        QCOMPARE(fixture.docked(), all);
        fixture.clickPlace("GrowthPanel");
        ui::PanelSection& growth = fixture.section("GrowthPanel");
        QVERIFY(growth.isFloating());
        QVERIFY(growth.isVisible());
        QCOMPARE(growth.windowTitle(), QStringLiteral("Growth"));
        QVERIFY(fixture.window.findChild<QPushButton*>(QStringLiteral("growPlay"))->isVisible());
        QCOMPARE(fixture.docked(),
            ids({"SegmentsPanel", "HistoryPanel", "LayersPanel", "VolumePanel", "ClippingPanel"}));
        // Its own button, or closing its window.
        fixture.clickPlace("GrowthPanel");
        QVERIFY(!growth.isFloating());
        QCOMPARE(fixture.docked(), all);
        fixture.clickPlace("GrowthPanel");
        growth.close();
        QTRY_VERIFY(!growth.isFloating());
        QVERIFY(growth.isVisible());
        QTRY_COMPARE(fixture.docked(), all);
    }

    void aDragOfTheHeaderTakesItOut()
    {
        PanelsFixture fixture(QSize(1200, 800));
        ui::PanelSection& history = fixture.section("HistoryPanel");
        QWidget* header = history.findChild<QFrame*>(QString(), Qt::FindDirectChildrenOnly);
        QTest::mousePress(header, Qt::LeftButton, {}, QPoint(80, 15));
        QTest::mouseMove(header, QPoint(10, 15));
        QTest::mouseMove(header, QPoint(-60, 15));
        QTest::mouseRelease(header, Qt::LeftButton, {}, QPoint(-60, 15));
        QVERIFY(history.isFloating());
        QVERIFY(!history.isFolded());
        // A click only folds.
        QTest::mouseClick(header, Qt::LeftButton, {}, QPoint(80, 15));
        QVERIFY(history.isFloating());
        QVERIFY(history.isFolded());
    }

    void theColumnGivesItsRoomWhenEmpty()
    {
        PanelsFixture fixture(QSize(1200, 800));
        const int narrow = fixture.window.views().width();
        for (const char* id : {"SegmentsPanel", "GrowthPanel", "HistoryPanel", "LayersPanel",
                 "VolumePanel", "ClippingPanel"})
            fixture.clickPlace(id);
        QVERIFY(!fixture.column().isVisible());
        QVERIFY(fixture.window.views().width() >= narrow + ui::PanelSection::leastWidth);
        // One key hides and shows them, wherever they are; so does closing the study.
        ui::PanelSection& growth = fixture.section("GrowthPanel");
        fixture.trigger("view.panels");
        QVERIFY(!growth.isVisible());
        fixture.trigger("view.panels");
        QVERIFY(growth.isVisible());
        fixture.trigger("view.resetPanels");
        QCOMPARE(fixture.docked().size(), 6);
        QTRY_COMPARE(fixture.window.views().width(), narrow);
        fixture.clickPlace("GrowthPanel");
        fixture.window.closeStudy();
        QVERIFY(!growth.isVisible());
    }

    void theMenuListsThem()
    {
        PanelsFixture fixture(QSize(1200, 800));
        QStringList names;
        for (const QMenu* menu : fixture.window.findChildren<QMenu*>()) {
            if (menu->title() != QStringLiteral("Panels"))
                continue;
            for (const QAction* action : menu->actions())
                names += action->text();
        }
        for (const char* name : {"Segments", "Growth", "History", "Sculpt layers", "Volume"})
            QVERIFY2(names.contains(QLatin1String(name)), name);
        QVERIFY(fixture.isChecked("panel.VolumePanel"));
        fixture.trigger("panel.VolumePanel");
        QVERIFY(!fixture.isChecked("panel.VolumePanel"));
        QVERIFY(!fixture.section("VolumePanel").isVisible());
        fixture.trigger("panel.VolumePanel");
        QVERIFY(fixture.section("VolumePanel").isVisible());
    }

    /// Before anything is kept, the window is no larger than the screen, with its title bar.
    void aFirstWindowFitsTheScreen()
    {
        const QSize room = QGuiApplication::primaryScreen()->availableSize();
        PanelsFixture fixture(room + QSize(200, 200));
        QVERIFY(fixture.window.width() > room.width() && fixture.window.height() > room.height());
        fixture.window.restoreLayout();
        QTRY_VERIFY(
            fixture.window.width() <= room.width() && fixture.window.height() < room.height());
    }

    void theLayoutComesBack()
    {
        int width = 0;
        {
            PanelsFixture fixture(QSize(1200, 800));
            fixture.window.restoreLayout(); // nothing kept yet: all in the column
            QCOMPARE(fixture.docked().size(), 6);
            fixture.clickPlace("HistoryPanel");
            // What the window system tells of its first size must not come after the second.
            QVERIFY(QTest::qWaitForWindowExposed(&fixture.section("HistoryPanel")));
            fixture.section("HistoryPanel").resize(333, 222);
            fixture.section("GrowthPanel").setFolded(true);
            QVERIFY(fixture.section("LayersPanel").isFolded());
            fixture.section("LayersPanel").setFolded(false);
            fixture.trigger("panel.VolumePanel");
            fixture.window.resize(1111, 777);
            QGuiApplication::sync();
            QCOMPARE(fixture.window.size(), QSize(1111, 777));
            width = fixture.column().width();
            fixture.window.close();
        }
        PanelsFixture fixture(QSize(1200, 800));
        QCOMPARE(fixture.docked().size(), 6);
        fixture.window.restoreLayout();
        QVERIFY(QTest::qWaitForWindowExposed(&fixture.section("HistoryPanel")));
        QTRY_COMPARE(fixture.window.size(), QSize(1111, 777));
        QVERIFY(fixture.section("HistoryPanel").isFloating());
        QVERIFY(fixture.section("HistoryPanel").isVisible());
        QTRY_COMPARE(fixture.section("HistoryPanel").size(), QSize(333, 222));
        QVERIFY(fixture.section("GrowthPanel").isFolded());
        QVERIFY(!fixture.section("LayersPanel").isFolded());
        QCOMPARE(fixture.docked(),
            ids({"SegmentsPanel", "GrowthPanel", "LayersPanel", "ClippingPanel"}));
        QTRY_COMPARE(fixture.column().width(), width);
    }
};

BURIN_WINDOW_TEST(PanelsUiTest)

} // namespace panelsUiTest

#include "PanelsUiTest.moc"
