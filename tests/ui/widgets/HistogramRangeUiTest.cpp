// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "ui/widgets/HistogramRange.h"

#include "ui/widgets/HistogramRangePlot.h"

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

namespace histogramRangeUiTest {

using ui::HistogramRange;
using ui::HistogramRangePlot;

class HistogramRangeUiTest : public QObject {
    Q_OBJECT

private:
    static void prepare(HistogramRange& range)
    {
        range.setHistogram(
            {-1000.0, 3000.0, std::vector<std::uint32_t>(400, 5)}, QStringLiteral("HU"));
        range.setRange(100.0, 900.0);
        range.resize(420, 120);
        range.show();
        QVERIFY(QTest::qWaitForWindowExposed(&range));
    }
    static void drag(HistogramRangePlot& plot, double from, double to)
    {
        const int y = plot.height() / 2;
        QTest::mousePress(&plot, Qt::LeftButton, {}, QPoint(int(std::lround(from)), y));
        QTest::mouseMove(&plot, QPoint(int(std::lround((from + to) / 2)), y));
        QTest::mouseMove(&plot, QPoint(int(std::lround(to)), y));
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, QPoint(int(std::lround(to)), y));
    }

private Q_SLOTS:
    void handlesAreDragged()
    {
        HistogramRange range;
        prepare(range);
        QSignalSpy edited(&range, &HistogramRange::rangeEdited);
        HistogramRangePlot& plot = *range.plot();
        const double perPixel = plot.valueAt(101) - plot.valueAt(100);
        drag(plot, plot.xOf(100.0), plot.xOf(-400.0));
        QVERIFY(edited.count() > 0);
        QVERIFY(std::abs(range.lower() + 400.0) <= 1.5 * perPixel);
        QCOMPARE(range.upper(), 900.0);
        drag(plot, plot.xOf(900.0), plot.xOf(2000.0));
        QVERIFY(std::abs(range.upper() - 2000.0) <= 1.5 * perPixel);
        QCOMPARE(edited.back()[0].toDouble(), range.lower());
        QCOMPARE(edited.back()[1].toDouble(), range.upper());
    }

    void theStretchBetweenIsShifted()
    {
        HistogramRange range;
        prepare(range);
        HistogramRangePlot& plot = *range.plot();
        drag(plot, plot.xOf(500.0), plot.xOf(1500.0));
        QCOMPARE(range.upper() - range.lower(), 800.0);
        QVERIFY(range.lower() > 900.0 && range.lower() < 1300.0);
        drag(plot, plot.xOf(range.lower() + 400.0), plot.xOf(2999.0) + 200.0);
        QCOMPARE(range.upper(), 3000.0);
        QCOMPARE(range.lower(), 2200.0);
    }

    void neverUpsideDown()
    {
        HistogramRange range;
        prepare(range);
        HistogramRangePlot& plot = *range.plot();
        drag(plot, plot.xOf(100.0), plot.xOf(2500.0));
        QCOMPARE(range.lower(), 900.0);
        QCOMPARE(range.upper(), 900.0);
        // Handles on top of each other come apart again, each to its side.
        drag(plot, plot.xOf(900.0) - 2.0, plot.xOf(200.0));
        QVERIFY(range.lower() < 300.0);
        QCOMPARE(range.upper(), 900.0);
        // Caught in the middle, or a little beside it.
        for (const double beside : {0.0, 2.0, -2.0}) {
            range.setRange(900.0, 900.0);
            drag(plot, plot.xOf(900.0) + beside, plot.xOf(200.0));
            QVERIFY(range.lower() < 300.0);
            QCOMPARE(range.upper(), 900.0);
            range.setRange(900.0, 900.0);
            drag(plot, plot.xOf(900.0) + beside, plot.xOf(1500.0));
            QCOMPARE(range.lower(), 900.0);
            QVERIFY(range.upper() > 1400.0);
        }
    }

    void exactNumbersAreTyped()
    {
        HistogramRange range;
        prepare(range);
        QSignalSpy edited(&range, &HistogramRange::rangeEdited);
        auto* lower = range.findChild<QDoubleSpinBox*>(QStringLiteral("rangeLower"));
        auto* upper = range.findChild<QDoubleSpinBox*>(QStringLiteral("rangeUpper"));
        QVERIFY(lower && upper);
        QVERIFY(lower->text().endsWith(QStringLiteral("HU")));
        upper->setFocus();
        upper->selectAll();
        QTest::keyClicks(upper, QLocale().toString(1234.5, 'f', 1));
        QTest::keyClick(upper, Qt::Key_Return);
        QCOMPARE(range.upper(), 1234.5);
        QCOMPARE(range.lower(), 100.0);
        lower->selectAll();
        QTest::keyClicks(lower, QStringLiteral("2000"));
        QTest::keyClick(lower, Qt::Key_Return);
        QCOMPARE(range.lower(), 2000.0);
        QCOMPARE(range.upper(), 2000.0);
        QCOMPARE(edited.count(), 2);
        // Beyond what there is: the nearest of it, not what is left of the digits.
        lower->selectAll();
        QTest::keyClicks(lower, QStringLiteral("-1024"));
        QTest::keyClick(lower, Qt::Key_Return);
        QCOMPARE(range.lower(), -1000.0);
        QCOMPARE(lower->value(), -1000.0);
        QCOMPARE(range.upper(), 2000.0);
        upper->setFocus();
        upper->selectAll();
        QTest::keyClicks(upper, QStringLiteral("99999"));
        QTest::keyClick(upper, Qt::Key_Return);
        QCOMPARE(range.upper(), 3000.0);
        lower->selectAll();
        QTest::keyClicks(lower, QStringLiteral("-x1"));
        QTest::keyClick(lower, Qt::Key_Return);
        QCOMPARE(range.lower(), -1.0); // a letter is no digit
    }

    void settingTellsNobody()
    {
        HistogramRange range;
        prepare(range);
        QSignalSpy edited(&range, &HistogramRange::rangeEdited);
        range.setRange(10.0, 20.0);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(range.lower(), 10.0);
    }

    void handlesStayInSight()
    {
        HistogramRange range;
        prepare(range);
        HistogramRangePlot& plot = *range.plot();
        const auto inSight = [&] {
            return plot.xOf(range.lower()) >= 0.0 && plot.xOf(range.upper()) <= plot.width();
        };
        // Dragged past the edge.
        plot.showValues(0.0, 1000.0);
        drag(plot, plot.xOf(900.0), plot.width() + 60.0);
        QVERIFY(range.upper() > 1000.0);
        QVERIFY(inSight());
        // Set from elsewhere, and asked to be shown.
        range.setRange(2500.0, 2800.0);
        QVERIFY(!inSight());
        range.showRange();
        QVERIFY(inSight());
        plot.showValues(-1000.0, 3000.0);
        range.setRange(40.0, 80.0);
        range.showRange();
        QVERIFY(plot.xOf(80.0) - plot.xOf(40.0) > 100.0);
        // What can be seen is left as it is.
        plot.showValues(0.0, 100.0);
        range.showRange();
        QCOMPARE(plot.valueAt(plot.xOf(0.0)), 0.0);
        QVERIFY(std::abs(plot.valueAt(plot.xOf(0.0) + 1.0) - 100.0 / (plot.width() - 12.0)) < 0.01);
    }

    void escapePutsTheDragBack()
    {
        HistogramRange range;
        prepare(range);
        QSignalSpy edited(&range, &HistogramRange::rangeEdited);
        QSignalSpy settled(&range, &HistogramRange::rangeSettled);
        QSignalSpy cancelled(&range, &HistogramRange::rangeCancelled);
        HistogramRangePlot& plot = *range.plot();
        const int y = plot.height() / 2;
        const QPoint far(int(plot.xOf(2000.0)), y);
        QTest::mousePress(&plot, Qt::LeftButton, {}, QPoint(int(plot.xOf(900.0)), y));
        QTest::mouseMove(&plot, far);
        QVERIFY(range.upper() > 1500.0);
        QTest::keyClick(&plot, Qt::Key_Escape);
        QCOMPARE(range.upper(), 900.0);
        QCOMPARE(edited.back()[1].toDouble(), 900.0);
        QTest::mouseMove(&plot, far + QPoint(5, 0));
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, far);
        QCOMPARE(range.upper(), 900.0);
        QCOMPARE(cancelled.count(), 1);
        QCOMPARE(settled.count(), 0);
    }

    void zoomKeepsTheValueUnderTheCursor()
    {
        HistogramRange range;
        prepare(range);
        HistogramRangePlot& plot = *range.plot();
        const QPointF at(plot.xOf(500.0), 10.0);
        const double before = plot.valueAt(at.x());
        QWheelEvent wheel(at, plot.mapToGlobal(at), {}, {0, 480}, Qt::NoButton, Qt::ControlModifier,
            Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &wheel);
        QVERIFY(std::abs(plot.valueAt(at.x()) - before) < 1e-6);
        QVERIFY(plot.valueAt(101) - plot.valueAt(100) < 6.0);
        range.zoomToRange();
        QVERIFY(plot.xOf(range.lower()) > 0.25 * plot.width());
        QVERIFY(plot.xOf(range.upper()) < 0.75 * plot.width());
    }
};

BURIN_WINDOW_TEST(HistogramRangeUiTest)

} // namespace histogramRangeUiTest

#include "HistogramRangeUiTest.moc"
