// SPDX-License-Identifier: Apache-2.0
#include "core/measure/MeasureHandles.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace measureHandlesTest {

using namespace core;
using Kind = Measurement::Kind;
using Points = std::vector<glm::dvec3>;

class MeasureHandlesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void endsMoveAlone()
    {
        const Measurement angle{
            .id = 1, .kind = Kind::Angle, .pointsLps = {{5, 0, 0}, {0, 0, 0}, {0, 5, 0}}};
        QCOMPARE(draggedPoints(angle, 1, {1, 1, 0}), (Points{{5, 0, 0}, {1, 1, 0}, {0, 5, 0}}));
        const Measurement arrow{.id = 1, .kind = Kind::Arrow, .pointsLps = {{5, 0, 0}, {0, 0, 0}}};
        QCOMPARE(draggedPoints(arrow, 0, {1, 1, 7}), (Points{{1, 1, 7}, {0, 0, 0}}));
    }

    void centresTakeAllAlong()
    {
        for (const Kind kind : {Kind::Ellipse, Kind::Rectangle, Kind::Outline}) {
            const Measurement region{
                .id = 1, .kind = kind, .pointsLps = {{5, 0, 0}, {9, 0, 0}, {5, 3, 0}}};
            QCOMPARE(
                draggedPoints(region, 0, {6, 1, 0}), (Points{{6, 1, 0}, {10, 1, 0}, {6, 4, 0}}));
        }
        const Measurement outline{
            .id = 1, .kind = Kind::Outline, .pointsLps = {{5, 0, 0}, {9, 0, 0}, {5, 3, 0}}};
        QCOMPARE(draggedPoints(outline, 2, {5, 4, 1}), (Points{{5, 1, 1}, {9, 1, 1}, {5, 4, 1}}));
        const Measurement ball{.id = 1, .kind = Kind::Ball, .pointsLps = {{5, 0, 0}, {9, 0, 0}}};
        QCOMPARE(draggedPoints(ball, 0, {0, 0, 2}), (Points{{0, 0, 2}, {4, 0, 2}}));
        QCOMPARE(draggedPoints(ball, 1, {5, 2, 0}), (Points{{5, 0, 0}, {5, 2, 0}}));
    }

    /// A half axis gets longer or shorter and stays perpendicular to the other one.
    void axesKeepTheirDirection()
    {
        for (const Kind kind : {Kind::Ellipse, Kind::Rectangle}) {
            const Measurement region{
                .id = 1, .kind = kind, .pointsLps = {{5, 0, 0}, {9, 0, 0}, {5, 3, 0}}};
            QCOMPARE(
                draggedPoints(region, 1, {7, 8, 2}), (Points{{5, 0, 0}, {7, 0, 0}, {5, 3, 0}}));
            QCOMPARE(
                draggedPoints(region, 2, {1, 6, 0}), (Points{{5, 0, 0}, {9, 0, 0}, {5, 6, 0}}));
        }
    }
};

BURIN_TEST(MeasureHandlesTest)

} // namespace measureHandlesTest

#include "MeasureHandlesTest.moc"
