// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionKeyframes.h"
#include "core/sessionfile/SessionFile.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/panels/history/HistoryTimeline.h"
#include "ui/panels/history/KeyframePopup.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/window/KeyframeRecorder.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

namespace keyframeRecorderUiTest {

using namespace core;

namespace {

/// The window over a session with a file; frames come when the test says so.
class Bench {
public:
    explicit Bench(const QString& path, bool continues = false)
        : fixture(test::smallStudy())
        , recorder(new ui::KeyframeRecorder(fixture.workspace, view()))
    {
        recorder->setClock([this] { return now; });
        fixture.workspace.setSession(nullptr);
        auto session = continues
            ? EditSession::open(fixture.engine, test::smallStudy(), path)
            : EditSession::create(fixture.engine, test::smallStudy(), {.file = path});
        if (!session)
            qFatal("no session");
        fixture.workspace.setSession(std::move(*session));
        // What moves when a study opens asks once more for a picture, at full quality, when it
        // rests.
        if (!QTest::qWaitFor([this] { return !requested().interacting; }))
            qFatal("the view does not come to rest");
        frame();
    }

    [[nodiscard]] EditSession& session() { return *fixture.workspace.session(); }
    [[nodiscard]] ui::ImageView& view() { return fixture.window.views().volume(); }
    [[nodiscard]] const gpu::FrameRequest& requested()
    {
        return fixture.frames.lastRequest(view().viewId());
    }

    void apply(const Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("not applied");
    }
    /// A new picture of what is asked for, coarse, then refined.
    void frame(int grey = 80)
    {
        QCoreApplication::sendPostedEvents(); // layouts, and frames that the fixture made, go first
        gpu::Frame frame;
        const gpu::FrameRequest& request = requested();
        frame.view = view().viewId();
        frame.sizePixels = request.sizePixels;
        frame.scene = request.scene;
        const std::size_t pixels =
            std::size_t(frame.sizePixels.x) * std::size_t(frame.sizePixels.y);
        frame.rgba =
            std::make_shared<const std::vector<std::uint8_t>>(pixels * 4, std::uint8_t(grey));
        for (const auto quality : {gpu::Frame::Quality::Coarse, gpu::Frame::Quality::Refined}) {
            frame.quality = quality;
            view().takeFrame(frame);
        }
    }
    /// Once there are so many; and a moment later, since nothing tells that the worker makes no
    /// more.
    [[nodiscard]] std::vector<RowId> keyframes(std::size_t expected)
    {
        static_cast<void>(QTest::qWaitFor(
            [this, expected] { return session().keyframes().rows().size() >= expected; }));
        QTest::qWait(60);
        return session().keyframes().rows();
    }

    qint64 now = 1000;
    test::WindowFixture fixture;
    ui::KeyframeRecorder* recorder;
};

QImage pictureIn(const QString& path, RowId row)
{
    const auto file = SessionFile::open(path, SessionFile::Access::ReadOnly);
    QImage image;
    (*file)->fetchKeyframe(
        row, [&image](const QByteArray& png) { image.loadFromData(png, "PNG"); });
    static_cast<void>((*file)->flush());
    return image;
}

using Rows = std::vector<RowId>;

} // namespace

class KeyframeRecorderUiTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_path = m_folder.filePath(QLatin1String(QTest::currentTestFunction()) + ".burin");
    }

    void afterTheFirstStepAndThenEveryTen()
    {
        Bench bench(m_path);
        QCOMPARE(bench.keyframes(0), Rows{});
        bench.apply(test::drillAt(0));
        QCOMPARE(bench.keyframes(0), Rows{}); // the picture is of the time before
        bench.frame();
        QCOMPARE(bench.keyframes(1), Rows{1});
        for (int i = 2; i <= 22; ++i) {
            bench.apply(test::drillAt(i - 12));
            bench.frame();
        }
        QCOMPARE(bench.keyframes(3), (Rows{1, 11, 21}));
    }

    void aStepOfTheDocumentNeedsNoNewPicture()
    {
        Bench bench(m_path);
        bench.apply(test::addSegment("A"));
        QCOMPARE(bench.keyframes(1), Rows{1});
    }

    void afterAMinuteOfWork()
    {
        Bench bench(m_path);
        bench.apply(test::drillAt(0));
        bench.frame();
        bench.now += 59'000;
        bench.apply(test::drillAt(4));
        bench.frame();
        QCOMPARE(bench.keyframes(1), Rows{1});
        bench.now += 1'000;
        QCOMPARE(bench.keyframes(1), Rows{1}); // not before something is done
        bench.apply(test::drillAt(-4));
        bench.frame();
        QCOMPARE(bench.keyframes(2), (Rows{1, 3}));
    }

    void undoAloneMakesNone()
    {
        Bench bench(m_path);
        bench.apply(test::drillAt(0));
        bench.frame();
        bench.now += 100'000;
        QVERIFY(bench.session().undo());
        QVERIFY(bench.session().settle());
        bench.frame();
        QCOMPARE(bench.keyframes(1), Rows{1});
    }

    void theEndOfASessionIsKept()
    {
        {
            Bench bench(m_path);
            bench.apply(test::drillAt(0));
            bench.frame(50);
            bench.apply(test::drillAt(4));
            bench.frame(120);
            bench.fixture.workspace.setSession(nullptr);
        }
        const QImage last = pictureIn(m_path, 2);
        QVERIFY(!last.isNull());
        QVERIFY(last.width() <= 256 && last.height() <= 192);
        QVERIFY(last.width() == 256 || last.height() == 192);
        QCOMPARE(last.pixelColor(last.rect().center()), QColor(120, 120, 120));
        QCOMPARE(pictureIn(m_path, 1).pixelColor(5, 5), QColor(50, 50, 50));
        {
            // Opened and closed again, nothing was seen that is not kept already.
            Bench bench(m_path, true);
            bench.frame(200);
            bench.fixture.workspace.setSession(nullptr);
        }
        QCOMPARE(pictureIn(m_path, 2), last);
    }

    void anOldPictureIsNotKeptForANewState()
    {
        {
            Bench bench(m_path);
            bench.apply(test::drillAt(0));
            bench.frame();
            bench.apply(test::drillAt(4)); // closed before it is drawn
            bench.fixture.workspace.setSession(nullptr);
        }
        QVERIFY(pictureIn(m_path, 2).isNull());
    }

    void theTimelineShowsTheNearest()
    {
        Bench bench(m_path);
        bench.fixture.window.addPanel(new ui::HistoryPanel(bench.fixture.workspace));
        bench.fixture.window.showPanels(true);
        for (int i = 1; i <= 14; ++i) {
            bench.apply(test::drillAt(i - 7));
            bench.frame(40 + 10 * i);
        }
        QCOMPARE(bench.keyframes(2), (Rows{1, 11}));
        auto* timeline = bench.fixture.window.findChild<ui::HistoryTimeline*>();
        QVERIFY(timeline && timeline->isVisible());
        const auto hover = [timeline](int step) {
            // Not by the display's one pointer, which other programs move too.
            const QPointF at(timeline->xOf(step), timeline->height() - 8);
            QMouseEvent event(QEvent::MouseMove, at, timeline->mapToGlobal(at), Qt::NoButton,
                Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(timeline, &event);
            QTRY_VERIFY(!timeline->popup().picture().isNull()); // it is read elsewhere
        };
        hover(5);
        hover(13);
        QVERIFY(timeline->popup().isVisible());
        QCOMPARE(timeline->popup().picture().pixelColor(9, 9), QColor(150, 150, 150));
        QVERIFY(timeline->popup().words().startsWith(QStringLiteral("Step 13: Drill")));
        QVERIFY(timeline->popup().words().endsWith(QStringLiteral("shows step 11")));
        hover(1);
        QCOMPARE(timeline->popup().picture().pixelColor(9, 9), QColor(50, 50, 50));
        QVERIFY(!timeline->popup().words().contains(u'\n'));
        hover(6); // as near to the first as to the eleventh
        QVERIFY(timeline->popup().words().endsWith(QStringLiteral("shows step 1")));
        if (qEnvironmentVariableIsSet("BURIN_SCREENSHOTS")) {
            const QDir folder(qEnvironmentVariable("BURIN_SCREENSHOTS"));
            bench.fixture.window.screen()->grabWindow(0).save(
                folder.filePath(QStringLiteral("timeline-keyframe.png")));
        }
        // Nothing was walked, and it goes with the pointer.
        QCOMPARE(bench.session().history().position(), RowId(14));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(timeline, &leave);
        QVERIFY(!timeline->popup().isVisible());

        // Dragged there and then undone: it does not go on speaking of a step that was left.
        const auto at = [timeline](int step) {
            return QPoint(qRound(timeline->xOf(step)), timeline->height() - 8);
        };
        QTest::mousePress(timeline, Qt::LeftButton, {}, at(7));
        hover(7);
        QTest::mouseRelease(timeline, Qt::LeftButton, {}, at(7));
        QVERIFY(bench.session().settle());
        QTRY_VERIFY(!timeline->isScrubbing());
        QCOMPARE(bench.session().history().position(), RowId(7));
        hover(7);
        QVERIFY(timeline->popup().words().startsWith(QStringLiteral("Step 7:")));
        QVERIFY(bench.session().undo());
        QVERIFY(bench.session().settle());
        QTRY_COMPARE(timeline->value(), 6);
        QVERIFY(!timeline->popup().isVisible());
        hover(6);
        QVERIFY(timeline->popup().words().startsWith(QStringLiteral("Step 6:")));
        QTest::keyClick(timeline, Qt::Key_Left);
        QVERIFY(!timeline->popup().isVisible());
        QVERIFY(bench.session().settle());
        hover(5);
        QVERIFY(timeline->popup().isVisible());
    }
};

BURIN_WINDOW_TEST(KeyframeRecorderUiTest)

} // namespace keyframeRecorderUiTest

#include "KeyframeRecorderUiTest.moc"
