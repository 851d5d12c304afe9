// SPDX-License-Identifier: Apache-2.0
#include "core/brick/ThreadWithoutVoxels.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/masks/MaskOverlap.h"
#include "core/masks/ReadImport.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/pictures/Collage.h"
#include "tests/support/fixtures/pictures/FigureWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/dialogs/MaskOrderDialog.h"
#include "ui/dialogs/segment/BetweenSlicesDialog.h"
#include "ui/dialogs/segment/MirrorDialog.h"
#include "ui/dialogs/segment/ReshapeDialog.h"
#include "ui/dialogs/segment/ThresholdDialog.h"
#include "ui/measure/DistanceOfSegments.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEnterEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QtTest>

#include <cmath>

namespace segmentPicturesUiTest {

/// The manual's pictures of what is done to segments as a whole and in the 3D view: threshold,
/// previews, clean up, mirroring, distances, scissors, overlaps, points in time. It only runs where
/// somebody wants pictures: BURIN_SCREENSHOTS names the folder.
class SegmentPicturesUiTest : public QObject, private test::FigureWindow {
    Q_OBJECT

    using Mouse = test::WindowFixture;

private:
    static constexpr double z = 20.0; ///< mm; the slice in which the ventricles are largest
    static constexpr QSize cleanSize{300, 270};

    void addSkull()
    {
        apply(test::newSegment(QStringLiteral("Skull"), 0xE6C84A));
        workspace().setActiveSegment(1);
        apply(core::ThresholdSegment{.segment = 1, .lower = 300.0});
    }
    template <class Dialog> Dialog& dialog()
    {
        auto* found = window().findChild<Dialog*>();
        if (!found)
            qFatal("no dialog");
        return *found;
    }
    /// A ball, and where it lies in the brain.
    [[nodiscard]] QByteArray ball(const glm::dvec3& centreLps, double radiusMm)
    {
        const core::VolumeGeometry& geometry = workspace().volume()->geometry;
        core::VoxelRuns runs;
        for (int k = 0; k < geometry.size.z; ++k) {
            for (int j = 0; j < geometry.size.y; ++j) {
                const glm::dvec3 first = geometry.toWorld(glm::dvec3(0, j, k)) - centreLps;
                const double rest = radiusMm * radiusMm - first.y * first.y - first.z * first.z;
                if (rest <= 0.0)
                    continue;
                const double step = geometry.toWorld(glm::dvec3(1, j, k)).x - centreLps.x - first.x;
                const int from = int(std::ceil((-first.x - std::sqrt(rest)) / step));
                const int to = int(std::floor((-first.x + std::sqrt(rest)) / step));
                if (to >= from)
                    runs.append((std::uint64_t(k) * geometry.size.y + j) * geometry.size.x + from,
                        std::uint64_t(to - from + 1));
            }
        }
        return core::packedRuns(runs);
    }
    /// From the front: a lesion that was drawn on five slices.
    ui::SliceView& lesionOnSlices()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Lesion"), 0xE07A5F));
        workspace().setActiveSegment(1);
        constexpr double apartMm = 8.0;
        const glm::dvec3 middle(30.0, 5.0, 34.5);
        for (int i = -2; i <= 2; ++i) {
            const glm::dvec3 place = middle + glm::dvec3(4.0 * i, 0.0, apartMm * i);
            apply(test::paintDiscAt(1, place, {0.0, 0.0, 1.0}, 16.0 - 2.5 * i * i));
        }
        ui::SliceView& coronal = window().views().coronal();
        window().views().maximise(&coronal);
        workspace().setCrosshairLps(middle);
        QCoreApplication::processEvents();
        coronal.setPlace({.centreLps = middle, .mmPerPixel = 0.28});
        rest();
        return coronal;
    }
    /// The same, and what is filled between them.
    [[nodiscard]] std::vector<QImage> lesionBetweenSlices()
    {
        ui::SliceView& coronal = lesionOnSlices();
        std::vector<QImage> seen{test::middleOf(coronal, cleanSize)};
        workspace().askToFillBetween(1);
        auto& asked = dialog<ui::BetweenSlicesDialog>();
        press("applyBetween");
        asked.close();
        rest();
        seen.push_back(test::middleOf(coronal, cleanSize));
        return seen;
    }
    /// Presses what makes a row, and waits for that.
    void press(const char* button)
    {
        auto* found = window().findChild<QPushButton*>(QLatin1String(button));
        QVERIFY(found);
        QVERIFY(wait([found] { return found->isEnabled(); }));
        const std::size_t rows = session().history().rows().size();
        found->click();
        QVERIFY(wait([&] { return session().history().rows().size() > rows; }));
    }
    /// The panel that cleans up, with the pointer on a button.
    [[nodiscard]] QImage panelWithPreview()
    {
        auto* button =
            window().findChild<QPushButton*>(QStringLiteral("cleanUp.segments.removeSmall"));
        const auto* now = window().findChild<QLabel*>(QStringLiteral("cleanUpNow"));
        window().findChild<QCheckBox*>(QStringLiteral("cleanUpPreview"))->setChecked(true);
        const QPointF middle = button->rect().center();
        QEnterEvent enter(middle, middle, button->mapToGlobal(middle));
        QCoreApplication::sendEvent(button, &enter);
        if (!wait([now] { return now->text().endsWith(QStringLiteral(" voxels")); }))
            qFatal("no preview: %s", qPrintable(now->text()));
        const QImage seen = pictureOf(QStringLiteral("Clean up"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(button, &leave);
        return seen;
    }
    /// Waits until a preview is there, and drawn. To settle would end it.
    void previewed(const QLabel& size)
    {
        QVERIFY(wait([&size] { return size.text().endsWith(u')'); }));
        for (int picture = 0; picture < 3; ++picture) {
            QTest::qWait(2 * restMs);
            QVERIFY(wait([this] { return window().views().refined(); }));
        }
    }

private Q_SLOTS:
    void initTestCase() { wantPictures(); }
    void init() { test::failOnUnexpectedMessages(); }

    /// The dialog while it is open, and what is seen meanwhile.
    void threshold()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Skull"), 0xE6C84A));
        workspace().setActiveSegment(1);
        workspace().askForThreshold(1);
        auto& asked = dialog<ui::ThresholdDialog>();
        QVERIFY(QTest::qWaitForWindowExposed(&asked));
        asked.findChild<QDoubleSpinBox*>(QStringLiteral("rangeLower"))->setValue(250.0);
        ui::ViewGrid& views = window().views();
        views.volume().flyTo({0.0, 0.0, 10.0}, {-0.5, -1.0, 0.3});
        ui::Camera camera = views.volume().camera();
        camera.heightMm = 330.0;
        views.volume().setCamera(camera);
        show(gpu::Context::Hidden);
        // To settle would end what is shown before it is applied.
        QVERIFY(wait([this] { return session().isOpen<core::ThresholdSegment>(); }));
        const auto* size = asked.findChild<QLabel*>(QStringLiteral("thresholdNow"));
        QVERIFY(wait([size] {
            return size->text().startsWith(QStringLiteral("Preview: "))
                && !size->text().contains(QStringLiteral("counting"));
        }));
        for (int picture = 0; picture < 3; ++picture) {
            QTest::qWait(2 * restMs);
            QVERIFY(wait([&views] { return views.refined(); }));
        }
        constexpr QSize side(300, 226);
        QVERIFY(
            test::keepCollage({{test::middleOf(views.axial(), side),
                                  test::middleOf(views.volume(), side), asked.grab().toImage()}},
                "threshold.png"));
        // What was counted in the preview is what the step comes to.
        const QString counted = size->text().section(QLatin1Char('\n'), 0, 0);
        QVERIFY(counted.startsWith(QStringLiteral("Preview: ")));
        asked.findChild<QPushButton*>(QStringLiteral("applyThreshold"))->click();
        const QString now = QStringLiteral("Now: ") + counted.mid(9);
        QVERIFY(wait([&] { return size->text().section(QLatin1Char('\n'), -1) == now; }));
        asked.close();
    }

    /// A margin around the ventricles, and a lesion between its slices, before they are steps.
    void previews()
    {
        constexpr QSize side(240, 226);
        openHead();
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(core::ThresholdSegment{.segment = 1,
            .lower = -20.0,
            .upper = 16.0,
            .box = core::GrowBox{.fromLps = {-45.0, -45.0, -10.0}, .toLps = {45.0, 55.0, 50.0}}});
        apply(core::CleanSegment{.segment = 1, .rule = core::IslandRule::FillHoles});
        apply(
            core::CleanSegment{.segment = 1, .rule = core::IslandRule::RemoveSmall, .mm3 = 100.0});
        ui::SliceView& axial = axialAlone({0.0, 8.0, z}, 0.34);
        rest();
        std::vector<QImage> margin{test::middleOf(axial, side)};
        workspace().askToReshape(1, core::ShapeOperation::Grow);
        auto& reshape = dialog<ui::ReshapeDialog>();
        QVERIFY(QTest::qWaitForWindowExposed(&reshape));
        reshape.findChild<QDoubleSpinBox*>(QStringLiteral("reshapeMm"))->setValue(1.5);
        const auto& size = *reshape.findChild<QLabel*>(QStringLiteral("reshapeNow"));
        previewed(size);
        margin.push_back(test::middleOf(axial, side));
        margin.push_back(reshape.grab().toImage());
        // What was counted in the preview is what the step comes to.
        const QString after = size.text().section(u' ', 4, 5);
        press("applyReshape");
        QVERIFY(wait([&] { return size.text() == QStringLiteral("Now: ") + after; }));
        reshape.close();

        ui::SliceView& coronal = lesionOnSlices();
        std::vector<QImage> filling{test::middleOf(coronal, side)};
        workspace().askToFillBetween(1);
        auto& between = dialog<ui::BetweenSlicesDialog>();
        QVERIFY(QTest::qWaitForWindowExposed(&between));
        previewed(*between.findChild<QLabel*>(QStringLiteral("betweenNow")));
        filling.push_back(test::middleOf(coronal, side));
        filling.push_back(between.grab().toImage());
        between.close();
        QVERIFY(test::keepCollage({margin, filling}, "previews.png"));
    }

    /// A segment with specks and a hole, the panel that cleans it, and a margin.
    void cleanUp()
    {
        openHead(QStringLiteral("Clean up"));
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(core::ThresholdSegment{.segment = 1,
            .lower = -20.0,
            .upper = 16.0,
            .box = core::GrowBox{.fromLps = {-45.0, -45.0, -10.0}, .toLps = {45.0, 55.0, 50.0}}});
        ui::SliceView& axial = axialAlone({0.0, 8.0, z}, 0.34);
        std::vector<QImage> panels;
        const auto keep = [&] {
            rest();
            panels.push_back(test::middleOf(axial, cleanSize));
        };
        keep();
        const QImage panel = panelWithPreview();
        press("cleanUp.segments.fillHoles");
        press("cleanUp.segments.removeSmall");
        keep();
        workspace().askToReshape(1, core::ShapeOperation::Grow);
        auto& margin = dialog<ui::ReshapeDialog>();
        QVERIFY(QTest::qWaitForWindowExposed(&margin));
        margin.findChild<QDoubleSpinBox*>(QStringLiteral("reshapeMm"))->setValue(2.0);
        press("applyReshape");
        margin.close();
        keep();
        std::vector<QImage> below = lesionBetweenSlices();
        below.insert(below.begin(), panel);
        QVERIFY(test::keepCollage({panels, below}, "clean-up.png"));
    }

    /// One ventricle gives two; then how far a lesion is from them.
    void mirrorAndDistance()
    {
        openHead(QStringLiteral("Measurements"));
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(core::ThresholdSegment{.segment = 1,
            .lower = -20.0,
            .upper = 16.0,
            .box = core::GrowBox{.fromLps = {-31.0, -38.0, 6.0}, .toLps = {-2.5, 63.0, 38.0}}});
        apply(core::CleanSegment{.segment = 1, .rule = core::IslandRule::FillHoles});
        const glm::dvec3 frontHorn(-7.9, -20.7, 20.5);
        apply(core::CleanSegment{
            .segment = 1, .rule = core::IslandRule::KeepClicked, .islandLps = frontHorn});
        ui::SliceView& axial = axialAlone({0.0, 8.0, z}, 0.34);
        rest();
        std::vector<QImage> mirrored{test::middleOf(axial, cleanSize)};
        workspace().askToMirror(1);
        auto& asked = dialog<ui::MirrorDialog>();
        QVERIFY(QTest::qWaitForWindowExposed(&asked));
        asked.findChild<QCheckBox*>(QStringLiteral("mirrorKeep"))->setChecked(true);
        previewed(*asked.findChild<QLabel*>(QStringLiteral("mirrorNow")));
        mirrored.push_back(test::middleOf(axial, cleanSize));
        mirrored.push_back(asked.grab().toImage());
        QVERIFY(test::keepCollage({mirrored}, "mirror.png"));
        press("applyMirror");
        asked.close();

        apply(test::newSegment(QStringLiteral("Lesion"), 0xE07A5F));
        apply(test::paintAt(2, {{38.0, -14.0, 26.0}}, 7.0));
        ui::measureDistance(workspace(), 1, 2);
        QVERIFY(wait([this] { return !session().document().measurements.empty(); }));
        show(gpu::Context::Hidden);
        ui::VolumeView& stage = window().views().volume();
        window().views().maximise(&stage);
        stage.flyTo({10.0, 8.0, z}, {0.35, -1.0, 0.9});
        ui::Camera camera = stage.camera();
        camera.heightMm = 190.0;
        stage.setCamera(camera);
        rest();
        QVERIFY(test::keepCollage(
            {{test::middleOf(stage, QSize(600, 330)), pictureOf(QStringLiteral("Measurements"))}},
            "segment-distance.png"));
    }

    /// The near wall of the skull is cut out, no deeper than that.
    void scissors()
    {
        openHead();
        addSkull();
        show(gpu::Context::Hidden);
        ui::VolumeView& stage = window().views().volume();
        window().views().maximise(&stage);
        stage.lookFrom({-0.5, -1.0, 0.45});
        auto& tool = hand<ui::SegmentScissorsTool>();
        tool.setSettings({.depthMm = 25.0});
        rest();
        const QPointF middle(stage.width() / 2.0, stage.height() / 2.0);
        const auto at = [&](double turn) {
            return middle + QPointF(-10.0 + 95.0 * std::cos(turn), -95.0 + 75.0 * std::sin(turn));
        };
        Mouse::hover(stage, at(0.0));
        Mouse::mouse(stage, QEvent::MouseButtonPress, at(0.0));
        for (double turn = 0.1; turn < 6.0; turn += 0.1)
            Mouse::mouse(stage, QEvent::MouseMove, at(turn));
        rest();
        constexpr QSize size(520, 470);
        std::vector<QImage> panels{test::middleOf(stage, size)};
        Mouse::mouse(stage, QEvent::MouseButtonRelease, at(6.0));
        Mouse::hover(stage, QPointF(5.0, 5.0));
        rest();
        panels.push_back(test::middleOf(stage, size));
        QVERIFY(test::keepCollage({panels}, "segment-scissors.png"));
    }

    /// The skull is split along a line that is drawn across; both volumes are told.
    void split()
    {
        openHead();
        addSkull();
        show(gpu::Context::Hidden);
        ui::VolumeView& stage = window().views().volume();
        window().views().maximise(&stage);
        stage.lookFrom({-0.8, -1.0, 0.1});
        auto& tool = hand<ui::SegmentScissorsTool>();
        tool.setSettings({.does = ui::SegmentScissorsTool::Does::SplitAlong});
        rest();
        const QPointF middle(stage.width() / 2.0, stage.height() / 2.0);
        const auto at = [&](double part) {
            return middle + QPointF(110.0 - 260.0 * part, -60.0 - 25.0 * std::sin(6.0 * part));
        };
        Mouse::hover(stage, at(0.0));
        Mouse::mouse(stage, QEvent::MouseButtonPress, at(0.0));
        for (double part = 0.02; part < 1.0; part += 0.02)
            Mouse::mouse(stage, QEvent::MouseMove, at(part));
        rest();
        QVERIFY(!tool.partsLine().isEmpty());
        constexpr QSize size(520, 470);
        std::vector<QImage> panels{test::middleOf(stage, size)};
        Mouse::mouse(stage, QEvent::MouseButtonRelease, at(1.0));
        Mouse::hover(stage, QPointF(5.0, 5.0));
        rest();
        panels.push_back(test::middleOf(stage, size));
        QVERIFY(test::keepCollage({panels}, "segment-split.png"));
    }

    /// Two segments of a file that overlap: each view in its own way, and what was asked before.
    void overlaps()
    {
        openHead();
        core::ImportMask mask{.file = QStringLiteral("lesion.seg.nrrd")};
        mask.size = workspace().volume()->geometry.size;
        mask.segments = {{.name = QStringLiteral("Oedema"),
                             .rgb = 0x30C060,
                             .code = {},
                             .voxels = ball({30.0, 10.0, 30.0}, 26.0)},
            {.name = QStringLiteral("Tumour"),
                .rgb = 0xE04080,
                .code = {},
                .voxels = ball({36.0, 4.0, 33.0}, 12.0)}};
        mask.planes = std::vector<int>{0, 1};
        apply(mask);
        workspace().setActiveSegment(2);
        workspace().setSegmentOpacity(1, 35);
        workspace().setCrosshairLps({36.0, 4.0, 33.0});
        ui::ViewGrid& views = window().views();
        views.axial().setSegmentLook({.drawing = ui::Workspace::SegmentDrawing::Outline});
        show(gpu::Context::Hidden);
        views.volume().flyTo({30.0, 10.0, 30.0}, {0.6, -1.0, 0.3});
        ui::Camera camera = views.volume().camera();
        camera.heightMm = 90.0;
        views.volume().setCamera(camera);
        rest();
        const std::vector<QImage> seen{views.axial().grab().toImage(),
            views.coronal().grab().toImage(), views.volume().grab().toImage()};
        core::ReadImport read{.edit = mask, .notes = {}};
        std::vector<core::MaskSegment> segments;
        const glm::ivec3 size = *mask.size;
        {
            const core::VoxelsAllowed unpacks; // it is the test that looks, not the window
            for (const core::ImportedSegment& each : *mask.segments)
                segments.push_back({.name = each.name,
                    .rgb = {},
                    .code = {},
                    .voxels =
                        *core::unpackedRuns(each.voxels, std::uint64_t(size.x) * size.y * size.z)});
        }
        read.overlaps = core::overlapsOf(segments);
        read.planes = {0, 1};
        ui::MaskOrderDialog asked(read, workspace().volume()->geometry, &window());
        asked.show();
        QVERIFY(QTest::qWaitForWindowExposed(&asked));
        asked.findChild<QRadioButton*>(QStringLiteral("maskOrderFlatten"))->click();
        QTest::qWait(restMs);
        QVERIFY(test::keepCollage(
            {{seen[0], seen[1]}, {seen[2], asked.grab().toImage()}}, "overlaps.png"));
    }

    /// The slider of the points in time, with its menu.
    void pointsInTime()
    {
        const test::SharedCase times = test::sharedCase(QStringLiteral("mr_4d_fmri_ge"));
        if (times.unpacked.isEmpty())
            QSKIP("no shared data here");
        start();
        window().opener().open(times.unpacked,
            QStringLiteral("1.2.840.113619.2.408.5282380.4562341.27283.1537222031.341@3"));
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("Series doctor")});
        QVERIFY(waitUntilDrawn());
        rest();
        auto* slider = window().findChild<QSlider*>(QStringLiteral("timeSlider"));
        Q_EMIT slider->customContextMenuRequested(slider->rect().center());
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        const QImage choices = menu->grab().toImage();
        QVERIFY(test::keepCollage({{window().views().axial().grab().toImage(),
                                      pictureOf(QStringLiteral("Series doctor")), choices}},
            "points-in-time.png"));
        menu->close();
    }
};

BURIN_WINDOW_TEST(SegmentPicturesUiTest)

} // namespace segmentPicturesUiTest

#include "SegmentPicturesUiTest.moc"
