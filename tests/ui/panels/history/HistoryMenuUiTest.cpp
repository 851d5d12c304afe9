// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/HistoryPanel.h"

#include <QApplication>
#include <QListView>
#include <QTimer>
#include <QtTest>

namespace historyMenuUiTest {

/// The menu of a step, while the study does not stay what it was.
class HistoryMenuUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Its entries are about a step of the session in which it was opened.
    void itClosesWithItsSession()
    {
        test::WindowFixture fixture(test::smallStudy());
        fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
        fixture.window.showPanels(true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        fixture.apply(test::drillAt(0));
        auto* list = fixture.window.findChild<QListView*>(QStringLiteral("historyList"));
        QVERIFY(list);
        bool wasOpen = false;
        bool isOpen = true;
        QTimer::singleShot(0, &fixture.window, [&] {
            wasOpen = QApplication::activePopupWidget() != nullptr;
            fixture.workspace.setSession(nullptr);
            isOpen = QApplication::activePopupWidget() != nullptr;
            if (isOpen)
                QApplication::activePopupWidget()->close();
        });
        const QModelIndex stroke = list->model()->index(1, 0);
        list->scrollTo(stroke);
        Q_EMIT list->customContextMenuRequested(list->visualRect(stroke).center());
        QVERIFY(wasOpen);
        QVERIFY(!isOpen);
    }
};

BURIN_WINDOW_TEST(HistoryMenuUiTest)

} // namespace historyMenuUiTest

#include "HistoryMenuUiTest.moc"
