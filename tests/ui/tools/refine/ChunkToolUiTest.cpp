// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "tests/reference/RefusingEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/series/NrrdFiles.h"
#include "ui/menus/EditableButton.h"
#include "ui/panels/refine/ChunksPanel.h"
#include "ui/tools/refine/ChunkTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Chunks.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace chunkToolUiTest {

namespace {

using Mode = core::ChunkToggle::Mode;

// The ball is the ventricle and some of the brain around it; bone lies from 13 to 16 mm.
constexpr double radius = 9.0;
constexpr double marginMm = 8.0;
constexpr int few = 5; // ventricle, brain within and without, bone, air
constexpr glm::dvec3 inVentricle(0.0, 0.0, 0.0);
constexpr glm::dvec3 inBone(14.0, 0.0, 0.0);

core::Edit ball()
{
    return test::ballMask(glm::ivec3(test::smallHead::side), radius);
}

QByteArray canonical(const core::Edit& edit)
{
    return QJsonDocument(core::editToJson(core::quantised(edit))).toJson(QJsonDocument::Compact);
}

/// The real window with the small head and a ball as segment 1.
class ChunkFixture : public test::WindowFixture {
public:
    ChunkFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , panel(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        apply(ball());
        workspace.setActiveSegment(1);
        workspace.setActiveTool(&tool);
        view.lookFrom({1.0, 0.0, 0.0});
    }
    [[nodiscard]] ui::Chunks& chunks() { return workspace.chunks(); }
    void apply(const core::Edit& edit)
    {
        QVERIFY(session().apply(edit));
        settle();
    }
    void settle()
    {
        QVERIFY(session().settle());
        QCoreApplication::processEvents();
        const auto counted = [this] { // what was asked about the change
            return session().settle() && !chunks().isCounting();
        };
        QVERIFY(QTest::qWaitFor(counted, 60000));
        QCoreApplication::processEvents();
    }
    /// Chunks are worked out on threads of their own.
    void await()
    {
        const auto there = [this] {
            session().poll();
            return chunks().map() != nullptr;
        };
        QVERIFY(QTest::qWaitFor(there, 60000));
        settle();
    }
    void divide(int count)
    {
        chunks().divide(marginMm);
        settle();
        await();
        // It has begun with the number that is suggested.
        ui::Chunks::Look look = chunks().look();
        look.count = count;
        look.bodies = ui::Chunks::Bodies::All;
        chunks().setLook(look);
        settle();
    }
    template <class Widget> [[nodiscard]] Widget* find(const char* name)
    {
        return panel.findChild<Widget*>(QLatin1String(name));
    }
    [[nodiscard]] core::RowId position() { return session().history().position(); }
    [[nodiscard]] const core::ChunkToggle* lastClick()
    {
        return session().history().row(position()).edit.as<core::ChunkToggle>();
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }
    template <class View> [[nodiscard]] static QPointF at(View& where, const glm::dvec3& lps)
    {
        return where.context().toPixel(lps);
    }
    template <class View>
    void click(View& where, const glm::dvec3& lps, Qt::KeyboardModifiers keys = Qt::NoModifier)
    {
        QTest::mouseClick(&where, Qt::LeftButton, keys, at(where, lps).toPoint());
        settle();
    }
    template <class View> void click(test::DrawnBy by, View& where, const glm::dvec3& lps)
    {
        test::drawStroke(by, where, {at(where, lps).toPoint()});
        settle();
    }
    [[nodiscard]] ui::Chunks::Chunk chunkAt(const glm::dvec3& lps)
    {
        const glm::ivec3 voxel(glm::round(workspace.volume()->geometry.toIndex(lps)));
        return chunks().chunkAt(voxel).value();
    }
    /// How strongly a slice shows what lies at a place, 0 … 255.
    [[nodiscard]] std::uint32_t strength(const glm::dvec3& lps)
    {
        const auto shown =
            std::get<gpu::SliceScene>(frames.lastRequest(slice.viewId()).scene).chunks;
        const glm::ivec3 voxel(glm::round(workspace.volume()->geometry.toIndex(lps)));
        const glm::ivec3 size = shown->box.maximum - shown->box.minimum;
        const glm::ivec3 within = voxel - shown->box.minimum;
        const int leaf =
            (*shown->leaves)[std::size_t((within.z * size.y + within.y) * size.x + within.x)];
        return shown->argb[std::size_t(leaf - 1)] >> 24;
    }

    ui::ChunkTool tool;
    ui::ChunksPanel panel;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

} // namespace

/// Chunks of a segment, added and taken with mouse and pen.
class ChunkToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The option bar says which voxels may change, and others stay as they are.
    void keepsToTheEditableRange()
    {
        ChunkFixture fixture;
        fixture.divide(few);
        QWidget parent;
        auto* button = fixture.tool.createOptions(&parent)->findChild<ui::EditableButton*>();
        QVERIFY(button);
        const core::RowId divided = fixture.position();
        const std::int64_t all = fixture.voxels();
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = 2000.0, .upper = 3000.0}); // none has these
        QVERIFY(button->toolTip().contains(QStringLiteral("editable: only 2000 … 3000 HU")));
        fixture.click(fixture.slice, inVentricle);
        QCOMPARE(fixture.position(), divided);
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -10.0, .upper = 20.0});
        fixture.click(fixture.slice, inVentricle);
        QVERIFY(fixture.lastClick());
        QVERIFY(
            fixture.lastClick()->editable == core::EditableRange({.lower = -10.0, .upper = 20.0}));
        QCOMPARE(fixture.voxels(), all - test::smallHead::voxelsOf(test::smallHead::ventricleHu));
    }

    void thePanelDivides()
    {
        ChunkFixture fixture;
        auto* divide = fixture.find<QPushButton>("divide");
        QVERIFY(divide->isEnabled());
        QVERIFY(!fixture.chunks().areas() && !fixture.chunks().bodies());
        QVERIFY(fixture.find<QCheckBox>("chunksShown")->isHidden()
            || fixture.find<QCheckBox>("chunksShown")->parentWidget()->isHidden());
        fixture.find<QDoubleSpinBox>("chunksMargin")->setValue(marginMm);
        divide->click();
        fixture.settle();
        fixture.await();
        const core::RowId divided = fixture.position();
        const auto* edit = fixture.session().history().row(divided).edit.as<core::DivideSegment>();
        QVERIFY(edit && edit->segment == 1);
        QCOMPARE(edit->marginMm, marginMm);
        QVERIFY(fixture.find<QCheckBox>("chunksShown")->isChecked());
        QVERIFY(fixture.chunks().areas() && fixture.chunks().bodies());
        const auto requested = [&](gpu::ViewId view) {
            const gpu::Scene& scene = fixture.frames.lastRequest(view).scene;
            return std::visit([](const auto& drawn) { return drawn.chunks; }, scene);
        };
        QCOMPARE(requested(fixture.slice.viewId()), fixture.chunks().areas());
        QCOMPARE(requested(fixture.view.viewId()), fixture.chunks().bodies());

        // The slider divides anew without a row, and says how many there are.
        const auto* state = fixture.find<QLabel>("chunksState");
        auto* count = fixture.find<QSlider>("chunkCount");
        count->setValue(count->minimum());
        const int fewest = fixture.chunks().count();
        QCOMPARE(fixture.chunks().shownCount(), 5);
        const auto before = fixture.chunks().areas();
        count->setValue(count->maximum());
        QCOMPARE(fixture.chunks().count(), fixture.chunks().map()->tree().finest());
        QVERIFY(fixture.chunks().count() > 20 * fewest);
        QVERIFY(fixture.chunks().areas() != before);
        QCOMPARE(fixture.chunks().areas()->leaves, before->leaves); // sent once
        QCOMPARE(fixture.position(), divided);
        QVERIFY2(state->text().endsWith(QStringLiteral("chunks")), qPrintable(state->text()));
        QVERIFY(fixture.chunks().ownCount() > 0
            && fixture.chunks().ownCount() < fixture.chunks().count());

        fixture.find<QSlider>("chunkOpacity")->setValue(70);
        QCOMPARE(fixture.chunks().areas()->opacity, 0.7f);
        fixture.find<QCheckBox>("chunksShown")->setChecked(false);
        QVERIFY(!requested(fixture.slice.viewId()) && !requested(fixture.view.viewId()));
        QCOMPARE(fixture.position(), divided);
    }

    /// The map's file is read beside the window; a bad one is told and leaves no row.
    void byAProbabilityMap()
    {
        ChunkFixture on;
        QTemporaryDir folder;
        const auto* source = on.find<QComboBox>("chunksSource");
        QCOMPARE(source->count(), 2);
        QVERIFY(source->currentData().toString().isEmpty());
        const core::Volume& volume = *on.workspace.volume();
        const auto put = [&folder](const char* name, const QByteArray& bytes) {
            QFile file(folder.filePath(QLatin1String(name)));
            if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
                qFatal("not written");
            return file.fileName();
        };
        const QString bad = put("bad.nrrd", "no map");
        QString failure;
        connect(&on.workspace, &ui::Workspace::failed, &on.workspace,
            [&failure](const core::Error& error) { failure = error.arguments.value(0); });
        const core::RowId before = on.position();
        on.chunks().divide(marginMm, bad);
        QVERIFY(on.chunks().isReading() && !on.find<QPushButton>("divide")->isEnabled());
        QTRY_VERIFY(!failure.isEmpty());
        QVERIFY(failure.contains(QLatin1String("bad.nrrd")));
        QTRY_VERIFY(!on.chunks().isReading() && on.find<QPushButton>("divide")->isEnabled());
        QCOMPARE(on.position(), before);

        const QString map = put("even.nrrd",
            test::nrrd::onGrid(volume.geometry, "uchar",
                QByteArray(qsizetype(volume.geometry.voxelCount()), char(200))));
        on.chunks().divide(marginMm, map);
        QTRY_VERIFY(!on.chunks().isReading());
        on.settle();
        on.await();
        const core::RowId divided = on.position();
        QVERIFY(divided > before);
        QVERIFY(on.session()
                    .history()
                    .row(divided)
                    .edit.get<core::DivideSegment>()
                    .probabilities.has_value());
        QCOMPARE(on.chunks().map()->tree().likelihood(on.chunkAt(inVentricle)), 2 * 200 - 255);
        QVERIFY(on.find<QPushButton>("divide")->isEnabled());
        // The same once more is no step, and the button comes back all the same.
        on.chunks().divide(marginMm, map);
        QTRY_VERIFY(!on.chunks().isReading());
        on.settle();
        QCOMPARE(on.position(), divided);
        QVERIFY(on.find<QPushButton>("divide")->isEnabled());
    }

    void whatHasNoVoxelsIsNotDivided()
    {
        ChunkFixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Empty"), 0x20A0C0));
        fixture.workspace.setActiveSegment(2);
        QVERIFY(!fixture.find<QPushButton>("divide")->isEnabled());
        QVERIFY(fixture.find<QLabel>("chunksWhose")
                    ->text()
                    .contains(QStringLiteral("Empty has no voxels yet")));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const core::RowId before = fixture.position();
        fixture.chunks().divide(10.0);
        QCOMPARE(said.size(), 1);
        QVERIFY(said.last().first().toString().contains(QStringLiteral("has no voxels yet")));
        // Nor is there anything to click on.
        fixture.click(fixture.slice, inBone);
        QVERIFY(said.last().first().toString().contains(QStringLiteral("press Divide")));
        QCOMPARE(fixture.position(), before);
    }

    void aDivisionIsAborted()
    {
        ChunkFixture fixture;
        const core::RowId before = fixture.position();
        fixture.chunks().divide(marginMm);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.position() != before);
        QVERIFY(fixture.chunks().isWorking()); // what is worked out comes in line with events
        fixture.find<QPushButton>("chunksAbort")->click();
        fixture.settle();
        QCOMPARE(fixture.position(), before);
        QVERIFY(!fixture.chunks().isWorking() && !fixture.chunks().division());
    }

    /// A step that is not carried out yet is not taken back in the division's place.
    void anAbortLeavesTheNewestStepAlone()
    {
        ChunkFixture fixture;
        fixture.chunks().divide(marginMm);
        QVERIFY(fixture.session().settle());
        const core::RowId divided = fixture.position();
        QVERIFY(fixture.chunks().isWorking());
        QVERIFY(fixture.session().apply(test::paintAt(1, {inBone})));
        QCOMPARE(fixture.position(), divided); // it waits
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.find<QPushButton>("chunksAbort")->click();
        fixture.settle();
        QCOMPARE(fixture.position(), divided + 1);
        QVERIFY(fixture.session().history().row(divided + 1).edit.is<core::PaintStroke>());
        QVERIFY(!fixture.chunks().isWorking() && !fixture.chunks().look().shown);
        QVERIFY(fixture.chunks().division()); // undo comes to it
        QVERIFY(!said.isEmpty());
        QVERIFY(said.last().first().toString().startsWith(QStringLiteral("The division stays")));
    }

    /// A preview that stands open comes to no step: the division goes once it has ended.
    void anAbortWaitsForAPreviewToEnd()
    {
        ChunkFixture fixture;
        const core::RowId before = fixture.position();
        fixture.chunks().divide(marginMm);
        QVERIFY(fixture.session().settle());
        const core::RowId divided = fixture.position();
        QVERIFY(divided != before && fixture.chunks().isWorking());
        QVERIFY(fixture.session().begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 2.0}));
        QVERIFY(fixture.session().openIsPreview());
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.find<QPushButton>("chunksAbort")->click();
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.position(), divided); // the preview is still being taken back
        fixture.settle();
        QCOMPARE(fixture.position(), before);
        QVERIFY(!fixture.chunks().isWorking() && !fixture.chunks().division());
        for (const QList<QVariant>& sentence : said)
            QVERIFY(!sentence.first().toString().startsWith(QStringLiteral("The division stays")));
    }

    /// The engine cannot read the box: it is said why, and Divide works once it can.
    void aDivisionThatFailsIsTakenBack()
    {
        reference::RefusingEngine engine;
        ChunkFixture fixture;
        fixture.workspace.setSession(
            *core::EditSession::create(engine, test::smallHead::volume(), {}));
        fixture.apply(ball());
        fixture.workspace.setActiveSegment(1);
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        const core::RowId before = fixture.position();
        auto* divide = fixture.find<QPushButton>("divide");
        const auto isWaiting = [&fixture] {
            return fixture.find<QProgressBar>("chunksProgress")->isVisibleTo(&fixture.panel);
        };
        divide->click();
        const auto told = [&] {
            fixture.session().poll(); // the row, then what became of it
            return failed.size() == 1;
        };
        QVERIFY(QTest::qWaitFor(told));
        QCOMPARE(failed.last().first().value<core::Error>().code, core::ErrorCode::OutOfMemory);
        QVERIFY(!fixture.chunks().isWorking() && !isWaiting());
        QTRY_COMPARE(fixture.position(), before);
        QVERIFY(!fixture.chunks().division() && !fixture.chunks().look().shown);
        QVERIFY(divide->isEnabled());

        QVERIFY(!fixture.session().settle()); // it returns that failure, too
        engine.refuses = false;
        divide->click();
        fixture.await();
        QVERIFY(fixture.chunks().areas() && !isWaiting());
        QCOMPARE(failed.size(), 1);
        // What a recipe, say, divided stays, though it is not shown.
        fixture.chunks().setLook({});
        fixture.apply(core::DivideSegment{.segment = 1, .marginMm = 4.0});
        engine.refuses = true;
        fixture.find<QCheckBox>("chunksShown")->setChecked(true);
        QVERIFY(!fixture.session().settle());
        QCOMPARE(failed.size(), 2);
        QVERIFY(!fixture.chunks().isWorking());
        QVERIFY(!fixture.find<QCheckBox>("chunksShown")->isChecked());
    }

    /// What it was to be made of is gone by the time it is its turn.
    void aSegmentThatLosesItsVoxelsIsNotDivided()
    {
        ChunkFixture fixture;
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QVERIFY(fixture.session().undo()); // the ball; it waits for the engine
        fixture.find<QPushButton>("divide")->click();
        static_cast<void>(fixture.session().settle());
        QCoreApplication::processEvents();
        QCOMPARE(failed.size(), 1);
        QVERIFY(!fixture.chunks().isWorking() && !fixture.chunks().division());
        QVERIFY(!fixture.find<QProgressBar>("chunksProgress")->isVisibleTo(&fixture.panel));
        QVERIFY(fixture.session().redo());
        fixture.settle();
        fixture.find<QPushButton>("divide")->click();
        fixture.settle();
        fixture.await();
    }

    void thePanelTellsHowFarItIs()
    {
        ChunkFixture fixture;
        fixture.chunks().divide(marginMm);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.chunks().isWorking());
        const auto* bar = fixture.find<QProgressBar>("chunksProgress");
        const auto* step = fixture.find<QLabel>("chunksStep");
        QVERIFY(bar->isVisibleTo(&fixture.panel) && step->isVisibleTo(&fixture.panel));
        QVERIFY(bar->maximum() == 100 && bar->minimum() == 0);
        QVERIFY2(step->text().endsWith(QStringLiteral(" %")), qPrintable(step->text()));
        // The panel asks while it waits, the map is not taken in meanwhile.
        QTRY_VERIFY(bar->value() >= 65);
        QVERIFY2(!step->text().contains(QStringLiteral("Fetching")), qPrintable(step->text()));
        fixture.await();
        QVERIFY(!bar->isVisibleTo(&fixture.panel));
    }

    void aClickOnASliceIsTheEditOfARecipe_data() { test::addMouseAndPen(); }
    void aClickOnASliceIsTheEditOfARecipe()
    {
        QFETCH(const test::DrawnBy, by);
        ChunkFixture fixture;
        fixture.divide(few);
        const std::int64_t before = fixture.voxels();
        const QPointF place = fixture.at(fixture.slice, inBone).toPoint();
        const glm::dvec3 lps = fixture.slice.context().toLps(place);
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const core::ChunkToggle expected{.segment = 1,
            .chunks = few,
            .pointsLps = {geometry.toWorld(glm::round(geometry.toIndex(lps)))}};
        fixture.click(by, fixture.slice, inBone);
        const core::ChunkToggle* click = fixture.lastClick();
        QVERIFY(click);
        core::ChunkToggle without = *click;
        without.bricks.reset();
        QCOMPARE(canonical(without), canonical(expected));
        QVERIFY(fixture.voxels() > before + 500);

        // The same edits without a window.
        test::WorkspaceFixture other;
        for (const core::Edit& edit : std::vector<core::Edit>{
                 ball(), core::DivideSegment{.segment = 1, .marginMm = marginMm}, expected})
            other.apply(edit);
        QCOMPARE(other.session().stateHash(), fixture.session().stateHash());

        // Once more, and it goes.
        fixture.click(by, fixture.slice, inBone);
        QCOMPARE(fixture.voxels(), before);
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(4));
    }

    void undoAndRedoShowWhoHasWhat()
    {
        ChunkFixture fixture;
        fixture.divide(few);
        const std::uint32_t strong = fixture.strength(inVentricle);
        const std::uint32_t weak = fixture.strength(inBone);
        QVERIFY(strong > weak && weak > 0);
        fixture.click(fixture.slice, inBone);
        fixture.tool.leave();
        QCOMPARE(fixture.strength(inBone), strong);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.strength(inBone), weak);
        QVERIFY(fixture.session().redo());
        fixture.settle();
        QCOMPARE(fixture.strength(inBone), strong);
        // Without the division there is nothing to show.
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(!fixture.chunks().areas());
        QVERIFY(fixture.session().redo());
        fixture.settle();
        fixture.await();
        QCOMPARE(fixture.strength(inBone), weak);
    }

    void theThirdDimensionTakesTheFirstThatIsSeen()
    {
        ChunkFixture fixture;
        fixture.divide(few);
        // From the left side of the patient, +x: all there is before the middle of the head.
        const auto pickedAt = [&] {
            fixture.click(fixture.view, inVentricle);
            return fixture.lastClick() ? fixture.lastClick()->pointsLps.front()
                                       : glm::dvec3(1000.0);
        };
        const glm::dvec3 whole = pickedAt();
        const core::VoxelBox& box = fixture.chunks().map()->box();
        const double face =
            fixture.workspace.volume()->geometry.toWorld(glm::dvec3(box.maximum - 1)).x;
        QCOMPARE(whole.x, face); // the box's first voxel
        // What lies before the plane is not there.
        core::ClipRegion clip = fixture.workspace.clip();
        clip.planes[0] = {.pointLps = {3.6, 0.0, 0.0}, .normalLps = {1.0, 0.0, 0.0}, .on = true};
        fixture.workspace.setClip(clip);
        QCoreApplication::processEvents();
        const glm::dvec3 clipped = pickedAt();
        QVERIFY2(std::abs(clipped.x - 3.5) < 0.6, qPrintable(QString::number(clipped.x)));
        // Nor are chunks that are not drawn: only the segment's are.
        clip.planes[0].on = false;
        fixture.workspace.setClip(clip);
        fixture.find<QComboBox>("chunkBodies")->setCurrentIndex(0);
        Q_EMIT fixture.find<QComboBox>("chunkBodies")->activated(0);
        QCOMPARE(fixture.chunks().look().bodies, ui::Chunks::Bodies::Own);
        QVERIFY(fixture.session().goTo(2));
        fixture.settle();
        fixture.await();
        // So are those that are likely wrong, so at a number at which the outermost is neither.
        const auto isDrawn = [&](const glm::ivec3& voxel) {
            const ui::Chunks& chunks = fixture.chunks();
            const auto chunk = chunks.chunkAt(voxel);
            return chunk
                && (chunks.has(*chunk)
                    || std::any_of(chunks.likely().begin(), chunks.likely().end(),
                        [&](const ui::Chunks::Likely& likely) { return likely.chunk == *chunk; }));
        };
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        glm::ivec3 first(glm::round(geometry.toIndex(inVentricle)));
        first.x = box.maximum.x - 1;
        ui::Chunks::Look look = fixture.chunks().look();
        while (isDrawn(first) && look.count < 100) {
            ++look.count;
            fixture.chunks().setLook(look);
            fixture.settle();
        }
        QVERIFY(!isDrawn(first));
        while (!isDrawn(first) && first.x > box.minimum.x)
            --first.x;
        const glm::dvec3 own = pickedAt();
        QVERIFY2(std::abs(own.x - geometry.toWorld(glm::dvec3(first)).x) < 1.0,
            qPrintable(QString::number(own.x)));
    }

    void chunksAreTakenWhereSegmentsAloneAreShown_data() { test::addMouseAndPen(); }
    void chunksAreTakenWhereSegmentsAloneAreShown()
    {
        QFETCH(const test::DrawnBy, by);
        ChunkFixture fixture;
        fixture.divide(few);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = gpu::Context::Hidden;
        fixture.workspace.setVolumeDisplay(display);
        QCoreApplication::processEvents();
        const std::int64_t before = fixture.voxels();
        const std::size_t rows = fixture.rows();
        fixture.click(by, fixture.view, inVentricle);
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastClick());
        QVERIFY(fixture.voxels() != before);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.voxels(), before);
    }

    void ctrlAndTheEraserOnlyTake()
    {
        ChunkFixture fixture;
        fixture.divide(few);
        const core::RowId before = fixture.position();
        fixture.click(fixture.slice, inBone, Qt::ControlModifier);
        QCOMPARE(fixture.position(), before); // it has none of it
        fixture.click(fixture.slice, inVentricle, Qt::ControlModifier);
        QVERIFY(fixture.lastClick() && fixture.lastClick()->mode == Mode::Remove);
        QVERIFY(fixture.position() != before);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        test::Pen pen(fixture.slice, test::Pen::End::Eraser);
        pen.press(fixture.at(fixture.slice, inVentricle), 1.0, 70000);
        pen.release(fixture.at(fixture.slice, inVentricle), 70020);
        fixture.settle();
        QVERIFY(fixture.lastClick() && fixture.lastClick()->mode == Mode::Remove);
    }

    void aDragTakesManyInOneStep()
    {
        ChunkFixture fixture;
        fixture.divide(300);
        const core::RowId before = fixture.position();
        const std::int64_t voxels = fixture.voxels();
        const glm::dvec3 from(11.5, -9.0, 0.0);
        const glm::dvec3 to(11.5, 9.0, 0.0);
        QVERIFY(!fixture.chunks().has(fixture.chunkAt(from)));
        const auto draw = [&](bool lift) {
            test::Pen pen(fixture.slice);
            quint64 time = 70000;
            pen.press(fixture.at(fixture.slice, from), 1.0, time);
            pen.move(fixture.at(fixture.slice, to), 1.0, time += 20);
            pen.move(fixture.at(fixture.slice, from), 1.0, time += 20); // over the same again
            if (lift)
                pen.release(fixture.at(fixture.slice, from), time + 20);
        };
        draw(true);
        fixture.settle();
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(before + 1));
        const core::ChunkToggle* drag = fixture.lastClick();
        QVERIFY(drag && drag->mode == Mode::Add);
        QVERIFY(drag->pointsLps.size() > 2);
        std::vector<ui::Chunks::Chunk> met;
        for (const glm::dvec3& point : drag->pointsLps)
            met.push_back(fixture.chunkAt(point));
        std::sort(met.begin(), met.end());
        QVERIFY(std::adjacent_find(met.begin(), met.end()) == met.end()); // each once
        for (const ui::Chunks::Chunk chunk : met)
            QVERIFY(fixture.chunks().has(chunk));
        QVERIFY(fixture.voxels() > voxels);

        // Taken back while the pen is down: nothing was done.
        const core::RowId after = fixture.position();
        const QByteArray hash = fixture.session().stateHash();
        draw(false);
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        fixture.settle();
        QCOMPARE(fixture.position(), after);
        QCOMPARE(fixture.session().stateHash(), hash);
    }

    void thePointedOneIsLitAndNamed()
    {
        ChunkFixture fixture;
        fixture.divide(few);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::uint32_t weak = fixture.strength(inBone);
        test::Pen pen(fixture.slice);
        pen.hover(fixture.at(fixture.slice, inBone), 70000);
        QVERIFY(fixture.strength(inBone) > weak);
        // Slices are as urgent as the 3D view, which else would be drawn before them.
        for (const gpu::ViewId view : {fixture.slice.viewId(), fixture.view.viewId()})
            QVERIFY(fixture.frames.lastRequest(view).interacting);
        QVERIFY(!said.isEmpty());
        const QString text = said.last().first().toString();
        const core::Volume& in = *fixture.workspace.volume();
        const std::int64_t voxels = fixture.chunks().voxels(fixture.chunkAt(inBone));
        const double volume = double(voxels) * in.geometry.voxelVolumeMm3() / 1000.0;
        QVERIFY(volume > 1.0 && volume < 50.0);
        QVERIFY2(text.contains(QLocale().toString(volume, 'f', 1) + QStringLiteral(" mL")),
            qPrintable(text));
        fixture.tool.leave();
        QCOMPARE(fixture.strength(inBone), weak);
        // Finer and coarser by key.
        const int count = fixture.chunks().look().count;
        fixture.tool.changeRadius(-1);
        QVERIFY(fixture.chunks().look().count > count);
        fixture.tool.changeRadius(1);
        QCOMPARE(fixture.chunks().look().count, count);
    }
};

BURIN_WINDOW_TEST(ChunkToolUiTest)

} // namespace chunkToolUiTest

#include "ChunkToolUiTest.moc"
