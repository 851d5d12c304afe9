// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/Actions.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/OptionBar.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QLabel>
#include <QMap>
#include <QTest>

#include <algorithm>

namespace keysUiTest {

/// The keys of the whole window, as all of its parts together give them.
class KeysUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// One that two actions ask for does neither.
    void noKeyIsGivenTwice()
    {
        test::ApplicationFixture fixture;
        QMap<QString, QString> owners;
        int keys = 0;
        for (const QAction* action : fixture.window().actionTable().all()) {
            for (const QKeySequence& key : action->shortcuts()) {
                const QString text = key.toString(QKeySequence::PortableText);
                QVERIFY2(!owners.contains(text),
                    qPrintable(QStringLiteral("%1: '%2' and '%3'")
                                   .arg(text, owners.value(text), action->text())));
                owners.insert(text, action->text());
                ++keys;
            }
        }
        QVERIFY2(keys > 50, qPrintable(QString::number(keys)));
        // Views and their tools have these: slices, lens, what is drawn or watched.
        for (const char* key : {"Z", "Space", "Esc", "Return", "Enter", "Backspace", "Left",
                 "Right", "Up", "Down", "PgUp", "PgDown", "Home", "End", "Tab"})
            QVERIFY2(!owners.contains(QLatin1String(key)), key);
    }

    /// E and B take the same brush, as an eraser and as a brush.
    void theEraserIsABrush()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::Actions& actions = fixture.window().actionTable();
        const auto* paint = fixture.window().findChild<ui::PaintTool*>();
        const auto press = [&actions](const char* id) { actions[QLatin1String(id)].trigger(); };
        const auto inHand = [&] {
            return fixture.workspace().activeTool() == paint ? paint->name() : QString();
        };
        const auto says = [&fixture](const QString& word) {
            const auto labels =
                fixture.window().findChild<ui::OptionBar*>()->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                [&word](const QLabel* label) { return label->text() == word; });
        };
        press("tool.erase");
        QCOMPARE(inHand(), QStringLiteral("Erase"));
        QVERIFY(says(QStringLiteral("Erase")) && actions[QStringLiteral("tool.erase")].isChecked());
        press("tool.paint");
        QCOMPARE(inHand(), QStringLiteral("Paint"));
        QVERIFY(says(QStringLiteral("Paint")) && !says(QStringLiteral("Erase")));
        QVERIFY(!actions[QStringLiteral("tool.erase")].isChecked());
        press("tool.erase");
        QVERIFY(says(QStringLiteral("Erase")));
        press("tool.erase");
        QVERIFY(!fixture.workspace().activeTool());
        press("tool.paint");
        QCOMPARE(inHand(), QStringLiteral("Paint"));
        press("tool.paint");
        QVERIFY(!fixture.workspace().activeTool());
    }

    /// The last step of the active segment goes, and a later one of another stays.
    void onlyTheActiveSegmentIsUndone()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        QAction& undo = fixture.window().actionTable()[QStringLiteral("edit.undoOnlySegment")];
        QVERIFY(!undo.isEnabled());
        for (const char* name : {"One", "Two"})
            fixture.edit(test::newSegment(QLatin1String(name), 0x4a9bff));
        fixture.edit(test::paintAt(1, {test::pointsInBrain().front()}, 2.0));
        fixture.edit(test::renameSegment(2, QStringLiteral("Second")));
        const core::Document& document = fixture.session().document();
        QVERIFY(document.segment(1)->voxels > 0);
        fixture.workspace().setActiveSegment(1);
        QCOMPARE(undo.text(), QStringLiteral("Undo last step of 'One' only"));
        undo.trigger();
        QTRY_COMPARE(document.segment(1)->voxels, std::int64_t(0));
        QCOMPARE(document.segment(2)->name, QStringLiteral("Second"));
    }

    /// The tab key over a view goes between the last two tools, and leaves the view where there are
    /// none, or backwards.
    void tabTakesTheToolBefore()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::MainWindow& window = fixture.window();
        const auto tab = [&window](Qt::KeyboardModifiers modifiers = {}) {
            window.views().axial().setFocus();
            QTest::keyClick(
                &window.views().axial(), modifiers ? Qt::Key_Backtab : Qt::Key_Tab, modifiers);
            return window.focusWidget() == &window.views().axial();
        };
        const auto inHand = [&fixture] {
            const ui::Tool* tool = fixture.workspace().activeTool();
            return tool ? tool->name() : QString();
        };
        const auto press = [&window](const char* id) {
            window.actionTable()[QLatin1String(id)].trigger();
        };
        QVERIFY(!tab() && !fixture.workspace().activeTool());
        press("tool.paint");
        QVERIFY(!tab());
        QCOMPARE(inHand(), QStringLiteral("Paint"));
        press("tool.seed");
        QVERIFY(tab());
        QCOMPARE(inHand(), QStringLiteral("Paint"));
        QVERIFY(tab());
        QCOMPARE(inHand(), QStringLiteral("Seed"));
        press("tool.navigate");
        QVERIFY(tab());
        QCOMPARE(inHand(), QStringLiteral("Seed"));
        QVERIFY(!tab(Qt::ShiftModifier));
        QCOMPARE(inHand(), QStringLiteral("Seed"));
    }

    /// Each press lifts another cut: a key that is held down lifts one.
    void aHeldKeyLiftsOnce()
    {
        test::ApplicationFixture fixture;
        QVERIFY(!fixture.window().actionTable()[QStringLiteral("pieces.lift")].autoRepeat());
    }
};

BURIN_WINDOW_TEST(KeysUiTest)

} // namespace keysUiTest

#include "KeysUiTest.moc"
