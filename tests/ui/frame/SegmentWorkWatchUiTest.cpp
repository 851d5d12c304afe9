// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/SegmentWorkWatch.h"

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/session/SegmentWork.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/frame/LoadingBar.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/views/ViewGrid.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>

namespace segmentWorkWatchUiTest {

namespace {

/// A window with a segment that is being mirrored: the session does not go on until it is asked to.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
        , bar(window.findChild<ui::LoadingBar*>(QStringLiteral("segmentWork")))
    {
        apply(test::addSegment("Organ"));
        apply(test::paintAt(1, {test::pointsInBrain().back()}, 3.0));
        before = session().stateHash();
    }
    ui::LoadingBar* bar;
    QByteArray before;
};

} // namespace

/// Edits of whole segments can be watched and abandoned from the window, not only in their dialogs.
class SegmentWorkWatchUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whatTakesLongIsShownAndAbandoned()
    {
        Fixture fixture;
        QVERIFY(fixture.bar && !fixture.bar->isVisible());
        const std::size_t rows = fixture.session().history().rows().size();
        QVERIFY(fixture.session().apply(core::MirrorSegment{.segment = 1}));
        QVERIFY(fixture.session().segmentWork().percent());
        QTRY_VERIFY(fixture.bar->isVisible());
        const auto labels = fixture.bar->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* each) {
            return each->text() == QStringLiteral("A segment is being worked out");
        }));
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QTest::mouseClick(fixture.bar->findChild<QPushButton*>(), Qt::LeftButton);
        static_cast<void>(fixture.session().settle());
        QTRY_VERIFY(!fixture.bar->isVisible());
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(fixture.session().stateHash(), fixture.before);
    }

    /// So is what the engine itself carries out.
    void whatTheEngineGoesThroughIsAbandoned_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Abort") << false;
        QTest::newRow("Esc") << true;
    }
    void whatTheEngineGoesThroughIsAbandoned()
    {
        QFETCH(const bool, byKey);
        Fixture fixture;
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        const std::size_t rows = fixture.session().history().rows().size();
        QVERIFY(fixture.session().apply(core::InvertSegment{.segment = 1}));
        QVERIFY(fixture.session().segmentWork().percent());
        QTRY_VERIFY(fixture.bar->isVisible());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        if (byKey)
            QTest::keyClick(&fixture.window, Qt::Key_Escape);
        else
            QTest::mouseClick(fixture.bar->findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(!fixture.session().segmentWork().percent());
        static_cast<void>(fixture.session().settle());
        QTRY_VERIFY(!fixture.bar->isVisible());
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(fixture.session().stateHash(), fixture.before);
    }

    /// What is being drawn goes first: Esc is meant for what is under the pen.
    void whatIsUnderThePenGoesFirst()
    {
        Fixture fixture;
        ui::MeasureTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        QVERIFY(fixture.session().apply(core::MirrorSegment{.segment = 1}));
        QTRY_VERIFY(fixture.bar->isVisible());
        ui::ImageView& view = fixture.window.views().axial();
        const QPointF middle = view.rect().toRectF().center();
        test::WindowFixture::mouse(view, QEvent::MouseButtonPress, middle);
        test::WindowFixture::mouse(view, QEvent::MouseMove, middle + QPointF(30.0, 10.0));
        QVERIFY(view.pointerIsAtWork());
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!view.pointerIsAtWork());
        QVERIFY(fixture.session().segmentWork().percent());
        test::WindowFixture::mouse(view, QEvent::MouseButtonRelease, middle + QPointF(30.0, 10.0));
        QVERIFY(fixture.session().document().measurements.empty());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QTest::keyClick(&view, Qt::Key_Escape);
        static_cast<void>(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), fixture.before);
        fixture.workspace.setActiveTool(nullptr);
    }

    void whatIsDoneSoonShowsNoBar()
    {
        Fixture fixture;
        QVERIFY(fixture.session().apply(core::MirrorSegment{.segment = 1}));
        QVERIFY(fixture.session().settle());
        QTest::qWait(700);
        QVERIFY(!fixture.bar->isVisible());
        QVERIFY(fixture.session().stateHash() != fixture.before);
    }

    /// The dialog of a preview says how far that is; once it is taken, it is work as any other.
    void aPreviewShowsNoBar()
    {
        Fixture fixture;
        QVERIFY(fixture.session().begin(core::MirrorSegment{.segment = 1}));
        QVERIFY(fixture.session().segmentWork().percent());
        QTest::qWait(700);
        QVERIFY(!fixture.bar->isVisible());
        fixture.session().end(core::Ending::Commit);
        QTRY_VERIFY(fixture.bar->isVisible());
        QVERIFY(fixture.session().settle());
        QTRY_VERIFY(!fixture.bar->isVisible());
        QVERIFY(fixture.session().stateHash() != fixture.before);
    }

    /// A preview that was opened meanwhile waits in line behind it.
    void workInFrontOfAPreviewIsShown()
    {
        Fixture fixture;
        QVERIFY(fixture.session().apply(core::MirrorSegment{.segment = 1}));
        QVERIFY(fixture.session().begin(core::MirrorSegment{.segment = 1}));
        QVERIFY(fixture.session().openIsPreview() && !fixture.session().segmentWork().isPreview());
        QVERIFY(fixture.session().segmentWork().percent());
        QTRY_VERIFY(fixture.bar->isVisible());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QTest::mouseClick(fixture.bar->findChild<QPushButton*>(), Qt::LeftButton);
        static_cast<void>(fixture.session().settle());
        QTRY_VERIFY(!fixture.bar->isVisible());
        QCOMPARE(fixture.session().stateHash(), fixture.before);
    }

    /// It goes with the study.
    void aClosedSessionShowsNone()
    {
        Fixture fixture;
        QVERIFY(fixture.session().apply(core::MirrorSegment{.segment = 1}));
        QTRY_VERIFY(fixture.bar->isVisible());
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.bar->isVisible());
    }
};

BURIN_WINDOW_TEST(SegmentWorkWatchUiTest)

} // namespace segmentWorkWatchUiTest

#include "SegmentWorkWatchUiTest.moc"
