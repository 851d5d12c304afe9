// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/ToolMaskOutline.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <cmath>

namespace toolMaskOutlineTest {

namespace {

using Curve = std::vector<glm::dvec2>;

Curve ellipse(const glm::dvec2& middle, const glm::dvec2& radii, int points)
{
    Curve curve;
    for (int i = 0; i < points; ++i) {
        const double t = 2.0 * M_PI * i / points;
        curve.push_back(middle + radii * glm::dvec2(std::cos(t), std::sin(t)));
    }
    return curve;
}

} // namespace

class ToolMaskOutlineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theMiddleAndTheGreaterSideAreTakenOut()
    {
        const auto drawn = ui::drawnToolMask(ellipse({40.0, -12.0}, {6.0, 15.0}, 400), 0.02);
        QVERIFY(drawn);
        QVERIFY(std::abs(drawn->radiusMm - 15.0) < 0.03);
        glm::dvec2 low(9.0);
        glm::dvec2 high(-9.0);
        for (const glm::dvec2& point : drawn->outline) {
            low = glm::min(low, point);
            high = glm::max(high, point);
            // On the ellipse, but for what was left out.
            QVERIFY(std::abs(glm::length(point / glm::dvec2(0.4, 1.0)) - 1.0) < 0.02);
        }
        QCOMPARE(low.y, -1.0);
        QCOMPARE(high.y, 1.0);
        QVERIFY(std::abs(low.x + high.x) < 1e-12);
        QVERIFY(drawn->outline.size() > 12 && drawn->outline.size() < 120);
    }

    void whatCoversNothingIsNoMask()
    {
        QVERIFY(!ui::drawnToolMask({}, 0.1));
        QVERIFY(!ui::drawnToolMask({{1.0, 1.0}, {2.0, 2.0}}, 0.1));
        QVERIFY(!ui::drawnToolMask(Curve(9, {3.0, 3.0}), 0.1));
        QVERIFY(
            !ui::drawnToolMask({{0.0, 0.0}, {5.0, 5.0}, {9.0, 9.0}, {2.0, 2.0}}, 0.01)); // a line
        QVERIFY(
            ui::drawnToolMask({{0.0, 0.0}, {9.0, 0.3}, {9.0, 0.6}, {0.0, 0.3}}, 0.01)); // a slit
        // An eight: its halves wind the other way round and both count.
        QVERIFY(ui::drawnToolMask({{0.0, 0.0}, {4.0, 4.0}, {4.0, 0.0}, {0.0, 4.0}}, 0.01));
    }

    void itIsReadAsItWasWritten()
    {
        const auto drawn = ui::drawnToolMask(ellipse({1.0, 2.0}, {7.0, 3.0}, 77), 0.05);
        QVERIFY(drawn);
        QVERIFY(ui::outlineFromJson(ui::outlineJson(drawn->outline)) == drawn->outline);
        const auto point = [](double x, double y) { return QJsonArray{x, y}; };
        for (const QJsonValue& damaged : std::vector<QJsonValue>{QJsonValue(), 7, QJsonArray(),
                 QJsonArray{point(0, 0), point(1, 1)},
                 QJsonArray{point(0, 0), point(1, 0), point(1, 2)},
                 QJsonArray{point(0, 0), point(1, 0), QJsonArray{1}},
                 QJsonArray{point(0, 0), point(1, 0), QStringLiteral("here")},
                 QJsonArray{point(-1, -1), point(0, 0), point(1, 1)}})
            QVERIFY(ui::outlineFromJson(damaged).empty());
        QCOMPARE(ui::outlineFromJson(QJsonArray{point(-1, 0), point(1, 0), point(1, 1)}).size(),
            std::size_t(3));
    }
};

BURIN_PLAIN_TEST(ToolMaskOutlineTest)

} // namespace toolMaskOutlineTest

#include "ToolMaskOutlineTest.moc"
