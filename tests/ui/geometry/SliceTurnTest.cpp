// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/SliceTurn.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>
#include <set>
#include <vector>

namespace sliceTurnTest {

using ui::SliceAxes;
using ui::SliceTurn;

namespace {

/// Places on the screen from its middle, rightwards and downwards.
struct Screen {
    int right;
    int down;
};

/// Where the axes put a place of the patient: the oracle that knows no turns.
Screen seenAt(const SliceAxes& axes, const glm::dvec3& placeLps)
{
    return {int(glm::dot(placeLps, axes.rightLps)), int(glm::dot(placeLps, axes.downLps))};
}

} // namespace

class SliceTurnTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachStepMovesThePicture();
    void anySequenceMovesThePicture();
    void thereAreEight();
    void theNormalIsRightTimesDown();
};

void SliceTurnTest::eachStepMovesThePicture()
{
    const SliceAxes axial = ui::sliceAxes(ui::SliceOrientation::Axial);
    const glm::dvec3 place = 5.0 * axial.rightLps + 2.0 * axial.downLps;
    const auto at = [&](const SliceTurn& turn) {
        const Screen seen = seenAt(turn.of(axial), place);
        return std::pair(seen.right, seen.down);
    };
    const SliceTurn upright;
    QVERIFY(upright.isUpright());
    QCOMPARE(at(upright), std::pair(5, 2));
    QCOMPARE(at(upright.flippedLeftRight()), std::pair(-5, 2));
    QCOMPARE(at(upright.flippedTopBottom()), std::pair(5, -2));
    // What is on the right goes to the bottom.
    QCOMPARE(at(upright.turnedClockwise()), std::pair(-2, 5));
}

/// However it lies, a step does to the picture on the screen what its name says.
void SliceTurnTest::anySequenceMovesThePicture()
{
    std::mt19937 random(20261127);
    for (const ui::SliceOrientation orientation : {ui::SliceOrientation::Axial,
             ui::SliceOrientation::Sagittal, ui::SliceOrientation::Coronal}) {
        const SliceAxes upright = ui::sliceAxes(orientation);
        const glm::dvec3 place = 7.0 * upright.rightLps + 3.0 * upright.downLps;
        SliceTurn turn;
        Screen expected{7, 3};
        for (int step = 0; step < 200; ++step) {
            switch (std::uniform_int_distribution(0, 2)(random)) {
            case 0:
                turn = turn.flippedLeftRight();
                expected = {-expected.right, expected.down};
                break;
            case 1:
                turn = turn.flippedTopBottom();
                expected = {expected.right, -expected.down};
                break;
            default:
                turn = turn.turnedClockwise();
                expected = {-expected.down, expected.right};
            }
            const Screen seen = seenAt(turn.of(upright), place);
            QCOMPARE(seen.right, expected.right);
            QCOMPARE(seen.down, expected.down);
        }
    }
}

void SliceTurnTest::thereAreEight()
{
    std::set<std::pair<bool, int>> seen;
    for (const bool flipped : {false, true}) {
        SliceTurn turn = flipped ? SliceTurn().flippedTopBottom() : SliceTurn();
        const SliceTurn first = turn;
        for (int quarter = 0; quarter < 4; ++quarter) {
            QVERIFY(turn.quarters >= 0 && turn.quarters < 4);
            seen.insert({turn.mirrored, turn.quarters});
            turn = turn.turnedClockwise();
        }
        QVERIFY(turn == first);
        QVERIFY(turn.flippedLeftRight().flippedLeftRight() == turn);
    }
    QCOMPARE(seen.size(), std::size_t(8));
}

void SliceTurnTest::theNormalIsRightTimesDown()
{
    const SliceAxes coronal = ui::sliceAxes(ui::SliceOrientation::Coronal);
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters) {
            const SliceAxes axes = SliceTurn{mirrored, quarters}.of(coronal);
            QVERIFY(glm::length(glm::cross(axes.rightLps, axes.downLps) - axes.normalLps) < 1e-12);
            QCOMPARE(axes.normalLps == coronal.normalLps, !mirrored);
        }
    }
}

BURIN_PLAIN_TEST(SliceTurnTest)

} // namespace sliceTurnTest

#include "SliceTurnTest.moc"
