// SPDX-License-Identifier: Apache-2.0
#include "core/measure/WoundArea.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>

namespace woundAreaTest {

using core::isWound;
using core::woundArea;

namespace {

bool isNear(double a, double b, double most)
{
    return std::abs(a - b) <= most;
}

} // namespace

class WoundAreaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void plainOnesHaveTheirArea()
    {
        const std::vector<glm::dvec2> square{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        QCOMPARE(woundArea(square), 12.0);
        QCOMPARE(woundArea({square.rbegin(), square.rend()}), 12.0); // in either sense
        QCOMPARE(woundArea({{0, 0}, {5, 1}, {2, 6}}), 14.0);
        // With a dent.
        QVERIFY(isNear(woundArea({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}), 10.0, 1e-12));
    }

    /// The shoelace formula would say 0 of the eight, and count the lap of the two twice.
    void crossingOnesHaveWhatTheyWindAround()
    {
        QVERIFY(isNear(woundArea({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), 2.0, 1e-12));
        // Two squares of 3 × 3 that share 1 × 1, drawn in one go.
        QVERIFY(isNear(woundArea({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 2}, {5, 2}, {5, 5}, {2, 5},
                           {2, 3}, {0, 3}}),
            17.0, 1e-12));
        // Twice around the same square.
        QCOMPARE(woundArea({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}), 16.0);
        // A star of five points holds its middle, around which it winds twice.
        std::vector<glm::dvec2> star;
        for (int i = 0; i < 5; ++i)
            star.emplace_back(std::cos(i * 4.0 * M_PI / 5.0), std::sin(i * 4.0 * M_PI / 5.0));
        // 10 · tan(18°) / (3 − tan²(18°)) of the radius squared.
        const double tangent = std::tan(M_PI / 10.0);
        QVERIFY(isNear(woundArea(star), 10.0 * tangent / (3.0 - tangent * tangent), 1e-9));
    }

    void linesHaveNone()
    {
        QCOMPARE(woundArea({}), 0.0);
        QCOMPARE(woundArea({{1, 1}}), 0.0);
        QCOMPARE(woundArea({{0, 0}, {5, 0}, {2, 0}}), 0.0);
        QVERIFY(isNear(woundArea({{0, 0}, {5, 5}, {2, 2}}), 0.0, 1e-12));
    }

    /// Random scribbles against the share of a fine grid of places that lie inside.
    void areaAndInsideAgree()
    {
        test::Random random(41);
        for (int round = 0; round < 20; ++round) {
            std::vector<glm::dvec2> scribble;
            for (int corner = test::randomInt(random, 3, 9); corner > 0; --corner)
                scribble.emplace_back(test::randomUnit(random), test::randomUnit(random));
            constexpr int fine = 400;
            int inside = 0;
            for (int y = 0; y < fine; ++y) {
                for (int x = 0; x < fine; ++x)
                    inside += isWound(scribble, {(x + 0.5) / fine, (y + 0.5) / fine}) ? 1 : 0;
            }
            QVERIFY(isNear(woundArea(scribble), double(inside) / (fine * fine), 0.01));
        }
    }

    void theBorderLiesInside()
    {
        const std::vector<glm::dvec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
        QVERIFY(isWound(square, {0, 0}) && isWound(square, {4, 4}) && isWound(square, {2, 4}));
        QVERIFY(isWound(square, {4, 1}) && isWound(square, {2, 2}));
        QVERIFY(!isWound(square, {4.001, 1}) && !isWound(square, {-0.001, 0}));
        QVERIFY(!isWound(square, {2, 5}));
    }
};

BURIN_TEST(WoundAreaTest)

} // namespace woundAreaTest

#include "WoundAreaTest.moc"
