// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QTest>

#include <cmath>

namespace partlyHiddenGlTest {

using namespace gpu;

namespace {

const glm::ivec2 frameSize(64, 64);
const glm::ivec3 size(48, 48, 48);
/// The far part shows less than the near one, in every mode; what is cut is a little more than
/// that.
constexpr double nearValue = 1000.0;
constexpr double farValue = 250.0;

VolumeScene scene(RenderMode mode)
{
    VolumeScene result;
    result.mode = mode;
    result.eyeLps = {0.0, -300.0, 0.0};
    result.heightMm = 64.0;
    result.surfaceThreshold = 100.0;
    result.mipWindow = {500.0, 1000.0};
    result.xrayWindow = {500.0, 1000.0};
    result.transferFunction.points = {{0.0, 0xFFFFFF, 0.05}, {2000.0, 0xFFFFFF, 0.05}};
    return result;
}

core::VoxelBox nearHalf()
{
    return {{0, 0, 0}, {size.x, size.y / 2, size.z}};
}

} // namespace

/// What sculpt layers hide only in part: pieces without a number, at their place.
class PartlyHiddenGlTest : public test::FrameTest {
    Q_OBJECT

    void openHalves()
    {
        m_fixture->open(test::centredGeometry(size),
            [](const glm::dvec3& lps) { return lps.y < -4.0 ? nearValue : farValue; });
        m_state = reference::DenseFields(size);
    }
    void cover(std::uint8_t layer, const core::VoxelBox& box)
    {
        for (int z = box.minimum.z; z < box.maximum.z; ++z)
            for (int y = box.minimum.y; y < box.maximum.y; ++y)
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    m_state.coverage(layer).at({x, y, z}) = 255;
        m_fixture->put(m_state);
    }
    /// Grey in the middle of the picture. @param shows 1 − what the layer hides
    double greyWith(VolumeScene view, double shows, double softness = 0.0)
    {
        view.pieces = {{.id = 0, .layer = 1, .opacity = float(shows), .softness = float(softness)}};
        const Frame frame = m_fixture->draw(view, frameSize);
        // Not for tools: none of it is told.
        if (!frame.pieces.empty())
            return -1.0;
        return test::pixel(frame, 32, 32).r;
    }

    reference::DenseFields m_state;

private Q_SLOTS:
    void hidesWhollyOrNotAtAll_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }
    void hidesWhollyOrNotAtAll()
    {
        QFETCH(int, mode);
        openHalves();
        const VolumeScene view = scene(RenderMode(mode));
        const double whole = test::pixel(m_fixture->draw(view, frameSize), 32, 32).r;
        cover(1, nearHalf());
        const double cut = test::pixel(m_fixture->draw(view, frameSize), 32, 32).r;
        QVERIFY2(mode == 0 || std::abs(whole - cut) > 5, qPrintable(QString::number(cut)));
        QVERIFY(std::abs(greyWith(view, 1.0) - whole) <= 2.0);
        QCOMPARE(greyWith(view, 0.0), cut);
    }

    /// A surface lets its share of what lies behind through.
    void surfacesShowTheirShare()
    {
        openHalves();
        cover(1, nearHalf());
        VolumeScene view = scene(RenderMode::Surface);
        view.eyeLps = {120.0, -260.0, 140.0}; // so that front and wall are lit differently
        const double behind = greyWith(view, 0.0);
        const double front = greyWith(view, 0.999);
        for (const double shows : {0.25, 0.5, 0.75}) {
            const double grey = greyWith(view, shows);
            QVERIFY2(std::abs(grey - shows * front - (1.0 - shows) * behind) < 3.0,
                qPrintable(QStringLiteral("%1 of %2 and %3").arg(grey).arg(front).arg(behind)));
        }
    }

    void volumeRenderingIsThinned()
    {
        openHalves();
        cover(1, nearHalf());
        cover(2, {{0, size.y / 2, 0}, size}); // all the rest is gone
        const VolumeScene view = scene(RenderMode::Dvr);
        const double full = greyWith(view, 0.999);
        for (const double shows : {0.25, 0.5, 0.75}) {
            const double expected = (1.0 - std::pow(1.0 - 0.05 * shows, size.y / 2))
                / (1.0 - std::pow(0.95, size.y / 2));
            QVERIFY2(std::abs(greyWith(view, shows) / full - expected) < 0.04,
                qPrintable(QStringLiteral("%1 of %2").arg(greyWith(view, shows)).arg(full)));
        }
    }

    void valuesCountByTheirShare()
    {
        openHalves();
        cover(1, nearHalf());
        for (const double shows : {0.1, 0.25, 0.5, 0.75}) {
            const double greatest = std::max(shows * nearValue, farValue) * 0.255;
            QVERIFY(std::abs(greyWith(scene(RenderMode::Mip), shows) - greatest) <= 2.0);
            const double cut = (20.0 * nearValue + 4.0 * farValue) / 24.0;
            const double mean = (shows * cut + farValue) / (shows + 1.0) * 0.255;
            QVERIFY(std::abs(greyWith(scene(RenderMode::Xray), shows) - mean) <= 4.0);
        }
    }

    /// A soft edge: matter fades out over what radiation reaches, about a millimetre of it in all.
    void aSoftEdgeFadesIntoTheCut()
    {
        openHalves();
        cover(1, {{12, 12, 12}, {36, 22, 36}}); // 10 mm thick
        cover(2, {{0, 0, 0}, size});
        const VolumeScene view = scene(RenderMode::Dvr);
        QCOMPARE(greyWith(view, 0.0), 0.0);
        const double full = greyWith(view, 0.999);
        const double soft = greyWith(view, 0.0, 1.0) / full;
        const double half = greyWith(view, 0.0, 0.5) / full;
        // 0.97 mm at each of both faces, by the kernel.
        const double expected = (1.0 - std::pow(0.95, 2 * 0.97)) / (1.0 - std::pow(0.95, 10.0));
        QVERIFY2(std::abs(soft - expected) < 0.06, qPrintable(QString::number(soft)));
        QVERIFY2(half > 0.05 && half < soft - 0.03, qPrintable(QString::number(half)));
        // Where half of it shows anyway, the edge adds to that.
        QVERIFY(greyWith(view, 0.5, 1.0) > greyWith(view, 0.5) + 2.0);
        // Other modes know no soft edge.
        for (const RenderMode mode : {RenderMode::Surface, RenderMode::Mip, RenderMode::Xray})
            QCOMPARE(greyWith(scene(mode), 0.0, 1.0), greyWith(scene(mode), 0.0));
    }
};

BURIN_TEST(PartlyHiddenGlTest)

} // namespace partlyHiddenGlTest

#include "PartlyHiddenGlTest.moc"
