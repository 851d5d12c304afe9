// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "tests/support/FrameTest.h"

#include <QPainter>
#include <QTest>

#include <algorithm>
#include <cmath>

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

/// A part of the demonstration head: the forehead's left half and what lies behind it.
struct Forehead {
    explicit Forehead(const core::DemoStudy& study)
    {
        const glm::ivec3 first(96, 0, 72);
        geometry = study.geometry;
        geometry.size = glm::ivec3(236, 170, 196) - first;
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
    void anObliqueCutIsEven()
    {
        const auto geometry = test::centredGeometry({64, 64, 64}, {0.9, 0.9, 1.2});
        m_fixture->open(geometry,
            [](const glm::dvec3& lps) { return glm::length(lps) < 27.0 ? 2000.0 : 100.0; });
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.25, -1.0, 0.4));
        const Field cut = coverageOf(
            geometry, [&](const glm::dvec3& lps) { return glm::dot(lps, normal) > 2.0; });
        VolumeScene view;
        view.eyeLps = 300.0 * glm::normalize(glm::dvec3(0.0, -1.0, 0.2));
        view.heightMm = 30.0;
        view.surfaceThreshold = 1000.0;
        const auto spread = [&] {
            const Frame frame = m_fixture->draw(view, {90, 90});
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
        };
        leaveOut(*m_fixture, cut);
        const double binary = spread();
        m_fixture->carve(cut);
        const double radiated = spread();
        QVERIFY2(binary > 1.0 && radiated <= 0.25 * binary,
            qPrintable(QStringLiteral("%1 against %2").arg(radiated).arg(binary)));
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
        const glm::dvec3 entry(34.0, -74.0, 48.0);
        const glm::dvec3 inwards = glm::normalize(glm::dvec3(-0.35, 0.85, -0.45));
        const Field cut = coverageOf(forehead.geometry, [&](const glm::dvec3& lps) {
            const double depth = glm::dot(lps - entry, inwards);
            const double aside = glm::length(lps - entry - depth * inwards);
            return aside < 19.0 && depth < 17.0 - 0.006 * aside * aside;
        });
        VolumeScene view;
        view.targetLps = entry + 6.0 * inwards;
        view.eyeLps = view.targetLps + 400.0 * glm::normalize(glm::dvec3(0.75, -0.85, 0.30));
        view.heightMm = 58.0;
        view.surfaceThreshold = -350.0;
        view.cutFaces = CutFaces::GreyValues;
        view.faceWindow = {250.0, 1400.0};
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

QTEST_GUILESS_MAIN(RadiatedCutGlTest)
#include "RadiatedCutGlTest.moc"
