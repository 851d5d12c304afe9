// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/ReviseStrokeDialog.h"

#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/StrokeRevision.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace reviseStrokeDialogUiTest {

using Kind = core::ToolMask::Kind;

namespace {

core::Edit drillWith(const core::ToolMask& mask)
{
    return test::drillWith({.mask = mask}, test::drillAt(0));
}

core::ScissorsCut scissors()
{
    core::ScissorsCut cut;
    cut.view = test::frontView();
    cut.polygonMm = {{-3.0, -3.0}, {3.0, -3.0}, {0.0, 3.0}};
    return cut;
}

core::Edit laser()
{
    const test::StrokeFacts drill = test::factsOfStroke(test::drillAt(0));
    const std::vector<glm::dvec2> outline{{-3.0, -2.0}, {3.0, -2.0}, {0.0, 2.0}};
    return test::laserWith({.view = drill.view,
        .mask = core::ToolMask{.polygonMm = outline},
        .surfaceThreshold = drill.surfaceThreshold,
        .samples = drill.samples});
}

/// The real window over a history of cuts, and their menu's doings.
struct Bench {
    explicit Bench(const std::vector<core::Edit>& edits)
        : fixture(test::smallStudy())
        , revision(fixture.workspace, &fixture.window)
    {
        fixture.window.show();
        for (const core::Edit& edit : edits)
            applied = applied && session().apply(edit) && session().settle();
    }
    [[nodiscard]] core::EditSession& session() { return *fixture.workspace.session(); }
    /// The dialog of a row. It closes by itself when it is answered.
    [[nodiscard]] ui::ReviseStrokeDialog* ask(core::RowId row)
    {
        revision.change(row);
        return fixture.window.findChild<ui::ReviseStrokeDialog*>();
    }
    void answer(const QPointer<ui::ReviseStrokeDialog>& dialog)
    {
        const auto buttons = dialog->findChild<QDialogButtonBox*>()->buttons();
        const auto change = std::find_if(buttons.begin(), buttons.end(),
            [](const QAbstractButton* button) { return button->text() == u"Change"; });
        QVERIFY(change != buttons.end());
        QTest::mouseClick(*change, Qt::LeftButton);
        QVERIFY(session().settle());
        QTRY_VERIFY(!dialog);
    }
    [[nodiscard]] core::ReviseStroke last()
    {
        return session().history().rows().back().edit.get<core::ReviseStroke>();
    }

    test::WindowFixture fixture;
    ui::StrokeRevision revision;
    bool applied = true;
};

QDoubleSpinBox* box(const ui::ReviseStrokeDialog& dialog, const char* name)
{
    return dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
}

void type(QDoubleSpinBox& into, const char* text)
{
    into.setFocus();
    into.selectAll();
    QTest::keyClicks(&into, QLatin1String(text));
    QTest::keyClick(&into, Qt::Key_Tab);
}

} // namespace

/// Changing cuts of every kind of mask in the window.
class ReviseStrokeDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void asksForWhatTheCutHas_data()
    {
        QTest::addColumn<QString>("fields");
        QTest::addColumn<int>("cut");
        QTest::newRow("circle") << "depth radius softness" << 0;
        QTest::newRow("square") << "depth side softness" << 1;
        QTest::newRow("ellipse") << "depth height softness width" << 2;
        QTest::newRow("rounded") << "depth height softness width" << 3;
        QTest::newRow("drawn by hand") << "depth factor softness" << 4;
        QTest::newRow("scissors through all") << "factor" << 5;
    }
    void asksForWhatTheCutHas()
    {
        QFETCH(QString, fields);
        QFETCH(int, cut);
        const std::vector<core::Edit> cuts{drillWith({.radiusMm = 3.0}),
            drillWith({.kind = Kind::Square, .widthMm = 5.0}),
            drillWith({.kind = Kind::Ellipse, .widthMm = 6.0, .heightMm = 3.0}),
            drillWith({.kind = Kind::Rounded, .widthMm = 6.0, .heightMm = 4.0, .cornerMm = 1.0}),
            laser(), scissors()};
        Bench bench({cuts[std::size_t(cut)]});
        QVERIFY(bench.applied);
        ui::ReviseStrokeDialog* dialog = bench.ask(1);
        QVERIFY(dialog);
        QStringList shown;
        for (const QDoubleSpinBox* each : dialog->findChildren<QDoubleSpinBox*>()) {
            QVERIFY(each->isVisible());
            const auto* text = each->findChild<QLineEdit*>();
            QVERIFY(each->fontMetrics().horizontalAdvance(each->text()) <= text->width());
            shown += each->objectName();
        }
        // The uppermost is at hand.
        const auto* first = qobject_cast<QDoubleSpinBox*>(dialog->focusWidget());
        QVERIFY(first);
        for (const QDoubleSpinBox* each : dialog->findChildren<QDoubleSpinBox*>())
            QVERIFY(first->y() <= each->y());
        shown.sort();
        QCOMPARE(shown.join(u' '), fields);
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(dialog->grab().save(
                QDir(folder).filePath(QStringLiteral("revise-%1.png").arg(cut))));
        // Looking changes nothing.
        const core::ReviseStroke edit = dialog->edit();
        QVERIFY(!edit.radiusMm && !edit.sideMm && !edit.widthMm && !edit.heightMm && !edit.factor
            && !edit.depthMm && !edit.softnessMm && !edit.layer && !edit.throughGaps);
        dialog->reject();
    }

    void theSideOfASquareIsChanged()
    {
        Bench bench({drillWith({.kind = Kind::Square, .widthMm = 5.0})});
        const QByteArray before = bench.session().stateHash();
        ui::ReviseStrokeDialog* dialog = bench.ask(1);
        QCOMPARE(box(*dialog, "side")->value(), 5.0);
        type(*box(*dialog, "side"), "8.5");
        bench.answer(dialog);
        QCOMPARE(bench.last().sideMm.value_or(0.0), 8.5);
        QVERIFY(!bench.last().depthMm && !bench.last().softnessMm);
        QVERIFY(bench.session().stateHash() != before);
        dialog = bench.ask(1);
        QCOMPARE(box(*dialog, "side")->value(), 8.5);
        dialog->reject();
    }

    void widthAndHeightAreChangedAlone()
    {
        Bench bench({drillWith({.kind = Kind::Ellipse, .widthMm = 6.0, .heightMm = 3.0})});
        ui::ReviseStrokeDialog* dialog = bench.ask(1);
        QCOMPARE(box(*dialog, "width")->value(), 6.0);
        type(*box(*dialog, "height"), "5");
        bench.answer(dialog);
        QCOMPARE(bench.last().heightMm.value_or(0.0), 5.0);
        QVERIFY(!bench.last().widthMm);
    }

    /// The factor is told of how it was drawn, however often it was changed since.
    void drawnOutlinesAreResized()
    {
        Bench bench({laser(), scissors()});
        for (const core::RowId row : {1, 2}) {
            ui::ReviseStrokeDialog* dialog = bench.ask(row);
            QCOMPARE(box(*dialog, "factor")->value(), 100.0);
            type(*box(*dialog, "factor"), "150");
            bench.answer(dialog);
            QCOMPARE(bench.last().factor.value_or(0.0), 1.5);
            dialog = bench.ask(row);
            QCOMPARE(box(*dialog, "factor")->value(), 150.0);
            // Something else is changed: it stays.
            if (box(*dialog, "softness"))
                type(*box(*dialog, "softness"), "0.5");
            else
                type(*box(*dialog, "factor"), "120");
            bench.answer(dialog);
            QVERIFY(std::abs(bench.last().factor.value_or(0.0) - (row == 1 ? 1.5 : 1.2)) < 1e-3);
            dialog = bench.ask(row);
            type(*box(*dialog, "factor"), "100");
            bench.answer(dialog);
            QVERIFY(!bench.last().factor);
        }
    }

    /// What a recipe changed by less than the box shows is kept.
    void finerValuesAreKept()
    {
        Bench bench({drillWith({.kind = Kind::Square, .widthMm = 5.0}),
            core::ReviseStroke{.row = 1, .sideMm = 7.125}});
        QVERIFY(bench.applied);
        ui::ReviseStrokeDialog* dialog = bench.ask(1);
        type(*box(*dialog, "depth"), "2");
        bench.answer(dialog);
        QCOMPARE(bench.last().sideMm.value_or(0.0), 7.125);
        QCOMPARE(bench.last().depthMm.value_or(0.0), 2.0);
    }
};

BURIN_WINDOW_TEST(ReviseStrokeDialogUiTest)

} // namespace reviseStrokeDialogUiTest

#include "ReviseStrokeDialogUiTest.moc"
