// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/views/ViewGrid.h"

#include <QSignalSpy>
#include <QtTest>

#include <cmath>
#include <utility>
#include <vector>

namespace peelEndsUiTest {

namespace {

/// The oracle, but one that cannot end what is open while it is told so.
class StuckEngine final : public reference::PassingEngine {
public:
    bool fails = false;

    core::Ticket submit(core::EngineCommand command) override
    {
        const bool isFailed = fails && std::holds_alternative<core::EndEdit>(command);
        if (isFailed)
            command = core::EndEdit{core::Ending::Rollback};
        const core::Ticket ticket = PassingEngine::submit(std::move(command));
        if (isFailed)
            m_failed.push_back(ticket);
        return ticket;
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        std::vector<core::EngineResult> results = PassingEngine::collect();
        for (core::EngineResult& result : results) {
            if (std::erase(m_failed, result.ticket) > 0)
                result.error =
                    core::Error{core::ErrorCode::OutOfMemory, {QStringLiteral("no room to end")}};
        }
        return results;
    }

private:
    std::vector<core::Ticket> m_failed;
};

/// The real window with the small head, whose bone the 3D view sees from the front.
class PeelFixture : public test::WindowFixture {
public:
    PeelFixture()
        : test::WindowFixture(test::smallHead::volume())
        , peel(workspace)
        , view(window.views().volume())
        , said(&workspace, &ui::Workspace::said)
        , failed(&workspace, &ui::Workspace::failed)
    {
        showBone();
    }
    void showBone()
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&peel);
        peel.setDepthMm(4.0);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    /// A ring, so far to the right of the middle; from 20 mm on there is only air.
    void draw(double radiusMm, double besideMm)
    {
        const double perMm = 1.0 / view.context().mmPerPixel();
        const QPointF middle =
            QPointF(view.width(), view.height()) / 2.0 + QPointF(besideMm * perMm, 0.0);
        std::vector<QPointF> way;
        for (int i = 0; i < 39; ++i) {
            const double t = 2.0 * M_PI * i / 40.0;
            way.push_back(middle + radiusMm * perMm * QPointF(std::cos(t), std::sin(t)));
        }
        test::drawStroke(test::DrawnBy::Pen, view, way);
    }
    [[nodiscard]] QString last() const { return said.back().front().toString(); }
    [[nodiscard]] bool wasSaid(const QString& sentence) const
    {
        for (const QList<QVariant>& each : said) {
            if (each.front().toString() == sentence)
                return true;
        }
        return false;
    }

    ui::PeelTool peel;
    ui::VolumeView& view;
    QSignalSpy said;
    QSignalSpy failed;
};

const QString nothing = QStringLiteral("Nothing was peeled there");

} // namespace

/// What the user hears of a peel that ends.
class PeelEndsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Then there is no row either, but what was wrong is told already.
    void whatFailsIsNotCalledNothing()
    {
        StuckEngine engine;
        PeelFixture fixture;
        fixture.workspace.setSession(
            *core::EditSession::create(engine, test::smallHead::volume(), {}));
        fixture.showBone();
        fixture.draw(8.0, 0.0);
        QVERIFY(fixture.peel.isOpen());
        fixture.session().poll();
        engine.fails = true;
        fixture.peel.confirm();
        QVERIFY(!fixture.session().settle());
        engine.fails = false;
        QCOMPARE(fixture.failed.size(), 1);
        QCOMPARE(fixture.rows(), std::size_t(0));
        QTest::qWait(20);
        QVERIFY(!fixture.wasSaid(nothing));
        // The next one is told of as before.
        fixture.draw(3.0, 21.0);
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(fixture.last(), nothing);
    }

    /// A peel over the air that another step has ended.
    void whatAnotherStepEndsIsToldOf()
    {
        PeelFixture fixture;
        fixture.draw(3.0, 21.0);
        QVERIFY(fixture.peel.isOpen());
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        QVERIFY(!fixture.peel.isOpen());
        QTRY_COMPARE((fixture.session().poll(), fixture.last()), nothing);
        QCOMPARE(fixture.rows(), std::size_t(1));
        // One that becomes a row is told of as that.
        fixture.draw(8.0, 0.0);
        QVERIFY(fixture.peel.isOpen());
        fixture.apply(test::newSegment(QStringLiteral("Other")));
        QTRY_VERIFY((fixture.session().poll(), fixture.last().contains(QStringLiteral("kept"))));
        QCOMPARE(fixture.rows(), std::size_t(3));
        QTest::qWait(20);
        QVERIFY(fixture.last() != nothing);
    }
};

BURIN_WINDOW_TEST(PeelEndsUiTest)

} // namespace peelEndsUiTest

#include "PeelEndsUiTest.moc"
