// SPDX-License-Identifier: Apache-2.0
#include "ui/views/MprPlanes.h"

#include "tests/support/program/TestProgram.h"

#include <QSignalSpy>
#include <QTest>

#include <array>
#include <cmath>
#include <random>

namespace mprPlanesTest {

using ui::MprPlanes;
using ui::SliceAxes;
using ui::SliceOrientation;

namespace {

constexpr double tiny = 1e-9;

/// The angle of the line in which a plane is seen in a slice, clockwise from its right, 0 … π.
double lineAngle(const MprPlanes& planes, SliceOrientation seenIn, SliceOrientation plane)
{
    const SliceAxes& seen = planes.axes(seenIn);
    const glm::dvec3 along = glm::cross(seen.normalLps, planes.axes(plane).normalLps);
    const double angle = std::atan2(glm::dot(along, seen.downLps), glm::dot(along, seen.rightLps));
    return angle < 0.0 ? angle + M_PI : angle;
}

/// Whether two angles of lines are the same, where π is 0 again.
bool sameLine(double a, double b)
{
    return std::abs(std::sin(a - b)) < tiny;
}

bool isExact(const SliceAxes& axes)
{
    return std::abs(glm::length(axes.rightLps) - 1.0) < 1e-12
        && std::abs(glm::length(axes.downLps) - 1.0) < 1e-12
        && std::abs(glm::dot(axes.rightLps, axes.downLps)) < 1e-12
        && glm::length(glm::cross(axes.rightLps, axes.downLps) - axes.normalLps) < 1e-12;
}

double cosineBetween(const MprPlanes& planes, SliceOrientation a, SliceOrientation b)
{
    return std::abs(glm::dot(planes.axes(a).normalLps, planes.axes(b).normalLps));
}

} // namespace

class MprPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void atFirstTheyLieAlongThePatient();
    void bothOthersTurnClockwise();
    void manyTurnsStayExactAndAtRightAngles();
    void oneTurnsAloneButNeverIntoAnother();
};

void MprPlanesTest::atFirstTheyLieAlongThePatient()
{
    MprPlanes planes;
    QSignalSpy changed(&planes, &MprPlanes::changed);
    QVERIFY(planes.alongPatient());
    for (const SliceOrientation each : MprPlanes::all)
        QVERIFY(planes.axes(each).normalLps == ui::sliceAxes(each).normalLps);
    planes.reset();
    QCOMPARE(changed.size(), 0);
    planes.turnOthers(SliceOrientation::Sagittal, 0.1);
    QCOMPARE(changed.size(), 1);
    QVERIFY(!planes.alongPatient());
    planes.reset();
    QCOMPARE(changed.size(), 2);
    QVERIFY(planes.alongPatient());
}

void MprPlanesTest::bothOthersTurnClockwise()
{
    for (const SliceOrientation seenIn : MprPlanes::all) {
        MprPlanes planes;
        const SliceAxes before = planes.axes(seenIn);
        for (const double radians : {0.3, -0.7, 2.0}) {
            std::array<double, 3> angles{};
            for (const SliceOrientation each : MprPlanes::all)
                angles[std::size_t(each)] = each == seenIn ? 0.0 : lineAngle(planes, seenIn, each);
            planes.turnOthers(seenIn, radians);
            for (const SliceOrientation each : MprPlanes::all) {
                if (each != seenIn)
                    QVERIFY(sameLine(
                        lineAngle(planes, seenIn, each), angles[std::size_t(each)] + radians));
            }
            QVERIFY(planes.axes(seenIn).rightLps == before.rightLps);
            QVERIFY(planes.axes(seenIn).downLps == before.downLps);
        }
    }
}

void MprPlanesTest::manyTurnsStayExactAndAtRightAngles()
{
    std::mt19937 random(354);
    std::uniform_real_distribution<double> radians(-1.5, 1.5);
    MprPlanes planes;
    for (int turn = 0; turn < 2000; ++turn) {
        planes.turnOthers(MprPlanes::all[random() % 3], radians(random));
        for (const SliceOrientation each : MprPlanes::all)
            QVERIFY(isExact(planes.axes(each)));
    }
    // Each is made exact for itself, so what lies between them adds up, but does not show.
    QVERIFY(cosineBetween(planes, SliceOrientation::Axial, SliceOrientation::Sagittal) < 1e-9);
    QVERIFY(cosineBetween(planes, SliceOrientation::Axial, SliceOrientation::Coronal) < 1e-9);
    QVERIFY(cosineBetween(planes, SliceOrientation::Sagittal, SliceOrientation::Coronal) < 1e-9);
}

void MprPlanesTest::oneTurnsAloneButNeverIntoAnother()
{
    MprPlanes planes;
    const SliceAxes sagittal = planes.axes(SliceOrientation::Sagittal);
    const double before = lineAngle(planes, SliceOrientation::Axial, SliceOrientation::Coronal);
    planes.turnOne(SliceOrientation::Axial, SliceOrientation::Coronal, 0.4);
    QVERIFY(sameLine(
        lineAngle(planes, SliceOrientation::Axial, SliceOrientation::Coronal), before + 0.4));
    QVERIFY(planes.axes(SliceOrientation::Sagittal).rightLps == sagittal.rightLps);
    // Not itself.
    planes.turnOne(SliceOrientation::Axial, SliceOrientation::Axial, 0.4);
    QVERIFY(planes.axes(SliceOrientation::Axial).rightLps
        == ui::sliceAxes(SliceOrientation::Axial).rightLps);

    std::mt19937 random(7);
    std::uniform_real_distribution<double> radians(-0.4, 0.4);
    for (int turn = 0; turn < 2000; ++turn) {
        const SliceOrientation plane = MprPlanes::all[random() % 3];
        const SliceOrientation seenIn = MprPlanes::all[random() % 3];
        planes.turnOne(seenIn, plane, radians(random));
        QVERIFY(isExact(planes.axes(plane)));
        for (const SliceOrientation a : MprPlanes::all) {
            for (const SliceOrientation b : MprPlanes::all)
                QVERIFY(a == b || cosineBetween(planes, a, b) <= 0.985);
        }
    }
    // Onto another one it is not turned at all.
    planes.reset();
    const glm::dvec3 coronal = planes.axes(SliceOrientation::Coronal).normalLps;
    planes.turnOne(SliceOrientation::Axial, SliceOrientation::Coronal, M_PI / 2.0);
    QVERIFY(planes.axes(SliceOrientation::Coronal).normalLps == coronal);
}

BURIN_TEST(MprPlanesTest)

} // namespace mprPlanesTest

#include "MprPlanesTest.moc"
