// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/EarlyPicture.h"

#include <QTest>

#include <cmath>

namespace earlyPictureGlTest {

namespace {

/// Two in three voxels of a slice wander through the window, so that interpolation shows.
int codeOf(const glm::ivec3& at)
{
    return 20000 + (at.x * 37 + at.y * 91 + at.z * 13) % 400 * 20;
}

/// A slice of what FrameFixture holds.
core::EarlySlice sliceOf(
    const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding, int slice)
{
    core::EarlySlice early;
    early.volume.geometry = geometry;
    early.volume.encoding = encoding;
    early.slice = slice;
    for (int y = 0; y < geometry.size.y; ++y) {
        for (int x = 0; x < geometry.size.x; ++x)
            early.codes.push_back(std::uint16_t(codeOf({x, y, slice})));
    }
    return early;
}

} // namespace

/// What stands in a slice view while the rest is read is what the engine draws afterwards.
class EarlyPictureGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void isWhatTheEngineDraws_data();
    void isWhatTheEngineDraws();
    void noneOfAnotherPlane();
};

void EarlyPictureGlTest::isWhatTheEngineDraws_data()
{
    QTest::addColumn<bool>("inverted");
    QTest::addColumn<double>("mmPerPixel");
    QTest::addColumn<double>("turnDegrees"); ///< of the slices, in their plane
    QTest::addColumn<gpu::Interpolation>("interpolation");
    using gpu::Interpolation;
    QTest::newRow("as it is") << false << 0.31 << 0.0 << Interpolation::Linear;
    QTest::newRow("dark is high") << true << 0.31 << 0.0 << Interpolation::Linear;
    QTest::newRow("small") << false << 1.7 << 0.0 << Interpolation::Linear;
    QTest::newRow("on its face") << false << 0.4 << 180.0 << Interpolation::Linear;
    QTest::newRow("turned in its plane") << false << 0.4 << 17.0 << Interpolation::Linear;
    QTest::newRow("voxels") << false << 0.31 << 0.0 << Interpolation::Nearest;
    QTest::newRow("voxels, turned") << true << 0.4 << 17.0 << Interpolation::Nearest;
}

void EarlyPictureGlTest::isWhatTheEngineDraws()
{
    QFETCH(bool, inverted);
    QFETCH(double, mmPerPixel);
    QFETCH(double, turnDegrees);
    QFETCH(gpu::Interpolation, interpolation);
    core::VolumeGeometry geometry;
    geometry.size = {44, 36, 9};
    const double turn = glm::radians(turnDegrees);
    const glm::dvec3 row(std::cos(turn), std::sin(turn), 0.0);
    const glm::dvec3 column(-std::sin(turn), std::cos(turn), 0.0);
    geometry.indexToWorld[0] = glm::dvec4(row * 0.75, 0.0);
    geometry.indexToWorld[1] = glm::dvec4(column * 1.25, 0.0);
    geometry.indexToWorld[2] = glm::dvec4(0.0, 0.0, 2.0, 0.0);
    geometry.indexToWorld[3] = glm::dvec4(-12.0, 7.0, 30.0, 1.0);
    const core::VoxelEncoding encoding{.rescaleSlope = 0.5, .rescaleIntercept = -3000.0};
    m_fixture->open(
        geometry,
        [&](const glm::dvec3& lps) {
            return double(codeOf(glm::ivec3(glm::round(geometry.toIndex(lps)))));
        },
        encoding);
    const core::EarlySlice early = sliceOf(geometry, encoding, 4);
    gpu::SliceScene scene;
    scene.centreLps = geometry.toWorld({21.37, 17.91, 4.0});
    scene.mmPerPixel = mmPerPixel;
    scene.window = {.centre = 9000.0, .width = 2500.0};
    scene.inverted = inverted;
    scene.interpolation = interpolation;
    const glm::ivec2 size(201, 140);
    const QImage drawn = test::imageOf(m_fixture->draw(scene, size));
    const QImage foretold = ui::earlyPicture(early, scene, {size.x, size.y});
    QCOMPARE(foretold.size(), drawn.size());
    int lit = 0;
    int onTheRim = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int off = qGray(drawn.pixel(x, y)) - qGray(foretold.pixel(x, y));
            lit += qGray(drawn.pixel(x, y)) > 20 ? 1 : 0;
            // Where the volume, or a voxel, ends a pixel may fall on either side, by the float's
            // last bit.
            onTheRim += std::abs(off) > 1 ? 1 : 0;
        }
    }
    QVERIFY2(lit > 300, qPrintable(QString::number(lit)));
    QVERIFY2(onTheRim <= 4, qPrintable(QString::number(onTheRim)));
}

void EarlyPictureGlTest::noneOfAnotherPlane()
{
    const core::VolumeGeometry geometry = test::centredGeometry({20, 20, 9});
    const core::EarlySlice early = sliceOf(geometry, {}, 4);
    gpu::SliceScene scene;
    scene.centreLps = geometry.toWorld({9.5, 9.5, 4.0});
    QVERIFY(!ui::earlyPicture(early, scene, {40, 40}).isNull());
    // The next slice; between the two; across.
    gpu::SliceScene other = scene;
    other.centreLps = geometry.toWorld({9.5, 9.5, 5.0});
    QVERIFY(ui::earlyPicture(early, other, {40, 40}).isNull());
    other.centreLps = geometry.toWorld({9.5, 9.5, 4.4});
    QVERIFY(ui::earlyPicture(early, other, {40, 40}).isNull());
    other = scene;
    other.downLps = {0.0, 0.0, -1.0};
    QVERIFY(ui::earlyPicture(early, other, {40, 40}).isNull());
    // Slightly tilted: a corner of the picture would be the next slice's.
    other = scene;
    other.downLps = glm::normalize(glm::dvec3(0.0, 1.0, 0.02));
    QVERIFY(ui::earlyPicture(early, other, {40, 40}).isNull());
    QVERIFY(ui::earlyPicture(early, scene, {}).isNull());
}

BURIN_TEST(EarlyPictureGlTest)

} // namespace earlyPictureGlTest

#include "EarlyPictureGlTest.moc"
