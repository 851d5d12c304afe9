// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/FloodFillTool.h"

#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/SegmentWork.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/filling/FloodFill.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/ViewGrid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace floodFillToolUiTest {

namespace {

using Labels = std::vector<std::uint8_t>;

/// The real window with the small head, whose middle voxel (20, 20, 20) has the crosshair: there
/// is the ventricle (8 HU), around it the brain (40 HU).
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , views(window.views())
    {
        workspace.setCrosshairLps(place({20.0, 20.0, 20.0}));
        workspace.setActiveTool(&tool);
        tool.setSettings({.in3D = false, .corners = false, .tolerance = 10.0});
    }
    [[nodiscard]] const core::FloodFill& lastEdit()
    {
        return session().history().rows().back().edit.get<core::FloodFill>();
    }
    [[nodiscard]] Labels labels() { return *session().questions().labels(0); }
    /// What an edit gives to segment 1 of a study without labels.
    [[nodiscard]] static Labels filledBy(const core::FloodFill& edit)
    {
        const core::LoadedVolume head = test::smallHead::volume();
        const Labels none(head.codes.size(), 0);
        const std::vector<bool> found = reference::floodedVoxels(edit, head, none);
        Labels filled(found.size(), 0);
        for (std::size_t voxel = 0; voxel < found.size(); ++voxel)
            filled[voxel] = found[voxel] ? 1 : 0;
        return filled;
    }
    void click(ui::ImageView& view, const glm::dvec3& index, bool pen,
        test::Pen::End end = test::Pen::End::Tip, Qt::KeyboardModifiers modifiers = {})
    {
        const QPointF at = pixel(view, index);
        if (pen) {
            test::Pen stylus(view, end);
            stylus.hover(at, m_milliseconds += 8);
            stylus.press(at, 0.4, m_milliseconds += 8);
            stylus.release(at, m_milliseconds += 8);
        } else {
            WindowFixture::click(view, at, modifiers);
        }
    }

    ui::FloodFillTool tool;
    ui::ViewGrid& views;

private:
    quint64 m_milliseconds = 50000;
};

} // namespace

class FloodFillToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// In each of the slices, with mouse and pen: the ventricle of that slice, as one step after
    /// the segment's.
    void aClickFillsInTheSlice_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<bool>("pen");
        for (const bool pen : {false, true}) {
            QTest::addRow("sagittal, %s", pen ? "pen" : "mouse") << 0 << pen;
            QTest::addRow("coronal, %s", pen ? "pen" : "mouse") << 1 << pen;
            QTest::addRow("axial, %s", pen ? "pen" : "mouse") << 2 << pen;
        }
    }
    void aClickFillsInTheSlice()
    {
        QFETCH(const int, axis);
        QFETCH(const bool, pen);
        Fixture fixture;
        const std::array<ui::SliceView*, 3> views{
            &fixture.views.sagittal(), &fixture.views.coronal(), &fixture.views.axial()};
        glm::dvec3 at(21.0, 19.0, 21.0);
        at[axis] = 20.0;
        fixture.click(*views.at(std::size_t(axis)), at, pen);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2)); // a segment for it, and the fill
        const core::FloodFill& edit = fixture.lastEdit();
        QVERIFY(edit.within == core::SliceAxis(axis));
        QVERIFY(!edit.erase && !edit.corners && !edit.overwriteUnlocked);
        QCOMPARE(edit.tolerance, 10.0);
        QVERIFY2(fixture.session().history().rows().back().name.startsWith(
                     QStringLiteral("Flood fill 'Segment 1' in a slice, +")),
            qPrintable(fixture.session().history().rows().back().name));
        const Labels filled = fixture.labels();
        QVERIFY(filled == Fixture::filledBy(edit));
        QVERIFY(std::count(filled.begin(), filled.end(), 1) > 50); // a disc of 5 mm
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        const Labels before = fixture.labels();
        QCOMPARE(std::count(before.begin(), before.end(), 1), std::ptrdiff_t(0));
    }

    /// In 3D it fills all of the ventricle, and with a greater tolerance the brain around it.
    void aClickFillsIn3D()
    {
        Fixture fixture;
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 10.0});
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QVERIFY(!fixture.lastEdit().within);
        QCOMPARE(fixture.session().document().segment(1)->voxels,
            test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        fixture.tool.changeRadius(1);
        QCOMPARE(fixture.tool.settings().tolerance, 11.0);
        fixture.tool.setSettings({.in3D = true, .corners = true, .tolerance = 40.0});
        fixture.click(fixture.views.coronal(), {20.0, 20.0, 20.0}, true);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 2);
        QVERIFY(fixture.lastEdit().corners);
        QCOMPARE(fixture.session().document().segment(1)->voxels,
            test::smallHead::voxelsOf(test::smallHead::ventricleHu)
                + test::smallHead::voxelsOf(test::smallHead::brainHu));
        QCOMPARE(said.back().front().toString(),
            fixture.session().history().rows().back().name
                + QStringLiteral("; Ctrl+Z takes it back"));
        // All of that is the segment's: nothing is left to be given.
        const std::size_t rows = fixture.rows();
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 3);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("Nothing there can be given to 'Segment 1'"));
        QCOMPARE(fixture.rows(), rows);
    }

    /// What hangs together of the segment goes, in the slice or as a whole, whatever its values.
    void controlAndTheEraserEndTakeAway()
    {
        Fixture fixture;
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 40.0});
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().settle());
        const Labels brain = fixture.labels();
        fixture.tool.setSettings({.in3D = false, .corners = false, .tolerance = 10.0});
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, true, test::Pen::End::Eraser);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().erase);
        Labels expected = brain;
        const std::size_t slice = std::size_t(40) * 40;
        std::fill_n(expected.begin() + std::ptrdiff_t(20 * slice), slice, std::uint8_t(0));
        QVERIFY(expected != brain);
        QVERIFY(fixture.labels() == expected);
        // The slice was all that joined the halves: one of them goes.
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 0.0});
        fixture.workspace.setCrosshairLps(fixture.place({20.0, 20.0, 25.0}));
        fixture.click(fixture.views.axial(), {20.0, 20.0, 25.0}, false, test::Pen::End::Tip,
            Qt::ControlModifier);
        QVERIFY(fixture.session().settle());
        std::fill(expected.begin() + std::ptrdiff_t(20 * slice), expected.end(), std::uint8_t(0));
        QVERIFY(fixture.labels() == expected);
        QVERIFY(std::count(expected.begin(), expected.end(), 1) > 1000);
    }

    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false, test::Pen::End::Tip,
            Qt::ControlModifier);
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.back().front().toString(), QStringLiteral("There is no segment to erase"));
        fixture.click(fixture.views.axial(), {20.0, 60.0, 20.0}, false);
        QCOMPARE(said.size(), 2);
        QCOMPARE(said.back().front().toString(), QStringLiteral("Click inside the volume"));
        QCOMPARE(fixture.rows(), std::size_t(0));
        QCOMPARE(fixture.tool.target(), QStringLiteral("fills a new segment"));

        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Organ"))));
        QVERIFY(fixture.session().apply(test::lockSegment(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        QCOMPARE(fixture.tool.target(), QStringLiteral("Organ is locked"));
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.tool.worksIn(fixture.views.sagittal().context()));
        QVERIFY(!fixture.tool.worksIn(fixture.views.volume().context()));
    }

    /// Of an oblique slice it fills the voxels in it, and in 3D it goes on from there.
    void anObliqueSliceIsFilled()
    {
        Fixture fixture;
        ui::ViewContext oblique = fixture.views.axial().context();
        auto& scene = std::get<gpu::SliceScene>(oblique.scene);
        scene.downLps = glm::normalize(scene.downLps + glm::dvec3(0.0, 0.0, 0.3));
        const glm::dvec3 normal = glm::normalize(glm::cross(scene.rightLps, scene.downLps));
        QVERIFY(fixture.tool.worksIn(oblique));
        ui::PointerSample sample;
        sample.position = oblique.toPixel(fixture.place({20.0, 20.0, 20.0}));
        fixture.tool.press(sample, oblique);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2)); // a segment for it, and the fill
        const core::FloodFill inSlice = fixture.lastEdit();
        QVERIFY(!inSlice.within && inSlice.normalLps);
        QVERIFY(std::abs(std::abs(glm::dot(*inSlice.normalLps, normal)) - 1.0) < 1e-4);
        const Labels filled = fixture.labels();
        QVERIFY(filled == Fixture::filledBy(inSlice));
        QVERIFY(std::count(filled.begin(), filled.end(), 1) > 40);

        sample.modifiers = Qt::ControlModifier;
        fixture.tool.press(sample, oblique);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().erase && fixture.lastEdit().normalLps);
        const Labels erased = fixture.labels();
        QCOMPARE(std::count(erased.begin(), erased.end(), 1), std::ptrdiff_t(0));

        sample.modifiers = {};
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 10.0});
        fixture.tool.press(sample, oblique);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.lastEdit().within && !fixture.lastEdit().normalLps);
        QCOMPARE(fixture.labels(), Fixture::filledBy(fixture.lastEdit()));
    }

    /// The standard planes lie oblique to the voxels of a tilted acquisition; planes along its
    /// voxels hold one slice of them, and the fill stays in that.
    void ofATiltedAcquisitionItFillsTheSliceThatIsShown()
    {
        test::WindowFixture fixture(test::oblique());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        ui::FloodFillTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        tool.setSettings({.in3D = false, .corners = false, .tolerance = 10.0});
        const glm::dvec3 middle(32.0, 24.0, 20.0);
        fixture.workspace.setCrosshairLps(fixture.place(middle));
        ui::ImageView& axial = fixture.window.views().axial();
        test::WindowFixture::click(axial, fixture.pixel(axial, middle));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2)); // a segment for it, and the fill
        const auto lastEdit = [&fixture] {
            return fixture.session().history().rows().back().edit.get<core::FloodFill>();
        };
        QVERIFY(!lastEdit().within && lastEdit().normalLps);
        // Codes grow with the column: the fill takes 21 columns, one voxel of each in each row.
        const std::set<std::array<int, 3>> shown = fixture.voxels();
        QCOMPARE(shown.size(), std::size_t(21) * std::size_t(geometry.size.y));
        const glm::dmat3 steps(geometry.indexToWorld);
        for (const auto& [x, y, z] : shown) {
            QVERIFY(std::abs(x - 32) <= 10);
            const glm::dvec3 away = fixture.place(glm::dvec3(x, y, z)) - lastEdit().placeLps;
            QVERIFY(std::abs(away.z) <= std::abs(steps[2].z) / 2.0 + 0.01);
        }
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.voxels().empty());

        ui::ViewContext acquired = axial.context();
        auto& scene = std::get<gpu::SliceScene>(acquired.scene);
        scene.centreLps = fixture.place(middle);
        scene.rightLps = geometry.direction()[0];
        scene.downLps = geometry.direction()[1];
        ui::PointerSample sample;
        sample.position = acquired.toPixel(fixture.place(middle));
        tool.press(sample, acquired);
        QVERIFY(fixture.session().settle());
        QVERIFY(lastEdit().within == core::SliceAxis::K);
        // Codes grow with the column: the fill takes 21 columns of one slice.
        const std::set<std::array<int, 3>> filled = fixture.voxels();
        QCOMPARE(filled.size(), std::size_t(21) * std::size_t(geometry.size.y));
        for (const std::array<int, 3>& voxel : filled)
            QCOMPARE(voxel[2], 20);
        fixture.workspace.setActiveTool(nullptr);
    }

    /// What a dialog previews is no reason to wait, and Esc is not about it.
    void aPreviewHoldsNothingUp()
    {
        Fixture fixture;
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 10.0});
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.apply(test::paintAt(1, {fixture.place({20.0, 20.0, 20.0})}, 2.0));
        fixture.workspace.setActiveSegment(1);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        // It is worked on as long as nobody polls.
        QVERIFY(fixture.session().begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 3.0}));
        QVERIFY(fixture.session().segmentWork().percent() && fixture.session().openIsPreview());
        fixture.tool.cancel();
        QVERIFY(fixture.session().segmentWork().percent() && fixture.session().openIsPreview());
        const std::size_t rows = fixture.rows();
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.labels() == Fixture::filledBy(fixture.lastEdit()));
        for (const QList<QVariant>& each : said)
            QVERIFY2(!each.front().toString().contains(QStringLiteral("worked out")),
                qPrintable(each.front().toString()));
    }

    /// Esc abandons what is being worked out.
    void escapeAbandons()
    {
        Fixture fixture;
        fixture.tool.setSettings({.in3D = true, .corners = false, .tolerance = 40.0});
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Organ"))));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().segmentWork().percent());
        fixture.tool.cancel();
        const core::Result<void> settled = fixture.session().settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == core::ErrorCode::Cancelled);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.rows(), std::size_t(1));
    }

    /// The option bar shows the settings and changes them; over others is the choice of Paint.
    void optionsAreSettings()
    {
        Fixture fixture;
        QWidget parent;
        QWidget* options = fixture.tool.createOptions(&parent);
        auto* reach = options->findChild<QComboBox*>(QStringLiteral("floodReach"));
        auto* tolerance = options->findChild<QDoubleSpinBox*>(QStringLiteral("floodTolerance"));
        auto* corners = options->findChild<QCheckBox*>(QStringLiteral("floodCorners"));
        auto* overwrite = options->findChild<QCheckBox*>(QStringLiteral("floodOverwrite"));
        QVERIFY(reach && tolerance && corners && overwrite);
        QCOMPARE(reach->currentText(), QStringLiteral("in the slice"));
        QCOMPARE(tolerance->value(), 10.0);
        QCOMPARE(tolerance->suffix(), QStringLiteral(" HU"));
        fixture.tool.setSettings({.in3D = true, .corners = true, .tolerance = 33.0});
        QCOMPARE(reach->currentText(), QStringLiteral("in 3D"));
        QCOMPARE(tolerance->value(), 33.0);
        QVERIFY(corners->isChecked());
        tolerance->setValue(70.0);
        QCOMPARE(fixture.tool.settings().tolerance, 70.0);
        QVERIFY(fixture.tool.settings().in3D && fixture.tool.settings().corners);
        corners->click();
        QVERIFY(!fixture.tool.settings().corners);
        overwrite->click();
        QVERIFY(fixture.workspace.brushSettings(ui::Workspace::Brush::Paint).overwriteUnlocked);
        fixture.click(fixture.views.axial(), {20.0, 20.0, 20.0}, false);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().overwriteUnlocked);
        // What a session kept comes back; what makes no sense does not.
        const QJsonObject kept = fixture.tool.settingsJson();
        fixture.tool.setSettings({});
        fixture.tool.applySettings(kept);
        QCOMPARE(fixture.tool.settings().tolerance, 70.0);
        QVERIFY(fixture.tool.settings().in3D);
        fixture.tool.applySettings({{QStringLiteral("tolerance"), -3.0}});
        QCOMPARE(fixture.tool.settings().tolerance, 70.0);
    }
};

BURIN_WINDOW_TEST(FloodFillToolUiTest)

} // namespace floodFillToolUiTest

#include "FloodFillToolUiTest.moc"
