// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QPainter>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace radiatedCutGlTest {

using namespace gpu;

namespace {

using Field = reference::DenseArray<std::uint8_t>;

/// Coverage of what a shape takes.
template <class Inside> Field coverageOf(const core::VolumeGeometry& geometry, Inside inside)
{
    Field field{geometry.size, {}};
    field.values.reserve(geometry.voxelCount());
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i)
                field.values.push_back(inside(geometry.toWorld(glm::dvec3(i, j, k))) ? 255 : 0);
    return field;
}

/// Voxels that are simply left out.
void leaveOut(test::FrameFixture& fixture, const Field& coverage)
{
    fixture.volume.radiation().upload<std::uint8_t>(coverage.values);
    fixture.volume.markDirty(VolumeField::Radiation, {glm::ivec3(0), coverage.size});
}

/// Standard deviation of the brightness in a picture's middle.
double spread(const Frame& frame)
{
    double sum = 0.0;
    double squares = 0.0;
    int pixels = 0;
    for (int y = 15; y < 75; ++y) {
        for (int x = 15; x < 75; ++x) {
            const double g = test::pixel(frame, x, y).g;
            sum += g;
            squares += g * g;
            ++pixels;
        }
    }
    const double mean = sum / pixels;
    return std::sqrt(std::max(squares / pixels - mean * mean, 0.0));
}

/// A part of the demonstration head: the forehead's left half and what lies behind it.
struct Forehead {
    explicit Forehead(const core::DemoStudy& study)
    {
        const glm::ivec3 first(96, 0, 72);
        geometry = study.geometry;
        geometry.size = glm::ivec3(236, 170, 200) - first;
        geometry.indexToWorld[3] = glm::dvec4(study.geometry.toWorld(glm::dvec3(first)), 1.0);
        for (int k = 0; k < geometry.size.z; ++k) {
            for (int j = 0; j < geometry.size.y; ++j) {
                const int row =
                    ((k + first.z) * study.geometry.size.y + j + first.y) * study.geometry.size.x;
                for (int i = 0; i < geometry.size.x; ++i)
                    codes.push_back(
                        std::uint16_t(study.hounsfield[std::size_t(row + i + first.x)] + 1024));
            }
        }
    }
    core::VolumeGeometry geometry;
    std::vector<std::uint16_t> codes;
};

} // namespace

/// A cut whose voxels are simply left out, against one that point radiation smooths.
class RadiatedCutGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    /// An oblique plane through one material is lit evenly: the spread of brightness over its face
    /// is at most a quarter of what voxels' steps make of it.
    void anObliqueCutIsEven_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<double>("most"); // of what steps make of it
        QTest::newRow("surface") << int(RenderMode::Surface) << 0.25;
        // Volume rendering sees through the first voxel, steps and all.
        QTest::newRow("DVR") << int(RenderMode::Dvr) << 0.8;
    }

    void anObliqueCutIsEven()
    {
        QFETCH(int, mode);
        QFETCH(double, most);
        const auto geometry = test::centredGeometry({64, 64, 64}, {0.9, 0.9, 1.2});
        m_fixture->open(geometry,
            [](const glm::dvec3& lps) { return glm::length(lps) < 27.0 ? 2000.0 : 100.0; });
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.25, -1.0, 0.4));
        const Field cut = coverageOf(
            geometry, [&](const glm::dvec3& lps) { return glm::dot(lps, normal) > 2.0; });
        VolumeScene view;
        view.mode = RenderMode(mode);
        view.eyeLps = 300.0 * glm::normalize(glm::dvec3(0.0, -1.0, 0.2));
        view.heightMm = 30.0;
        view.surfaceThreshold = 1000.0;
        view.transferFunction.points = {{1500.0, 0xF0E0D0, 0.0}, {1900.0, 0xF0E0D0, 0.9}};
        leaveOut(*m_fixture, cut);
        const double binary = spread(m_fixture->draw(view, {90, 90}));
        m_fixture->carve(cut);
        const double radiated = spread(m_fixture->draw(view, {90, 90}));
        QVERIFY2(binary > 1.0 && radiated <= most * binary,
            qPrintable(QStringLiteral("%1 against %2").arg(radiated).arg(binary)));
    }

    /// A carved face that is seen straight on shows the grey values of a slice just behind it, a
    /// little darker by the light.
    void carvedFacesShowWhatLiesBehind()
    {
        const auto geometry = test::centredGeometry({60, 60, 50}, {1.0, 1.0, 1.2});
        m_fixture->open(geometry, [](const glm::dvec3& lps) {
            const double wave = std::sin(0.25 * lps.x) * std::cos(0.2 * lps.z);
            return glm::length(lps) < 28.0 ? 2000.0 + 600.0 * wave : 100.0;
        });
        m_fixture->carveBox({{0, 0, 0}, {60, 28, 50}}); // the cut lies at y = -2 mm
        VolumeScene view;
        view.targetLps = {0.0, -2.0, 0.0};
        view.eyeLps = {0.0, -300.0, 0.0};
        view.heightMm = 40.0;
        view.surfaceThreshold = 1000.0;
        view.cutFaces = CutFaces::GreyValues;
        view.faceWindow = {2000.0, 1600.0};
        const glm::ivec2 size(60, 60);
        const Frame face = m_fixture->draw(view, size);
        SliceScene slice;
        slice.centreLps = {0.0, -1.5, 0.0};
        slice.downLps = {0.0, 0.0, -1.0};
        slice.mmPerPixel = view.heightMm / size.y;
        slice.window = view.faceWindow;
        slice.showCarved = false;
        const Frame known = m_fixture->draw(slice, size);
        for (int y = 6; y < 54; ++y) {
            for (int x = 6; x < 54; ++x) {
                const glm::ivec3 seen = test::pixel(face, x, y);
                const double expected = 0.93 * test::pixel(known, x, y).g;
                QVERIFY2(std::abs(seen.g - expected) <= 8.0 && std::abs(seen.r - seen.b) <= 1,
                    qPrintable(QStringLiteral("(%1, %2): %3 instead of %4")
                                   .arg(x)
                                   .arg(y)
                                   .arg(seen.g)
                                   .arg(expected)));
            }
        }
    }

    /// The same drilled hole without and with radiation, side by side. With BURIN_SCREENSHOTS the
    /// picture is written there: resources/help/radiated-cut.png.
    void drilledForehead()
    {
        const auto study = core::makeDemoStudy({});
        QVERIFY(study);
        const Forehead forehead(*study);
        QVERIFY(m_fixture->volume.open(forehead.geometry.size, forehead.codes));
        core::VoxelEncoding encoding;
        encoding.rescaleIntercept = -1024.0;
        m_fixture->volume.setGeometry(forehead.geometry, encoding);
        // A round mask swept inwards, its floor bowed like the head.
        const glm::dvec3 entry(44.0, -52.0, 80.0);
        const glm::dvec3 inwards = glm::normalize(glm::dvec3(-0.60, 0.70, -0.55));
        const Field cut = coverageOf(forehead.geometry, [&](const glm::dvec3& lps) {
            const double depth = glm::dot(lps - entry, inwards);
            const double aside = glm::length(lps - entry - depth * inwards);
            return aside < 19.0 && depth < 24.0 - 0.004 * aside * aside;
        });
        VolumeScene view;
        view.targetLps = entry + 12.0 * inwards;
        view.eyeLps = view.targetLps + 400.0 * glm::normalize(glm::dvec3(0.95, -0.62, 0.48));
        view.heightMm = 52.0;
        view.surfaceThreshold = -350.0;
        view.cutFaces = CutFaces::GreyValues;
        view.faceWindow = {350.0, 1700.0};
        const glm::ivec2 size(480, 400);
        QImage both(2 * size.x + 8, size.y, QImage::Format_RGB888);
        both.fill(0x303030);
        QPainter painter(&both);
        leaveOut(*m_fixture, cut);
        const Frame binary = m_fixture->draw(view, size);
        painter.drawImage(0, 0, test::imageOf(binary));
        m_fixture->carve(cut);
        const Frame radiated = m_fixture->draw(view, size);
        painter.drawImage(size.x + 8, 0, test::imageOf(radiated));
        painter.end();
        // The cut is where it was: it is only smoother.
        int apart = 0;
        int differs = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 change =
                    glm::abs(test::pixel(binary, x, y) - test::pixel(radiated, x, y));
                differs += change.g > 6 ? 1 : 0;
                apart += change.g > 100 ? 1 : 0;
            }
        }
        QVERIFY2(differs > size.x * size.y / 50, qPrintable(QString::number(differs)));
        QVERIFY2(apart < size.x * size.y / 50, qPrintable(QString::number(apart)));
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(both.save(folder + QStringLiteral("/radiated-cut.png")));
    }
};

BURIN_TEST(RadiatedCutGlTest)

} // namespace radiatedCutGlTest

#include "RadiatedCutGlTest.moc"
