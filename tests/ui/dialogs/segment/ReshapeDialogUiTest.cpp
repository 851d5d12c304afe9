// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ReshapeDialog.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/SegmentWork.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"
#include "ui/panels/lists/SegmentsPanel.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <memory>

namespace reshapeDialogUiTest {

namespace {

/// Brain has grown, bone has a dab.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        window.addPanel(new ui::SegmentsPanel(workspace));
        window.showPanels(true);
        for (const core::Edit& edit : std::vector<core::Edit>{test::addSegment("Brain"),
                 test::addSegment("Bone"), test::seedInBrain(1), test::growBrain(),
                 test::paintAt(2, test::pointsInBone(), 1.5)})
            apply(edit);
        workspace.setActiveSegment(1);
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    [[nodiscard]] const core::HistoryRow& lastRow() { return session().history().rows().back(); }
    [[nodiscard]] ui::ReshapeDialog* dialog() { return window.findChild<ui::ReshapeDialog*>(); }
    /// The dialog after the menu Segments has opened it.
    [[nodiscard]] ui::ReshapeDialog& opened(const char* action)
    {
        window.actionTable()[QLatin1String(action)].trigger();
        return *dialog();
    }
    /// The labels as they are seen, also in what is no step yet.
    [[nodiscard]] std::vector<std::uint8_t> labels()
    {
        const auto reader =
            std::make_shared<core::LabelReader>(workspace.volume()->geometry.size, 0);
        bool isAsked = true;
        while (isAsked) {
            bool isAnswered = false;
            isAsked = session().questions().readOn(
                reader, [&isAnswered](const core::Result<void>&) { isAnswered = true; });
            while (isAsked && !isAnswered)
                session().poll();
        }
        const core::VoxelsAllowed allowed; // the study is a small one
        return reader->takeLabels();
    }
    /// With nobody to wake the window, so that what is worked out stays so.
    [[nodiscard]] bool waitUntilItIsWorkedOut()
    {
        wakeUp.stop();
        return QTest::qWaitFor([this] { return session().isOpen<core::ReshapeSegment>(); })
            && !session().openHasBegun();
    }
    [[nodiscard]] QString sizeOf(std::int64_t voxels)
    {
        return ui::volumeText(
            double(voxels) * workspace.volume()->geometry.voxelVolumeMm3() / 1000.0);
    }

    QTimer wakeUp;
};

QComboBox& operationOf(const QWidget& dialog)
{
    return *dialog.findChild<QComboBox*>(QStringLiteral("reshapeOperation"));
}

QDoubleSpinBox& mmOf(const QWidget& dialog)
{
    return *dialog.findChild<QDoubleSpinBox*>(QStringLiteral("reshapeMm"));
}

QPushButton& buttonOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QPushButton*>(QLatin1String(name));
}

QString whoseOf(const QWidget& dialog)
{
    return dialog.findChild<QLabel*>(QStringLiteral("reshapeWhose"))->text();
}

QCheckBox& previewOf(const QWidget& dialog)
{
    return *dialog.findChild<QCheckBox*>(QStringLiteral("reshapePreview"));
}

/// What it says of the segment's size.
QString nowOf(const QWidget& dialog)
{
    return dialog.findChild<QLabel*>(QStringLiteral("reshapeNow"))->text();
}

void press(QPushButton& button)
{
    QTest::mouseClick(&button, Qt::LeftButton);
}

} // namespace

class ReshapeDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("reshape"));
    }

    /// From the menu bar: the active segment grows, the dialog stays, and undo brings all back.
    void theActiveSegmentGrows()
    {
        Fixture fixture;
        const std::int64_t before = fixture.voxels(1);
        const QAction& action = fixture.window.actionTable()[QStringLiteral("segments.margin")];
        QCOMPARE(action.text(), QStringLiteral("Grow or shrink 'Brain' by a margin …"));
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QVERIFY(dialog.isVisible() && !dialog.isModal());
        QVERIFY(dialog.windowType() == Qt::Tool); // the window's keys work in it, too
        QCOMPARE(whoseOf(dialog), QStringLiteral("Brain"));
        QCOMPARE(operationOf(dialog).currentText(), QStringLiteral("Grow by a margin"));
        QCOMPARE(mmOf(dialog).value(), 2.0);
        mmOf(dialog).setValue(1.5);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        press(buttonOf(dialog, "applyReshape"));
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        const std::int64_t after = fixture.voxels(1);
        QVERIFY(after > before);
        QVERIFY2(fixture.lastRow().name.startsWith(QLatin1String("Grow 'Brain' by 1.5 mm, +")),
            qPrintable(fixture.lastRow().name));
        QCOMPARE(said.front().front().toString(),
            fixture.lastRow().name + QStringLiteral("; Ctrl+Z takes it back"));
        QVERIFY(dialog.isVisible());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), before);
    }

    /// The pressed key of the default button does the same; another operation has its own size,
    /// and each finds its last one again, in another window, too.
    void sizesAreRemembered()
    {
        {
            Fixture fixture;
            ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
            QComboBox& operation = operationOf(dialog);
            operation.setCurrentText(QStringLiteral("Shrink by a margin"));
            QCOMPARE(mmOf(dialog).value(), 2.0);
            mmOf(dialog).setValue(3.25);
            QTest::keyClick(&mmOf(dialog), Qt::Key_Return);
            QVERIFY(fixture.session().settle());
            QVERIFY2(
                fixture.lastRow().name.startsWith(QStringLiteral("Shrink 'Brain' by 3.25 mm, −")),
                qPrintable(fixture.lastRow().name));
            operation.setCurrentText(QStringLiteral("Smooth by closing"));
            QCOMPARE(mmOf(dialog).value(), 1.5);
            operation.setCurrentText(QStringLiteral("Shrink by a margin"));
            QCOMPARE(mmOf(dialog).value(), 3.25);
        }
        Fixture anew;
        ui::ReshapeDialog& dialog = anew.opened("segments.margin");
        QCOMPARE(mmOf(dialog).value(), 2.0);
        operationOf(dialog).setCurrentText(QStringLiteral("Shrink by a margin"));
        QCOMPARE(mmOf(dialog).value(), 3.25);
    }

    /// Every entry of the list is the edit that it says.
    void eachChoiceIsItsEdit_data()
    {
        using core::ShapeOperation;
        using core::ShellPlace;
        QTest::addColumn<QString>("text");
        QTest::addColumn<core::ShapeOperation>("operation");
        QTest::addColumn<int>("shell"); // less than 0: none
        const auto row = [](const char* text, ShapeOperation operation, int shell = -1) {
            QTest::newRow(text) << QString::fromUtf8(text) << operation << shell;
        };
        row("Grow by a margin", ShapeOperation::Grow);
        row("Shrink by a margin", ShapeOperation::Shrink);
        row("Hollow: a shell inside its border", ShapeOperation::Hollow, int(ShellPlace::Inside));
        row("Hollow: a shell along its border", ShapeOperation::Hollow, int(ShellPlace::Centred));
        row("Hollow: a shell outside its border", ShapeOperation::Hollow, int(ShellPlace::Outside));
        row("Smooth by majority", ShapeOperation::Median);
        row("Smooth by a Gaussian", ShapeOperation::Gaussian);
        row("Smooth all shown segments together", ShapeOperation::Gaussian);
        row("Smooth by opening", ShapeOperation::Open);
        row("Smooth by closing", ShapeOperation::Close);
        row("Wrap and make solid", ShapeOperation::Wrap);
    }
    void eachChoiceIsItsEdit()
    {
        QFETCH(const QString, text);
        QFETCH(const core::ShapeOperation, operation);
        QFETCH(const int, shell);
        Fixture fixture;
        // A hole and a speck, so that each of them finds something to do.
        const glm::dvec3 middle = test::pointsInBrain().front();
        fixture.apply(test::eraseAt(1, {middle}, 1.2));
        fixture.apply(test::paintAt(1, {glm::dvec3(-18.0, -16.0, 106.0)}, 1.2));
        ui::ReshapeDialog& dialog = fixture.opened("segments.smooth");
        QComboBox& choice = operationOf(dialog);
        QCOMPARE(choice.count(), 11);
        choice.setCurrentText(text);
        QCOMPARE(choice.currentText(), text);
        mmOf(dialog).setValue(2.0);
        const std::size_t rows = fixture.session().history().rows().size();
        press(buttonOf(dialog, "applyReshape"));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        const auto& edit = fixture.lastRow().edit.get<core::ReshapeSegment>();
        QCOMPARE(edit.segment, 1);
        QVERIFY(edit.operation == operation);
        QCOMPARE(edit.mm, 2.0);
        QCOMPARE(edit.shell.has_value(), shell >= 0);
        QVERIFY(!edit.shell || int(*edit.shell) == shell);
        const bool isJoint = text == QStringLiteral("Smooth all shown segments together");
        QCOMPARE(edit.with.value_or(std::vector<int>()),
            isJoint ? std::vector<int>{2} : std::vector<int>());
    }

    /// All that are shown are smoothed together, also where they overlap; those that are hidden or
    /// locked are not.
    void overlappingOnesAreSmoothedTogether()
    {
        Fixture fixture;
        fixture.apply(core::AddSegment{.name = QStringLiteral("Lobe"), .plane = 1});
        fixture.apply(test::paintAt(3, {test::pointsInBrain().front()}, 4.0));
        fixture.apply(core::AddSegment{.name = QStringLiteral("Locked"), .plane = 1});
        fixture.apply(test::lockSegment(4));
        fixture.workspace.setActiveSegment(1);
        ui::ReshapeDialog& dialog = fixture.opened("segments.smooth");
        operationOf(dialog).setCurrentText(QStringLiteral("Smooth all shown segments together"));
        mmOf(dialog).setValue(2.0);
        const std::int64_t lobe = fixture.voxels(3);
        press(buttonOf(dialog, "applyReshape"));
        QVERIFY(fixture.session().settle());
        QCOMPARE(
            fixture.lastRow().edit.get<core::ReshapeSegment>().with.value_or(std::vector<int>()),
            (std::vector<int>{2, 3}));
        QVERIFY(fixture.voxels(3) != lobe);
    }

    /// Margins by side are there for margins alone; they begin with the one margin, and what is set
    /// is what is done.
    void marginsBySides()
    {
        Fixture fixture;
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        auto* bySides = dialog.findChild<QCheckBox*>(QStringLiteral("reshapeBySides"));
        auto* fields = dialog.findChild<QWidget*>(QStringLiteral("reshapeSides"));
        QVERIFY(bySides && bySides->isVisible() && fields && !fields->isVisible());
        mmOf(dialog).setValue(1.5);
        bySides->setChecked(true);
        QVERIFY(fields->isVisible() && !mmOf(dialog).isEnabled());
        const auto sideOf = [&](int side) {
            return dialog.findChild<QDoubleSpinBox*>(QStringLiteral("reshapeSide%1").arg(side));
        };
        for (int side = 0; side < 6; ++side)
            QCOMPARE(sideOf(side)->value(), 1.5);
        sideOf(1)->setValue(4.25);
        sideOf(3)->setValue(0.0);
        press(buttonOf(dialog, "applyReshape"));
        QVERIFY(fixture.session().settle());
        QVERIFY2(fixture.lastRow().name.startsWith(
                     QLatin1String("Grow 'Brain' by margins of up to 4.25 mm, +")),
            qPrintable(fixture.lastRow().name));
        const auto& edit = fixture.lastRow().edit.get<core::ReshapeSegment>();
        QCOMPARE(edit.sides.rightMm.value_or(-1.0), 1.5);
        QCOMPARE(edit.sides.leftMm.value_or(-1.0), 4.25);
        QCOMPARE(edit.sides.posteriorMm.value_or(-1.0), 0.0);
        QCOMPARE(edit.sides.superiorMm.value_or(-1.0), 1.5);
        operationOf(dialog).setCurrentText(QStringLiteral("Smooth by closing"));
        QVERIFY(!bySides->isVisible() && !fields->isVisible() && mmOf(dialog).isEnabled());
        operationOf(dialog).setCurrentText(QStringLiteral("Shrink by a margin"));
        QVERIFY(fields->isVisible());
        bySides->setChecked(false);
        QVERIFY(!fields->isVisible() && mmOf(dialog).isEnabled());
    }

    /// The menu of a row asks about that row's segment, and each entry begins with its operation.
    void aRowAsksAboutItsSegment()
    {
        Fixture fixture;
        auto* list = fixture.window.findChild<QListView*>(QStringLiteral("segmentList"));
        const QPoint at = list->visualRect(list->model()->index(1, 0)).center();
        bool found = false;
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            const QMenu* cleanUp = nullptr;
            for (QMenu* each : menu->findChildren<QMenu*>()) {
                if (each->title() == QStringLiteral("Clean up"))
                    cleanUp = each;
            }
            QVERIFY(cleanUp);
            for (QAction* each : cleanUp->actions()) {
                if (each->text() == QStringLiteral("Hollow …")) {
                    found = true;
                    each->trigger();
                    break;
                }
            }
            menu->close();
        });
        Q_EMIT list->customContextMenuRequested(at);
        QVERIFY(found && fixture.dialog());
        QCOMPARE(whoseOf(*fixture.dialog()), QStringLiteral("Bone"));
        QCOMPARE(operationOf(*fixture.dialog()).currentText(),
            QStringLiteral("Hollow: a shell inside its border"));
        QCOMPARE(operationOf(fixture.opened("segments.smooth")).currentText(),
            QStringLiteral("Smooth by majority"));
        QCOMPARE(whoseOf(*fixture.dialog()), QStringLiteral("Brain"));
        QCOMPARE(fixture.window.findChildren<ui::ReshapeDialog*>().size(), 1);
    }

    /// Seen before it is a step, with its size; taken as it is seen, and the recipe's equal.
    void isSeenBeforeItIsAStep()
    {
        Fixture fixture;
        fixture.wakeUp.start(10);
        const std::vector<std::uint8_t> first = fixture.labels();
        const std::int64_t before = fixture.voxels(1);
        const std::size_t rows = fixture.rows();
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QCOMPARE(nowOf(dialog), QStringLiteral("Preview: %1 → …").arg(fixture.sizeOf(before)));
        QTRY_VERIFY2(nowOf(dialog).endsWith(u')'), qPrintable(nowOf(dialog)));
        const std::vector<std::uint8_t> seen = fixture.labels();
        const std::int64_t after = std::count(seen.begin(), seen.end(), std::uint8_t(1));
        QVERIFY(after > before && seen != first);
        QCOMPARE(nowOf(dialog),
            QStringLiteral("Preview: %1 → %2 (+%3)")
                .arg(
                    fixture.sizeOf(before), fixture.sizeOf(after), fixture.sizeOf(after - before)));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.voxels(1), before);
        QVERIFY(fixture.session().openIsPreview());

        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        press(buttonOf(dialog, "applyReshape"));
        QVERIFY(!fixture.session().openEdit());
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.labels(), seen);
        QCOMPARE(said.front().front().toString(),
            fixture.lastRow().name + QStringLiteral("; Ctrl+Z takes it back"));
        QTRY_COMPARE(nowOf(dialog), QStringLiteral("Now: %1").arg(fixture.sizeOf(after)));
        Fixture recipe;
        recipe.apply(core::ReshapeSegment{.segment = 1, .mm = 2.0});
        QCOMPARE(fixture.session().stateHash(), recipe.session().stateHash());
        // What was taken is not done once more by itself.
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.labels(), first);
        QTRY_COMPARE(nowOf(dialog), QStringLiteral("Now: %1").arg(fixture.sizeOf(before)));
    }

    /// It follows the fields; switched off, closed, or when anything else is done, all is as
    /// before.
    void thePreviewFollows()
    {
        Fixture fixture;
        fixture.wakeUp.start(10);
        const std::vector<std::uint8_t> first = fixture.labels();
        const QByteArray hash = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        const auto seen = [&](double mm) {
            return QTest::qWaitFor([&] {
                const core::Edit* open = fixture.session().openEdit();
                const auto* edit = open ? open->as<core::ReshapeSegment>() : nullptr;
                return edit && edit->mm == mm && nowOf(dialog).endsWith(u')');
            });
        };
        QVERIFY(seen(2.0));
        const std::vector<std::uint8_t> byTwo = fixture.labels();
        mmOf(dialog).setValue(3.0);
        QVERIFY(nowOf(dialog).endsWith(QStringLiteral("→ …")));
        QVERIFY(seen(3.0) && fixture.labels() != byTwo);
        mmOf(dialog).setValue(2.0);
        QVERIFY(seen(2.0) && fixture.labels() == byTwo);
        operationOf(dialog).setCurrentText(QStringLiteral("Shrink by a margin"));
        QVERIFY(QTest::qWaitFor([&] { return nowOf(dialog).contains(QStringLiteral("(−")); }));
        QVERIFY(fixture.labels() != byTwo);
        previewOf(dialog).setChecked(false);
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.labels(), first);
        QVERIFY(nowOf(dialog).startsWith(QStringLiteral("Now: ")));
        mmOf(dialog).setValue(1.0);
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        previewOf(dialog).setChecked(true);
        QVERIFY(seen(1.0));
        dialog.reject();
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
        QCOMPARE(fixture.rows(), rows);

        // What is done meanwhile takes it back; the next change of a field shows it again.
        QVERIFY(&fixture.opened("segments.margin") == &dialog);
        QVERIFY(seen(2.0));
        fixture.apply(test::addSegment("Third"));
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.labels(), first);
        QTRY_VERIFY(nowOf(dialog).startsWith(QStringLiteral("Now: ")));
        mmOf(dialog).setValue(2.5);
        QVERIFY(seen(2.5));
        dialog.close();
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.rows(), rows + 1);
    }

    void theBoxIsRemembered()
    {
        for (const bool isOn : {true, false, true}) {
            Fixture fixture;
            ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
            QCOMPARE(previewOf(dialog).isChecked(), isOn);
            previewOf(dialog).setChecked(!isOn);
        }
    }

    /// What is being worked out is taken, too: nothing is begun anew.
    void takenWhileItIsWorkedOut()
    {
        Fixture fixture;
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QVERIFY(fixture.waitUntilItIsWorkedOut());
        QPushButton& apply = buttonOf(dialog, "applyReshape");
        QVERIFY(apply.isEnabled() && buttonOf(dialog, "abortReshape").isEnabled());
        apply.click();
        QVERIFY(!fixture.session().openEdit() && fixture.session().segmentWork().percent());
        QVERIFY(!apply.isEnabled());
        const std::size_t rows = fixture.rows();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        Fixture recipe;
        recipe.apply(core::ReshapeSegment{.segment = 1, .mm = 2.0});
        QCOMPARE(fixture.session().stateHash(), recipe.session().stateHash());
    }

    /// Another field, or Abort, drops it at once; only who aborts is told.
    void whatIsWorkedOutIsDropped()
    {
        Fixture fixture;
        const QByteArray hash = fixture.session().stateHash();
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QVERIFY(fixture.waitUntilItIsWorkedOut());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        mmOf(dialog).setValue(4.0);
        QVERIFY(!fixture.session().openEdit() && !fixture.session().segmentWork().percent());
        QVERIFY(fixture.waitUntilItIsWorkedOut());
        QCOMPARE(fixture.session().openEdit()->get<core::ReshapeSegment>().mm, 4.0);
        QCOMPARE(failed.size(), 0);
        fixture.wakeUp.start(10);
        QTRY_VERIFY(nowOf(dialog).endsWith(u')'));
        // The one before is gone first: a poll that the next one needs could also be the one in
        // which what it has worked out begins to be written, after which nothing is dropped.
        previewOf(dialog).setChecked(false);
        QVERIFY(fixture.session().settle());
        mmOf(dialog).setValue(3.0);
        previewOf(dialog).setChecked(true);
        QVERIFY(fixture.waitUntilItIsWorkedOut());
        QTRY_VERIFY(buttonOf(dialog, "abortReshape").isEnabled());
        buttonOf(dialog, "abortReshape").click();
        fixture.wakeUp.start(10);
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!fixture.session().openEdit() && !fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
        QTRY_VERIFY(nowOf(dialog).startsWith(QStringLiteral("Now: ")));
        QTRY_VERIFY(!buttonOf(dialog, "abortReshape").isEnabled());
        QVERIFY(buttonOf(dialog, "applyReshape").isEnabled());
    }

    /// What cannot be changed says why; what has nothing to be done is told.
    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QPushButton& apply = buttonOf(dialog, "applyReshape");
        QVERIFY(apply.isEnabled());
        fixture.apply(test::lockSegment(1));
        QVERIFY(!apply.isEnabled());
        QCOMPARE(apply.toolTip(), QStringLiteral("'Brain' is locked"));
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.margin")].isEnabled());
        fixture.apply(test::lockSegment(1, false));
        QVERIFY(apply.isEnabled());
        fixture.apply(core::RemoveSegment{.segment = 1});
        QVERIFY(!apply.isEnabled());
        QCOMPARE(apply.toolTip(), QStringLiteral("there is no segment"));

        fixture.apply(test::addSegment("Empty"));
        fixture.workspace.setActiveSegment(3);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        press(buttonOf(fixture.opened("segments.margin"), "applyReshape"));
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Empty' stays as it is"));
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void abortedOnTheWay()
    {
        Fixture fixture;
        const std::int64_t before = fixture.voxels(1);
        const std::size_t rows = fixture.session().history().rows().size();
        ui::ReshapeDialog& dialog = fixture.opened("segments.margin");
        QPushButton& abort = buttonOf(dialog, "abortReshape");
        QVERIFY(!abort.isEnabled());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        // Not through the window, whose events would let the work go on.
        buttonOf(dialog, "applyReshape").click();
        QVERIFY(abort.isEnabled());
        abort.click();
        const core::Result<void> settled = fixture.session().settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == core::ErrorCode::Cancelled);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(fixture.voxels(1), before);
        QTRY_VERIFY(!abort.isEnabled());
    }
};

BURIN_WINDOW_TEST(ReshapeDialogUiTest)

} // namespace reshapeDialogUiTest

#include "ReshapeDialogUiTest.moc"
