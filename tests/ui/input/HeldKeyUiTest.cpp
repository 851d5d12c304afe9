// SPDX-License-Identifier: Apache-2.0
#include "ui/input/HeldKey.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"

#include <QAction>
#include <QKeyEvent>
#include <QTest>

#include <optional>

namespace heldKeyUiTest {

namespace {

constexpr int longPress = ui::HeldKey::heldMilliseconds + 150;

/// A window with something that H shows and hides.
struct Window {
    QWidget widget;
    QAction action;
    bool shown = true;
    int switched = 0;

    Window()
    {
        action.setShortcut(Qt::Key_H);
        QObject::connect(&action, &QAction::triggered, &action, [this] {
            shown = !shown;
            ++switched;
        });
        new ui::HeldKey(action);
        widget.addAction(&action);
        widget.setFocusPolicy(Qt::StrongFocus);
        widget.resize(200, 100);
        widget.show();
        widget.activateWindow();
        if (!QTest::qWaitForWindowActive(&widget))
            qFatal("the window does not become active");
        widget.setFocus();
    }
};

void repeat(QWidget& widget, QEvent::Type type)
{
    QKeyEvent event(type, Qt::Key_H, Qt::NoModifier, QStringLiteral("h"), true);
    QCoreApplication::sendEvent(&widget, &event);
}

} // namespace

/// H shows and hides for good, or for as long as it is held.
class HeldKeyUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aShortPressSwitches()
    {
        Window window;
        QTest::keyClick(&window.widget, Qt::Key_H);
        QVERIFY(!window.shown);
        QTest::qWait(longPress); // nothing is pending
        QVERIFY(!window.shown);
        QTest::keyClick(&window.widget, Qt::Key_H);
        QVERIFY(window.shown);
        QCOMPARE(window.switched, 2);
    }

    void aLongPressSwitchesBack()
    {
        Window window;
        for (const bool shown : {true, false}) {
            window.shown = shown;
            QTest::keyPress(&window.widget, Qt::Key_H);
            QCOMPARE(window.shown, !shown);
            // A key that is held is sent again and again.
            repeat(window.widget, QEvent::KeyRelease);
            repeat(window.widget, QEvent::KeyPress);
            QCOMPARE(window.shown, !shown);
            QTest::qWait(longPress);
            repeat(window.widget, QEvent::KeyRelease);
            repeat(window.widget, QEvent::KeyPress);
            QCOMPARE(window.shown, !shown);
            QTest::keyRelease(&window.widget, Qt::Key_H);
            QCOMPARE(window.shown, shown);
        }
        QCOMPARE(window.switched, 4);
    }

    /// Nobody tells the window then that the key was let go.
    void leavingTheWindowSwitchesBack()
    {
        Window window;
        QTest::keyPress(&window.widget, Qt::Key_H);
        QVERIFY(!window.shown);
        QEvent left(QEvent::WindowDeactivate);
        QCoreApplication::sendEvent(&window.widget, &left);
        QVERIFY(window.shown);
        QTest::keyRelease(&window.widget, Qt::Key_H);
        QVERIFY(window.shown);
        QCOMPARE(window.switched, 2);
        // What was switched by a short press stays.
        QTest::keyClick(&window.widget, Qt::Key_H);
        QCoreApplication::sendEvent(&window.widget, &left);
        QVERIFY(!window.shown);
    }

    void aMenuSwitchesForGood()
    {
        Window window;
        window.action.trigger();
        QTest::qWait(longPress);
        QTest::keyRelease(&window.widget, Qt::Key_H);
        QVERIFY(!window.shown);
        // Other keys have nothing to do with it.
        QTest::keyClick(&window.widget, Qt::Key_J);
        QCOMPARE(window.switched, 1);
    }

    /// In the main window: all segments, in every view, and no step of the history.
    void theWindowPeeksUnderItsSegments()
    {
        test::WindowFixture fixture(test::smallStudy());
        core::EditSession& session = *fixture.workspace.session();
        QVERIFY(session.apply(test::addSegment("Brain")));
        QVERIFY(session.settle());
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        ui::SliceView& axial = fixture.window.views().axial();
        axial.setFocus();
        const std::size_t rows = session.history().rows().size();
        const auto visible = [&fixture](const ui::ImageView& view) {
            return fixture.frames.lastRequest(view.viewId()).segments.visible[1];
        };
        const auto everywhere = [&](bool wanted) {
            return visible(axial) == wanted && visible(fixture.window.views().coronal()) == wanted
                && visible(fixture.window.views().volume()) == wanted;
        };
        QTRY_VERIFY(everywhere(true));
        QTest::keyPress(&axial, Qt::Key_H);
        QTRY_VERIFY(everywhere(false));
        QTest::qWait(longPress);
        QVERIFY(everywhere(false));
        QTest::keyRelease(&axial, Qt::Key_H);
        QTRY_VERIFY(everywhere(true));
        QVERIFY(session.document().segment(1)->visible);
        QCOMPARE(session.history().rows().size(), rows);
        const QAction& action = fixture.window.actionTable()[QStringLiteral("view.segments")];
        QVERIFY(action.isChecked());
        QTest::keyClick(&axial, Qt::Key_H);
        QTRY_VERIFY(everywhere(false));
        QVERIFY(!action.isChecked());
    }
};

BURIN_WINDOW_TEST(HeldKeyUiTest)

} // namespace heldKeyUiTest

#include "HeldKeyUiTest.moc"
