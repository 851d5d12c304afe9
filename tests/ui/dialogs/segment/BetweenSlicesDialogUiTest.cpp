// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/BetweenSlicesDialog.h"

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/growth/ProbedVoxel.h"
#include "core/session/SegmentWork.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <memory>

namespace betweenSlicesDialogUiTest {

namespace {

/// A segment that was drawn on two axial slices.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        apply(test::addSegment("Organ"));
        apply(test::addSegment("Empty"));
        draw(8, 6.0);
        draw(16, 3.0);
        workspace.setActiveSegment(1);
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
        wakeUp.start(10);
    }
    /// On a slice, as the volume numbers them.
    void draw(int slice, double radiusMm)
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        apply(test::paintDiscAt(1, geometry.toWorld(glm::dvec3(20.0, 18.0, double(slice))),
            geometry.direction()[2], radiusMm));
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }
    [[nodiscard]] const core::HistoryRow& lastRow() { return session().history().rows().back(); }
    /// The dialog after the menu Segments has opened it.
    [[nodiscard]] ui::BetweenSlicesDialog& opened()
    {
        window.actionTable()[QStringLiteral("segments.fillBetween")].trigger();
        return *window.findChild<ui::BetweenSlicesDialog*>();
    }

    /// The label in the middle of a slice now, also in what is no step yet.
    [[nodiscard]] int labelIn(int slice)
    {
        const auto label = std::make_shared<int>(-1);
        session().questions().probe({glm::ivec3(20, 18, slice)},
            [label](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                if (probes && !probes->empty())
                    *label = probes->front().label;
            });
        session().poll();
        return *label;
    }

    QTimer wakeUp;
};

QString textOf(const QWidget& dialog, const char* name)
{
    return dialog.findChild<QLabel*>(QLatin1String(name))->text();
}

QPushButton& buttonOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QPushButton*>(QLatin1String(name));
}

} // namespace

class BetweenSlicesDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("between"));
    }

    /// It says what is drawn and how much lies between; what it said is what it fills.
    void saysWhatItFills()
    {
        Fixture fixture;
        const QAction& action =
            fixture.window.actionTable()[QStringLiteral("segments.fillBetween")];
        QCOMPARE(action.text(), QStringLiteral("Fill between slices of 'Organ' …"));
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QVERIFY(dialog.isVisible() && !dialog.isModal());
        QVERIFY(dialog.windowType() == Qt::Tool); // the window's keys work in it, too
        QCOMPARE(textOf(dialog, "betweenWhose"), QStringLiteral("Organ"));
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"), QStringLiteral("Drawn: axial slices 9, 17"));
        const QString promised = textOf(dialog, "betweenResult");
        const std::int64_t before = fixture.voxels();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&buttonOf(dialog, "applyBetween"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        const std::int64_t gained = fixture.voxels() - before;
        QVERIFY(gained > 0);
        const double millilitres =
            double(gained) * fixture.workspace.volume()->geometry.voxelVolumeMm3() / 1000.0;
        QCOMPARE(promised,
            QStringLiteral("Fills 7 empty slices: %1 voxels, %2")
                .arg(ui::countText(gained), ui::volumeText(millilitres)));
        const auto& edit = fixture.lastRow().edit.get<core::FillBetweenSlices>();
        QCOMPARE(edit.segment, 1);
        QVERIFY(!edit.axis);
        QCOMPARE(said.front().front().toString(),
            fixture.lastRow().name + QStringLiteral("; Ctrl+Z takes it back"));
        // It looks again by itself: now nothing is left, and after undo it is as before.
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"),
            QStringLiteral("No slice between drawn ones is empty."));
        QVERIFY(!buttonOf(dialog, "applyBetween").isEnabled());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QTRY_COMPARE(textOf(dialog, "betweenResult"), promised);
        QVERIFY(buttonOf(dialog, "applyBetween").isEnabled());
        QCOMPARE(fixture.voxels(), before);
    }

    /// Seen before it is filled, anew with every slice that is drawn, and taken as it is seen.
    void isSeenBeforeItIsFilled()
    {
        Fixture fixture;
        const std::int64_t before = fixture.voxels();
        const std::size_t rows = fixture.rows();
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QTRY_VERIFY(textOf(dialog, "betweenNow").endsWith(u')'));
        QVERIFY(fixture.session().isOpen<core::FillBetweenSlices>());
        QCOMPARE(fixture.labelIn(12), 1);
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.voxels(), before);
        const QString promised = textOf(dialog, "betweenResult");
        QVERIFY(promised.startsWith(QStringLiteral("Fills 7 empty slices")));

        // One more slice: the preview goes, and comes again with it.
        fixture.draw(12, 1.2);
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.labelIn(11), 0);
        QTRY_VERIFY(textOf(dialog, "betweenResult").startsWith(QStringLiteral("Fills 6")));
        QTRY_VERIFY(textOf(dialog, "betweenNow").endsWith(u')'));
        QCOMPARE(fixture.labelIn(11), 1);
        auto* box = dialog.findChild<QCheckBox*>(QStringLiteral("betweenPreview"));
        box->setChecked(false);
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.labelIn(11), 0);
        QVERIFY(textOf(dialog, "betweenNow").startsWith(QStringLiteral("Now: ")));
        box->setChecked(true);
        QTRY_COMPARE(fixture.labelIn(11), 1);

        QTest::mouseClick(&buttonOf(dialog, "applyBetween"), Qt::LeftButton);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 2);
        QCOMPARE(fixture.labelIn(11), 1);
        Fixture recipe;
        recipe.draw(12, 1.2);
        recipe.apply(core::FillBetweenSlices{.segment = 1});
        QCOMPARE(fixture.session().stateHash(), recipe.session().stateHash());
        // Nothing is left to be filled; undone, it is seen again until the dialog closes.
        QTRY_VERIFY(!buttonOf(dialog, "applyBetween").isEnabled());
        QVERIFY(fixture.session().undo());
        QTRY_COMPARE(fixture.labelIn(11), 0);
        QTRY_COMPARE(fixture.labelIn(11), 1);
        dialog.reject();
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.labelIn(11), 0);
        QCOMPARE(fixture.rows(), rows + 2);
    }

    /// While another preview is seen it cannot look; it does once that is gone.
    void looksWhenAnotherPreviewIsGone()
    {
        Fixture fixture;
        QVERIFY(fixture.session().begin(core::MirrorSegment{.segment = 1}));
        const ui::BetweenSlicesDialog& dialog = fixture.opened();
        QTRY_VERIFY(fixture.session().openHasBegun());
        QVERIFY(textOf(dialog, "betweenResult").isEmpty());
        fixture.session().end(core::Ending::Rollback);
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"), QStringLiteral("Drawn: axial slices 9, 17"));
    }

    /// Another slice, another axis: it follows both.
    void followsTheSegmentAndTheAxis()
    {
        Fixture fixture;
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"), QStringLiteral("Drawn: axial slices 9, 17"));
        fixture.draw(17, 3.0);
        fixture.draw(12, 5.0);
        QTRY_COMPARE(
            textOf(dialog, "betweenDrawn"), QStringLiteral("Drawn: axial slices 9, 13, 17–18"));
        auto* axis = dialog.findChild<QComboBox*>(QStringLiteral("betweenAxis"));
        QCOMPARE(axis->count(), 4);
        axis->setCurrentText(QStringLiteral("Between coronal slices"));
        QTRY_VERIFY2(
            textOf(dialog, "betweenDrawn").startsWith(QStringLiteral("Drawn: coronal slices ")),
            qPrintable(textOf(dialog, "betweenDrawn")));
        QVERIFY(!buttonOf(dialog, "applyBetween").isEnabled()); // a disc has no gap
        QCOMPARE(
            buttonOf(dialog, "applyBetween").toolTip(), QStringLiteral("there is nothing to fill"));
        axis->setCurrentText(QStringLiteral("Between axial slices"));
        QTRY_VERIFY(buttonOf(dialog, "applyBetween").isEnabled()
            && textOf(dialog, "betweenResult").startsWith(QStringLiteral("Fills 6 empty slices")));
        QTest::keyClick(&buttonOf(dialog, "applyBetween"), Qt::Key_Space);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastRow().edit.get<core::FillBetweenSlices>().axis == core::SliceAxis::K);
    }

    /// Strokes on slices of several directions: it names them all, fills what lies between, and
    /// goes on with each stroke; a dab that touches up a slice of another direction changes
    /// nothing.
    void takesPlanesOfSeveralDirections()
    {
        Fixture fixture;
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const glm::dvec3 middle = geometry.toWorld(glm::dvec3(20.0, 18.0, 12.0));
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"), QStringLiteral("Drawn: axial slices 9, 17"));
        fixture.apply(test::paintDiscAt(1, middle, geometry.direction()[0], 0.5));
        QTRY_VERIFY2(
            textOf(dialog, "betweenDrawn").startsWith(QStringLiteral("Drawn: axial slices 9, 13")),
            qPrintable(textOf(dialog, "betweenDrawn")));
        QVERIFY(!textOf(dialog, "betweenDrawn").contains(u'·'));
        fixture.apply(test::paintDiscAt(1, middle, geometry.direction()[1], 5.0));
        QTRY_VERIFY2(textOf(dialog, "betweenDrawn")
                         .startsWith(QStringLiteral("Drawn: axial slices 9, 17 · coronal slices ")),
            qPrintable(textOf(dialog, "betweenDrawn")));
        QTRY_VERIFY(textOf(dialog, "betweenResult")
                        .startsWith(QStringLiteral("Fills what lies between: ")));
        QTRY_VERIFY(fixture.session().isOpen<core::FillBetweenSlices>());
        fixture.apply(test::paintDiscAt(1, middle, glm::dvec3(1.0, 1.0, 0.6), 5.0));
        QTRY_VERIFY2(textOf(dialog, "betweenDrawn").endsWith(QStringLiteral(" · 1 oblique slice")),
            qPrintable(textOf(dialog, "betweenDrawn")));
        const QString promised = textOf(dialog, "betweenResult");
        const std::int64_t before = fixture.voxels();
        QTest::mouseClick(&buttonOf(dialog, "applyBetween"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        const std::int64_t gained = fixture.voxels() - before;
        QVERIFY(gained > 0);
        QVERIFY2(
            promised.startsWith(
                QStringLiteral("Fills what lies between: %1 voxels, ").arg(ui::countText(gained))),
            qPrintable(promised));
        const auto edit = fixture.lastRow().edit.get<core::FillBetweenSlices>();
        QVERIFY(edit.planes && edit.planes->size() == 4 && !edit.axis);
        // Whoever chooses an axis gets the slices across it.
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        dialog.findChild<QComboBox*>(QStringLiteral("betweenAxis"))
            ->setCurrentText(QStringLiteral("Between axial slices"));
        QTRY_VERIFY(textOf(dialog, "betweenResult").endsWith(QStringLiteral(" mL"))
            && textOf(dialog, "betweenDrawn").startsWith(QStringLiteral("Drawn: axial slices ")));
        QVERIFY(!textOf(dialog, "betweenDrawn").contains(u'·'));
    }

    /// What cannot be filled says why.
    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QPushButton& apply = buttonOf(dialog, "applyBetween");
        QTRY_VERIFY(textOf(dialog, "betweenResult").startsWith(QStringLiteral("Fills ")));
        fixture.apply(test::lockSegment(1));
        QVERIFY(!apply.isEnabled());
        QCOMPARE(apply.toolTip(), QStringLiteral("'Organ' is locked"));
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.fillBetween")].isEnabled());
        fixture.workspace.setActiveSegment(2);
        QCOMPARE(textOf(fixture.opened(), "betweenWhose"), QStringLiteral("Empty"));
        QTRY_COMPARE(textOf(dialog, "betweenDrawn"),
            QStringLiteral("No slice between drawn ones is empty."));
        QCOMPARE(textOf(dialog, "betweenResult"),
            QStringLiteral("Draw the segment on some slices first, with empty ones between them."));
        QCOMPARE(fixture.window.findChildren<ui::BetweenSlicesDialog*>().size(), 1);
        // Out of sight it looks at nothing.
        dialog.close();
        QCOMPARE(textOf(dialog, "betweenWhose"), QStringLiteral("Empty"));
        fixture.apply(test::lockSegment(1, false));
        QVERIFY(!dialog.isVisible());
    }

    void abortedOnTheWay()
    {
        Fixture fixture;
        const std::int64_t before = fixture.voxels();
        const std::size_t rows = fixture.session().history().rows().size();
        ui::BetweenSlicesDialog& dialog = fixture.opened();
        QTRY_VERIFY(textOf(dialog, "betweenResult").startsWith(QStringLiteral("Fills ")));
        QPushButton& abort = buttonOf(dialog, "abortBetween");
        QVERIFY(!abort.isEnabled());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        // Not through the window, whose events would let the work go on.
        buttonOf(dialog, "applyBetween").click();
        QVERIFY(abort.isEnabled());
        abort.click();
        const core::Result<void> settled = fixture.session().settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == core::ErrorCode::Cancelled);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(fixture.voxels(), before);
        QTRY_VERIFY(!abort.isEnabled());
    }
};

BURIN_WINDOW_TEST(BetweenSlicesDialogUiTest)

} // namespace betweenSlicesDialogUiTest

#include "BetweenSlicesDialogUiTest.moc"
