// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/overlays/Readout.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/ViewSteps.h"

#include <QAction>
#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QMouseEvent>
#include <QtTest>

namespace overlappingSegmentsUiTest {

namespace {

using Labels = std::vector<std::uint8_t>;

constexpr int liver = 1;
constexpr int tumour = 2;
constexpr glm::ivec3 inBoth(20, 18, 17); // the middle of the study
constexpr glm::ivec3 inLiver(7, 7, 17);
constexpr glm::ivec3 inNone(34, 32, 17);

/// A liver, and a tumour within it that has its voxels, too, as one file brought them.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::smallStudy())
        , paint(workspace)
    {
        const core::Edit mask =
            test::maskImport(QStringLiteral("organs.seg.nrrd"), workspace.volume()->geometry.size,
                {{QStringLiteral("Liver"), box({4, 4, 6}, {30, 30, 26}), 0x805030},
                    {QStringLiteral("Tumour"), box({14, 12, 10}, {26, 24, 24}), 0xF0E050}},
                {0, 1});
        if (!session().apply(mask) || !session().settle())
            qFatal("the mask is not taken in");
        workspace.setCrosshairLps(placeOf(inBoth));
        workspace.setActiveSegment(liver);
    }
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    [[nodiscard]] ui::SliceView& axial() { return window.views().axial(); }
    [[nodiscard]] glm::dvec3 placeOf(const glm::ivec3& voxel) const
    {
        return workspace.volume()->geometry.toWorld(glm::dvec3(voxel));
    }
    [[nodiscard]] QPoint pixelOf(const glm::ivec3& voxel)
    {
        return axial().context().toPixel(placeOf(voxel)).toPoint();
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    [[nodiscard]] Labels labels(std::uint8_t plane)
    {
        reference::DenseFields fields = engine.fields();
        return fields.labels(plane).values;
    }
    void settle()
    {
        for (int round = 0; round < 5; ++round) {
            if (!session().settle())
                qFatal("not settled");
            session().poll();
        }
    }
    void takeUnderPointer(ui::ImageView& view, const QPointF& at)
    {
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(&view, &move);
        window.actionTable()[QStringLiteral("segments.underPointer")].trigger();
        settle();
    }
    /// Null if none opens.
    [[nodiscard]] QMenu* menuAt(const glm::ivec3& voxel)
    {
        QTest::mouseClick(&axial(), Qt::RightButton, {}, pixelOf(voxel));
        settle();
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }

    ui::PaintTool paint;

private:
    [[nodiscard]] core::VoxelRuns box(const glm::ivec3& from, const glm::ivec3& to) const
    {
        const glm::ivec3 size = workspace.volume()->geometry.size;
        core::VoxelRuns runs;
        for (int z = from.z; z < to.z; ++z) {
            for (int y = from.y; y < to.y; ++y)
                runs.append(std::uint64_t((z * size.y + y) * size.x + from.x),
                    std::uint64_t(to.x - from.x));
        }
        return runs;
    }
};

} // namespace

/// Segments that share voxels: both are named, meant in their turn, and edited each in its plane.
class OverlappingSegmentsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theReadoutNamesAll()
    {
        Fixture fixture;
        const ui::Readout readout(fixture.workspace);
        // The crosshair stands in both already.
        for (const auto& [voxel, names] : {std::pair(inLiver, " · Liver"),
                 std::pair(inBoth, " · Liver, Tumour"), std::pair(inLiver, " · Liver")}) {
            fixture.workspace.setCrosshairLps(fixture.placeOf(voxel));
            fixture.settle();
            QVERIFY2(readout.text().endsWith(QString::fromUtf8(names)), qPrintable(readout.text()));
        }
        fixture.workspace.setCrosshairLps(fixture.placeOf(inNone));
        fixture.settle();
        QVERIFY(!readout.text().contains(QStringLiteral("Liver")));
    }

    void theListTellsTheOneAbove()
    {
        Fixture fixture;
        fixture.window.addPanel(new ui::SegmentsPanel(fixture.workspace));
        const auto* list = fixture.window.findChild<QListView*>(QStringLiteral("segmentList"));
        QVERIFY(list);
        QCOMPARE(list->model()->rowCount(), 2);
        const auto tip = [list](int row) {
            return list->model()->index(row, 0).data(Qt::ToolTipRole).toString();
        };
        QVERIFY(!tip(0).contains(QStringLiteral("overlaps")));
        QVERIFY(tip(1).contains(QStringLiteral("overlaps others: plane 2")));
    }

    /// What the menus say of carving a segment is what the session says.
    void noneIsCarvedBesideAProtectedOneOfAnotherPlane()
    {
        Fixture fixture;
        core::EditSession& session = fixture.session();
        for (const int label : {liver, tumour}) {
            for (const bool outside : {false, true})
                QCOMPARE(ui::whyNotCarved(session.document(), label, outside), QString());
        }
        QVERIFY(session.apply(test::protectSegment(liver)));
        fixture.settle();
        for (const bool outside : {false, true}) {
            const QString why = ui::whyNotCarved(session.document(), tumour, outside);
            QVERIFY2(why.startsWith(QStringLiteral("'Liver' is protected")), qPrintable(why));
            QVERIFY(why.contains(QStringLiteral("another label plane")));
            const auto refused = session.apply(core::SegmentToLayer{.segment = tumour,
                .layer = 1,
                .outside = outside ? std::optional(true) : std::nullopt});
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, core::ErrorCode::SegmentProtected);
        }
        QCOMPARE(ui::whyNotCarved(session.document(), liver),
            QStringLiteral("'Liver' is protected from sculpting"));
        // All but it may go: the others of its plane, and what nobody has.
        QCOMPARE(ui::whyNotCarved(session.document(), liver, true), QString());
        QVERIFY(session.apply(
            core::SegmentToLayer{.segment = liver, .layer = 1, .outside = std::optional(true)}));
        fixture.settle();
        // One of a further plane is protected like those of the first.
        QVERIFY(session.apply(test::protectSegment(tumour)));
        fixture.settle();
        QCOMPARE(ui::whyNotCarved(session.document(), tumour),
            QStringLiteral("'Tumour' is protected from sculpting"));
    }

    /// One after the other becomes active where they overlap; what is hidden is passed by.
    void aKeyGoesFromOneToTheOther()
    {
        Fixture fixture;
        const QPointF at = fixture.pixelOf(inBoth);
        for (const int expected : {tumour, liver, tumour}) {
            fixture.takeUnderPointer(fixture.axial(), at);
            QCOMPARE(fixture.workspace.activeSegment(), expected);
        }
        fixture.takeUnderPointer(fixture.axial(), fixture.pixelOf(inLiver));
        QCOMPARE(fixture.workspace.activeSegment(), liver);
        fixture.workspace.viewSteps().showAlone(liver);
        fixture.settle();
        fixture.takeUnderPointer(fixture.axial(), at);
        QCOMPARE(fixture.workspace.activeSegment(), liver);
    }

    /// A ray meets the segments of all planes that are shown.
    void the3dViewMeetsTheOneAbove()
    {
        Fixture fixture;
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = gpu::Context::Hidden;
        fixture.workspace.setVolumeDisplay(display);
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.workspace.viewSteps().showAlone(tumour);
        fixture.settle();
        fixture.takeUnderPointer(view, QRectF(view.rect()).center());
        QCOMPARE(fixture.workspace.activeSegment(), tumour);
        fixture.workspace.viewSteps().showAlone(liver);
        fixture.settle();
        fixture.takeUnderPointer(view, QRectF(view.rect()).center());
        QCOMPARE(fixture.workspace.activeSegment(), liver);
    }

    void aMenuIsAboutTheActiveOne()
    {
        Fixture fixture;
        QMenu* menu = fixture.menuAt(inBoth);
        QVERIFY(menu);
        QCOMPARE(menu->actions().front()->text(), QStringLiteral("Remove this island of 'Liver'"));
        const QList<QAction*> others =
            menu->findChildren<QAction*>(QStringLiteral("activateOther"));
        QCOMPARE(others.size(), 1);
        QCOMPARE(others.front()->text(), QStringLiteral("Make 'Tumour' active"));
        others.front()->trigger();
        menu->close();
        QCOMPARE(fixture.workspace.activeSegment(), tumour);

        menu = fixture.menuAt(inBoth);
        QVERIFY(menu);
        QCOMPARE(menu->actions().front()->text(), QStringLiteral("Remove this island of 'Tumour'"));
        // Its voxels are the liver's already, in another plane.
        const auto* give = menu->findChild<QMenu*>(QStringLiteral("giveIsland"));
        QVERIFY(give);
        QCOMPARE(give->actions().size(), 1);
        QVERIFY(!give->actions().front()->isEnabled());
        QCOMPARE(give->actions().front()->toolTip(),
            QStringLiteral("'Liver' lies on another label plane"));
        const Labels before = fixture.labels(0);
        menu->actions().front()->trigger();
        menu->close();
        fixture.settle();
        QCOMPARE(fixture.voxels(tumour), std::int64_t(0));
        QCOMPARE(fixture.voxels(liver), std::int64_t(26 * 26 * 20));
        QVERIFY(fixture.labels(0) == before);
    }

    /// The menu merges it into the one below; what they cannot exchange says why.
    void theOneAboveIsMerged()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(tumour);
        QMenu& segments = fixture.window.segmentsMenu();
        segments.popup(fixture.window.mapToGlobal(QPoint(40, 40)));
        segments.close();
        const auto* swap = segments.findChild<QMenu*>(QStringLiteral("swapSegments"));
        const auto* merge = segments.findChild<QMenu*>(QStringLiteral("mergeSegments"));
        QVERIFY(swap && merge);
        QCOMPARE(swap->actions().size(), 1);
        QVERIFY(!swap->actions().front()->isEnabled());
        QCOMPARE(swap->actions().front()->toolTip(),
            QStringLiteral("'Liver' lies on another label plane"));
        QCOMPARE(merge->actions().size(), 1);
        QVERIFY(merge->actions().front()->isEnabled());
        // All of it is the liver's already.
        const Labels before = fixture.labels(0);
        merge->actions().front()->trigger();
        fixture.settle();
        QVERIFY(fixture.labels(0) == before);
        QCOMPARE(fixture.voxels(tumour), std::int64_t(0));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.voxels(tumour), std::int64_t(12 * 12 * 14));
    }

    /// What is painted or erased of one leaves the other as it is, even where both are.
    void theBrushLeavesTheOther()
    {
        Fixture fixture;
        fixture.workspace.setBrushSettings(
            ui::Workspace::Brush::Paint, {.radiusMm = 3.0, .disc = true});
        fixture.workspace.setActiveTool(&fixture.paint);
        const Labels liverBefore = fixture.labels(0);
        const Labels tumourBefore = fixture.labels(1);
        const std::int64_t all = fixture.voxels(liver);
        const std::int64_t part = fixture.voxels(tumour);
        QCOMPARE(part, std::int64_t(12 * 12 * 14));

        QTest::mouseClick(
            &fixture.axial(), Qt::LeftButton, Qt::ControlModifier, fixture.pixelOf(inBoth));
        fixture.settle();
        const std::int64_t erased = all - fixture.voxels(liver);
        QVERIFY(erased > 0);
        QVERIFY(fixture.labels(1) == tumourBefore);
        QCOMPARE(fixture.voxels(tumour), part);
        const Labels liverThen = fixture.labels(0);
        QVERIFY(liverThen != liverBefore);

        // Where the liver is, and where nothing is, in the tumour's plane.
        fixture.workspace.setActiveSegment(tumour);
        for (const glm::ivec3& place : {inLiver, inNone}) {
            const std::int64_t now = fixture.voxels(tumour);
            QTest::mouseClick(&fixture.axial(), Qt::LeftButton, {}, fixture.pixelOf(place));
            fixture.settle();
            QVERIFY(fixture.voxels(tumour) > now);
            QVERIFY(fixture.labels(0) == liverThen);
        }
        QCOMPARE(fixture.voxels(liver), all - erased);
        for (int step = 0; step < 3; ++step)
            QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.labels(0) == liverBefore);
        QVERIFY(fixture.labels(1) == tumourBefore);
    }
};

BURIN_WINDOW_TEST(OverlappingSegmentsUiTest)

} // namespace overlappingSegmentsUiTest

#include "OverlappingSegmentsUiTest.moc"
