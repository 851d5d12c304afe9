// SPDX-License-Identifier: Apache-2.0
#include "app/window/DemonstrationStudy.h"
#include "core/demo/HeadPhantom.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/pictures/ManualWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/study/OpenStudyDialog.h"
#include "ui/frame/MendingStrip.h"
#include "ui/models/HistoryModel.h"
#include "ui/panels/SeriesDoctorPanel.h"
#include "ui/panels/history/HistoryTimeline.h"
#include "ui/panels/history/KeyframePopup.h"
#include "ui/tools/refine/ChunkTool.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/tools/view/CuttingPlaneTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/Refinement.h"

#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include <cmath>
#include <cstdint>

namespace manualPicturesUiTest {

/// The manual's pictures of the history, of studies that come in, of masks that are mended and that
/// go out, in the real window on the demonstration study and on shared ones. It takes a minute, so
/// it only runs where somebody wants them: BURIN_SCREENSHOTS names the folder.
class ManualPicturesUiTest : public QObject, private test::ManualWindow {
    Q_OBJECT

private:
    [[nodiscard]] ui::HistoryTimeline& timeline()
    {
        return *window().findChild<ui::HistoryTimeline*>();
    }
    /// A stroke from where the 3D view looks, in parts of its height right of and above the middle.
    [[nodiscard]] core::Edit drill(
        const glm::dvec2& from, const glm::dvec2& to, double radiusMm, double depthMm)
    {
        const ui::Camera& camera = window().views().volume().camera();
        const glm::dvec2 start = from * camera.heightMm;
        const glm::dvec2 end = to * camera.heightMm;
        const std::vector<core::PenSample> samples{
            {start.x, start.y, 1.0, 0.0}, {end.x, end.y, 1.0, 0.4}};
        return test::drillWith({.view = core::OrthographicView{.eyeLps = camera.eyeLps(),
                                    .targetLps = camera.targetLps,
                                    .up = camera.up,
                                    .heightMm = camera.heightMm},
            .radiusMm = radiusMm,
            .depthMm = depthMm,
            .surfaceThreshold = workspace().volumeDisplay().surfaceThreshold,
            .samples = samples});
    }
    void unfoldBranches()
    {
        QAbstractItemModel& model =
            *window().findChild<QListView*>(QStringLiteral("historyList"))->model();
        for (int row = 0; row < model.rowCount(); ++row)
            model.setData(model.index(row, 0), false, ui::HistoryModel::FoldedRole);
    }
    void point(int step)
    {
        const QPointF at(timeline().xOf(step), timeline().height() - 8);
        QMouseEvent event(QEvent::MouseMove, at, timeline().mapToGlobal(at), Qt::NoButton,
            Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&timeline(), &event);
    }
    void open(const QString& study)
    {
        window().opener().open(study);
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
    }
    /// The demonstration study without some of its slices.
    [[nodiscard]] QString gapped()
    {
        const QString folder = m_folder.filePath(QStringLiteral("gapped"));
        if (QDir(folder).exists())
            return folder;
        QDir().mkpath(folder);
        if (!app::loadDemonstration(core::Progress()))
            qFatal("no demonstration study");
        const QDir from(app::demonstrationFolder());
        for (const QString& name : from.entryList({QStringLiteral("*.dcm")}, QDir::Files)) {
            const int slice = QFileInfo(name).baseName().right(4).toInt();
            if (slice < 120 || slice > 123)
                QFile::copy(from.filePath(name), folder + u'/' + name);
        }
        return folder;
    }
    /// The ventricles as a network might have found them: the front of one is missing, and there is
    /// a leak beside the other.
    [[nodiscard]] core::Edit poorVentricles()
    {
        const core::VolumeGeometry& geometry = workspace().volume()->geometry;
        const core::HeadPhantom head;
        const glm::dvec3 right(20.5, 31.0, 18.0); // what has calcified in the horns is theirs, too
        const glm::dvec3 leak(-29.0, 38.0, 22.0);
        const glm::dvec3 one = geometry.toIndex({-45.0, -45.0, -20.0});
        const glm::dvec3 other = geometry.toIndex({45.0, 65.0, 45.0});
        const glm::ivec3 from(glm::min(one, other));
        const glm::ivec3 to(glm::max(one, other));
        core::VoxelRuns runs;
        for (int k = from.z; k <= to.z; ++k) {
            for (int j = from.y; j <= to.y; ++j) {
                for (int i = from.x; i <= to.x; ++i) {
                    const glm::dvec3 place = geometry.toWorld(glm::dvec3(i, j, k));
                    const glm::dvec3 folded(std::abs(place.x), place.y, place.z);
                    const bool isMissing = place.x > 1.0 && place.y < -14.0;
                    const bool isTheirs = glm::distance(folded, right) < 5.5
                        || head.at(glm::vec3(place)).part == core::HeadPart::Ventricles;
                    if ((isTheirs && !isMissing) || glm::distance(place, leak) < 8.0)
                        runs.append(
                            (std::uint64_t(k) * geometry.size.y + j) * geometry.size.x + i, 1);
                }
            }
        }
        return test::maskImport(QStringLiteral("ventricles.nii.gz"), geometry.size,
            {{QStringLiteral("Ventricles"), runs, 0x4AA3FF}});
    }
    /// A study whose slices a gantry tilted; empty where there are no shared data.
    [[nodiscard]] static QString tilted()
    {
        const test::SharedCase tilted = test::sharedCase(QStringLiteral("ct_tilt_study_philips"));
        return tilted.source.isEmpty() ? QString() : tilted.unpacked;
    }
    static void copyAll(const QString& from, const QString& to)
    {
        QDirIterator files(from, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString file = files.next();
            const QString copy = to + u'/' + QDir(from).relativeFilePath(file);
            QVERIFY(QDir().mkpath(QFileInfo(copy).path()) && QFile::copy(file, copy));
        }
    }
    /// The series doctor with one of its offers chosen.
    void keepDoctor(const QString& study, const char* name)
    {
        start();
        open(study);
        foldAllBut({QStringLiteral("Series doctor"), QStringLiteral("Segments")});
        auto* doctor = window().findChild<ui::SeriesDoctorPanel*>();
        QVERIFY(doctor);
        auto* offer = doctor->findChild<QRadioButton*>(QStringLiteral("repairChoice1"));
        QVERIFY(offer);
        offer->click();
        QCOMPARE(doctor->findChild<QPushButton*>(QStringLiteral("applyRepair"))->text(),
            QStringLiteral("Apply"));
        keep(name);
    }
    /// The window, with what floats over it.
    void keep(const char* name)
    {
        // Panels count what a step changed 120 ms after it (GenerationSection, ToleranceSection),
        // and tell nobody.
        QTest::qWait(300);
        QPixmap picture = window().grab();
        if (const QWidget& popup = timeline().popup(); popup.isVisible()) {
            QPainter painter(&picture);
            painter.drawPixmap(window().mapFromGlobal(popup.mapToGlobal(QPoint())),
                const_cast<QWidget&>(popup).grab());
        }
        save(picture, name);
    }

private Q_SLOTS:
    void initTestCase() { wantPictures(); }
    void init() { test::failOnUnexpectedMessages(); }

    void studyBrowser()
    {
        if (tilted().isEmpty())
            QSKIP("no shared data here");
        const QString folder = m_folder.filePath(QStringLiteral("CD of the hospital"));
        QVERIFY(QDir().mkpath(folder));
        const test::SharedCase times = test::sharedCase(QStringLiteral("mr_4d_fmri_ge"));
        for (const auto& [study, name] : {std::pair(gapped(), "one"), std::pair(tilted(), "two"),
                 std::pair(times.unpacked, "three")})
            copyAll(study, folder + u'/' + QLatin1String(name));
        const auto study = core::Study::scan(folder, core::Progress());
        QVERIFY(study);
        start();
        core::StudyListing listing = study->listing();
        listing.path = QStringLiteral("/media/jane/CD of the hospital");
        ui::OpenStudyDialog dialog(listing);
        dialog.show();
        auto* list = dialog.findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItemCount(), 3);
        for (int row = 0; row < 3; ++row)
            QVERIFY(wait([&] { return !list->topLevelItem(row)->icon(0).isNull(); }));
        list->setCurrentItem(list->topLevelItem(0));
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        save(dialog.grab(), "study-browser.png");
    }

    void seriesDoctor()
    {
        if (tilted().isEmpty())
            QSKIP("no shared data here");
        keepDoctor(tilted(), "series-doctor-tilt.png");
        keepDoctor(gapped(), "series-doctor-gap.png");
    }

    void exportWithVerdict()
    {
        start();
        m_application->openDemonstration();
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
        const auto code = [](const char* value, const char* meaning) {
            return core::CodedConcept{
                QStringLiteral("SCT"), QLatin1String(value), QLatin1String(meaning)};
        };
        apply(core::AddSegment{
            QStringLiteral("Ventricles"), 0x4AA3FF, code("35764002", "Brain ventricle")});
        apply(test::seedAt(1, {{-22.0, 24.0, 20.0}}));
        apply(test::growBetween(-20, 18, 12));
        apply(core::AddSegment{QStringLiteral("Trepanation"), 0xE07A5F, code("89546000", "Skull")});
        apply(drill({-0.08, 0.21}, {0.08, 0.21}, 12, 14));
        apply(core::LayerToSegment{.layer = 1, .target = {.segment = 2}});
        ui::ExportDialog dialog(workspace());
        dialog.findChild<QLineEdit*>(QStringLiteral("exportFile"))
            ->setText(m_folder.filePath(QStringLiteral("head-seg.dcm")));
        dialog.show();
        QSignalSpy exported(&dialog, &ui::ExportDialog::exported);
        dialog.findChild<QPushButton*>(QStringLiteral("exportStart"))->click();
        QVERIFY(wait([&] { return exported.count() == 1; }));
        // A place of nobody's machine.
        QLineEdit* file = dialog.findChild<QLineEdit*>(QStringLiteral("exportFile"));
        const QSignalBlocker quiet(file);
        file->setText(QStringLiteral("/home/jane/masks/head-seg.dcm"));
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        save(dialog.grab(), "export-verdict.png");
    }

    /// The strip of the steps of mending after the first one: places to look at first, and what is
    /// seen at the first of them.
    void mending()
    {
        start();
        m_application->openDemonstration();
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("Comparison")});
        apply(poorVentricles());
        workspace().setActiveSegment(session().document().segments.front().label);
        ui::ViewGrid& views = window().views();
        const glm::dvec3 middle(-10.0, 18.0, 20.0);
        for (ui::SliceView* slice : {&views.axial(), &views.coronal(), &views.sagittal()})
            slice->setPlace({.centreLps = middle, .mmPerPixel = 0.3});
        ui::Workspace::VolumeDisplay display = workspace().volumeDisplay();
        display.context = gpu::Context::Hidden;
        workspace().setVolumeDisplay(display);
        views.volume().flyTo(middle, {-0.7, -1.0, 0.8});
        ui::Camera camera = views.volume().camera();
        camera.heightMm = 120.0;
        views.volume().setCamera(camera);
        const ui::MendingStrip& strip = window().mendingStrip();
        QVERIFY(wait([&strip] { return strip.isVisible(); }));
        strip.findChild<QToolButton*>(QStringLiteral("mendingLook"))->click();
        auto* places = window().findChild<QListWidget*>(QStringLiteral("placesToLookAt"));
        QVERIFY(wait([places] { return places->isVisible() && places->count() > 0; }));
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        QTest::mouseClick(places->viewport(), Qt::LeftButton, {},
            places->visualItemRect(places->item(0)).center());
        QVERIFY(strip.next() == ui::MendingStrip::Step::Mend);
        QVERIFY(waitUntilDrawn());
        keep("mending.png");
    }

    void repairedSurface()
    {
        openLesion();
        apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 11.0, .pointsLps = {{42, -36, 43}, {50, -44, 44}}}});
        apply(core::MarkSurface{
            .mark = core::SurfaceMark::Red, .path = {.radiusMm = 8.0, .pointsLps = {{4, -6, 25}}}});
        apply(
            core::SpherePush{.path = {.radiusMm = 11.0, .pointsLps = {{4, -2, 34}, {2, -4, 27}}}});
        // The surface close by, and nothing before it.
        ui::VolumeView& stage = window().views().volume();
        stage.flyTo({26, -20, 42}, glm::dvec3(0.0));
        ui::Camera camera = stage.camera();
        camera.heightMm = 125.0;
        stage.setCamera(camera);
        workspace().setCrosshairLps({24, -18, 42});
        workspace().refinement().setSettings(
            {.mode = ui::Refinement::Mode::Sphere, .radiusMm = 11.0});
        take<ui::RefineTool>();
        QVERIFY(waitUntilDrawn());
        ui::ImageView& slice = window().views().axial();
        const QPointF at = slice.context().toPixel({36, -38, 42});
        QTest::mouseMove(&slice, at.toPoint());
        QVERIFY(waitUntilDrawn());
        keep("refining.png");
    }

    void cuttingPlane()
    {
        openLesion();
        apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 11.0, .pointsLps = {{42, -36, 43}, {50, -44, 44}}}});
        // Along the leak.
        ui::CuttingPlane& plane = workspace().plane();
        QVERIFY(plane.passThrough({10, 4, 46}, {50, -44, 44}, {28, -20, 90}));
        if (plane.pose().normalLps().y < 0.0)
            plane.flip();
        workspace().setCrosshairLps({30, -24, 43});
        ui::CuttingPlane::Look look = plane.look();
        look.clipsAbove = true;
        plane.setLook(look);
        window().views().arrange(ui::ViewGrid::Layout::PenAndStage);
        window().views().volume().lookFrom(
            glm::normalize(-plane.pose().normalLps() + glm::dvec3(0.45, 0.0, 0.35)));
        take<ui::CuttingPlaneTool>();
        QVERIFY(waitUntilDrawn());
        keep("cutting-plane.png");
    }

    void chunksOfALiver()
    {
        const test::SharedCase body = test::sharedCase(QStringLiteral("ct_totalseg_body_3mm"));
        if (body.source.isEmpty())
            QSKIP("no shared data here");
        start();
        open(body.source + QStringLiteral("/ct_3mm.nii.gz"));
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("Chunks")});
        // Grown by its values alone, a liver leaks.
        apply(core::AddSegment{.name = QStringLiteral("Liver"), .rgb = 0xE07A5F});
        workspace().setActiveSegment(1);
        apply(test::seedAt(1, {{-66.0, -170.0, 392.0}}));
        apply(test::growBetween(5, 95, 30));
        QVERIFY(session().document().segment(1)->voxels > 10000);
        ui::Chunks& chunks = workspace().chunks();
        chunks.divide(12.0);
        QVERIFY(wait([&] { return chunks.map() != nullptr; }));
        workspace().setCrosshairLps({-66.0, -170.0, 392.0});
        take<ui::ChunkTool>();
        workspace().setWindowLevel({.centre = 50.0, .width = 350.0});
        ui::Workspace::VolumeDisplay display = workspace().volumeDisplay();
        display.surfaceThreshold = 180.0;
        workspace().setVolumeDisplay(display);
        window().views().volume().flyTo({-60.0, -170.0, 380.0}, {0.35, -1.0, 0.25});
        core::ClipRegion clip = workspace().clip();
        clip.planes[0] = {
            .pointLps = workspace().crosshairLps(), .normalLps = {0.0, -1.0, 0.0}, .on = true};
        workspace().setClip(clip);
        QVERIFY(waitUntilDrawn());
        ui::ImageView& slice = window().views().axial();
        QTest::mouseMove(&slice, slice.context().toPixel({-20.0, -170.0, 392.0}).toPoint());
        QVERIFY(waitUntilDrawn());
        keep("chunks.png");
    }

    void historyWithBranchesAndTimeline()
    {
        start();
        m_application->openDemonstration();
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("History")});

        apply(drill({-0.10, 0.21}, {0.10, 0.21}, 14, 12));
        apply(drill({-0.08, 0.21}, {0.08, 0.21}, 9, 24));
        apply(core::AddSegment{.name = QStringLiteral("Brain"), .rgb = 0x4AA3FF});
        apply(test::seedAt(1, {{-16.0, 0.5, 20.5}, {-14.0, 0.5, 20.5}}));
        const core::RowId seeded = session().history().position();
        apply(test::growBetween(-20, 120, 30));
        apply(test::growBetween(-20, 160, 25));
        QVERIFY(session().goTo(seeded));
        QVERIFY(waitUntilDrawn());
        apply(test::growBetween(0, 90, 88));
        apply(test::renameSegment(1, QStringLiteral("Cerebrum")));
        apply(drill({0.22, 0.0}, {0.24, -0.04}, 9, 14));
        apply(test::revertRows({session().history().position()}));
        const core::RowId last = session().history().position();
        apply(core::AddSegment{.name = QStringLiteral("Ventricles"), .rgb = 0xE07A5F});
        QVERIFY(session().goTo(last));
        QVERIFY(waitUntilDrawn());
        unfoldBranches();
        keep("history.png");

        point(6);
        point(2);
        QVERIFY(wait([this] { return !timeline().popup().picture().isNull(); }));
        keep("timeline.png");
    }
};

BURIN_WINDOW_TEST(ManualPicturesUiTest)

} // namespace manualPicturesUiTest

#include "ManualPicturesUiTest.moc"
