// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "core/demo/HeadPhantom.h"
#include "core/document/Piece.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SculptStage.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace reenactmentGlTest {

using namespace core;
using test::drawSketch;
using test::sceneOf;
using test::SculptStage;
using test::viewFrom;

namespace {

const glm::ivec2 panelSize(430, 400);

/// What a hand draws: not quite an ellipse.
std::vector<glm::dvec2> sketch(const glm::dvec2& middle, const glm::dvec2& radii)
{
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < 160; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 160.0;
        const double wobble = 1.0 + 0.05 * std::sin(3.0 * t + 0.4) + 0.02 * std::sin(7.0 * t);
        outline.push_back(middle + radii * wobble * glm::dvec2(std::cos(t), std::sin(t)));
    }
    return outline;
}

/// Skin faint, bone dense, grey matter there, fluid clear.
gpu::TransferFunction headColours()
{
    return {{{-400.0, 0x6b3b2a, 0.0}, {-150.0, 0xc98f6a, 0.15}, {-20.0, 0xc98f6a, 0.1},
        {0.0, 0xb5654c, 0.0}, {18.0, 0xb5654c, 0.0}, {30.0, 0xd8a090, 0.2}, {60.0, 0xe0b0a0, 0.3},
        {220.0, 0xe3c08e, 0.3}, {450.0, 0xf3e3c4, 0.5}, {1200.0, 0xffffff, 0.9}}};
}

void tell(const char* name, const test::Opening& opening)
{
    qInfo("%s: %.1f %% cut through, %zu of %zu carved voxels beside the mask, %.3f %% of the "
          "brain touched",
        name, 100.0 * opening.cutThrough, opening.outside, opening.carved,
        100.0 * double(opening.touched) / double(std::max<std::size_t>(opening.spared, 1)));
}

/// What seed A says of an opened skull (issue: ≥ 95 % cut through, nothing beside the mask, ≤ 0.5 %
/// of the brain).
void checkOpening(const char* name, const test::Opening& opening)
{
    tell(name, opening);
    QVERIFY(opening.carved > 10000);
    QVERIFY(opening.spared > 10000);
    QVERIFY(opening.cutThrough >= 0.95);
    QCOMPARE(opening.outside, std::size_t(0));
    QVERIFY(opening.touched <= opening.spared / 200);
}

} // namespace

/// The paper's figures again (seed A, figures 1, 3, 4, 5, 9), measured. With BURIN_SCREENSHOTS the
/// pictures of the manual are written there: resources/help/reenact-*.png.
class ReenactmentGlTest : public QObject {
    Q_OBJECT

private:
    DemoStudy m_demo;
    std::unique_ptr<SculptStage> m_head;

    [[nodiscard]] bool isPart(std::size_t voxel, HeadPart first, HeadPart last) const
    {
        const auto part = HeadPart(m_demo.parts[voxel]);
        return part >= first && part <= last;
    }
    [[nodiscard]] auto isSkull() const
    {
        return
            [this](std::size_t voxel) { return isPart(voxel, HeadPart::Skull, HeadPart::Skull); };
    }
    [[nodiscard]] auto isBrain() const
    {
        return [this](std::size_t voxel) {
            return isPart(voxel, HeadPart::GreyMatter, HeadPart::BrainStem);
        };
    }
    /// A study of the shared data, or nothing where there are none.
    [[nodiscard]] static std::unique_ptr<SculptStage> shared(const char* name)
    {
        const test::SharedCase found = test::sharedCase(QString::fromLatin1(name));
        if (found.source.isEmpty())
            return nullptr;
        return std::make_unique<SculptStage>(test::openVolume(found.unpacked));
    }
    [[nodiscard]] static glm::dvec3 middleOf(const SculptStage& stage)
    {
        const VolumeGeometry& geometry = stage.study().volume.geometry;
        return geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto demo = makeDemoStudy({});
        QVERIFY(demo);
        m_demo = *demo;
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        LoadedVolume study;
        study.volume.geometry = m_demo.geometry;
        study.volume.encoding.rescaleIntercept = -1024.0;
        study.volume.unit = QStringLiteral("HU");
        for (const std::int16_t hounsfield : m_demo.hounsfield)
            study.codes.push_back(std::uint16_t(hounsfield + 1024));
        m_head = std::make_unique<SculptStage>(std::move(study));
        QVERIFY(m_head->isReady());
    }
    void cleanup() { m_head.reset(); }

    /// Figures 1a to 1c and 5: a region is sketched, the scalp is peeled off, then the bone; the
    /// bone is laid aside.
    void skullIsPeeledAndLaidAside()
    {
        const OrthographicView view = viewFrom({0.6, -0.55, 0.95}, {0.0, 0.0, 10.0}, 260.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.mode = gpu::RenderMode::Dvr;
        scene.transferFunction = headColours();
        const std::vector<glm::dvec2> outline = sketch({0.0, 22.0}, {46.0, 32.0});
        std::vector<QImage> panels{m_head->draw(scene, panelSize)};
        drawSketch(panels.back(), view, outline);

        PeelCut peel{.layer = 1, .view = view, .polygonMm = outline, .depthMm = 5.0};
        peel.surfaceThreshold = -300.0;
        QCOMPARE(m_head->apply(peel), QString());
        panels.push_back(m_head->draw(scene, panelSize));
        QCOMPARE(m_head->apply(AddLayer{.name = QStringLiteral("Bone")}), QString());
        peel.layer = 2;
        peel.depthMm = 8.5;
        peel.surfaceThreshold = 200.0;
        peel.throughGaps = true;
        QCOMPARE(m_head->apply(peel), QString());
        panels.push_back(m_head->draw(scene, panelSize));

        std::vector<std::uint8_t> carved = m_head->voxels(Field::Coverage, 1);
        const std::vector<std::uint8_t> bone = m_head->voxels(Field::Coverage, 2);
        std::transform(carved.begin(), carved.end(), bone.begin(), carved.begin(),
            [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
        checkOpening("demonstration head",
            test::measureOpening(m_demo.geometry, carved, view, outline, isSkull(), isBrain()));

        QCOMPARE(
            m_head->apply(CutPiece{.layer = 2, .name = QStringLiteral("Skull cap")}), QString());
        QCOMPARE(m_head->apply(ChangePiece{.piece = 1,
                     .offsetMm = glm::dvec3(62.0, 10.0, -6.0),
                     .rotationDegrees = glm::dvec3(0.0, 50.0, 0.0)}),
            QString());
        const Piece& piece = m_head->session().document().pieces.front();
        scene.pieces = {{.id = piece.id,
            .layer = piece.layer,
            .shownFromTrue = shownFromTrue(piece, m_demo.geometry)}};
        panels.push_back(m_head->draw(scene, panelSize));
        QVERIFY(test::keepPanels(panels, "reenact-peel.png"));
    }

    /// Figure 3: a square mask is pressed into the skull, once and then through it.
    void skullIsDrilledWithASquareMask()
    {
        const OrthographicView view = viewFrom({0.9, -0.35, 0.5}, {0.0, 0.0, 20.0}, 210.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 200.0;
        DrillStroke drill{.layer = 1, .view = view};
        drill.mask.kind = ToolMask::Kind::Square;
        drill.mask.widthMm = 34.0;
        drill.mask.rotationDegrees = 12.0;
        drill.surfaceThreshold = 200.0;
        drill.depthMm = 8.0;
        drill.samples = {{.xMm = 6.0, .yMm = 36.0, .pressure = 0.7}};
        std::vector<QImage> panels{m_head->draw(scene, panelSize)};
        QCOMPARE(m_head->apply(drill), QString());
        panels.push_back(m_head->draw(scene, panelSize));
        drill.samples.front().pressure = 1.0;
        // It cuts deeper where it goes on, the rim too.
        for (int press = 0; press < 3; ++press)
            QCOMPARE(m_head->apply(drill), QString());
        panels.push_back(m_head->draw(scene, panelSize));
        const double c = std::cos(12.0 / 180.0 * std::numbers::pi);
        const double s = std::sin(12.0 / 180.0 * std::numbers::pi);
        std::vector<glm::dvec2> square;
        for (const glm::dvec2& corner :
            {glm::dvec2(17, 17), glm::dvec2(-17, 17), glm::dvec2(-17, -17), glm::dvec2(17, -17)})
            square.push_back(glm::dvec2(6.0, 36.0)
                + glm::dvec2(c * corner.x - s * corner.y, s * corner.x + c * corner.y));
        checkOpening("drill",
            test::measureOpening(m_demo.geometry, m_head->voxels(Field::Coverage, 1), view, square,
                isSkull(), isBrain()));
        QVERIFY(test::keepPanels(panels, "reenact-drill.png"));
    }

    /// Figure 4: a circular mask that stands across the skull, one press and a layer lasered off.
    void skullIsLasered()
    {
        const OrthographicView view = viewFrom({0.9, -0.35, 0.5}, {0.0, 0.0, 20.0}, 210.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 200.0;
        LaserStroke laser{.layer = 1, .view = view};
        laser.mask.radiusMm = 16.0;
        laser.surfaceThreshold = 200.0;
        laser.depthMm = 8.0;
        laser.samples = {{.xMm = 28.0, .yMm = 30.0, .pressure = 0.7}};
        std::vector<QImage> panels{m_head->draw(scene, panelSize)};
        QCOMPARE(m_head->apply(laser), QString());
        panels.push_back(m_head->draw(scene, panelSize));
        laser.samples.clear();
        for (int i = 0; i <= 30; ++i)
            laser.samples.push_back({.xMm = 28.0 - 1.6 * i,
                .yMm = 30.0 + 8.0 * std::sin(0.1 * i),
                .pressure = 1.0,
                .tSeconds = i / 60.0});
        QCOMPARE(m_head->apply(laser), QString());
        panels.push_back(m_head->draw(scene, panelSize));
        QVERIFY(test::keepPanels(panels, "reenact-laser.png"));
        // The middle of the path is open; the mask's rim stands askew to the view.
        std::vector<glm::dvec2> inner;
        for (int i = 0; i < 64; ++i) {
            const double t = 2.0 * std::numbers::pi * i / 64.0;
            inner.emplace_back(4.0 + 30.0 * std::cos(t), 34.0 + 8.0 * std::sin(t));
        }
        const test::Opening opening = test::measureOpening(
            m_demo.geometry, m_head->voxels(Field::Coverage, 1), view, inner, isSkull(), isBrain());
        tell("laser, its middle", opening);
        QVERIFY(opening.cutThrough >= 0.95);
        QVERIFY(opening.touched <= opening.spared / 200);
    }

    /// Figure 1 on a real CT: bone from 226 HU on; behind it, of the brain's values, is the brain.
    void realSkullIsPeeled()
    {
        const auto stage = shared("ct_cranium_inv3");
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        const LoadedVolume& study = stage->study();
        const OrthographicView view = viewFrom({0.3, 0.6, 0.9}, middleOf(*stage), 230.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 226.0;
        const std::vector<glm::dvec2> outline = sketch({-10.0, 10.0}, {36.0, 26.0});
        std::vector<QImage> panels{stage->draw(scene, panelSize)};
        drawSketch(panels.back(), view, outline);
        PeelCut peel{.layer = 1, .view = view, .polygonMm = outline, .depthMm = 5.0};
        peel.surfaceThreshold = 226.0;
        peel.throughGaps = true;
        QCOMPARE(stage->apply(peel), QString());
        panels.push_back(stage->draw(scene, panelSize));
        QVERIFY(stage->session().undo());
        QVERIFY(stage->session().settle());
        peel.depthMm = 9.4;
        QCOMPARE(stage->apply(peel), QString());
        panels.push_back(stage->draw(scene, panelSize));
        QVERIFY(test::keepPanels(panels, "reenact-skull.png"));

        const auto value = [&study](std::size_t voxel) {
            return study.volume.encoding.value(study.codes[voxel]);
        };
        const auto isBone = [&value](std::size_t voxel) { return value(voxel) >= 226.0; };
        const std::vector<bool> behind =
            test::behindShell(study.volume.geometry, view, outline, isBone);
        checkOpening("skull CT",
            test::measureOpening(study.volume.geometry, stage->voxels(Field::Coverage, 1), view,
                outline, isBone, [&](std::size_t voxel) {
                    return behind[voxel] && value(voxel) >= 0.0 && value(voxel) <= 80.0;
                }));
    }

    /// And on a real MR, where scalp and skull go at once: the scalp is bright, the bone dark.
    void realHeadIsPeeledInMr()
    {
        const auto stage = shared("mr_t1_sag_mprage");
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        const LoadedVolume& study = stage->study();
        const OrthographicView view = viewFrom({0.55, -0.6, 0.9}, middleOf(*stage), 230.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 60.0;
        const std::vector<glm::dvec2> outline = sketch({-4.0, 40.0}, {42.0, 32.0});
        std::vector<QImage> panels{stage->draw(scene, panelSize)};
        drawSketch(panels.back(), view, outline);
        PeelCut peel{.layer = 1, .view = view, .polygonMm = outline, .depthMm = 4.0};
        peel.surfaceThreshold = 60.0;
        peel.throughGaps = true;
        QCOMPARE(stage->apply(peel), QString());
        panels.push_back(stage->draw(scene, panelSize));
        QVERIFY(stage->session().undo());
        QVERIFY(stage->session().settle());
        // Skin and brain are of one brightness, and the skull is a dark line a voxel wide. What
        // tells them apart is the fat and marrow between: it is grown from a sketch on it, the
        // brain is told from it by another, and protected. Then the peel may be as deep as the
        // thickest place asks for.
        const auto value = [&study](std::size_t voxel) {
            return study.volume.encoding.value(study.codes[voxel]);
        };
        const test::BandShell shell =
            test::bandShell(study.volume.geometry, view, outline, value, 60.0, 230.0);
        QVERIFY(shell.met > 0.95);
        QCOMPARE(stage->apply(test::newSegment(QStringLiteral("Fat"), 0xE8D8A0)), QString());
        QCOMPARE(stage->apply(test::newSegment(QStringLiteral("Brain"), 0xE0B0A8)), QString());
        const glm::dmat3 axes = *viewAxes(view, {});
        const auto under = [&](const glm::dvec2& onPlane, const auto& isThere) {
            for (double depth = -200.0; depth < 200.0; depth += 0.4) {
                const glm::dvec3 at = view.targetLps + axes * glm::dvec3(onPlane, depth);
                const glm::ivec3 voxel(glm::round(study.volume.geometry.toIndex(at)));
                if (study.volume.geometry.contains(voxel) && isThere(stage->placeOf(voxel)))
                    return at;
            }
            return glm::dvec3(0.0);
        };
        SeedStroke fat{.segment = 1, .pointsLps = {}};
        SeedStroke brain{.segment = 2, .pointsLps = {}};
        GrowBox box{.fromLps = glm::dvec3(1e9), .toLps = glm::dvec3(-1e9)};
        for (int i = -5; i <= 5; ++i) {
            const glm::dvec2 onPlane(-4.0 + 7.0 * i, 40.0);
            fat.pointsLps.push_back(
                under(onPlane, [&](std::size_t voxel) { return value(voxel) >= 300.0; }));
            brain.pointsLps.push_back(fat.pointsLps.back() + 25.0 * axes[2]);
        }
        for (const glm::dvec2& point : sketch({-4.0, 40.0}, {50.0, 40.0})) {
            const glm::dvec3 at =
                under(point, [&](std::size_t voxel) { return value(voxel) >= 60.0; });
            box.fromLps = glm::min(box.fromLps, glm::min(at, at + 40.0 * axes[2]));
            box.toLps = glm::max(box.toLps, glm::max(at, at + 40.0 * axes[2]));
        }
        QCOMPARE(stage->apply(fat), QString());
        QCOMPARE(stage->apply(test::growBy(
                     {.lower = 230.0, .upper = 2000.0, .connectivity = 26, .box = box})),
            QString());
        QCOMPARE(stage->apply(brain), QString());
        QCOMPARE(stage->apply(GrowFromSeeds{.box = box}), QString());
        QCOMPARE(stage->apply(test::protectSegment(2)), QString());
        peel.depthMm = 8.0;
        QCOMPARE(stage->apply(peel), QString());
        gpu::SegmentDisplay shown;
        shown.rgb[2] = 0xE0B0A8;
        shown.visible[2] = true;
        panels.push_back(stage->draw(scene, panelSize, shown));
        QVERIFY(test::keepPanels(panels, "reenact-mr.png"));
        const test::Opening opening = test::measureOpening(
            study.volume.geometry, stage->voxels(Field::Coverage, 1), view, outline,
            [&](std::size_t voxel) { return shell.over[voxel]; },
            [&](std::size_t voxel) { return shell.behind[voxel] && value(voxel) >= 90.0; }, 0.5);
        checkOpening("head MR", opening);
    }

    /// Figure 9, bottom: the bone over a molar is drilled away, seeds are sketched on the tooth, it
    /// grows, is protected while all around it goes, and is pasted by itself, larger.
    void aToothIsTakenOut()
    {
        const auto stage = shared("ct_cranium_inv3");
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        const VolumeGeometry& geometry = stage->study().volume.geometry;
        const auto place = [&geometry](double i, double j, double k) {
            return geometry.toWorld({i, j, k});
        };
        const auto direction = [&place](const glm::dvec3& index) {
            return glm::normalize(place(index.x, index.y, index.z) - place(0, 0, 0));
        };
        // From the cheek, a little from the front.
        const glm::dvec3 towardsViewer =
            direction({1, 0, 0}) + 0.3 * direction({0, 1, 0}) - 0.1 * direction({0, 0, 1});
        const OrthographicView view = viewFrom(towardsViewer, place(159, 184, 8), 62.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 226.0;
        std::vector<QImage> panels{stage->draw(scene, panelSize)};

        // The roots lie under a shell of bone.
        DrillStroke drill{.layer = 1, .view = viewFrom(towardsViewer, place(160, 179, 9), 62.0)};
        drill.mask.kind = ToolMask::Kind::Ellipse;
        drill.mask.widthMm = 15.0;
        drill.mask.heightMm = 14.0;
        drill.depthMm = 2.0;
        drill.surfaceThreshold = 226.0;
        drill.samples = {{}};
        QCOMPARE(stage->apply(drill), QString());
        QCOMPARE(stage->apply(test::newSegment(QStringLiteral("Molar"), 0xF2D9A6)), QString());
        SeedStroke seeds{.segment = 1, .pointsLps = {}};
        for (int k = 1; k < 8; ++k)
            seeds.pointsLps.push_back(place(160, 178, k));
        QCOMPARE(stage->apply(seeds), QString());
        panels.push_back(stage->draw(scene, panelSize));
        QCOMPARE(stage->apply(test::growBetween(1200.0, 3071.0)), QString());
        QCOMPARE(stage->apply(test::protectSegment(1)), QString());

        DrillStroke around = drill;
        around.mask.widthMm = 21.0;
        around.mask.heightMm = 26.0;
        around.view.targetLps = place(159, 179, 5);
        around.view.eyeLps = around.view.targetLps + 300.0 * glm::normalize(towardsViewer);
        around.depthMm = 30.0;
        around.throughGaps = true;
        QCOMPARE(stage->apply(around), QString());
        gpu::SegmentDisplay shown;
        shown.rgb[1] = 0xF2D9A6;
        shown.visible[1] = true;
        panels.push_back(stage->draw(scene, panelSize, shown));

        // Far beside the head, so that nothing else is in the picture.
        PastePiece paste{.segment = 1, .name = QStringLiteral("Molar")};
        paste.pivotLps = place(159, 179, 5);
        paste.pose = {.offsetMm = 500.0 * direction({0, 0, 1}), .zoom = 2.4};
        QCOMPARE(stage->apply(paste), QString());
        const Piece& piece = stage->session().document().pieces.front();
        const glm::dmat4 pose = shownFromTrue(piece, geometry);
        gpu::VolumeScene alone = sceneOf(
            viewFrom(towardsViewer, glm::dvec3(pose * glm::dvec4(*piece.pivotLps, 1.0)), 62.0));
        alone.surfaceThreshold = 226.0;
        alone.pieces = {
            {.id = 1, .segment = 1, .shownFromTrue = pose, .rgb = 0xF2D9A6, .solid = true}};
        panels.push_back(stage->draw(alone, panelSize));
        QVERIFY(test::keepPanels(panels, "reenact-tooth.png"));

        const std::vector<std::uint8_t> labels = stage->voxels(Field::Labels, 0);
        const std::vector<std::uint8_t> coverage = stage->voxels(Field::Coverage, 1);
        glm::ivec3 low(1000);
        glm::ivec3 high(-1);
        int tooth = 0;
        int carvedTooth = 0;
        int carved = 0;
        const glm::ivec3 size = geometry.size;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            carved += coverage[i] >= 128 ? 1 : 0;
            if (labels[i] != 1)
                continue;
            const glm::ivec3 at(
                int(i) % size.x, int(i) / size.x % size.y, int(i) / (size.x * size.y));
            low = glm::min(low, at);
            high = glm::max(high, at);
            ++tooth;
            carvedTooth += coverage[i] >= 128 ? 1 : 0;
        }
        const glm::dvec3 extentMm = glm::dvec3(high - low + 1) * geometry.spacingMm();
        const double mL = tooth * geometry.voxelVolumeMm3() / 1000.0;
        qInfo("tooth: %.2f mL, %.1f x %.1f x %.1f mm; %d voxels carved around it, %d of its %d", mL,
            extentMm.x, extentMm.y, extentMm.z, carved, carvedTooth, tooth);
        // One molar and no jaw, no neighbour.
        QVERIFY(mL > 0.7 && mL < 1.4);
        QVERIFY(extentMm.x < 16.0 && extentMm.y < 14.0 && extentMm.z < 24.0);
        QVERIFY(carved > 3000);
        // The first, shallow press came before anything was protected.
        QVERIFY(carvedTooth <= tooth / 10);
        // The piece fills the picture at its zoom, and nothing else does.
        int lit = 0;
        for (int y = 0; y < panelSize.y; ++y)
            for (int x = 0; x < panelSize.x; ++x)
                lit += qGray(panels.back().pixel(x, y)) > 20 ? 1 : 0;
        QVERIFY2(lit > panelSize.x * panelSize.y / 12 && lit < panelSize.x * panelSize.y / 2,
            qPrintable(QString::number(lit)));
    }
};

BURIN_TEST(ReenactmentGlTest)

} // namespace reenactmentGlTest

#include "ReenactmentGlTest.moc"
