// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/KeysDialog.h"
#include "ui/window/MainWindow.h"

#include <QApplication>
#include <QTreeWidget>
#include <QtTest>

namespace keysDialogUiTest {

class KeysDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::theme::apply(*qApp); }
    void init() { test::failOnUnexpectedMessages(); }

    /// It is read to look something up, and fits the smallest screen.
    void nothingIsCut()
    {
        test::WindowFixture fixture(test::headFirstSupine());
        ui::KeysDialog dialog(fixture.window.actionTable());
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QVERIFY2(dialog.width() <= 1280, qPrintable(QString::number(dialog.width())));
        QVERIFY(dialog.height() <= 680);
        const auto& list = *dialog.findChild<QTreeWidget*>();
        QVERIFY(list.topLevelItemCount() > 40);
        int width = 0;
        for (int column = 0; column < list.columnCount(); ++column) {
            width += list.columnWidth(column);
            for (int i = 0; i < list.topLevelItemCount(); ++i) {
                const QTreeWidgetItem& row = *list.topLevelItem(i);
                const QFontMetrics metrics(row.font(column));
                QVERIFY2(metrics.horizontalAdvance(row.text(column)) < list.columnWidth(column),
                    qPrintable(row.text(column)));
            }
        }
        QVERIFY2(width <= list.viewport()->width(),
            qPrintable(QStringLiteral("%1 of %2").arg(list.viewport()->width()).arg(width)));
    }
};

BURIN_WINDOW_TEST(KeysDialogUiTest)

} // namespace keysDialogUiTest

#include "KeysDialogUiTest.moc"
