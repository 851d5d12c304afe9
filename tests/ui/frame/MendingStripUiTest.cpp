// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/MendingStrip.h"

#include "tests/support/program/TestProgram.h"

#include <QImage>
#include <QLabel>
#include <QTest>

#include <algorithm>
#include <vector>

namespace mendingStripUiTest {

namespace {

/// How many pixels of the ground lie beside a dot, on either side of each.
std::vector<int> gapsBesideDots(ui::MendingStrip& strip)
{
    const QImage seen = strip.grab().toImage();
    const int y = strip.height() / 2;
    std::vector<int> gaps;
    for (const auto* label : strip.findChildren<QLabel*>()) {
        if (label->text() != QStringLiteral("·"))
            continue;
        const QRect dot = label->geometry();
        const QRgb ground = seen.pixel(dot.left() - 1, y);
        for (const int side : {-1, 1}) {
            int x = side < 0 ? dot.left() - 1 : dot.right() + 1;
            int gap = 0;
            for (; seen.rect().contains(x, y) && seen.pixel(x, y) == ground; x += side)
                ++gap;
            gaps.push_back(gap);
        }
    }
    return gaps;
}

} // namespace

class MendingStripUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Whichever step is the next one.
    void dotsLieInTheMiddle()
    {
        using Step = ui::MendingStrip::Step;
        ui::MendingStrip strip;
        strip.resize(600, strip.height());
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        for (const Step next : {Step::Look, Step::Mend, Step::Export}) {
            strip.showSteps({next != Step::Look, false, false, false}, next);
            QCoreApplication::processEvents();
            const std::vector<int> gaps = gapsBesideDots(strip);
            QCOMPARE(gaps.size(), std::size_t(6));
            const auto [least, most] = std::minmax_element(gaps.begin(), gaps.end());
            QVERIFY2(*least > 0 && *most - *least <= 1,
                qPrintable(QStringLiteral("%1 … %2").arg(*least).arg(*most)));
        }
    }
};

BURIN_WINDOW_TEST(MendingStripUiTest)

} // namespace mendingStripUiTest

#include "MendingStripUiTest.moc"
