// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/support/cases/growth/GrowToClosure.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace radiatedSegmentGlTest {

using namespace gpu;

namespace {

using Field = reference::DenseArray<std::uint8_t>;

/// What a segmentation map holds of a mask's voxels without radiation.
Field binary(const glm::ivec3& size, std::vector<std::uint8_t> mask)
{
    std::transform(mask.begin(), mask.end(), mask.begin(),
        [](std::uint8_t member) { return std::uint8_t(member != 0 ? 255 : 0); });
    return {size, std::move(mask)};
}

bool isLit(const Frame& frame, int x, int y)
{
    return test::pixel(frame, x, y).b > 12;
}

/// How unevenly what both pictures show is lit: the mean second difference of brightness along
/// rows and columns.
double roughness(const Frame& frame, const Frame& other)
{
    double sum = 0.0;
    int places = 0;
    for (int y = 1; y + 1 < frame.sizePixels.y; ++y) {
        for (int x = 1; x + 1 < frame.sizePixels.x; ++x) {
            const glm::ivec2 around[] = {{x, y}, {x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
            if (!std::all_of(std::begin(around), std::end(around), [&](const glm::ivec2& at) {
                    return isLit(frame, at.x, at.y) && isLit(other, at.x, at.y);
                }))
                continue;
            const int here = 2 * test::pixel(frame, x, y).b;
            sum += std::abs(test::pixel(frame, x - 1, y).b + test::pixel(frame, x + 1, y).b - here);
            sum += std::abs(test::pixel(frame, x, y - 1).b + test::pixel(frame, x, y + 1).b - here);
            ++places;
        }
    }
    return places == 0 ? 0.0 : sum / (2.0 * places);
}

} // namespace

/// The paper's figure 7: ventricles, partly segmented, drawn by a map of yes and no, and by one
/// that point radiation smooths. With BURIN_SCREENSHOTS: resources/help/growth-radiated.png.
class RadiatedSegmentGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void partOfTheVentricles()
    {
        const test::SharedCase found = test::sharedCase(QStringLiteral("mr_brain_mricrop_itksnap"));
        if (found.source.isEmpty())
            QSKIP("no shared data");
        const core::LoadedVolume study =
            test::openVolume(found.source + QStringLiteral("/mri.nii.gz"));
        const core::VolumeGeometry& geometry = study.volume.geometry;
        const core::VoxelEncoding& encoding = study.volume.encoding;

        reference::ReferenceEngine oracle;
        QVERIFY(oracle.openVolume(geometry.size, study.codes));
        const std::vector<glm::ivec3> seeds{{33, 40, 51}, {48, 40, 51}};
        core::GrowLimits limits{.majority = 14, .boxed = true};
        limits.boxFrom = {0, 0, 42};
        limits.boxTo = geometry.size - 1;
        const test::GrownVoxels grown = test::growToClosure(oracle, geometry.size, seeds,
            encoding.lowestCodeAtLeast(0.0), encoding.highestCodeAtMost(38.0), limits);
        const Field yesOrNo = binary(geometry.size, grown.mask);
        const auto members = std::count(grown.mask.begin(), grown.mask.end(), std::uint8_t(1));
        QVERIFY2(members > 6000 && members < 18000, qPrintable(QString::number(members)));

        QVERIFY(m_fixture->volume.open(geometry.size, study.codes));
        m_fixture->volume.setGeometry(geometry, encoding);
        m_fixture->volume.labels().upload<std::uint8_t>(grown.mask);
        const core::OrthographicView camera =
            test::viewFrom({-0.75, -0.75, 0.55}, geometry.toWorld({40.5, 49.0, 51.0}), 74.0);
        VolumeScene view = test::sceneOf(camera);
        view.surfaceThreshold = 10000.0; // nothing but the segment
        SegmentDisplay shown;
        shown.rgb[1] = 0x6FA8DC;
        shown.visible[1] = true;
        const glm::ivec2 size(420, 360);
        const core::VoxelBox everywhere{glm::ivec3(0), geometry.size};
        const auto draw = [&](const Field& map) {
            m_fixture->volume.segmentation().upload<std::uint8_t>(map.values);
            m_fixture->volume.markDirty(VolumeField::Labels, everywhere);
            m_fixture->volume.markDirty(VolumeField::Segmentation, everywhere);
            return m_fixture->draw(view, size, shown);
        };
        const Frame stepped = draw(yesOrNo);
        const Frame smooth = draw(reference::radiation(yesOrNo));

        // The same body; only its surface is another.
        int lit = 0;
        int differ = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                lit += isLit(stepped, x, y) ? 1 : 0;
                differ += isLit(stepped, x, y) != isLit(smooth, x, y) ? 1 : 0;
            }
        }
        const double before = roughness(stepped, smooth);
        const double after = roughness(smooth, stepped);
        qInfo("%td voxels; roughness %.2f as steps, %.2f radiated; %.1f %% of the outline differs",
            members, before, after, 100.0 * differ / std::max(lit, 1));
        QVERIFY(test::keepPanels(
            {test::imageOf(stepped), test::imageOf(smooth)}, "growth-radiated.png"));
        QVERIFY(lit > size.x * size.y / 10);
        QVERIFY(differ < lit / 12);
        QVERIFY(before > 1.0 && after < 0.6 * before);
    }
};

BURIN_TEST(RadiatedSegmentGlTest)

} // namespace radiatedSegmentGlTest

#include "RadiatedSegmentGlTest.moc"
