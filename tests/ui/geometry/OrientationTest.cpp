// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "ui/geometry/Camera.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/geometry/ViewPlane.h"

#include <QTest>

#include <algorithm>

namespace orientationTest {

class OrientationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void letters_data();
    void letters();
    void planesAreRadiological();
    void stackOfAnAlignedVolumeIsItsSlices();
    void stackCoversAnObliqueVolume();
    void obliqueSlabsAreSampledBetweenSlices();
    void movingKeepsThePlace();
    void cameraSides_data();
    void cameraSides();
    void orbitFollowsThePointer();
};

using glm::dvec3;

namespace {

ui::SliceStack stackOf(const core::VolumeGeometry& geometry, ui::SliceOrientation orientation)
{
    return ui::sliceStack(geometry, ui::sliceAxes(orientation).normalLps);
}

} // namespace

void OrientationTest::letters_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<QString>("letters");
    const auto row = [](double x, double y, double z, const char* letters) {
        QTest::newRow(letters) << x << y << z << QString::fromLatin1(letters);
    };
    row(1, 0, 0, "L");
    row(-1, 0, 0, "R");
    row(0, 1, 0, "P");
    row(0, -1, 0, "A");
    row(0, 0, 1, "S");
    row(0, 0, -1, "I");
    row(0.9, -0.4, 0, "LA");
    row(-0.3, 0.2, 0.9, "SRP");
    row(0, 0.05, -1, "I");
    row(2, 2, 2, "LPS");
}

void OrientationTest::letters()
{
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QTEST(ui::directionLetters(dvec3(x, y, z)), "letters");
}

void OrientationTest::planesAreRadiological()
{
    const auto axial = ui::sliceAxes(ui::SliceOrientation::Axial);
    QCOMPARE(ui::directionLetters(-axial.rightLps), QStringLiteral("R"));
    QCOMPARE(ui::directionLetters(-axial.downLps), QStringLiteral("A"));
    const auto coronal = ui::sliceAxes(ui::SliceOrientation::Coronal);
    QCOMPARE(ui::directionLetters(-coronal.rightLps), QStringLiteral("R"));
    QCOMPARE(ui::directionLetters(-coronal.downLps), QStringLiteral("S"));
    const auto sagittal = ui::sliceAxes(ui::SliceOrientation::Sagittal);
    QCOMPARE(ui::directionLetters(-sagittal.rightLps), QStringLiteral("A"));
    QCOMPARE(ui::directionLetters(-sagittal.downLps), QStringLiteral("S"));
}

void OrientationTest::stackOfAnAlignedVolumeIsItsSlices()
{
    core::VolumeGeometry geometry;
    geometry.size = {20, 30, 13};
    geometry.indexToWorld = glm::dmat4(1.0);
    geometry.indexToWorld[2][2] = 2.5;
    geometry.indexToWorld[3] = {5.0, -7.0, -100.0, 1.0};
    const auto stack = stackOf(geometry, ui::SliceOrientation::Axial);
    QCOMPARE(stack.count, 13);
    QCOMPARE(stack.stepMm, 2.5);
    for (int k = 0; k < 13; ++k)
        QCOMPARE(stack.numberAt(geometry.toWorld(dvec3(3, 4, k))), k);
    QCOMPARE(stackOf(geometry, ui::SliceOrientation::Coronal).count, 30);
    QCOMPARE(stackOf(geometry, ui::SliceOrientation::Sagittal).count, 20);
}

void OrientationTest::stackCoversAnObliqueVolume()
{
    core::VolumeGeometry geometry;
    geometry.size = {40, 40, 10};
    const double c = std::cos(0.5);
    const double s = std::sin(0.5);
    geometry.indexToWorld =
        glm::dmat4({1, 0, 0, 0}, {0, c, s, 0}, {0, -3.0 * s, 3.0 * c, 0}, {12.0, 9.0, -40.0, 1});
    const auto stack = stackOf(geometry, ui::SliceOrientation::Axial);
    double lowest = 1e9;
    double highest = -1e9;
    for (const dvec3& corner : geometry.cornersLps()) {
        lowest = std::min(lowest, corner.z);
        highest = std::max(highest, corner.z);
    }
    QVERIFY(stack.firstMm >= lowest - 0.5 * stack.stepMm);
    QVERIFY(stack.firstMm <= lowest + stack.stepMm);
    const double last = stack.firstMm + (stack.count - 1) * stack.stepMm;
    QVERIFY(last <= highest + 0.5 * stack.stepMm);
    QVERIFY(last >= highest - stack.stepMm);
}

void OrientationTest::obliqueSlabsAreSampledBetweenSlices()
{
    // Slices of 3 mm with pixels of 0.5 mm.
    core::VolumeGeometry geometry;
    geometry.size = {64, 64, 30};
    geometry.indexToWorld = glm::dmat4(
        {0.5, 0.0, 0.0, 0.0}, {0.0, 0.5, 0.0, 0.0}, {0.0, 0.0, 3.0, 0.0}, {1.0, 2.0, 3.0, 1.0});
    const auto samples = [&geometry](const dvec3& normal) {
        return ui::samplesPerSlice(geometry, ui::sliceStack(geometry, glm::normalize(normal)));
    };
    // All that there is lies on the slices.
    for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, -1)})
        QCOMPARE(samples(axis), 1);
    QCOMPARE(samples({0.001, 0.0, 1.0}), 1); // cosines are rounded in files
    // At 3-4-5 a step of 2.4 mm passes 2.88 voxels aside: 5 samples of 0.58 are too far apart.
    QCOMPARE(samples({0.6, 0.0, 0.8}), 7);
    // Nearly along the slices a step is one of their pixels.
    QCOMPARE(samples({1.0, 0.3, 0.0}), 3);
    for (const dvec3& normal : {dvec3(0.2, 0.3, 1.0), dvec3(1, 1, 1), dvec3(-2, 5, 1)}) {
        const ui::SliceStack stack = ui::sliceStack(geometry, glm::normalize(normal));
        const int count = ui::samplesPerSlice(geometry, stack);
        QVERIFY(count % 2 == 1);
        const dvec3 step = stack.normalLps * stack.stepMm / double(count);
        const dvec3 apart = glm::abs(geometry.toIndex(geometry.toWorld(dvec3(0.0)) + step));
        QVERIFY(std::max({apart.x, apart.y, apart.z}) < 0.501);
    }
}

void OrientationTest::movingKeepsThePlace()
{
    core::VolumeGeometry geometry;
    geometry.size = {10, 10, 10};
    const auto stack = stackOf(geometry, ui::SliceOrientation::Sagittal);
    const dvec3 moved = stack.movedTo(dvec3(3.0, 4.4, 5.5), 0);
    QCOMPARE(moved, dvec3(9.0, 4.4, 5.5)); // numbers grow towards the patient's right
    QCOMPARE(stack.movedTo(moved, 99), dvec3(0.0, 4.4, 5.5));
}

void OrientationTest::cameraSides_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<QString>("right");
    QTest::addColumn<QString>("up");
    QTest::newRow("front") << 0.0 << -1.0 << 0.0 << QStringLiteral("L") << QStringLiteral("S");
    QTest::newRow("back") << 0.0 << 1.0 << 0.0 << QStringLiteral("R") << QStringLiteral("S");
    QTest::newRow("left") << 1.0 << 0.0 << 0.0 << QStringLiteral("P") << QStringLiteral("S");
    QTest::newRow("right") << -1.0 << 0.0 << 0.0 << QStringLiteral("A") << QStringLiteral("S");
    QTest::newRow("above") << 0.0 << 0.0 << 1.0 << QStringLiteral("R") << QStringLiteral("A");
    QTest::newRow("below") << 0.0 << 0.0 << -1.0 << QStringLiteral("L") << QStringLiteral("A");
}

void OrientationTest::cameraSides()
{
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    ui::Camera camera;
    camera.orbit(33.0, -12.0);
    camera.lookFrom({x, y, z});
    QTEST(ui::directionLetters(camera.right()), "right");
    QTEST(ui::directionLetters(camera.up), "up");
}

void OrientationTest::orbitFollowsThePointer()
{
    // What is nearest to the viewer goes where the pointer goes.
    ui::Camera camera;
    const dvec3 nose = camera.towardsViewer;
    camera.orbit(20.0, 0.0);
    QVERIFY(glm::dot(nose, camera.right()) > 0.3);
    camera = {};
    camera.orbit(0.0, 20.0);
    QVERIFY(glm::dot(nose, camera.up) < -0.3);
    for (int i = 0; i < 500; ++i)
        camera.orbit(7.0, 3.0);
    QVERIFY(std::abs(glm::length(camera.up) - 1.0) < 1e-9);
    QVERIFY(std::abs(glm::dot(camera.up, camera.towardsViewer)) < 1e-9);
}

BURIN_TEST(OrientationTest)

} // namespace orientationTest

#include "OrientationTest.moc"
