// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/session/StepFindings.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/dialogs/session/ReviseStrokeDialog.h"
#include "ui/frame/MessageBar.h"
#include "ui/frame/PanelSection.h"
#include "ui/models/HistoryModel.h"
#include "ui/panels/history/HistoryDelegate.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/panels/history/HistoryTimeline.h"
#include "ui/workspace/ViewSteps.h"

#include <QApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <functional>

namespace historyPanelUiTest {

class HistoryPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aStepIsUndoneAlone()
    {
        test::WindowFixture fixture(test::smallStudy());
        fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
        fixture.window.showPanels(true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
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
        QCOMPARE(name, QStringLiteral("Undo only 'Drill 5.0 mm'"));

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

    /// A double click goes to what was shown then, before and after.
    void changesOfTheViewAreWalkedTo()
    {
        Panel panel;
        panel.applyAll({test::addSegment("Brain"), test::addSegment("Skull")});
        panel.fixture.workspace.viewSteps().showSegment(1, false);
        panel.fixture.workspace.viewSteps().showSegment(2, false);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        const auto shown = [&panel](int label) {
            return panel.session().document().segment(label)->visible;
        };
        QCOMPARE(panel.index(3).data().toString(), QStringLiteral("Hide 2 segments"));
        QCOMPARE(enabledIn(panel.list, 3), QStringList{});
        panel.doubleClick(2);
        panel.settle();
        QVERIFY(shown(1) && shown(2));
        QCOMPARE(panel.polledPosition(), core::RowId(2));
        QCOMPARE(enabledIn(panel.list, 3), QStringList{tr("Go to this step")});
        panel.doubleClick(3);
        panel.settle();
        QVERIFY(!shown(1) && !shown(2));
        QCOMPARE(panel.polledPosition(), core::RowId(2));
        QCOMPARE(panel.session().history().rows().size(), std::size_t(2));
        // Under another step it leads to that step, and leaves what is shown.
        panel.goTo(1);
        panel.doubleClick(3);
        panel.settle();
        QCOMPARE(panel.polledPosition(), core::RowId(2));
        QVERIFY(!shown(1) && !shown(2));
    }

    void aStrokeIsChangedAndRemovedOutOfOrder()
    {
        Panel panel;
        core::EditSession& session = panel.session();
        const core::Edit second = test::drillWith({.radiusMm = 3.0}, test::drillAt(1));
        panel.applyAll({test::drillAt(0), second});
        const auto answer = [&panel](const std::function<void(ui::ReviseStrokeDialog&)>& act) {
            const QPointer<ui::ReviseStrokeDialog> dialog =
                panel.fixture.window.findChild<ui::ReviseStrokeDialog*>();
            QVERIFY(dialog);
            act(*dialog);
            QVERIFY(panel.session().settle());
            QTRY_VERIFY(!dialog); // the next one is looked for by its class
        };
        choose(panel.list, 1, tr("Change stroke …"));
        answer([](ui::ReviseStrokeDialog& dialog) {
            auto* radius = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("radius"));
            QCOMPARE(radius->value(), 4.0);
            radius->setValue(7.5);
            dialog.accept();
        });
        const auto& edit = session.history().row(3).edit.get<core::ReviseStroke>();
        QCOMPARE(edit.row, std::int64_t(1));
        QCOMPARE(edit.radiusMm.value_or(0.0), 7.5);
        QVERIFY(!edit.depthMm && !edit.layer && !edit.throughGaps && !edit.removed);

        // Once more: it shows what counts now, and taking it back leaves nothing to say.
        choose(panel.list, 1, tr("Change stroke …"));
        answer([](ui::ReviseStrokeDialog& dialog) {
            auto* radius = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("radius"));
            QCOMPARE(radius->value(), 7.5);
            keepPicture(dialog, "change-stroke.png");
            dialog.reject();
        });
        QCOMPARE(session.history().rows().size(), std::size_t(3));

        choose(panel.list, 1, tr("Remove stroke"));
        QVERIFY(session.settle());
        QCoreApplication::sendPostedEvents(); // the bar takes its place
        QCOMPARE(session.findings().strokesOnRevisedSurface(), std::vector<core::RowId>{2});
        QVERIFY2(panel.fixture.window.messages().sentence().startsWith(tr("One later stroke")),
            qPrintable(panel.fixture.window.messages().sentence()));
        QCOMPARE(enabledIn(panel.list, 1),
            (QStringList{
                tr("Go to this step"), tr("Undo only this step"), tr("Bring stroke back")}));
        auto* again = panel.fixture.window.messages().findChild<QPushButton*>();
        QVERIFY(again && again->isVisible());
        keepPicture(panel.fixture.window, "drill-again.png");
        // An offer that the user has gone past says so and does nothing.
        QSignalSpy said(&panel.fixture.workspace, &ui::Workspace::said);
        QVERIFY(session.undo());
        QVERIFY(session.settle());
        QTest::mouseClick(again, Qt::LeftButton);
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), std::size_t(4));
        QVERIFY(!said.isEmpty());
        choose(panel.list, 1, tr("Remove stroke"));
        QVERIFY(session.settle());
        QCoreApplication::sendPostedEvents();
        QTest::mouseClick(again, Qt::LeftButton);
        QVERIFY(session.settle());
        // Removed, and drilled anew where the surface is now: as if it alone had been drawn.
        QCOMPARE(session.history().rows().size(), std::size_t(7));
        const QByteArray alone = session.stateHash();
        Panel other;
        other.applyAll({second});
        QCOMPARE(alone, other.session().stateHash());
    }

    /// The dialog asks for what the cut has.
    void everyCutIsChanged()
    {
        Panel panel;
        core::EditSession& session = panel.session();
        const test::StrokeFacts drill = test::factsOfStroke(test::drillAt(0));
        const core::Edit peel =
            test::peelWith({.view = drill.view, .surfaceThreshold = drill.surfaceThreshold},
                {{-9.0, -8.0}, {9.0, -7.0}, {1.0, 10.0}});
        panel.applyAll({test::drillAt(0), peel, test::carveAt({drill.view.targetLps})});
        const auto change = [&panel](int place, const QStringList& fields, const char* field,
                                double value) {
            choose(panel.list, place, tr("Change stroke …"));
            const QPointer<ui::ReviseStrokeDialog> dialog =
                panel.fixture.window.findChild<ui::ReviseStrokeDialog*>();
            QVERIFY(dialog);
            QStringList shown;
            for (const QWidget* each : dialog->findChildren<QWidget*>()) {
                if (each->isVisible() && each->objectName() != QLatin1String("qt_spinbox_lineedit")
                    && !each->objectName().isEmpty())
                    shown += each->objectName();
            }
            shown.sort();
            QCOMPARE(shown, fields);
            keepPicture(*dialog, qPrintable(QStringLiteral("change-%1.png").arg(place)));
            dialog->findChild<QDoubleSpinBox*>(QLatin1String(field))->setValue(value);
            dialog->accept();
            QVERIFY(panel.session().settle());
            QTRY_VERIFY(!dialog);
        };
        change(1, {"depth", "radius", "softness", "throughGaps"}, "softness", 2.0);
        change(2, {"depth", "factor", "throughGaps"}, "depth", 6.5);
        change(3, {"radius"}, "radius", 7.0);
        const auto revision = [&session](core::RowId row) {
            return session.history().row(row).edit.get<core::ReviseStroke>();
        };
        QCOMPARE(revision(4).softnessMm.value_or(0.0), 2.0);
        QVERIFY(!revision(4).radiusMm && !revision(4).depthMm && !revision(4).throughGaps);
        QCOMPARE(revision(5).depthMm.value_or(0.0), 6.5);
        QVERIFY(!revision(5).radiusMm && !revision(5).softnessMm && !revision(5).throughGaps);
        QCOMPARE(revision(6).radiusMm.value_or(0.0), 7.0);
        QVERIFY(!revision(6).depthMm && !revision(6).softnessMm && !revision(6).throughGaps);
    }

    void branchesUnfoldAndAreReturnedTo()
    {
        Panel panel;
        core::EditSession& session = panel.session();
        QListView* list = panel.list;
        panel.applyAll({test::addSegment("Brain"), test::drillAt(0), test::seedInBrain(1)});
        panel.goTo(1);
        panel.applyAll({test::addSegment("Bone"), test::addSegment("Skin")});
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 4 5"));

        // By a click on the arrow; beside it a click only chooses.
        panel.click(panel.arrowOf(2));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 >2 >3 4 5"));
        panel.click(list->visualRect(panel.index(2)).center());
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 >2 >3 4 5"));
        panel.click(panel.arrowOf(2));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 4 5"));
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, panel.arrowOf(2));
        QVERIFY(session.settle());
        QCOMPARE(session.history().position(), core::RowId(5));

        // By keys, as trees do.
        list->setFocus();
        list->setCurrentIndex(panel.index(2));
        panel.setFolded(2, true);
        QTest::keyClick(list, Qt::Key_Right);
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 >2 >3 4 5"));
        QTest::keyClick(list, Qt::Key_Right);
        QCOMPARE(list->currentIndex().row(), 3);
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Left);
        QCOMPARE(list->currentIndex().row(), 2);
        QTest::keyClick(list, Qt::Key_Left);
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 3 4 5"));
        QTest::keyClick(list, Qt::Key_Right);

        // A double click on one of its rows walks there; the rest of it can be redone.
        panel.doubleClick(3);
        QVERIFY(session.settle());
        QCOMPARE(session.history().position(), core::RowId(2));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 5 2 3"));
        // Return on a heading goes to the branch's end.
        list->setCurrentIndex(panel.index(2));
        QTest::keyClick(list, Qt::Key_Return);
        QVERIFY(session.settle());
        QCOMPARE(session.history().position(), core::RowId(5));
    }

    void theMenuKnowsBranches()
    {
        Panel panel;
        panel.applyAll({test::drillAt(-4), test::drillAt(4)});
        panel.goTo(1);
        panel.applyAll({test::drillAt(0)});
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 2 3"));
        QCOMPARE(enabledIn(panel.list, 2),
            (QStringList{tr("Go to the end of this branch"), tr("Show its steps")}));
        choose(panel.list, 2, tr("Show its steps"));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 2 >2 3"));
        // Nothing of a branch is undone alone: it is not done.
        QCOMPARE(enabledIn(panel.list, 3), QStringList{tr("Go to this step")});
        QCOMPARE(enabledIn(panel.list, 4),
            (QStringList{tr("Undo only this step"), tr("Change stroke …"), tr("Remove stroke"),
                tr("Lift as a piece")}));
        choose(panel.list, 3, tr("Go to this step"));
        QVERIFY(panel.session().settle());
        QCOMPARE(panel.session().history().position(), core::RowId(2));
        choose(panel.list, 2, tr("Go to the end of this branch"));
        QVERIFY(panel.session().settle());
        QCOMPARE(panel.session().history().position(), core::RowId(3));
        choose(panel.list, 2, tr("Show its steps"));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 2 >2 3"));
        choose(panel.list, 2, tr("Hide its steps"));
        QCOMPARE(panel.listed(), QStringLiteral("0 1 >branch to 2 3"));
    }

    void saysHowManyBranchesThereAre()
    {
        Panel panel;
        panel.applyAll({test::addSegment("A"), test::drillAt(0)});
        for (int branch = 0; branch < 11; ++branch) {
            panel.goTo(1);
            panel.applyAll({test::drillAt(branch % 5 - 2)});
        }
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        const auto* section = panel.fixture.window.findChild<ui::PanelSection*>();
        const auto labels = section->findChildren<QLabel*>();
        const auto summary = std::find_if(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().startsWith(QStringLiteral("2 steps · 11 branches · "));
        });
        QVERIFY(summary != labels.end());
        const QLabel& label = **summary;
        QVERIFY(
            label.fontMetrics().horizontalAdvance(label.text()) <= label.contentsRect().width());
    }

    void theTimelineIsThereWhenThereIsAChoice()
    {
        Panel panel;
        QVERIFY(!panel.timeline->isVisible());
        panel.applyAll({test::addSegment("Brain")});
        QVERIFY(!panel.timeline->isVisible());
        panel.applyAll({test::drillAt(0)});
        QVERIFY(panel.timeline->isVisible());
        QCOMPARE(panel.timeline->caption(), QStringLiteral("step 2 of 2: Drill 5.0 mm"));
        panel.goTo(1);
        QCOMPARE(panel.timeline->caption(), QStringLiteral("step 1 of 2: Add segment 'Brain'"));
        QCOMPARE(panel.timeline->value(), 1);
        panel.fixture.workspace.setSession(nullptr);
        QVERIFY(!panel.timeline->isVisible());
    }

    void theTimelineIsDragged()
    {
        std::vector<core::RowId> passed;
        Panel panel;
        panel.applyAll({test::addSegment("Brain")});
        for (int step = 2; step <= 30; ++step)
            panel.applyAll({step % 3 == 0
                    ? core::Edit(test::drillAt(step - 16))
                    : core::Edit(test::renameSegment(1, QStringLiteral("name %1").arg(step)))});
        QCOMPARE(panel.session().history().rows().size(), std::size_t(30));
        connect(&panel.fixture.workspace, &ui::Workspace::documentChanged, panel.timeline, [&] {
            const core::RowId position = panel.session().history().position();
            if (passed.empty() || passed.back() != position)
                passed.push_back(position);
        });

        // It follows while the handle is held, and the list is where the handle is.
        panel.press(30);
        panel.drag(3);
        QCOMPARE(panel.timeline->caption(), QStringLiteral("step 3 of 30: Drill 5.0 mm"));
        QCOMPARE(panel.list->currentIndex().row(), 3);
        QVERIFY(panel.list->viewport()->rect().contains(
            panel.list->visualRect(panel.list->currentIndex()).center()));
        QTRY_COMPARE(panel.polledPosition(), core::RowId(3));
        QVERIFY(panel.timeline->isSliderDown());
        QCOMPARE(panel.timeline->value(), 3);

        // Turned round on the way, it does not first go to the end.
        passed.clear();
        panel.drag(28);
        panel.drag(12);
        panel.release(12);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(12));
        QTRY_VERIFY(!panel.timeline->isScrubbing());
        QVERIFY(*std::max_element(passed.begin(), passed.end()) < 28);
        QCOMPARE(panel.timeline->value(), 12);
        QVERIFY(panel.list->currentIndex().data(ui::HistoryModel::CurrentRole).toBool());
        QCOMPARE(panel.session().history().rows().size(), std::size_t(30)); // no step of its own

        // Back to the beginning, and out of the widget to the end.
        panel.press(0);
        panel.release(0);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(0));
        QCOMPARE(panel.timeline->caption(), QStringLiteral("step 0 of 30: Study opened"));
        panel.press(15);
        QTest::mouseRelease(panel.timeline, Qt::LeftButton, {},
            QPoint(panel.timeline->width() + 400, panel.timeline->height() / 2));
        QTRY_COMPARE(panel.polledPosition(), core::RowId(30));
    }

    void theTimelineWalksByKeys()
    {
        Panel panel;
        panel.applyAll({test::addSegment("Brain"), test::drillAt(0), test::seedInBrain(1),
            test::growBrain(2)});
        panel.goTo(2);
        panel.applyAll({test::drillAt(3)});
        panel.timeline->setFocus();
        QTest::keyClick(panel.timeline, Qt::Key_Left);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(2));
        QTest::keyClick(panel.timeline, Qt::Key_Left);
        QTest::keyClick(panel.timeline, Qt::Key_Left);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(0));
        QTest::keyClick(panel.timeline, Qt::Key_Right);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(1));
        QTest::keyClick(panel.timeline, Qt::Key_End); // of the current line, not of a branch
        QTRY_COMPARE(panel.polledPosition(), core::RowId(5));
        QCOMPARE(panel.timeline->maximum(), 3);
        QTest::keyClick(panel.timeline, Qt::Key_Home);
        QTRY_COMPARE(panel.polledPosition(), core::RowId(0));
    }

    /// For people who want to look: the folder is named by BURIN_SCREENSHOTS.
    void looksLikeATree()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS names no folder");
        Panel panel;
        panel.applyAll({test::addSegment("Brain"), test::drillAt(0), test::drillAt(3),
            test::seedInBrain(1), test::growBrain(2), test::growBrain(4)});
        panel.goTo(3);
        panel.applyAll({test::drillAt(-6), test::seedInBrain(1), test::growBrain(3),
            test::drillAt(6), test::addSegment("Skull, outer table")});
        panel.goTo(9);
        panel.applyAll({test::growBrain(1), test::drillAt(9)});
        panel.goTo(0);
        panel.applyAll({test::addSegment("Something else")});
        panel.goTo(5);
        for (int row = 0; row < panel.list->model()->rowCount(); ++row)
            panel.setFolded(row, row == 1);
        panel.list->setFocus();
        panel.list->setCurrentIndex(panel.index(6));
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        panel.fixture.window.grab().save(QDir(folder).filePath(QStringLiteral("history.png")));
    }

private:
    /// The panel in the real window, with a small study open.
    struct Panel {
        Panel()
            : fixture(test::smallStudy())
        {
            fixture.window.addPanel(new ui::HistoryPanel(fixture.workspace));
            fixture.window.showPanels(true);
            fixture.window.activateWindow();
            if (!QTest::qWaitForWindowActive(&fixture.window))
                qFatal("the window does not show");
            list = fixture.window.findChild<QListView*>(QStringLiteral("historyList"));
            timeline = fixture.window.findChild<ui::HistoryTimeline*>();
        }
        [[nodiscard]] core::RowId polledPosition()
        {
            session().poll();
            return session().history().position();
        }
        [[nodiscard]] QPoint onTimeline(int step) const
        {
            return {qRound(timeline->xOf(step)), timeline->height() - 10};
        }
        void press(int step) const
        {
            QTest::mousePress(timeline, Qt::LeftButton, {}, onTimeline(step));
        }
        void drag(int step) const { QTest::mouseMove(timeline, onTimeline(step)); }
        void release(int step) const
        {
            QTest::mouseRelease(timeline, Qt::LeftButton, {}, onTimeline(step));
        }
        [[nodiscard]] core::EditSession& session() { return *fixture.workspace.session(); }
        void settle()
        {
            if (!session().settle())
                qFatal("the session does not settle");
        }
        void applyAll(const std::vector<core::Edit>& edits)
        {
            for (const core::Edit& edit : edits) {
                if (!session().apply(edit))
                    qFatal("an edit is refused");
                settle();
            }
        }
        void goTo(core::RowId row)
        {
            if (!session().goTo(row))
                qFatal("no such row");
            settle();
        }
        [[nodiscard]] QModelIndex index(int row) const { return list->model()->index(row, 0); }
        void setFolded(int row, bool folded) const
        {
            list->model()->setData(index(row), folded, ui::HistoryModel::FoldedRole);
        }
        [[nodiscard]] QPoint arrowOf(int row) const
        {
            const int depth = index(row).data(ui::HistoryModel::DepthRole).toInt();
            return ui::HistoryDelegate::arrowRect(list->visualRect(index(row)), depth).center();
        }
        void click(const QPoint& at) const
        {
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
        }
        void doubleClick(int row) const
        {
            const QPoint at = list->visualRect(index(row)).center();
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
            QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
        }
        /// Row numbers, ">" in front for each branch that they lie on.
        [[nodiscard]] QString listed() const
        {
            QStringList entries;
            for (int row = 0; row < list->model()->rowCount(); ++row) {
                const bool heading = index(row).data(ui::HistoryModel::HeadingRole).toBool();
                entries += QString(index(row).data(ui::HistoryModel::DepthRole).toInt(), u'>')
                    + (heading ? QStringLiteral("branch to ") : QString())
                    + index(row).data(ui::HistoryModel::RowIdRole).toString();
            }
            return entries.join(u' ');
        }

        test::WindowFixture fixture;
        QListView* list = nullptr;
        ui::HistoryTimeline* timeline = nullptr;
    };

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
    /// For the eyes, where BURIN_SCREENSHOTS names a folder.
    static void keepPicture(QWidget& widget, const char* name)
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(widget.grab().save(QDir(folder).filePath(QLatin1String(name))));
    }
    static QStringList enabledIn(QListView* list, int row)
    {
        QStringList enabled;
        withMenu(list, row, [&enabled](const QMenu& menu) {
            for (const QAction* action : menu.actions()) {
                if (action->isEnabled() && !action->isSeparator())
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

BURIN_WINDOW_TEST(HistoryPanelUiTest)

} // namespace historyPanelUiTest

#include "HistoryPanelUiTest.moc"
