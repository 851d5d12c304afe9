// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/WindowMapping.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace windowMappingTest {

using namespace gpu;

namespace {

double greyAt(const core::VoxelEncoding& encoding, const core::WindowLevel& window, double code)
{
    const glm::dvec2 grey = greyOfTexel(encoding, window);
    return grey.x * code / 65535.0 + grey.y;
}

} // namespace

class WindowMappingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Every bit as PS3.3 C.11.2.1.2.1 has it: pictures of CT are what they always were.
    void wholeNumbersAreLinear_data()
    {
        QTest::addColumn<double>("slope");
        QTest::addColumn<int>("storedStep");
        QTest::newRow("CT") << 1.0 << 1;
        QTest::newRow("stored the other way round") << -1.0 << -1;
    }
    void wholeNumbersAreLinear()
    {
        QFETCH(double, slope);
        QFETCH(int, storedStep);
        const core::VoxelEncoding encoding{
            .rescaleSlope = slope, .rescaleIntercept = -1024.3, .storedStep = storedStep};
        const glm::dvec2 value = valueOfTexel(encoding);
        for (const core::WindowLevel& window :
            {core::WindowLevel{40.0, 400.0}, core::WindowLevel{32.0, 12.0},
                core::WindowLevel{0.5, 1.0}, core::WindowLevel{-600.0, 0.25}}) {
            const double span = std::max(window.width - 1.0, 1e-3);
            const glm::dvec2 grey = greyOfTexel(encoding, window);
            QVERIFY(grey.x == value.x / span);
            QVERIFY(grey.y == (value.y - (window.centre - 0.5)) / span + 0.5);
        }
        QCOMPARE(leastWindowWidth(encoding), 1e-3);
        QCOMPARE(valuesApart(encoding), 1.0);
    }

    void fractionsAreContinuous_data()
    {
        QTest::addColumn<double>("range");
        QTest::newRow("probabilities") << 1.0;
        QTest::newRow("ADC in mm2/s") << 0.003;
        QTest::newRow("SUV") << 31.7;
        QTest::newRow("minute") << 1e-12;
    }
    void fractionsAreContinuous()
    {
        QFETCH(double, range);
        const core::VoxelEncoding encoding{
            .rescaleSlope = range / 65535.0, .rescaleIntercept = 0.0};
        const core::WindowLevel window{0.5 * range, range};
        QVERIFY(std::abs(greyAt(encoding, window, 0.0)) < 1e-9);
        QVERIFY(std::abs(greyAt(encoding, window, 65535.0 / 2.0) - 0.5) < 1e-9);
        QVERIFY(std::abs(greyAt(encoding, window, 65535.0) - 1.0) < 1e-9);
        const core::WindowLevel lower{0.125 * range, 0.25 * range};
        QVERIFY(std::abs(greyAt(encoding, lower, 65535.0 / 8.0) - 0.5) < 1e-9);
        const GreyRamp ramp = greyRampOf(encoding, lower);
        QCOMPARE(ramp.middle, lower.centre);
        QCOMPARE(ramp.span, lower.width);
        QVERIFY(leastWindowWidth(encoding) > 0.0 && leastWindowWidth(encoding) < 1e-4 * range);
    }

    void aWindowWithoutWidthIsAStep()
    {
        const core::VoxelEncoding encoding{.rescaleSlope = 1.0 / 65535.0};
        const core::WindowLevel window{0.5, 0.0};
        QVERIFY(std::isfinite(greyOfTexel(encoding, window).x));
        QVERIFY(greyAt(encoding, window, 32000.0) < 0.0);
        QVERIFY(greyAt(encoding, window, 33000.0) > 1.0);
    }
};

BURIN_TEST(WindowMappingTest)

} // namespace windowMappingTest

#include "WindowMappingTest.moc"
