// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/program/TestProgram.h"
#include "ui/input/Tool.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QtTest>

#include <functional>

namespace laserUiTest {

/// The laser in the real window, with the real engine: by its key, shown before the press, cut,
/// undone. With BURIN_SCREENSHOTS on the demonstration head, for people who want to look.
class LaserUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void cutsWhereItIsShown()
    {
        test::ApplicationFixture fixture;
        const auto wait = [](const std::function<bool()>& condition) {
            return QTest::qWaitFor(condition, test::ApplicationFixture::patience);
        };
        const auto drawn = [&] {
            return test::waitUntilDrawn(fixture.window(), fixture.workspace());
        };
        if (qEnvironmentVariableIsSet("BURIN_SCREENSHOTS")) {
            Q_EMIT fixture.window().demonstrationRequested();
            QVERIFY(wait([&] { return fixture.workspace().session() != nullptr; }));
        } else {
            fixture.open(fixture.path("case/ct"));
        }
        QVERIFY(drawn());
        ui::VolumeView& view = fixture.window().views().volume();
        const auto take = [&fixture](Qt::Key key) {
            for (QAction* action : fixture.window().findChildren<QAction*>()) {
                if (action->shortcut() == QKeySequence(key))
                    action->trigger();
            }
        };
        take(Qt::Key_T);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        test::look(fixture.window().grab(), "drill-window.png");
        take(Qt::Key_A);
        const ui::Tool* tool = fixture.workspace().activeTool();
        QVERIFY(tool);
        QCOMPARE(tool->iconName(), QStringLiteral("laser"));

        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        const QPointF aside(0.16 * view.width(), -0.1 * view.height());
        test::Pen pen(view);
        const QImage before = view.grab().toImage();
        pen.hover(middle + aside, 1000);
        QVERIFY(fixture.session().settle()); // what it meets is asked for
        QTRY_VERIFY_WITH_TIMEOUT(
            view.grab().toImage() != before, test::ApplicationFixture::patience);
        test::look(fixture.window().grab(), "laser-window.png");
        test::look(view.grab(), "laser-footprint.png");
        QVERIFY(view.grab().toImage() != before);

        pen.press(middle + aside, 1.0, 2000);
        for (int i = 1; i <= 12; ++i)
            pen.move(middle + aside * (1.0 - i / 12.0), 1.0, quint64(2000 + 20 * i));
        pen.release(middle, 2300);
        QVERIFY(fixture.session().settle());
        const auto& rows = fixture.session().history().rows();
        QCOMPARE(rows.size(), std::size_t(1));
        QVERIFY(rows.back().name.startsWith(QStringLiteral("Laser 15.0 mm, ")));
        QVERIFY(rows.back().statistics.voxelsChanged > 0);
        QVERIFY(drawn());
        test::look(view.grab(), "laser-cut.png");
        const QByteArray after = fixture.session().stateHash();
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().redo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), after);
    }
};

BURIN_WINDOW_TEST(LaserUiTest)

} // namespace laserUiTest

#include "LaserUiTest.moc"
