// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/MessageBar.h"

#include "core/edits/kinds/segments/AddSegment.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Theme.h"
#include "ui/frame/StartPage.h"
#include "ui/views/ViewGrid.h"

#include <QImage>
#include <QTest>
#include <QToolButton>

#include <array>

namespace messageBarUiTest {

/// Messages at the top of the window.
class MessageBarUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void messagesLieOverThePictures();
    void onTheStartPageTheyHideNothing();
    void noticesGoByThemselves();
    void textsKeepClearOfMessages();
    void whatSpeaksOfAStepGoesWithIt();
};

void MessageBarUiTest::messagesLieOverThePictures()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::MessageBar& bar = fixture.window.messages();
    bar.dismiss();
    QCoreApplication::sendPostedEvents(); // layouts are posted events
    const auto placeOf = [&fixture](const QWidget& widget) {
        return QRect(widget.mapTo(&fixture.window, QPoint(0, 0)), widget.size());
    };
    const auto pictures = [&fixture, &placeOf] {
        QList<QRect> places;
        for (const ui::ImageView* view : fixture.window.views().views())
            places += placeOf(*view);
        return places;
    };
    const QList<QRect> before = pictures();
    bar.show(ui::MessageBar::Kind::Error, QStringLiteral("The disk is full."),
        QStringLiteral("Try again"), [] {});
    QCoreApplication::sendPostedEvents();
    QTRY_VERIFY(bar.isVisible() && bar.height() > 20);
    QCOMPARE(pictures(), before);
    const QRect all = placeOf(fixture.window.views());
    const QRect shown = placeOf(bar);
    QVERIFY(all.contains(shown));
    QCOMPARE(shown.top(), all.top());
    QVERIFY(shown.height() < all.height() / 4);
    // It lies on top, and takes what is clicked there.
    const QWidget* there = fixture.window.childAt(shown.center());
    QVERIFY(there && (there == &bar || bar.isAncestorOf(there)));
    QTest::mouseClick(bar.findChild<QToolButton*>(QStringLiteral("closeMessage")), Qt::LeftButton);
    QVERIFY(!bar.isVisible());
    QCoreApplication::sendPostedEvents();
    QCOMPARE(pictures(), before);
}

void MessageBarUiTest::onTheStartPageTheyHideNothing()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::MessageBar& bar = fixture.window.messages();
    // What was said of a study goes with it, and what could be done there.
    bar.show(
        ui::MessageBar::Kind::Caution, QStringLiteral("Imported."), QStringLiteral("Undo"), [] {});
    fixture.window.closeStudy();
    QVERIFY(!bar.isVisible());
    bar.show(ui::MessageBar::Kind::Error, QStringLiteral("There is no such folder."));
    const auto* start = fixture.window.findChild<ui::StartPage*>();
    QVERIFY(start && start->isVisible());
    QTRY_VERIFY(bar.isVisible() && bar.height() > 20);
    QTRY_VERIFY(bar.mapTo(&fixture.window, QPoint(0, bar.height())).y()
        <= start->mapTo(&fixture.window, QPoint(0, 0)).y());
}

/// What asks for nothing goes by itself; all else waits for the user.
void MessageBarUiTest::noticesGoByThemselves()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::MessageBar& bar = fixture.window.messages();
    bar.setNoticeTime(40);
    for (const auto kind : {ui::MessageBar::Kind::Caution, ui::MessageBar::Kind::Error}) {
        bar.show(ui::MessageBar::Kind::Notice, QStringLiteral("Saved."));
        bar.show(kind, QStringLiteral("Not saved."));
        QTest::qWait(120);
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.sentence(), QStringLiteral("Not saved."));
    }
    bar.show(
        ui::MessageBar::Kind::Notice, QStringLiteral("Imported."), QStringLiteral("Undo"), [] {});
    QTest::qWait(120);
    QVERIFY(bar.isVisible());
    bar.show(ui::MessageBar::Kind::Notice, QStringLiteral("Saved."));
    QVERIFY(bar.isVisible());
    QTRY_VERIFY(!bar.isVisible());
}

/// View, patient and letters are read whatever a message says over them.
void MessageBarUiTest::textsKeepClearOfMessages()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& views = fixture.window.views();
    ui::MessageBar& bar = fixture.window.messages();
    bar.dismiss();
    QCoreApplication::sendPostedEvents();
    const auto covered = [&views] {
        return std::array<int, 4>{views.axial().coveredTop(), views.volume().coveredTop(),
            views.sagittal().coveredTop(), views.coronal().coveredTop()};
    };
    QCOMPARE(covered(), (std::array<int, 4>{}));
    // The title is the only text of that colour; the bar at the view's top has it, too.
    const auto titleTop = [&views] {
        const QImage picture = views.axial().grab().toImage();
        for (int y = ui::theme::viewBarHeight + 1; y < picture.height() / 2; ++y) {
            for (int x = 0; x < 80; ++x) {
                if (picture.pixelColor(x, y) == views.axial().barColour())
                    return y;
            }
        }
        return -1;
    };
    const int before = titleTop();
    QVERIFY(before > 0);
    bar.show(ui::MessageBar::Kind::Error, QStringLiteral("The disk is full."));
    QTRY_VERIFY(bar.isVisible() && bar.height() > 20);
    QTRY_COMPARE(covered(), (std::array<int, 4>{bar.height(), bar.height(), 0, 0}));
    QCOMPARE(titleTop(), before + bar.height());
    // Also in what is alone, and again when all are there.
    views.maximise(&views.sagittal());
    QTRY_COMPARE(views.sagittal().coveredTop(), bar.height());
    views.maximise(nullptr);
    QTRY_COMPARE(covered(), (std::array<int, 4>{bar.height(), bar.height(), 0, 0}));
    bar.dismiss();
    QCOMPARE(covered(), (std::array<int, 4>{}));
    QCOMPARE(titleTop(), before);
}

/// What offers to undo a step lies over the pictures only while that is the last one.
void MessageBarUiTest::whatSpeaksOfAStepGoesWithIt()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::MessageBar& bar = fixture.window.messages();
    const QString said = QStringLiteral("Imported.");
    const auto show = [&] {
        bar.show(ui::MessageBar::Kind::Notice, said, QStringLiteral("Undo"), [] {});
        bar.dismissAtNextStep(fixture.workspace);
    };
    fixture.apply(core::AddSegment{.name = QStringLiteral("one"), .rgb = 0x123456});
    show();
    QCoreApplication::processEvents();
    QVERIFY(bar.isVisible());
    fixture.apply(core::AddSegment{.name = QStringLiteral("two"), .rgb = 0x123456});
    QVERIFY(!bar.isVisible());
    show();
    QVERIFY(fixture.session().undo());
    QVERIFY(fixture.session().settle());
    QVERIFY(!bar.isVisible());
    // Another message stays.
    show();
    bar.show(ui::MessageBar::Kind::Error, QStringLiteral("The disk is full."));
    fixture.apply(core::AddSegment{.name = QStringLiteral("three"), .rgb = 0x123456});
    QVERIFY(bar.isVisible());
}

BURIN_WINDOW_TEST(MessageBarUiTest)

} // namespace messageBarUiTest

#include "MessageBarUiTest.moc"
