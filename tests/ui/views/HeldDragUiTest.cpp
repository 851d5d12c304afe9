// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <utility>

namespace heldDragUiTest {

/// Drags that outlast their study: its pictures stay while another point in time is opened.
class HeldDragUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aButtonThatGoesUpMeanwhileEndsIt()
    {
        test::WindowFixture fixture(test::smallStudy());
        ui::VolumeView& view = fixture.window.views().volume();
        QTRY_VERIFY(!view.picture().isNull());
        const QPointF from = QRectF(view.rect()).center();
        const QPointF to = from + QPointF(20.0, 0.0);
        const glm::dvec3 towardsViewer = view.camera().towardsViewer;
        fixture.mouse(view, QEvent::MouseButtonPress, from);
        fixture.mouse(view, QEvent::MouseMove, to);
        QVERIFY(view.camera().towardsViewer != towardsViewer);
        fixture.window.views().holdPictures(QStringLiteral("Opening point 2 of 3"));
        fixture.workspace.setSession(nullptr);
        QVERIFY(view.isVisible() && view.holdsPicture());
        fixture.mouse(view, QEvent::MouseButtonRelease, to);

        auto next = core::EditSession::create(fixture.engine, test::smallStudy(), {});
        QVERIFY(next);
        fixture.workspace.setSession(std::move(*next));
        const glm::dvec3 now = view.camera().towardsViewer;
        fixture.hover(view, to + QPointF(40.0, 0.0));
        QVERIFY(view.camera().towardsViewer == now);
    }
};

BURIN_WINDOW_TEST(HeldDragUiTest)

} // namespace heldDragUiTest

#include "HeldDragUiTest.moc"
