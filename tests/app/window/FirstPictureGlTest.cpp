// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/fixtures/frames/FrameFixture.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/OpeningView.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace firstPictureGlTest {

namespace {

/// What of a picture is lit, and how.
struct Light {
    double share = 0.0; ///< of pixels that are no background
    double luminance = 0.0; ///< mean of these, 0 … 255
    double redness = 0.0; ///< of these: red / green
};

Light lightOf(const QImage& picture)
{
    glm::dvec3 sum(0.0);
    int lit = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor colour = picture.pixelColor(x, y);
            const glm::dvec3 rgb(colour.red(), colour.green(), colour.blue());
            if (glm::dot(rgb, glm::dvec3(0.299, 0.587, 0.114)) <= 12.0)
                continue;
            sum += rgb;
            ++lit;
        }
    }
    const glm::dvec3 mean = sum / std::max(double(lit), 1.0);
    return {.share = double(lit) / (double(picture.width()) * picture.height()),
        .luminance = glm::dot(mean, glm::dvec3(0.299, 0.587, 0.114)),
        .redness = mean.r / std::max(mean.g, 1.0)};
}

} // namespace

/// The first volume rendering of real studies, before anyone has touched a control: neither black
/// nor a fog of one colour. Tolerances are what somebody who looked at the pictures took for as
/// good: a fifth of the share that is lit, a quarter of its luminance, and 0.1 of its redness.
class FirstPictureGlTest : public test::GlTest {
    Q_OBJECT

private Q_SLOTS:
    void volumeRenderingIsReadable_data()
    {
        QTest::addColumn<QString>("study");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("luminance");
        QTest::addColumn<double>("redness");
        QTest::newRow("MR, head") << QStringLiteral("mr_t1_sag_mprage") << 0.18 << 118.0 << 1.20;
        QTest::newRow("CT, abdomen")
            << QStringLiteral("ct_abdomen_j2k_organs") << 0.125 << 112.0 << 1.19;
    }

    void volumeRenderingIsReadable()
    {
        QFETCH(QString, study);
        QFETCH(double, share);
        QFETCH(double, luminance);
        QFETCH(double, redness);
        const test::SharedCase data = test::sharedCase(study);
        if (data.source.isEmpty())
            QSKIP("no shared data here");
        const auto loaded = core::loadVolume(
            (data.unpacked.isEmpty() ? data.source : data.unpacked) + QStringLiteral("/dicom"));
        QVERIFY(loaded);
        const core::Volume& volume = loaded->volume;
        test::FrameFixture fixture;
        std::size_t next = 0;
        fixture.open(
            volume.geometry, [&](const glm::dvec3&) { return double(loaded->codes[next++]); },
            volume.encoding);
        ui::Workspace::VolumeDisplay display = ui::initialVolumeDisplay(volume);
        display.mode = gpu::RenderMode::Dvr;
        const QSize size(300, 200);
        ui::Camera camera = ui::openingCamera(volume.geometry);
        camera.heightMm = ui::fittingHeightMm(camera, volume.geometry, size);
        const QImage picture = test::imageOf(
            fixture.draw(ui::volumeScene(camera, display), {size.width(), size.height()}));
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            picture.save(folder + QStringLiteral("/first-%1.png").arg(study));
        const Light light = lightOf(picture);
        const QString told = QStringLiteral("%1 % lit, luminance %2, red / green %3")
                                 .arg(100.0 * light.share, 0, 'f', 1)
                                 .arg(light.luminance, 0, 'f', 1)
                                 .arg(light.redness, 0, 'f', 2);
        qInfo("%s", qPrintable(told));
        QVERIFY2(std::abs(light.share - share) <= 0.2 * share, qPrintable(told));
        QVERIFY2(std::abs(light.luminance - luminance) <= 0.25 * luminance, qPrintable(told));
        QVERIFY2(std::abs(light.redness - redness) <= 0.1, qPrintable(told));
    }
};

BURIN_TEST(FirstPictureGlTest)

} // namespace firstPictureGlTest

#include "FirstPictureGlTest.moc"
