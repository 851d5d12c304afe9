// SPDX-License-Identifier: Apache-2.0
#include "tests/support/FailingLog.h"
#include "tests/support/SmallStudy.h"
#include "tests/support/WindowFixture.h"
#include "ui/panels/HistoryPanel.h"

#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QTimer>
#include <QtTest>

class HistoryPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aStepIsUndoneAlone()
    {
        test::WindowFixture fixture(test::smallStudy());
        fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
        fixture.window.showPanels(true);
        QTest::qWait(50);
        core::EditSession& session = *fixture.workspace.session();
        for (const core::Edit& edit : std::vector<core::Edit>{test::addSegment("Brain"),
                 test::drillAt(0), test::seedInBrain(1), test::growBrain(2)})
            QVERIFY(session.apply(edit));
        QVERIFY(session.settle());
        auto* list = fixture.window.findChild<QListView*>(QStringLiteral("historyList"));
        QVERIFY(list);

        // The opened study and the segment changed no voxel; there is nothing to undo alone.
        QCOMPARE(enabledIn(list, 0), QStringList{tr("Go to this step")});
        QCOMPARE(enabledIn(list, 1), QStringList{tr("Go to this step")});
        QCOMPARE(enabledIn(list, 4), QStringList{tr("Undo only this step")});

        choose(list, 2, tr("Undo only this step"));
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), std::size_t(5));
        const QString name = list->model()->index(5, 0).data().toString();
        QCOMPARE(name, QStringLiteral("Undo only step 2"));

        // Its growth came after it: said, and nothing done.
        QSignalSpy failures(&fixture.workspace, &ui::Workspace::failed);
        choose(list, 3, tr("Undo only this step"));
        static_cast<void>(session.settle());
        QCOMPARE(session.history().rows().size(), std::size_t(5));
        QCOMPARE(failures.size(), 1);

        choose(list, 1, tr("Go to this step"));
        QVERIFY(session.settle());
        QCOMPARE(session.history().position(), core::RowId(1));
        QCOMPARE(enabledIn(list, 2), QStringList{tr("Go to this step")}); // undone
    }

private:
    /// Opens the menu of a row and hands it to @p look, which runs while it is open.
    static void withMenu(QListView* list, int row, const std::function<void(QMenu&)>& look)
    {
        bool looked = false;
        QTimer::singleShot(0, list, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            looked = true;
            look(*menu);
            menu->close();
        });
        const QModelIndex index = list->model()->index(row, 0);
        list->scrollTo(index);
        Q_EMIT list->customContextMenuRequested(list->visualRect(index).center());
        QVERIFY(looked);
    }
    static QStringList enabledIn(QListView* list, int row)
    {
        QStringList enabled;
        withMenu(list, row, [&enabled](const QMenu& menu) {
            for (const QAction* action : menu.actions()) {
                if (action->isEnabled())
                    enabled += action->text();
            }
        });
        return enabled;
    }
    static void choose(QListView* list, int row, const QString& text)
    {
        withMenu(list, row, [&text](const QMenu& menu) {
            for (QAction* action : menu.actions()) {
                if (action->text() == text)
                    action->trigger();
            }
        });
    }
};

QTEST_MAIN(HistoryPanelUiTest)
#include "HistoryPanelUiTest.moc"
