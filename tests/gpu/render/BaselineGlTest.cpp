// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameFixture.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>
#include <cstdlib>

namespace baselineGlTest {

using namespace gpu;

namespace {

/// A shell of bone around tissue with a bright knot, drilled open, with two segments inside.
double phantom(const glm::dvec3& lps)
{
    const double r = glm::length(lps * glm::dvec3(1.0, 0.85, 0.95));
    const auto smooth = [](double edge) { return 1.0 / (1.0 + std::exp(-edge / 0.7)); };
    const double shell = smooth(30.0 - r) * smooth(r - 25.0);
    const double knot = smooth(5.0 - glm::length(lps - glm::dvec3(8.0, 5.0, -6.0)));
    return 1000.0 * smooth(34.0 - r) + 1200.0 * shell + 500.0 * knot;
}

} // namespace

/// Pictures as they were when someone looked at them, drawn by llvmpipe. Tolerance: the mean
/// difference over all channels is at most 1.0 of 255, and at most 0.5 % of the pixels differ by
/// more than 24, so that another driver's rounding passes and another look does not.
///
/// After a wanted change: BURIN_WRITE_BASELINES=1 BaselineGlTest, then look at each picture.
class BaselineGlTest : public test::GlTest {
    Q_OBJECT

    static Scene view(RenderMode mode, bool orthographic)
    {
        VolumeScene scene;
        scene.mode = mode;
        scene.eyeLps = {110.0, -190.0, 120.0};
        scene.heightMm = 88.0;
        scene.orthographic = orthographic;
        scene.surfaceThreshold = 1500.0;
        scene.mipWindow = {1600.0, 1400.0};
        scene.xrayWindow = {700.0, 1300.0};
        scene.transferFunction.points = {{600.0, 0xB06048, 0.0}, {1000.0, 0xC87860, 0.03},
            {1300.0, 0xD89070, 0.05}, {1700.0, 0xF0DCC0, 0.5}, {2300.0, 0xFFF8EC, 0.8}};
        return scene;
    }

private Q_SLOTS:
    void looksAsBefore_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("sculpted");
        for (const char* name : {"surface", "perspective", "dvr", "mip", "xray", "slice"}) {
            for (const bool sculpted : {false, true}) {
                const QString file = QString::fromLatin1(name)
                    + (sculpted ? QStringLiteral("-sculpted") : QString());
                QTest::newRow(qPrintable(file)) << QString::fromLatin1(name) << sculpted;
            }
        }
    }

    void looksAsBefore()
    {
        QFETCH(QString, name);
        QFETCH(bool, sculpted);
        test::FrameFixture fixture;
        fixture.open(test::centredGeometry({72, 80, 64}, {1.0, 1.0, 1.2}), phantom);
        SegmentDisplay segments;
        if (sculpted) {
            segments.rgb[1] = 0x4AA3FF;
            segments.rgb[2] = 0x59C07A;
            segments.visible[1] = segments.visible[2] = true;
            fixture.carveBox({{36, 0, 34}, {60, 40, 64}});
            const core::VoxelBox first{{38, 22, 36}, {46, 32, 46}};
            const core::VoxelBox second{{46, 22, 36}, {54, 32, 42}};
            fixture.fill(VolumeField::Labels, first, 1);
            fixture.fill(VolumeField::Labels, second, 2);
            fixture.fill(VolumeField::Segmentation, first, 255);
            fixture.fill(VolumeField::Segmentation, second, 255);
        }
        Scene scene = view(name == QLatin1String("dvr") ? RenderMode::Dvr
                : name == QLatin1String("mip")          ? RenderMode::Mip
                : name == QLatin1String("xray")         ? RenderMode::Xray
                                                        : RenderMode::Surface,
            name != QLatin1String("perspective"));
        if (name == QLatin1String("slice")) {
            SliceScene slice;
            slice.centreLps = {0.0, 0.0, 8.0};
            slice.mmPerPixel = 0.45;
            slice.window = {1100.0, 2000.0};
            scene = slice;
        }
        const QImage drawn = test::imageOf(fixture.draw(scene, {220, 180}, segments));
        const QString file = QStringLiteral(BURIN_TEST_DATA_DIR "/baselines/%1.png")
                                 .arg(QString::fromUtf8(QTest::currentDataTag()));
        if (qEnvironmentVariableIsSet("BURIN_WRITE_BASELINES"))
            QVERIFY(drawn.convertToFormat(QImage::Format_RGB888).save(file));
        const QImage known = QImage(file).convertToFormat(QImage::Format_RGBA8888);
        QVERIFY2(!known.isNull(), qPrintable(file));
        QCOMPARE(drawn.size(), known.size());
        double sum = 0.0;
        int off = 0;
        for (int y = 0; y < known.height(); ++y) {
            const uchar* a = drawn.constScanLine(y);
            const uchar* b = known.constScanLine(y);
            for (int x = 0; x < known.width(); ++x) {
                int most = 0;
                for (int channel = 0; channel < 3; ++channel) {
                    const int apart = std::abs(int(a[4 * x + channel]) - int(b[4 * x + channel]));
                    sum += apart;
                    most = std::max(most, apart);
                }
                off += most > 24 ? 1 : 0;
            }
        }
        const double pixels = double(known.width()) * known.height();
        QVERIFY2(sum / (3.0 * pixels) <= 1.0 && off <= 0.005 * pixels,
            qPrintable(
                QStringLiteral("mean %1, %2 pixels off").arg(sum / (3.0 * pixels)).arg(off)));
    }
};

BURIN_TEST(BaselineGlTest)

} // namespace baselineGlTest

#include "BaselineGlTest.moc"
