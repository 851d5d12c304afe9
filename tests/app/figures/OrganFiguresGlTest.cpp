// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/session/SessionChunks.h"
#include "tests/support/cases/growth/RealGrowths.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SculptStage.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/OpenedVolume.h"
#include "ui/settings/ChunkLeaves.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace organFiguresGlTest {

using namespace core;

namespace {

constexpr int leftKidney = 3; ///< among the labels of the study
constexpr double radiusMm = 17.0;
constexpr std::uint32_t kidneyRgb = 0xD89A94;
constexpr std::uint32_t chunkArgb = 0xFFF0D040;

/// A kidney with a tumour at its outer side, brighter than it, as a network masks it that knows
/// healthy kidneys: without the tumour.
struct TumourInKidney {
    LoadedVolume study;
    std::vector<std::uint8_t> truth; ///< 1 in kidney and tumour
    std::vector<std::uint8_t> mask; ///< 1 in what is left of the kidney
    glm::dvec3 tumourLps{0.0};
    glm::dvec3 middleLps{0.0};

    /// @param labels of the study's voxels
    TumourInKidney(LoadedVolume of, const std::vector<std::uint8_t>& labels)
        : study(std::move(of))
        , truth(test::maskOf(labels, leftKidney))
        , mask(truth)
    {
        double codes = 0.0;
        double count = 0.0;
        forEachVoxel([&](std::size_t voxel, const glm::dvec3& lps) {
            if (truth[voxel] == 0)
                return;
            middleLps += lps;
            codes += double(study.codes[voxel]);
            ++count;
            // Left of the patient is +x; half of the tumour stands out there.
            if (tumourLps == glm::dvec3(0.0) || lps.x > tumourLps.x)
                tumourLps = lps;
        });
        middleLps /= count;
        const double unit =
            std::abs(study.volume.encoding.value(1) - study.volume.encoding.value(0));
        const int code = int(std::lround(codes / count + 60.0 / unit));
        const int noise = int(std::lround(12.0 / unit));
        test::Random random(3);
        const glm::dvec3 tumour = tumourLps;
        forEachVoxel([&](std::size_t voxel, const glm::dvec3& lps) {
            const bool isFree = labels[voxel] == 0 || labels[voxel] == leftKidney;
            if (!isFree || glm::distance(lps, tumour) > radiusMm)
                return;
            truth[voxel] = 1;
            mask[voxel] = 0;
            study.codes[voxel] = std::uint16_t(code + test::randomInt(random, -noise, noise));
        });
    }
    [[nodiscard]] Edit maskImport() const
    {
        VoxelRuns runs;
        for (std::size_t voxel = 0; voxel < mask.size(); ++voxel) {
            if (mask[voxel] != 0)
                runs.append(voxel, 1);
        }
        return test::maskImport(QStringLiteral("network.nii"), study.volume.geometry.size,
            {{QStringLiteral("Kidney"), runs, kidneyRgb}});
    }

private:
    template <class Visit> void forEachVoxel(const Visit& visit) const
    {
        const VolumeGeometry& geometry = study.volume.geometry;
        std::size_t voxel = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x, ++voxel)
                    visit(voxel, geometry.toWorld(glm::dvec3(x, y, z)));
            }
        }
    }
};

/// Chunks as the 3D view shows one of them that the pen points at.
std::shared_ptr<const gpu::SceneChunks> sceneOf(
    const ui::ChunkLeaves& leaves, const std::optional<ChunkTree::Chunk>& lit, int count)
{
    auto scene = std::make_shared<gpu::SceneChunks>();
    scene->box = leaves.map->box();
    scene->leaves = leaves.ofVoxel;
    scene->opacity = 0.8f;
    for (const ChunkTree::Chunk chunk : leaves.map->tree().chunksOfLeaves(count))
        scene->argb.push_back(lit == chunk ? chunkArgb : 0);
    return scene;
}

} // namespace

/// Organs of real studies whose masks are wrong, mended with one tool (issue 34), in numbers. With
/// BURIN_SCREENSHOTS the pictures before, during and after are written there:
/// resources/help/mend-*.png.
class OrganFiguresGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A planted tumour that a network has missed: with the number of chunks as it is suggested,
    /// one click.
    void kidneyWithATumour()
    {
        const test::SharedCase body = test::sharedCase(QStringLiteral("ct_totalseg_body_3mm"));
        if (body.source.isEmpty())
            QSKIP("no shared data");
        const LoadedVolume map =
            test::openVolume(body.source + QStringLiteral("/ct_3mm_labels.nii.gz"));
        std::vector<std::uint8_t> labels;
        labels.reserve(map.codes.size());
        for (const std::uint16_t code : map.codes)
            labels.push_back(std::uint8_t(std::lround(map.volume.encoding.value(code))));
        const TumourInKidney kidney(
            test::openVolume(body.source + QStringLiteral("/ct_3mm.nii.gz")), labels);
        test::SculptStage stage(kidney.study);
        QVERIFY(stage.isReady());
        QCOMPARE(stage.apply(kidney.maskImport()), QString());
        const auto diceNow = [&] {
            return test::dice(test::maskOf(stage.voxels(Field::Labels, 0), 1), kidney.truth);
        };
        const double before = diceNow();

        gpu::VolumeScene view = test::sceneOf(
            test::viewFrom({0.5, -1.0, 0.3}, 0.5 * (kidney.middleLps + kidney.tumourLps), 170.0));
        view.context = gpu::Context::Hidden;
        view.plane = gpu::ScenePlane{.centreLps = kidney.tumourLps,
            .rightLps = {1.0, 0.0, 0.0},
            .downLps = {0.0, 0.0, -1.0},
            .halfSizeMm = {80.0, 80.0},
            .window = {.centre = 50.0, .width = 400.0}};
        gpu::SegmentDisplay segments;
        segments.rgb[1] = kidneyRgb;
        segments.visible[1] = true;
        std::vector<QImage> panels;
        const auto keep = [&] {
            if (test::panelsWanted())
                panels.push_back(stage.draw(view, {430, 400}, segments));
        };
        keep();

        QCOMPARE(stage.apply(DivideSegment{.segment = 1, .marginMm = 25.0}), QString());
        SessionChunks& chunks = stage.session().chunks();
        QVERIFY(QTest::qWaitFor(
            [&] {
                stage.session().poll();
                return chunks.map() != nullptr;
            },
            120000));
        const ui::ChunkLeaves leaves(chunks.map(), 1);
        QVERIFY(leaves.suggestedCount);
        const glm::ivec3 voxel(glm::round(kidney.study.volume.geometry.toIndex(kidney.tumourLps)));
        view.chunks = sceneOf(
            leaves, leaves.map->chunkAt(voxel, *leaves.suggestedCount), *leaves.suggestedCount);
        keep();
        QCOMPARE(
            stage.apply(ChunkToggle{
                .segment = 1, .chunks = *leaves.suggestedCount, .pointsLps = {kidney.tumourLps}}),
            QString());
        view.chunks.reset();
        keep();
        const double after = diceNow();
        qInfo("kidney: Dice %.4f before, %.4f after a click among %d chunks", before, after,
            *leaves.suggestedCount);
        QVERIFY(before < 0.97);
        QVERIFY(after > 0.98);
        QVERIFY(panels.empty() || test::keepPanels(panels, "mend-kidney.png"));
    }
};

BURIN_TEST(OrganFiguresGlTest)

} // namespace organFiguresGlTest

#include "OrganFiguresGlTest.moc"
