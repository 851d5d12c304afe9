// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentOpacity.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/models/SegmentListModel.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/SegmentActions.h"

#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <functional>

namespace segmentOpacityUiTest {

namespace {

/// The window with two segments in the list.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        window.addPanel(new ui::SegmentsPanel(workspace));
        window.showPanels(true);
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qFatal("the window does not become active");
        list = window.findChild<QListView*>(QStringLiteral("segmentList"));
        for (const char* name : {"S1", "S2"}) {
            if (!workspace.session()->apply(test::newSegment(QLatin1String(name))))
                qFatal("no segment");
        }
        if (!workspace.session()->settle())
            qFatal("not settled");
    }
    [[nodiscard]] QModelIndex row(int number) const { return list->model()->index(number, 0); }
    /// Opens the menu of the second segment, and closes it again.
    /// @return whether there was a slider
    bool withSlider(const std::function<void(QSlider&)>& use)
    {
        bool used = false;
        QTimer::singleShot(0, &window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            if (auto* slider = menu->findChild<QSlider*>(QStringLiteral("segmentOpacity"))) {
                use(*slider);
                used = true;
            }
            menu->close();
        });
        Q_EMIT list->customContextMenuRequested(list->visualRect(row(1)).center());
        return used;
    }
    [[nodiscard]] int transparency(const ui::ImageView& view, int label)
    {
        return frames.lastRequest(view.viewId()).segments.transparencyPercent[std::size_t(label)];
    }

    QListView* list = nullptr;
};

} // namespace

class SegmentOpacityUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void keysAndWheelMoveIt()
    {
        Fixture fixture;
        ui::ViewGrid& views = fixture.window.views();
        const std::size_t rows = fixture.workspace.session()->history().rows().size();
        int percent = 100;
        QVERIFY(fixture.withSlider([&](QSlider& slider) {
            QCOMPARE(slider.value(), 100);
            QTest::keyClick(&slider, Qt::Key_Left);
            QCOMPARE(slider.value(), 95);
            const QPointF at(slider.rect().center());
            QWheelEvent turned(at, slider.mapToGlobal(at), {}, {0, -120}, Qt::NoButton,
                Qt::NoModifier, Qt::NoScrollPhase, false);
            // As one that a mouse sends: only such a one goes on to what the slider stands in.
            QSpontaneKeyEvent::setSpontaneous(&turned);
            qApp->notify(&slider, &turned);
            percent = slider.value();
            QVERIFY(percent < 95);
            // The views follow while the menu is open.
            QTRY_COMPARE(fixture.transparency(views.axial(), 2), 100 - percent);
            QTRY_COMPARE(fixture.transparency(views.volume(), 2), 100 - percent);
        }));
        QCOMPARE(fixture.workspace.segmentOpacity(2), percent);
        QCOMPARE(fixture.workspace.segmentOpacity(1), 100);
        QCOMPARE(fixture.transparency(views.axial(), 1), 0);
        QCOMPARE(fixture.workspace.session()->history().rows().size(), rows);
        const QString told = QStringLiteral("opacity %1 %").arg(percent);
        QVERIFY(fixture.row(1).data(Qt::ToolTipRole).toString().contains(told));
        QVERIFY(fixture.row(1).data(Qt::AccessibleTextRole).toString().endsWith(told));
        QVERIFY(
            !fixture.row(0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("opacity")));
    }

    void itBeginsWhereItWasLeft()
    {
        Fixture fixture;
        fixture.workspace.setSegmentOpacity(2, 60);
        QVERIFY(fixture.withSlider([](QSlider& slider) {
            QCOMPARE(slider.value(), 60);
            // None is lost from sight.
            QTest::keyClick(&slider, Qt::Key_Home);
            QCOMPARE(slider.value(), ui::Workspace::leastSegmentOpacity);
        }));
        QCOMPARE(fixture.workspace.segmentOpacity(2), ui::Workspace::leastSegmentOpacity);
        QVERIFY(fixture.withSlider([](QSlider& slider) { QTest::keyClick(&slider, Qt::Key_End); }));
        QVERIFY(fixture.workspace.segmentOpacities().empty());
    }

    void onlySegmentsHaveOne()
    {
        Fixture fixture;
        fixture.workspace.setSegmentOpacities({{-3, 50}, {0, 50}, {256, 50}, {1, 100}, {2, -7}});
        QCOMPARE(fixture.workspace.segmentOpacities(),
            (std::map<int, int>{{2, ui::Workspace::leastSegmentOpacity}}));
    }

    void aNewSegmentHasNotThatOfOneUndone()
    {
        Fixture fixture;
        ui::ViewGrid& views = fixture.window.views();
        core::EditSession& session = *fixture.workspace.session();
        fixture.workspace.setSegmentOpacities({{1, 30}, {2, 40}});
        QVERIFY(session.undo());
        QVERIFY(session.settle());
        QCOMPARE(fixture.workspace.segmentOpacity(1), 30);
        QVERIFY(session.apply(test::newSegment(QStringLiteral("another"))));
        QVERIFY(session.settle());
        QCOMPARE(session.document().segments.back().label, 2);
        QCOMPARE(fixture.workspace.segmentOpacities(), (std::map<int, int>{{1, 30}}));
        QTRY_COMPARE(fixture.transparency(views.axial(), 2), 0);
        QCOMPARE(fixture.transparency(views.axial(), 1), 70);
        QVERIFY(fixture.withSlider([](QSlider& slider) { QCOMPARE(slider.value(), 100); }));
    }

    void oneThatComesBackHasItsOwn()
    {
        Fixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        const std::map<int, int> opacities{{1, 30}, {2, 40}};
        fixture.workspace.setSegmentOpacities(opacities);
        // As the timeline goes, to before all and forwards again.
        QVERIFY(session.goTo(0));
        QVERIFY(session.settle());
        QVERIFY(fixture.workspace.segmentOpacities().empty());
        QVERIFY(session.goTo(core::RowId(session.history().rows().size())));
        QVERIFY(session.settle());
        QCOMPARE(fixture.workspace.segmentOpacities(), opacities);
        // Deleted, and undone.
        ui::removeSegment(fixture.workspace, 2);
        QVERIFY(session.settle());
        QCOMPARE(fixture.workspace.segmentOpacities(), (std::map<int, int>{{1, 30}}));
        QVERIFY(session.undo());
        QVERIFY(session.settle());
        QCOMPARE(fixture.workspace.segmentOpacities(), opacities);
    }

    void anotherSessionBeginsWithout()
    {
        Fixture fixture;
        fixture.workspace.setSegmentOpacity(1, 30);
        fixture.workspace.setSession(nullptr);
        QVERIFY(fixture.workspace.segmentOpacities().empty());
    }
};

BURIN_WINDOW_TEST(SegmentOpacityUiTest)

} // namespace segmentOpacityUiTest

#include "SegmentOpacityUiTest.moc"
