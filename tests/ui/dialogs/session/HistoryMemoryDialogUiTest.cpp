// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"
#include "ui/dialogs/session/HistoryMemoryDialog.h"
#include "ui/settings/HistoryMemory.h"

#include <QDir>
#include <QMenu>
#include <QSettings>
#include <QSpinBox>
#include <QTest>

namespace historyMemoryDialogUiTest {

class HistoryMemoryDialogUiTest : public QObject {
    Q_OBJECT

private:
    test::OwnSettings m_settings;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_settings.clear();
    }

    void theSettingHasBounds()
    {
        QCOMPARE(ui::historyMebibytes(), ui::usualHistoryMebibytes);
        ui::setHistoryMebibytes(1);
        QCOMPARE(ui::historyMebibytes(), 16);
        ui::setHistoryMebibytes(100000);
        QCOMPARE(ui::historyMebibytes(), 4096);
        QSettings().setValue(QStringLiteral("history/memoryMebibytes"), QStringLiteral("much"));
        QCOMPARE(ui::historyMebibytes(), ui::usualHistoryMebibytes);
    }

    void isASettingOnceAccepted()
    {
        test::WindowFixture fixture(test::headFirstSupine());
        ui::HistoryMemoryDialog dialog(fixture.workspace, &fixture.window);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto* field = dialog.findChild<QSpinBox*>(QStringLiteral("historyMebibytes"));
        QCOMPARE(field->value(), ui::usualHistoryMebibytes);
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(
                dialog.grab().save(QDir(folder).filePath(QStringLiteral("history-memory.png"))));
        field->setValue(1024);
        dialog.reject();
        QCOMPARE(ui::historyMebibytes(), ui::usualHistoryMebibytes);
        dialog.accept();
        QCOMPARE(ui::historyMebibytes(), 1024);
    }

    void isInTheMenu()
    {
        test::WindowFixture fixture(test::headFirstSupine());
        const QAction& action = fixture.window.actionTable()[QStringLiteral("edit.historyMemory")];
        QVERIFY(fixture.window.editMenu().actions().contains(const_cast<QAction*>(&action)));
        QVERIFY(action.isEnabled());
    }
};

BURIN_WINDOW_TEST(HistoryMemoryDialogUiTest)

} // namespace historyMemoryDialogUiTest

#include "HistoryMemoryDialogUiTest.moc"
