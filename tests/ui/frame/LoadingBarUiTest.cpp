// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/LoadingBar.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace loadingBarUiTest {

class LoadingBarUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void workThatEndsSoonNeedNotBeShown()
    {
        constexpr int laterMs = 50;
        ui::LoadingBar bar;
        bar.begin(QStringLiteral("Opening a.dcm"));
        QVERIFY(bar.isVisible());
        bar.end();
        QVERIFY(!bar.isVisible());

        bar.showAfter(laterMs);
        bar.begin(QStringLiteral("Opening b.dcm"));
        QVERIFY(!bar.isVisible());
        bar.end();
        QTest::qWait(3 * laterMs);
        QVERIFY(!bar.isVisible());
        bar.begin(QStringLiteral("Opening c.dcm"));
        QTRY_VERIFY(bar.isVisible());
        bar.end();
        QVERIFY(!bar.isVisible());

        bar.showAfter(0);
        bar.begin(QStringLiteral("Opening d.dcm"));
        QVERIFY(bar.isVisible());
    }
};

BURIN_WINDOW_TEST(LoadingBarUiTest)

} // namespace loadingBarUiTest

#include "LoadingBarUiTest.moc"
