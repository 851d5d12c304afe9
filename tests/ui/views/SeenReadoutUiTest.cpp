// SPDX-License-Identifier: Apache-2.0
#include "ui/views/SeenReadout.h"

#include "core/document/Piece.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/session/SessionDisplay.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/StatusLine.h"

#include <QtTest>

namespace seenReadoutUiTest {

namespace {

class ReadoutFixture : public test::WindowFixture {
public:
    ReadoutFixture()
        : test::WindowFixture(test::smallHead::volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        view().lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] ui::VolumeView& view() { return window.views().volume(); }
    /// Straight to the view: what the display's own pointer does is none of its business.
    void point(const QPointF& fromMiddle)
    {
        const QPointF at = QPointF(view().width(), view().height()) / 2.0 + fromMiddle;
        QMouseEvent move(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(&view(), &move);
    }
    void hover(const QPointF& fromMiddle)
    {
        point(fromMiddle);
        settle();
    }
    void settle()
    {
        // Pieces take questions of their own.
        for (int round = 0; round < 5; ++round) {
            if (!workspace.session()->settle())
                qFatal("not settled");
            workspace.session()->poll();
        }
    }
    [[nodiscard]] std::optional<double> distanceMm() const
    {
        const auto& lps = workspace.pointedLps();
        return lps ? std::optional(glm::length(*lps)) : std::nullopt;
    }
};

} // namespace

/// The status line over the 3D view: what is seen under the pointer.
class SeenReadoutUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void tellsTheVoxelThatIsSeen()
    {
        ReadoutFixture fixture;
        QVERIFY(!fixture.workspace.pointedLps());
        fixture.hover({4.0, 2.0});
        QVERIFY(fixture.distanceMm());
        QVERIFY(std::abs(*fixture.distanceMm() - 16.0) < 1.6); // bone's outer face
        QVERIFY(fixture.workspace.pointedLps()->y < 0.0);
        fixture.settle();
        const auto* status = fixture.window.findChild<ui::StatusLine*>();
        QVERIFY(status);
        QVERIFY2(
            status->readout().contains(QStringLiteral("900 HU")), qPrintable(status->readout()));
    }

    void nothingSeenIsTheCrosshairAgain()
    {
        ReadoutFixture fixture;
        fixture.hover({0.0, 0.0});
        QVERIFY(fixture.workspace.pointedLps());
        // The corner shows air.
        fixture.hover({12.0 - fixture.view().width() / 2.0, fixture.view().height() / 2.0 - 12.0});
        QVERIFY(!fixture.workspace.pointedLps());
    }

    void aLateAnswerIsDroppedOnceThePointerHasLeft()
    {
        ReadoutFixture fixture;
        fixture.point({0.0, 0.0});
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&fixture.view(), &leave);
        fixture.settle();
        QVERIFY(!fixture.workspace.pointedLps());
    }

    /// Where segments alone are shown they are what is pointed at, not the skull around them.
    void aloneSegmentsAreSeen()
    {
        ReadoutFixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        QVERIFY(session.apply(test::ballMask(glm::ivec3(test::smallHead::side), 6.0)));
        QVERIFY(session.settle());
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = gpu::Context::Hidden;
        for (const gpu::RenderMode mode : {gpu::RenderMode::Surface, gpu::RenderMode::Mip}) {
            display.mode = mode;
            fixture.workspace.setVolumeDisplay(display);
            fixture.hover({0.0, 0.0});
            QVERIFY(fixture.distanceMm());
            const int label = session.document().segments.front().label;
            const glm::dvec3 index =
                fixture.workspace.volume()->geometry.toIndex(*fixture.workspace.pointedLps());
            const glm::dvec3 middle = 0.5 * glm::dvec3(test::smallHead::side - 1);
            QVERIFY(std::abs(glm::distance(index, middle) - 6.0) < 1.5);
            QCOMPARE(label, 1);
            // Nothing is seen where there is tissue alone, nor of a segment that is hidden.
            fixture.hover({0.0, -1.4 * 9.0 / fixture.view().context().mmPerPixel()});
            QVERIFY(!fixture.workspace.pointedLps());
            session.display().setSegmentVisible(label, false);
            fixture.hover({0.0, 0.0});
            QVERIFY(!fixture.workspace.pointedLps());
            session.display().setSegmentVisible(label, true);
        }
    }

    /// Where the volume steps back for a segment, the segment is pointed at, and the skull beside.
    void segmentsAreSeenThroughWhatStepsBack_data()
    {
        QTest::addColumn<gpu::Context>("context");
        QTest::newRow("cut away") << gpu::Context::CutAway;
        QTest::newRow("translucent") << gpu::Context::Translucent;
    }
    void segmentsAreSeenThroughWhatStepsBack()
    {
        QFETCH(const gpu::Context, context);
        ReadoutFixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        QVERIFY(session.apply(test::ballMask(glm::ivec3(test::smallHead::side), 6.0)));
        QVERIFY(session.settle());
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.context = context;
        display.contextOpacity = 0.25;
        for (const gpu::RenderMode mode : {gpu::RenderMode::Surface, gpu::RenderMode::Mip}) {
            display.mode = mode;
            fixture.workspace.setVolumeDisplay(display);
            fixture.hover({0.0, 0.0});
            QVERIFY(fixture.distanceMm());
            QVERIFY2(
                *fixture.distanceMm() < 8.0, qPrintable(QString::number(*fixture.distanceMm())));
            fixture.hover({0.0, -1.4 * 9.0 / fixture.view().context().mmPerPixel()});
            QVERIFY(fixture.distanceMm());
            QVERIFY2(
                *fixture.distanceMm() > 12.5, qPrintable(QString::number(*fixture.distanceMm())));
            // A segment that is hidden is none.
            session.display().setSegmentVisible(1, false);
            fixture.hover({0.0, 0.0});
            QVERIFY(fixture.distanceMm() && *fixture.distanceMm() > 12.5);
            session.display().setSegmentVisible(1, true);
        }
    }

    /// Wherever a piece is shown, what is pointed at on it means its true place.
    void onAPieceItIsTheTruePlace()
    {
        ReadoutFixture fixture;
        const core::OrthographicView view{
            .eyeLps = {0, -200, 0}, .targetLps = {0, 0, 0}, .up = {0, 0, 1}, .heightMm = 80};
        const core::Edit lid = test::drillWith({.view = view,
            .radiusMm = 8.0,
            .depthMm = 6.0,
            .surfaceThreshold = 300.0,
            .samples = std::vector<core::PenSample>{{0.0, 0.0, 1.0, 0.0}}});
        core::EditSession& session = *fixture.workspace.session();
        QVERIFY(session.apply(lid));
        QVERIFY(session.settle());
        QVERIFY(session.apply(core::CutPiece{.layer = 1, .name = QStringLiteral("Lid")}));
        QVERIFY(session.settle());
        const glm::dvec3 away(0.0, -60.0, 0.0); // towards the viewer
        QVERIFY(session.apply(core::ChangePiece{.piece = 1, .offsetMm = away}));
        QVERIFY(session.settle());
        fixture.hover({0.0, 0.0});
        QVERIFY(fixture.distanceMm());
        QVERIFY2(std::abs(*fixture.distanceMm() - 16.0) < 1.6,
            qPrintable(QString::number(*fixture.distanceMm())));
    }
};

BURIN_WINDOW_TEST(SeenReadoutUiTest)

} // namespace seenReadoutUiTest

#include "SeenReadoutUiTest.moc"
