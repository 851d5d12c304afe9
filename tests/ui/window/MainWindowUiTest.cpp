// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/dialogs/study/OpenStudyDialog.h"
#include "ui/frame/MessageBar.h"
#include "ui/frame/StartPage.h"
#include "ui/frame/ToolColumn.h"
#include "ui/overlays/CautionStrip.h"
#include "ui/panels/VolumePanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/OptionBar.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mainWindowUiTest {

class MainWindowUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void titleSaysWhoseStudy();
    void textsOfAStudy();
    void narrowRangesHaveTheirDecimals();
    void cautionStaysUntilAccepted();
    void theDoctorsAnswerClosesIt();
    void undoSaysWhatItUndoes();
    void undoKeepsItsWidth();
    void layoutsAreInAButton();
    void digitsAreWindowPresets();
    void closingShowsTheStartPage();
    void listOfVolumesChoosesNothing();
    void pointsInTimeAreChosen();
    void openingTellsWhyNot();
    void toolsFitALowWindow();
};

void MainWindowUiTest::toolsFitALowWindow()
{
    QWidget window;
    auto* row = new QHBoxLayout(&window);
    auto* tools = new ui::ToolColumn(&window);
    row->addWidget(tools);
    for (int i = 0; i < 12; ++i) {
        if (i % 4 == 3)
            tools->addGroupLine();
        auto* action = new QAction(QStringLiteral("Tool %1").arg(i), tools);
        tools->addTool(*action, QStringLiteral("Tool"));
    }
    window.show();
    const QList<QToolButton*> buttons = tools->findChildren<QToolButton*>();
    QCOMPARE(buttons.size(), 12);
    for (const int height : {560, 1000, 560}) {
        window.resize(100, height);
        QTRY_COMPARE(window.height(), height);
        // Names where there is room for them, and every tool within reach.
        const Qt::ToolButtonStyle style =
            height == 1000 ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly;
        for (const QToolButton* button : buttons) {
            QTRY_COMPARE(button->toolButtonStyle(), style);
            QTRY_VERIFY(tools->rect().contains(button->geometry()));
        }
    }
}

void MainWindowUiTest::titleSaysWhoseStudy()
{
    test::WindowFixture fixture(test::headFirstSupine());
    const QString title = fixture.window.windowTitle();
    for (const char* part :
        {"TEST, WINDOW", "T-0815", "1961-02-03", "2026-11-20", "series 3", "Plain"})
        QVERIFY2(title.contains(QLatin1String(part)), part);
}

void MainWindowUiTest::textsOfAStudy()
{
    QCOMPARE(ui::personName(QStringLiteral("Doe^Jane^A^Dr")), QStringLiteral("Doe, Jane A Dr"));
    QCOMPARE(ui::personName(QStringLiteral("Doe^^^^")), QStringLiteral("Doe"));
    QCOMPARE(ui::numberText(-0.04, 1), QStringLiteral("0.0"));
    QCOMPARE(ui::numberText(-12.5, 1), QString(QChar(0x2212)) + QStringLiteral("12.5"));
    QCOMPARE(ui::valueText(41.6, QStringLiteral("HU"), 4000.0), QStringLiteral("42 HU"));
    QCOMPARE(ui::valueText(0.1234, QString(), 0.5), QStringLiteral("0.1234"));
    QCOMPARE(ui::patientText({}), QStringLiteral("patient not named in the source"));
}

/// An ADC in mm²/s is 0.003 at most: its surface can be moved, and its texts tell it.
void MainWindowUiTest::narrowRangesHaveTheirDecimals()
{
    QCOMPARE(
        ui::valueText(0.00123, QStringLiteral("mm²/s"), 0.003), QStringLiteral("0.001230 mm²/s"));
    for (const auto& [span, decimals] :
        {std::pair(4000.0, 0), std::pair(100.0, 0), std::pair(99.0, 1), std::pair(5.0, 2),
            std::pair(0.5, 4), std::pair(0.003, 6), std::pair(1e-20, 8), std::pair(0.0, 4)})
        QCOMPARE(ui::decimalsForSpan(span), decimals);

    core::LoadedVolume loaded = test::plainCt(test::headFirstSupine());
    loaded.volume.encoding = {.rescaleSlope = 0.003 / 65535.0};
    loaded.volume.unit = QStringLiteral("mm²/s");
    loaded.volume.minimum = 0.0;
    loaded.volume.maximum = 0.003;
    loaded.volume.histogram.minimum = 0.0;
    loaded.volume.histogram.maximum = 0.003;
    test::WindowFixture fixture(loaded);
    const QString preset = fixture.window.actionTable()[QStringLiteral("window.preset2")].text();
    QVERIFY2(preset.contains(QStringLiteral("0.003000 / 0.001500")), qPrintable(preset));
    ui::VolumePanel panel(fixture.workspace);
    // The panel fills itself when a study opens.
    fixture.workspace.setSession(nullptr);
    auto session = core::EditSession::create(fixture.engine, loaded, {});
    QVERIFY(session);
    fixture.workspace.setSession(std::move(*session));
    auto* threshold = panel.findChild<QDoubleSpinBox*>(QStringLiteral("surfaceThreshold"));
    QVERIFY(threshold);
    for (const double value : {0.00123, 0.00124}) {
        threshold->setValue(value);
        QVERIFY(std::abs(fixture.workspace.volumeDisplay().surfaceThreshold - value) < 1e-6);
    }
}

void MainWindowUiTest::cautionStaysUntilAccepted()
{
    core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
    volume.volume.problems = {
        {core::VolumeProblem::Kind::Tilt,
            {core::ProblemCode::AsStored, {QStringLiteral("The slices are tilted by 12°.")}}, true},
        {core::VolumeProblem::Kind::LossyCompression,
            {core::ProblemCode::AsStored, {QStringLiteral("Lossy.")}}, false}};
    test::WindowFixture fixture(volume);
    ui::MessageBar& bar = fixture.window.messages();
    QVERIFY(bar.isVisible());
    QVERIFY(bar.sentence().contains(QStringLiteral("tilted by 12°")));
    QVERIFY(!ui::cautionText(volume.volume).contains(QStringLiteral("Lossy")));
    // Every view carries the strip; its colour is in no picture of this fixture's grey volume.
    const auto stripIn = [](ui::ImageView* view) {
        return view->grab().toImage().pixelColor(1, 90 + view->coveredTop())
            == QColor(0xf0, 0xb0, 0x4a);
    };
    for (ui::ImageView* view : fixture.window.views().views())
        QVERIFY2(stripIn(view), qPrintable(view->title()));
    auto buttons = bar.findChildren<QPushButton*>();
    QCOMPARE(buttons.size(), 1);
    // Each button says what it does, and only for this message.
    auto* close = bar.findChild<QToolButton*>(QStringLiteral("closeMessage"));
    const auto tellsOfTheCaution = [close, &buttons] {
        return close->toolTip().contains(QStringLiteral("the views keep their caution"))
            && buttons.front()->toolTip().contains(QStringLiteral("out of the views"));
    };
    QVERIFY(tellsOfTheCaution());
    // Closing it hides the message and answers nothing.
    QTest::mouseClick(close, Qt::LeftButton);
    QVERIFY(!bar.isVisible());
    QVERIFY(!fixture.workspace.cautionAccepted());
    for (ui::ImageView* view : fixture.window.views().views())
        QVERIFY2(stripIn(view), qPrintable(view->title()));
    // The series doctor calls it the same.
    QCOMPARE(buttons.front()->text(), QStringLiteral("Keep as it is"));
    fixture.workspace.setSession(nullptr);
    auto again = core::EditSession::create(fixture.engine, volume, {});
    QVERIFY(again);
    fixture.workspace.setSession(std::move(*again));
    QVERIFY(bar.isVisible());
    QTest::mouseClick(buttons.front(), Qt::LeftButton);
    QVERIFY(fixture.workspace.cautionAccepted());
    QVERIFY(!bar.isVisible());
    bar.show(ui::MessageBar::Kind::Notice, QStringLiteral("Something else"));
    QVERIFY(!tellsOfTheCaution());
    QCOMPARE(close->toolTip(), QStringLiteral("Close this message; nothing else changes"));
    QVERIFY(buttons.front()->toolTip().isEmpty());
    bar.dismiss();
    for (ui::ImageView* view : fixture.window.views().views())
        QVERIFY2(!stripIn(view), qPrintable(view->title()));
}

/// A caution that is answered elsewhere need not be answered here, too.
void MainWindowUiTest::theDoctorsAnswerClosesIt()
{
    core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
    volume.volume.problems = {{core::VolumeProblem::Kind::Tilt,
        {core::ProblemCode::AsStored, {QStringLiteral("The slices are tilted by 12°.")}}, true}};
    test::WindowFixture fixture(volume);
    ui::MessageBar& bar = fixture.window.messages();
    QVERIFY(bar.isVisible());
    // What another message says stays.
    const QString caution = bar.sentence();
    bar.show(ui::MessageBar::Kind::Error, QStringLiteral("Something else"));
    fixture.workspace.acceptCaution();
    QVERIFY(bar.isVisible());
    fixture.workspace.setSession(nullptr);
    auto again = core::EditSession::create(fixture.engine, volume, {});
    QVERIFY(again);
    fixture.workspace.setSession(std::move(*again));
    QVERIFY(bar.isVisible());
    QCOMPARE(bar.sentence(), caution);
    fixture.workspace.acceptCaution();
    QVERIFY(!bar.isVisible());
}

/// The tool and its options stay where they are, whatever the next step is called.
void MainWindowUiTest::undoKeepsItsWidth()
{
    test::WindowFixture fixture(test::headFirstSupine());
    const auto* bar = fixture.window.findChild<ui::OptionBar*>();
    QVERIFY(bar && bar->isVisible());
    QList<const QToolButton*> steps;
    for (const char* id : {"edit.undo", "edit.redo"}) {
        for (const QToolButton* button : bar->findChildren<QToolButton*>()) {
            if (button->defaultAction() == &fixture.window.actionTable()[QLatin1String(id)])
                steps += button;
        }
    }
    QCOMPARE(steps.size(), 2);
    const auto places = [&steps] {
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        return QList<QRect>{steps[0]->geometry(), steps[1]->geometry()};
    };
    const QList<QRect> before = places();
    QCOMPARE(steps[0]->text(), QStringLiteral("Undo"));
    QCOMPARE(before[0].width(), before[1].width());
    core::EditSession& session = *fixture.workspace.session();
    for (const char* name : {"A", "A segment whose name is as long as names are at times"}) {
        QVERIFY(session.apply(test::newSegment(QLatin1String(name), 0xffffff)));
        QVERIFY(session.settle());
        QVERIFY(steps[0]->text() != QStringLiteral("Undo"));
        QCOMPARE(places(), before);
    }
    QVERIFY(session.undo());
    QVERIFY(session.settle());
    QCOMPARE(places(), before);
    // What is cut is told whole by the tip.
    QVERIFY(steps[1]->toolTip().contains(QStringLiteral("as long as names are at times")));
}

void MainWindowUiTest::layoutsAreInAButton()
{
    test::WindowFixture fixture(test::headFirstSupine());
    auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("layouts"));
    QVERIFY(button && button->isVisible() && button->menu());
    ui::ViewGrid& views = fixture.window.views();
    QVERIFY(!views.maximised());
    // They are the menu's actions, so each says whether it is the present one.
    const auto entry = [&](const char* id) {
        QAction* action = &fixture.window.actionTable()[QLatin1String(id)];
        return button->menu()->actions().contains(action) ? action : nullptr;
    };
    QAction* axial = entry("view.axial");
    QAction* four = entry("view.four");
    QVERIFY(axial && four && four->isChecked() && !axial->isChecked());
    axial->trigger();
    QCOMPARE(views.maximised(), static_cast<ui::ImageView*>(&views.axial()));
    QVERIFY(axial->isChecked() && !four->isChecked());
    four->trigger();
    QVERIFY(!views.maximised() && four->isChecked());
    fixture.window.closeStudy();
    QVERIFY(!button->isVisible());
}

void MainWindowUiTest::undoSaysWhatItUndoes()
{
    test::WindowFixture fixture(test::headFirstSupine());
    QAction& undo = fixture.window.actionTable()[QStringLiteral("edit.undo")];
    QAction& redo = fixture.window.actionTable()[QStringLiteral("edit.redo")];
    QVERIFY(!undo.isEnabled());
    core::EditSession& session = *fixture.workspace.session();
    QVERIFY(session.apply(test::newSegment(QStringLiteral("Skull"), 0xffffff)));
    QVERIFY(session.settle());
    QVERIFY(undo.isEnabled());
    QVERIFY2(undo.text().contains(session.history().rows().front().name), qPrintable(undo.text()));
    undo.trigger();
    QVERIFY(session.settle());
    QVERIFY(!undo.isEnabled());
    QVERIFY(redo.isEnabled());
    QVERIFY(redo.text().contains(QStringLiteral("Skull")));
}

void MainWindowUiTest::digitsAreWindowPresets()
{
    test::WindowFixture fixture(test::headFirstSupine());
    fixture.window.actionTable()[QStringLiteral("window.preset5")].trigger();
    QCOMPARE(fixture.workspace.windowLevel(), (core::WindowLevel{40.0, 80.0}));
    QVERIFY(fixture.window.actionTable()[QStringLiteral("window.preset5")].isChecked());
}

void MainWindowUiTest::closingShowsTheStartPage()
{
    test::WindowFixture fixture(test::headFirstSupine());
    QVERIFY(fixture.window.views().isVisible());
    fixture.window.closeStudy();
    QVERIFY(!fixture.window.views().isVisible());
    QCOMPARE(fixture.window.windowTitle(), QStringLiteral("Burin"));
    QVERIFY(!fixture.window.actionTable()[QStringLiteral("file.close")].isEnabled());
}

void MainWindowUiTest::listOfVolumesChoosesNothing()
{
    core::StudyListing listing;
    listing.path = QStringLiteral("folder");
    core::SeriesEntry entry;
    entry.geometry.size = {4, 4, 4};
    entry.key = QStringLiteral("1.2.3");
    core::SeriesEntry other = entry;
    other.key = QStringLiteral("1.2.4");
    core::SeriesEntry single = entry;
    single.key = QStringLiteral("1.2.5");
    single.geometry.size.z = 1;
    listing.studies.push_back({QStringLiteral("1.2"), {entry, other, single}});
    listing.foreign.push_back({.kind = QStringLiteral("localizer"),
        .files = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}});
    ui::OpenStudyDialog dialog(listing);
    dialog.show();
    QVERIFY(dialog.chosenKey().isEmpty());
    auto* list = dialog.findChild<QTreeWidget*>();
    QCOMPARE(list->topLevelItemCount(), 2);
    // What is not offered is told, file by file.
    const auto labels = dialog.findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text()
            == QStringLiteral("Also found: 1 × single image (open its file), 3 × localizer");
    }));
    QVERIFY(!dialog.findChild<QComboBox*>()->isVisible());
    list->topLevelItem(1)->setSelected(true);
    QCOMPARE(dialog.chosenKey(), QStringLiteral("1.2.4"));
}

void MainWindowUiTest::pointsInTimeAreChosen()
{
    core::StudyListing listing;
    listing.path = QStringLiteral("folder");
    core::SeriesEntry entry;
    entry.geometry.size = {4, 4, 4};
    entry.key = QStringLiteral("1.2.3");
    entry.times = QStringList{QStringLiteral("trigger time 0 ms"), QString()};
    listing.studies.push_back({QStringLiteral("1.2"), {entry}});
    ui::OpenStudyDialog dialog(listing);
    dialog.show();
    auto* time = dialog.findChild<QComboBox*>();
    QVERIFY(time->isVisible());
    QCOMPARE(time->count(), 2);
    QCOMPARE(time->itemText(0), QStringLiteral("1 of 2: trigger time 0 ms"));
    QCOMPARE(time->itemText(1), QStringLiteral("2 of 2"));
    QCOMPARE(dialog.chosenKey(), QStringLiteral("1.2.3"));
    time->setCurrentIndex(1);
    QCOMPARE(dialog.chosenKey(), QStringLiteral("1.2.3@2"));
}

void MainWindowUiTest::openingTellsWhyNot()
{
    test::WindowFixture fixture(test::headFirstSupine());
    QSignalSpy finished(&fixture.window.opener(), &ui::StudyOpener::finished);
    fixture.window.opener().open(QStringLiteral("/no/such/folder"));
    QVERIFY(finished.wait(20000));
    QVERIFY(fixture.window.messages().sentence().contains(QStringLiteral("/no/such/folder")));
    QVERIFY(fixture.workspace.volume()); // what was open stays open
}

BURIN_WINDOW_TEST(MainWindowUiTest)

} // namespace mainWindowUiTest

#include "MainWindowUiTest.moc"
