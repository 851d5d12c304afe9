// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/BurinProgram.h"
#include "ui/input/Tool.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace longStrokeUiTest {

namespace {

constexpr double samplesPerSecond = 120.0;

double milliseconds(const QElapsedTimer& timer)
{
    return double(timer.nsecsElapsed()) * 1e-6;
}

/// What happens in the window while the pen is down.
struct Watch {
    std::vector<double> handling; ///< ms, of each event of the pen
    double longestTurn = 0.0; ///< ms between two looks at the event loop
    std::vector<gpu::Frame::Quality> frames; ///< of the 3D view
};

/// Seconds of all processors that this program has used.
double processorSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

QByteArray summary(const char* name, const Watch& watch, double seconds, double processors)
{
    std::vector<double> sorted = watch.handling;
    std::sort(sorted.begin(), sorted.end());
    double sum = 0.0;
    for (const double each : sorted)
        sum += each;
    return QStringLiteral("%1: %2 s, %3 events; handled in %4 ms on average, 99 % within %5 ms, at "
                          "most %6 ms; the event loop was away for %7 ms at most; %8 pictures a "
                          "second in the 3D view, of %9 processors")
        .arg(QLatin1String(name))
        .arg(seconds, 0, 'f', 1)
        .arg(sorted.size())
        .arg(sum / double(sorted.size()), 0, 'f', 2)
        .arg(sorted[sorted.size() * 99 / 100], 0, 'f', 2)
        .arg(sorted.back(), 0, 'f', 2)
        .arg(watch.longestTurn, 0, 'f', 1)
        .arg(double(watch.frames.size()) / seconds, 0, 'f', 1)
        .arg(processors, 0, 'f', 1)
        .toUtf8();
}

} // namespace

/// Issue 4, "no hitch": a stroke at a tablet's rate on the demonstration head, in the real window
/// with the real engine. The numbers are printed; what decides is that nothing of the stroke is
/// lost, that pictures keep coming, coarse ones, and that the full one comes back.
class LongStrokeUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<test::ApplicationFixture> m_fixture;
    bool m_slow = false; ///< no machine draws this window whole in the time of a coarse picture

    static bool wait(const std::function<bool()>& condition)
    {
        return QTest::qWaitFor(condition, test::ApplicationFixture::patience);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const test::Outcome info = test::burin({QStringLiteral("info"), QStringLiteral("--gl")});
        m_slow = info.output.contains("llvmpipe") && QThread::idealThreadCount() <= 4;
        m_fixture = std::make_unique<test::ApplicationFixture>();
        Q_EMIT m_fixture->window().demonstrationRequested();
        QVERIFY(wait([&] { return m_fixture->workspace().session() != nullptr; }));
        ui::ViewGrid& views = m_fixture->window().views();
        views.maximise(&views.volume());
    }
    void cleanupTestCase() { m_fixture.reset(); }
    void init() { test::failOnUnexpectedMessages(); }

    void nothingHitches_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("drill") << QStringLiteral("drill");
        QTest::newRow("laser") << QStringLiteral("laser");
        QTest::newRow("carve brush") << QStringLiteral("carve");
    }
    void nothingHitches()
    {
        QFETCH(QString, name);
        ui::MainWindow& window = m_fixture->window();
        core::EditSession& session = m_fixture->session();
        ui::VolumeView& view = window.views().volume();
        for (ui::Tool* tool : window.findChildren<ui::Tool*>()) {
            if (tool->iconName() == name)
                m_fixture->workspace().setActiveTool(tool);
        }
        QVERIFY(m_fixture->workspace().activeTool());
        view.lookFrom({0.0, -1.0, 0.0});
        QVERIFY(wait([&] { return session.idle() && window.views().refined(); }));
        const std::size_t rowsBefore = session.history().rows().size();

        Watch watch;
        // A picture that is new, whatever else is told of.
        const auto counting = connect(&view, &ui::ImageView::qualityChanged, this,
            [&watch, &view, last = view.picture().cacheKey()]() mutable {
                if (std::exchange(last, view.picture().cacheKey()) != last && view.quality())
                    watch.frames.push_back(*view.quality());
            });
        // Round and round over the forehead, as fast as a hand does.
        const QPointF middle(0.5 * view.width(), 0.38 * view.height());
        const double reach = 0.2 * view.height();
        const double seconds = test::longRun() ? 10.0 : 2.5;
        const int samples = int(seconds * samplesPerSecond);
        const auto place = [&](int sample) {
            const double angle = sample / samplesPerSecond * 2.2;
            return middle
                + QPointF(std::cos(angle), std::sin(1.7 * angle)) * reach
                * (0.4 + 0.6 * std::min(1.0, double(sample) / samples));
        };
        const auto pressure = [](int sample) { return 0.55 + 0.45 * std::sin(sample * 0.05); };

        test::Pen pen(view);
        const double usedBefore = processorSeconds();
        QElapsedTimer clock;
        clock.start();
        double looked = 0.0;
        const auto handle = [&](const std::function<void(quint64)>& event) {
            QElapsedTimer timer;
            timer.start();
            event(quint64(10000 + clock.elapsed()));
            watch.handling.push_back(milliseconds(timer));
        };
        const auto look = [&] {
            QCoreApplication::processEvents();
            const double now = milliseconds(clock);
            watch.longestTurn = std::max(watch.longestTurn, now - looked);
            looked = now;
        };
        handle([&](quint64 time) { pen.press(place(0), pressure(0), time); });
        // However slow the machine, pictures come; the pen goes on until a few have.
        constexpr std::size_t fewest = 3;
        constexpr double longestSeconds = 120.0;
        int sample = 1;
        const auto goesOn = [&] {
            return sample < samples
                || (watch.frames.size() < fewest && sample < longestSeconds * samplesPerSecond);
        };
        for (; goesOn(); ++sample) {
            // Who comes late gets all that is due at once, as from a tablet.
            while (milliseconds(clock) < 1000.0 * sample / samplesPerSecond) {
                look();
                QThread::usleep(500);
            }
            handle([&](quint64 time) { pen.move(place(sample), pressure(sample), time); });
        }
        look();
        const double lasted = milliseconds(clock) / 1000.0;
        const double processors = (processorSeconds() - usedBefore) / lasted;
        const std::vector<gpu::Frame::Quality> frames = watch.frames;
        handle([&](quint64 time) { pen.release(place(sample - 1), time); });
        disconnect(counting);
        watch.frames = frames;
        qInfo("%s", summary(qPrintable(name), watch, lasted, processors).constData());

        // All of the stroke arrived, in one step.
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), rowsBefore + 1);
        const core::HistoryRow& row = session.history().rows().back();
        QVERIFY(row.statistics.voxelsChanged > 0);
        if (row.edit.is<core::DrillStroke>() || row.edit.is<core::LaserStroke>()) {
            const QJsonObject edit = core::editToJson(row.edit);
            QCOMPARE(edit[QStringLiteral("samples")].toArray().size(), qsizetype(sample));
        }
        // Pictures came while the pen was down; where drawing is slow, coarse ones.
        QVERIFY2(frames.size() >= fewest, qPrintable(QString::number(frames.size())));
        const auto count = [&frames](gpu::Frame::Quality quality) {
            return std::count(frames.begin(), frames.end(), quality);
        };
        QCOMPARE(count(gpu::Frame::Quality::Refined), 0);
        if (m_slow)
            QVERIFY(2 * std::size_t(count(gpu::Frame::Quality::Coarse)) > frames.size());
        // Then the full picture comes back.
        QVERIFY(wait([&] { return window.views().refined(); }));
        QCOMPARE(
            view.quality().value_or(gpu::Frame::Quality::Coarse), gpu::Frame::Quality::Refined);
        test::look(window.grab(), qPrintable(QStringLiteral("long-stroke-%1.png").arg(name)));
    }
};

BURIN_WINDOW_TEST(LongStrokeUiTest)

} // namespace longStrokeUiTest

#include "LongStrokeUiTest.moc"
