// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "core/demo/HeadPhantom.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "tests/support/cases/growth/GrowthFigure.h"
#include "tests/support/cases/growth/RealGrowths.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SculptStage.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace growthFiguresGlTest {

using namespace core;
using test::GrowthFigure;
using test::inColours;
using test::RealGrowth;
using test::RealStructure;
using test::sceneOf;
using test::SculptStage;
using test::shareInside;
using test::viewFrom;
using test::within;

namespace {

constexpr std::uint32_t red = 0xE0503C;
constexpr std::uint32_t ivory = 0xF2E2C0;
constexpr std::uint32_t rose = 0xD89A94;
constexpr std::uint32_t blue = 0x6FA8DC;
constexpr std::uint32_t brown = 0xA8563C;
constexpr std::uint32_t yellow = 0xF0D040;

AddSegment segment(const char* name, std::uint32_t rgb)
{
    return {.name = QString::fromLatin1(name), .rgb = rgb};
}

std::vector<glm::dvec2> ellipse(const glm::dvec2& middle, const glm::dvec2& radii)
{
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < 120; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 120.0;
        outline.push_back(middle + radii * glm::dvec2(std::cos(t), std::sin(t)));
    }
    return outline;
}

} // namespace

/// The paper's figures of growth again (seed A, figures 1, 8 and 9), on real images and in numbers.
/// With BURIN_SCREENSHOTS the pictures of the manual are written there:
/// resources/help/growth-*.png.
class GrowthFiguresGlTest : public QObject {
    Q_OBJECT

private:
    [[nodiscard]] static std::unique_ptr<SculptStage> shared(const char* name, const char* file)
    {
        const test::SharedCase found = test::sharedCase(QString::fromLatin1(name));
        if (found.source.isEmpty())
            return nullptr;
        const QString path = file == nullptr
            ? found.unpacked
            : found.source + QLatin1Char('/') + QLatin1String(file);
        return std::make_unique<SculptStage>(test::openVolume(path));
    }

    /// 1 in the regions of grey matter that the atlas of mr_brain_ch2_atlases has.
    [[nodiscard]] static std::vector<std::uint8_t> atlasRegions()
    {
        const LoadedVolume atlas =
            test::openVolume(test::sharedCase(QStringLiteral("mr_brain_ch2_atlases")).source
                + QStringLiteral("/aal.nii.gz"));
        std::vector<std::uint8_t> regions;
        for (const std::uint16_t code : atlas.codes)
            regions.push_back(atlas.volume.encoding.value(code) > 0.5 ? 1 : 0);
        return regions;
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Figure 8 in the demonstration head: the skull is clipped away, both middle cerebral arteries
    /// are sketched in a MIP from above; growth goes on into the veins, and is taken back by a
    /// sketch on the sagittal sinus.
    void arteriesOfTheDemonstrationHead()
    {
        const auto demo = makeDemoStudy({});
        QVERIFY(demo);
        LoadedVolume study;
        study.volume.geometry = demo->geometry;
        study.volume.encoding.rescaleIntercept = -1024.0;
        study.volume.unit = QStringLiteral("HU");
        for (const std::int16_t hounsfield : demo->hounsfield)
            study.codes.push_back(std::uint16_t(hounsfield + 1024));
        SculptStage stage(std::move(study));
        QVERIFY(stage.isReady());
        GrowthFigure figure(stage);

        const OrthographicView above{.eyeLps = {0.0, 0.0, 330.0},
            .targetLps = {0.0, 4.0, 30.0},
            .up = {0.0, -1.0, 0.0},
            .heightMm = 160.0};
        gpu::VolumeScene mip = sceneOf(above);
        mip.mode = gpu::RenderMode::Mip;
        mip.mipWindow = {170.0, 420.0};
        mip.clip = wholeVolume(figure.geometry());
        mip.clip.box = {
            .minimum = {-0.5, -0.5, 95.5}, .maximum = {255.5, 255.5, 165.5}, .on = true};
        const std::vector<glm::dvec2> strokes[] = {
            {{32.0, 19.8}, {9.5, 22.3}}, {{-11.3, 22.3}, {-34.6, 19.8}}};
        figure.shows(mip);
        QCOMPARE(figure.does(segment("Arteries", red)), QString());
        for (const auto& stroke : strokes) {
            figure.sketched(above, stroke, false);
            QCOMPARE(figure.seeds(1, mip, stroke), QString());
        }
        const auto shown = inColours({red});
        const OrthographicView behind = viewFrom({0.35, -1.0, 0.22}, {0.0, 8.0, -10.0}, 205.0);
        gpu::VolumeScene xray = sceneOf(behind);
        xray.mode = gpu::RenderMode::Xray;
        xray.xrayWindow = {60.0, 900.0};
        const GrowCriteria criteria{.lower = 180.0, .upper = 350.0};
        QCOMPARE(figure.does(test::growBy(criteria, 80)), QString());
        figure.shows(xray, shown);
        QCOMPARE(figure.does(ResumeGrowth{}), QString());
        figure.shows(xray, shown);
        const std::vector<std::uint8_t> vessels =
            test::maskOf(demo->parts, std::uint8_t(HeadPart::Vessels));
        const glm::ivec3 size = figure.geometry().size;
        const std::vector<std::uint8_t> sinus =
            within(vessels, size, {118, 205, 105}, {137, 255, 164});
        const std::vector<std::uint8_t> willis =
            within(vessels, size, {85, 95, 95}, {171, 125, 105});
        const double leaked = shareInside(sinus, figure.mask(1));
        const double circleBefore = shareInside(willis, figure.mask(1));
        QCOMPARE(figure.plugs({128, 218, 115}), QString());
        QCOMPARE(figure.plugs({124, 217, 140}), QString());
        figure.shows(xray, shown);
        const double pure = shareInside(figure.mask(1), vessels);
        const double left = shareInside(sinus, figure.mask(1));
        const double circle = shareInside(willis, figure.mask(1));
        qInfo("arteries: %d actions, %.1f mL, %.1f %% of it vessels; sagittal sinus %.1f %%, then "
              "%.1f %%; around the circle of Willis %.1f %%, then %.1f %%",
            figure.actions(), figure.mL(1), 100.0 * pure, 100.0 * leaked, 100.0 * left,
            100.0 * circleBefore, 100.0 * circle);
        QVERIFY(figure.actions() <= 10);
        QVERIFY(leaked > 0.9);
        QVERIFY(left < 0.01);
        QVERIFY(pure > 0.94);
        QVERIFY(circle > 0.7 * circleBefore);
        QVERIFY(figure.kept("growth-arteries.png"));
    }

    /// Figure 8 on a real CT: a thick slab as MIP, the aorta sketched in it, then its false lumen;
    /// growth takes the heart, two plugs take it back.
    void aortaIsSketchedInMip()
    {
        std::optional<RealGrowth> growth = test::realGrowth(RealStructure::Aorta);
        if (!growth)
            QSKIP("no shared data");
        SculptStage stage(growth->study);
        QVERIFY(stage.isReady());
        GrowthFigure figure(stage);
        const OrthographicView side{.eyeLps = figure.place({400.0, 66.0, 78.0}),
            .targetLps = figure.place({62.0, 66.0, 78.0}),
            .up = {0.0, 0.0, 1.0},
            .heightMm = 240.0};
        gpu::VolumeScene mip = sceneOf(side);
        mip.mode = gpu::RenderMode::Mip;
        mip.mipWindow = {300.0, 900.0};
        mip.clip = wholeVolume(figure.geometry());
        mip.clip.box.minimum.x = 58.5;
        mip.clip.box.maximum.x = 61.5;
        mip.clip.box.on = true;
        const auto onPlane = [&](double row, double slice) {
            const glm::dvec3 away = figure.place({62.0, row, slice}) - side.targetLps;
            return glm::dvec2(away.y, away.z);
        };
        const std::vector<glm::dvec2> strokes[] = {
            {onPlane(46, 90), onPlane(44, 107), onPlane(55, 129), onPlane(72, 139),
                onPlane(88, 125), onPlane(96, 101)},
            {onPlane(84, 146), onPlane(97, 136), onPlane(104, 120), onPlane(107, 95),
                onPlane(104, 72), onPlane(93, 60)}};
        figure.shows(mip);
        QCOMPARE(figure.does(segment("Aorta", red)), QString());
        for (const auto& stroke : strokes) {
            figure.sketched(side, stroke, false);
            QCOMPARE(figure.seeds(1, mip, stroke), QString());
        }
        const auto shown = inColours({red});
        const OrthographicView front =
            viewFrom({0.75, -0.75, 0.12}, figure.place({60.0, 66.0, 80.0}), 250.0);
        gpu::VolumeScene xray = sceneOf(front);
        xray.mode = gpu::RenderMode::Xray;
        xray.xrayWindow = {-280.0, 900.0};
        QCOMPARE(figure.does(test::growBy({.lower = 200.0, .upper = 600.0, .majority = 14}, 40)),
            QString());
        figure.shows(xray, shown);
        QCOMPARE(figure.does(ResumeGrowth{}), QString());
        figure.shows(xray, shown);
        const double leaked = test::dice(figure.mask(1), growth->reference);
        QCOMPARE(figure.plugs({60, 58, 74}), QString());
        QCOMPARE(figure.plugs({60, 22, 63}), QString());
        figure.shows(xray, shown);
        const double reached = test::dice(figure.mask(1), growth->reference);
        qInfo("aorta from sketches in MIP: %d actions, Dice %.3f, before the heart went %.3f",
            figure.actions(), reached, leaked);
        QVERIFY(figure.actions() <= 10);
        QVERIFY(leaked < 0.5);
        QVERIFY(figure.kept("growth-aorta.png"));
        QVERIFY(reached > 0.7);
        QVERIFY(figure.kept("growth-aorta.png"));
    }

    /// Figure 9, top: the head is opened, the left ventricle seeded; growth spreads into what lies
    /// around and is reversed by a narrower interval; the right one is seeded and growth completed.
    /// There is no mask of these ventricles: what can be measured is that they are as large as each
    /// other and lie outside the atlas' grey matter.
    void ventriclesOfTheWholeHead()
    {
        const auto stage = shared("mr_brain_ch2_atlases", "ch2.nii.gz");
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        GrowthFigure figure(*stage);
        const OrthographicView view =
            viewFrom({-0.25, -0.55, 1.0}, figure.place({90.0, 112.0, 105.0}), 175.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 50.0;
        scene.cutFaces = gpu::CutFaces::GreyValues;
        scene.faceWindow = {70.0, 140.0};
        const std::vector<glm::dvec2> outline = ellipse({0.0, -4.0}, {52.0, 54.0});
        figure.shows(scene);
        figure.sketched(view, outline, true);
        ScissorsCut open{.layer = 1, .view = view, .polygonMm = outline, .depthMm = 68.0};
        open.surfaceThreshold = 50.0;
        QCOMPARE(figure.does(open), QString());
        QCOMPARE(figure.does(segment("Lateral ventricles", blue)), QString());
        QCOMPARE(figure.seeds(1, {{98, 105, 96}, {105, 125, 96}}), QString());
        const auto shown = inColours({blue});
        const GrowCriteria criteria{.lower = 0.0, .upper = 70.0, .majority = 14};
        QCOMPARE(figure.does(test::growBy(criteria, 130)), QString());
        const double leaked = figure.mL(1);
        figure.shows(scene, shown);
        ChangeInterval narrower;
        narrower.criteria.lower = 0.0;
        narrower.criteria.upper = 45.0;
        QCOMPARE(figure.does(narrower), QString());
        const double one = figure.mL(1);
        figure.shows(scene, shown);
        QCOMPARE(figure.seeds(1, {{83, 105, 96}, {76, 125, 96}}), QString());
        QCOMPARE(figure.does(ResumeGrowth{}), QString());
        const double both = figure.mL(1);
        figure.shows(scene, shown);

        const std::vector<std::uint8_t> grey = atlasRegions();
        const double inGrey = shareInside(figure.mask(1), grey);
        qInfo("ventricles of ch2: %d actions; leak %.1f mL, left %.1f mL, both %.1f mL; %.1f %% in "
              "regions of the atlas",
            figure.actions(), leaked, one, both, 100.0 * inGrey);
        QVERIFY(figure.actions() <= 10);
        QVERIFY(leaked > 2.0 * both);
        QVERIFY(one > 4.0 && one < 10.0);
        QVERIFY(both > 1.7 * one && both < 2.5 * one);
        QVERIFY(inGrey < 0.16);
        QVERIFY(figure.kept("growth-ventricles.png"));
    }

    /// Figure 1 c to e: skull and scalp are peeled off, seeds sketched on the cortex; white and
    /// grey matter grow, each by its own interval, and are shown by themselves.
    void greyAndWhiteMatter()
    {
        const auto stage = shared("mr_brain_ch2_atlases", "ch2.nii.gz");
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        GrowthFigure figure(*stage);
        const OrthographicView view =
            viewFrom({0.75, -0.35, 0.8}, figure.place({90.0, 108.0, 105.0}), 205.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 66.0;
        const std::vector<glm::dvec2> outline = ellipse({0.0, 8.0}, {74.0, 62.0});
        QCOMPARE(figure.does(test::peelWith(
                     {.view = view, .depthMm = 15.0, .surfaceThreshold = 66.0, .throughGaps = true},
                     outline)),
            QString());
        const GrowBox upper{.fromLps = figure.place({0, 0, 75}),
            .toLps = figure.place(glm::dvec3(figure.geometry().size - 1))};
        QCOMPARE(figure.does(segment("White matter", ivory)), QString());
        QCOMPARE(figure.seeds(1, {{60, 100, 100}, {60, 130, 100}}), QString());
        QCOMPARE(figure.does(
                     test::growBy({.lower = 93.0, .upper = 135.0, .majority = 16, .box = upper})),
            QString());
        QCOMPARE(figure.does(test::lockSegment(1)), QString());
        QCOMPARE(figure.does(segment("Grey matter", rose)), QString());
        const std::vector<glm::dvec2> stroke{
            {-40.0, -4.0}, {-10.0, 14.0}, {20.0, 6.0}, {46.0, -8.0}};
        gpu::VolumeScene deeper = scene;
        deeper.surfaceThreshold = 72.0;
        QCOMPARE(figure.seeds(2, deeper, stroke), QString());
        figure.shows(scene);
        figure.sketched(view, stroke, false, 0xFF60A0);
        QCOMPARE(figure.does(test::growBy(
                     {.lower = 62.0, .upper = 92.0, .majority = 14, .box = upper}, 25)),
            QString());
        figure.shows(scene, inColours({0, rose}));
        QCOMPARE(figure.does(ResumeGrowth{}), QString());

        const glm::dvec3 aside =
            glm::normalize(glm::cross(view.targetLps - view.eyeLps, glm::dvec3(0.0, 0.0, 1.0)));
        const glm::dvec3 far(0.0, 0.0, 600.0);
        for (int label = 1; label <= 2; ++label) {
            PastePiece paste{.segment = label, .name = QStringLiteral("alone")};
            paste.pivotLps = view.targetLps;
            paste.pose.offsetMm = far + 400.0 * label * aside;
            QCOMPARE(figure.does(paste), QString());
        }
        const std::vector<std::uint32_t> rgb{ivory, rose};
        for (int label = 2; label >= 1; --label) {
            OrthographicView beside = view;
            const glm::dvec3 offset = far + 400.0 * label * aside;
            beside.targetLps += offset;
            beside.eyeLps += offset;
            figure.showsPieces(sceneOf(beside), rgb);
        }

        const std::vector<std::uint8_t> regions = atlasRegions();
        const double inRegions = shareInside(figure.mask(2), regions);
        qInfo(
            "white matter %.0f mL, grey matter %.0f mL above the box's floor; %.1f %% of the grey "
            "in regions of the atlas",
            figure.mL(1), figure.mL(2), 100.0 * inRegions);
        QVERIFY(figure.mL(1) > 400.0 && figure.mL(1) < 600.0);
        QVERIFY(figure.mL(2) > 280.0 && figure.mL(2) < 450.0);
        QVERIFY(inRegions > 0.93);
        QVERIFY(figure.kept("growth-brain.png"));
    }

    /// Figure 9, bottom, by shrinking: from the crown down into the jaw, and back.
    void molarGrowsIntoTheJawAndBack()
    {
        std::optional<RealGrowth> growth = test::realGrowth(RealStructure::Tooth);
        if (!growth)
            QSKIP("no shared data");
        SculptStage stage(growth->study);
        QVERIFY(stage.isReady());
        GrowthFigure figure(stage);
        const auto direction = [&](const glm::dvec3& index) {
            return glm::normalize(figure.place(index) - figure.place(glm::dvec3(0.0)));
        };
        const glm::dvec3 towardsViewer =
            direction({1, 0, 0}) + 0.3 * direction({0, 1, 0}) - 0.1 * direction({0, 0, 1});
        const OrthographicView view = viewFrom(towardsViewer, figure.place({159, 184, 8}), 62.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = 226.0;
        figure.shows(scene);
        std::vector<Edit> edits = growth->edits;
        const Edit laser =
            test::laserWith({.view = viewFrom(towardsViewer, figure.place({160, 179, 10}), 62.0),
                .radiusMm = 7.5,
                .depthMm = 2.4,
                .surfaceThreshold = 226.0,
                .samples = std::vector<PenSample>(1)});
        QCOMPARE(figure.does(laser), QString());
        QCOMPARE(figure.does(edits[0]), QString());
        QCOMPARE(figure.does(edits[1]), QString());
        QCOMPARE(figure.does(edits[2]), QString());
        const double leaked = figure.mL(1);
        figure.shows(scene, inColours({red}));
        QCOMPARE(figure.does(edits[3]), QString());
        figure.shows(scene, inColours({red}));
        const double mL = figure.mL(1);
        PastePiece paste{.segment = 1, .name = QStringLiteral("Molar")};
        paste.pivotLps = figure.place({156, 180, 6});
        paste.pose = {.offsetMm = 500.0 * direction({0, 0, 1}), .zoom = 2.4};
        QCOMPARE(figure.does(paste), QString());
        OrthographicView alone = view;
        alone.targetLps = *paste.pivotLps + paste.pose.offsetMm;
        alone.eyeLps = alone.targetLps + 300.0 * glm::normalize(towardsViewer);
        figure.showsPieces(sceneOf(alone), {ivory});
        qInfo("molar: %d actions, %.2f mL; with the jaw %.1f mL", figure.actions(), mL, leaked);
        QVERIFY(figure.actions() <= 10);
        QVERIFY(leaked > 50.0);
        QVERIFY(mL > 1.0 && mL < 1.6);
        QVERIFY(figure.kept("growth-tooth.png"));
    }

    /// Figure 9, middle: the wall of the belly is peeled away, liver, lungs and a bronchus are
    /// seeded by several strokes and shown by themselves. No mask belongs to this study; volumes
    /// are told.
    void abdomenIsOpened()
    {
        if (!test::longRun() && !test::panelsWanted())
            QSKIP("23 million voxels: in the long run only");
        const auto stage = shared("ct_lidc0314_lower", nullptr);
        if (!stage)
            QSKIP("no shared data");
        QVERIFY(stage->isReady());
        GrowthFigure figure(*stage);
        const OrthographicView view =
            viewFrom({-0.3, -1.0, 0.22}, figure.place({236.0, 280.0, 42.0}), 230.0);
        gpu::VolumeScene scene = sceneOf(view);
        scene.surfaceThreshold = -300.0;
        scene.cutFaces = gpu::CutFaces::GreyValues;
        scene.faceWindow = {40.0, 350.0};
        const std::vector<glm::dvec2> outline = ellipse({-4.0, -6.0}, {112.0, 44.0});
        figure.shows(scene);
        figure.sketched(view, outline, true);
        QCOMPARE(
            figure.does(test::peelWith(
                {.view = view, .depthMm = 38.0, .surfaceThreshold = -300.0, .throughGaps = true},
                outline)),
            QString());
        figure.shows(scene);

        const GrowBox below{
            .fromLps = figure.place({0, 0, 0}), .toLps = figure.place({511, 511, 60})};
        QCOMPARE(figure.does(segment("Liver", brown)), QString());
        QCOMPARE(figure.seeds(1, {{110, 250, 30}, {150, 200, 30}}), QString());
        QCOMPARE(figure.does(
                     test::growBy({.lower = -10.0, .upper = 135.0, .majority = 27, .box = below})),
            QString());
        const double leaked = figure.mL(1);
        QCOMPARE(figure.shrinksAt({{350, 300, 20}, {380, 300, 20}}), QString());
        QCOMPARE(figure.shrinksAt({{330, 240, 36}, {350, 260, 36}}), QString());
        QCOMPARE(figure.does(test::lockSegment(1)), QString());
        QCOMPARE(figure.does(segment("Bronchus", yellow)), QString());
        QCOMPARE(figure.seeds(2, {{304, 340, 86}, {304, 340, 88}}), QString());
        QCOMPARE(figure.does(test::growBetween(-1000.0, -870.0)), QString());
        QCOMPARE(figure.does(test::lockSegment(2)), QString());
        QCOMPARE(figure.does(segment("Lungs", blue)), QString());
        QCOMPARE(figure.seeds(3, {{340, 300, 80}, {330, 380, 80}}), QString());
        QCOMPARE(figure.seeds(3, {{226, 320, 86}, {226, 380, 86}}), QString());
        QCOMPARE(figure.does(test::growBetween(-1000.0, -500.0)), QString());
        figure.shows(scene, inColours({brown, yellow, blue}));
        qInfo("abdomen: liver %.0f mL (with spleen and stomach %.0f), lungs %.0f mL, bronchus %.2f "
              "mL",
            figure.mL(1), leaked, figure.mL(3), figure.mL(2));
        for (int label = 1; label <= 3; ++label) {
            PastePiece paste{.segment = label, .name = QStringLiteral("alone")};
            paste.pivotLps = view.targetLps;
            paste.pose.offsetMm = {0.0, 0.0, 700.0};
            QCOMPARE(figure.does(paste), QString());
        }
        OrthographicView beside = view;
        beside.targetLps.z += 700.0;
        beside.eyeLps.z += 700.0;
        figure.showsPieces(sceneOf(beside), {brown, yellow, blue});
        QVERIFY(leaked > 1.25 * figure.mL(1));
        QVERIFY(figure.mL(1) > 600.0 && figure.mL(1) < 1000.0);
        QVERIFY(figure.mL(3) > 450.0 && figure.mL(3) < 600.0);
        QVERIFY(figure.mL(2) > 0.02 && figure.mL(2) < 1.0);
        QVERIFY(figure.kept("growth-abdomen.png"));
    }
};

BURIN_TEST(GrowthFiguresGlTest)

} // namespace growthFiguresGlTest

#include "GrowthFiguresGlTest.moc"
