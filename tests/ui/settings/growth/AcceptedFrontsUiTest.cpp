// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/AcceptedFronts.h"

#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/session/StepFindings.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/panels/LeakyPanel.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/LeakSection.h"
#include "ui/tasks/growth/LiveInterval.h"
#include "ui/workspace/PendingSeeds.h"

#include <QAbstractButton>
#include <QLabel>
#include <QtTest>

#include <cmath>
#include <functional>

namespace acceptedFrontsUiTest {

using test::leakyVessel;

namespace {

/// The growth through the hole in the vessel's wall has raised an alarm, which was accepted, and
/// has gone on to its end.
class AcceptedLeak : public test::LeakyPanel {
public:
    AcceptedLeak()
    {
        click("growPlay");
        const auto alarm = session().findings().leakAlarm();
        if (!alarm)
            qFatal("no alarm");
        raisedMm2 = std::ceil(2.0 * double(alarm->areaUm2) / 1.0e6);
        asked = *alarm;
        click("leakAccept");
        if (offered())
            qFatal("it asks for a leak again");
    }
    /// By how much a front must be wider for the next growth to ask.
    [[nodiscard]] double nextMm2() const { return panel.growEdit().guard.areaMm2; }
    [[nodiscard]] double setMm2() const { return workspace.growSettings().guardAreaMm2; }
    [[nodiscard]] bool isTold() { return part<QLabel>("leakRaised").isVisible(); }
    /// Raises an alarm at the end of what has grown.
    void alarm(std::int64_t areaUm2)
    {
        const std::uint32_t generation = session().document().generation(0);
        panel.findChild<ui::LeakSection*>()->showAlarm(core::LeakAlarm{.generation = generation,
            .narrow = generation - 1,
            .voxels = 300,
            .areaUm2 = areaUm2,
            .voxel = leakyVessel().seed});
    }

    core::LeakAlarm asked;
    double raisedMm2 = 0.0; ///< that the next front must be wider by
};

using Doing = std::function<void(AcceptedLeak&)>;

} // namespace

class AcceptedFrontsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Who has said that a front is no leak is not asked about the next one that is like it.
    void growthAsksLater()
    {
        AcceptedLeak fixture;
        const core::History& history = fixture.session().history();
        const auto* grown = history.row(history.position()).edit.as<core::GrowSteps>();
        QVERIFY(grown);
        QCOMPARE(grown->guard.areaMm2, fixture.raisedMm2);
        QCOMPARE(grown->guard.factor.value_or(0.0), 2.0);
        QCOMPARE(grown->guard.backMm, core::GrowGuard().backMm);
        QVERIFY(fixture.raisedMm2 > 2.0 * fixture.setMm2());
        QCOMPARE(fixture.setMm2(), 60.0); // the field stays as the user has set it
        QCOMPARE(fixture.nextMm2(), fixture.raisedMm2);
        QVERIFY(fixture.isTold());
        const QString told = fixture.part<QLabel>("leakRaised").text();
        QVERIFY2(told.contains(QString::number(fixture.raisedMm2) + QStringLiteral(" mm²")),
            qPrintable(told));
    }

    void itEnds_data()
    {
        QTest::addColumn<Doing>("by");
        QTest::newRow("the link") << Doing([](AcceptedLeak& leak) {
            Q_EMIT leak.part<QLabel>("leakRaised").linkActivated(QStringLiteral("ask"));
        });
        QTest::newRow("undo") << Doing([](AcceptedLeak& leak) {
            QVERIFY(leak.session().undo());
            leak.settle();
            QCOMPARE(leak.session().document().generation(0), leak.asked.generation);
        });
        QTest::newRow("to the seeds")
            << Doing([](AcceptedLeak& leak) { leak.click("growToSeeds"); });
        QTest::newRow("shrunk as far") << Doing([](AcceptedLeak& leak) {
            const std::uint32_t now = leak.session().document().generation(0);
            leak.apply(core::ShrinkSteps{.steps = int(now - leak.asked.generation)});
        });
        QTest::newRow("shrink here") << Doing([](AcceptedLeak& leak) {
            leak.apply(core::ShrinkAt{.pointsLps = {leak.placeOf(leakyVessel().click)}});
        });
        QTest::newRow("a sketch") << Doing([](AcceptedLeak& leak) {
            leak.apply(test::seedAt(1, {leak.placeOf({2, 2, 2})}));
        });
        QTest::newRow("a rejection") << Doing([](AcceptedLeak& leak) {
            leak.alarm(300'000'000);
            leak.click("leakReject");
            QVERIFY(leak.session().document().generation(0) > leak.asked.generation);
        });
        QTest::newRow("the area") << Doing([](AcceptedLeak& leak) {
            ui::GrowSettings settings = leak.workspace.growSettings();
            settings.guardAreaMm2 = 61.0;
            leak.workspace.setGrowSettings(settings);
        });
        QTest::newRow("the factor") << Doing([](AcceptedLeak& leak) {
            ui::GrowSettings settings = leak.workspace.growSettings();
            settings.guard.value = 2.1;
            leak.workspace.setGrowSettings(settings);
        });
        QTest::newRow("off and on") << Doing([](AcceptedLeak& leak) {
            leak.part<QAbstractButton>("growGuard").click();
            QVERIFY(!leak.panel.growEdit().guard.factor);
            QVERIFY(!leak.isTold());
            leak.part<QAbstractButton>("growGuard").click();
        });
    }
    void itEnds()
    {
        QFETCH(Doing, by);
        AcceptedLeak fixture;
        QCOMPARE(fixture.nextMm2(), fixture.raisedMm2);
        by(fixture);
        QCOMPARE(fixture.nextMm2(), fixture.setMm2());
        QVERIFY(!fixture.isTold());
        if (fixture.session().history().canRedo()) {
            QVERIFY(fixture.session().redo());
            fixture.settle();
            QCOMPARE(fixture.nextMm2(), fixture.setMm2());
        }
    }

    void othersAreNotMeant()
    {
        AcceptedLeak fixture;
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.overwriteUnlocked = true;
        fixture.workspace.setGrowSettings(settings);
        fixture.click("growShrink");
        QCOMPARE(fixture.nextMm2(), fixture.raisedMm2);
        fixture.apply(test::newSegment(QStringLiteral("Other"), 1));
        fixture.apply(test::seedAt(2, {fixture.placeOf({2, 2, 2})}));
        fixture.workspace.setActiveSegment(2);
        settings.lower = leakyVessel().lowCode - 100.0;
        settings.upper = leakyVessel().lowCode - 50.0;
        fixture.workspace.setGrowSettings(settings);
        QCOMPARE(fixture.nextMm2(), fixture.setMm2());
        QVERIFY(!fixture.isTold());
    }

    /// It admits what nobody has seen.
    void anotherIntervalIsAskedAbout()
    {
        AcceptedLeak fixture;
        ui::LiveInterval interval(fixture.workspace);
        interval.move(leakyVessel().lowCode - 1.0, leakyVessel().highCode);
        interval.settle();
        fixture.settle();
        const core::History& history = fixture.session().history();
        const auto* change = history.row(history.position()).edit.as<core::ChangeInterval>();
        QVERIFY(change);
        QCOMPARE(change->guard.areaMm2, fixture.setMm2());
    }

    /// Segments that grow together ask as soon as one of them has to.
    void togetherTheLeastCounts()
    {
        AcceptedLeak fixture;
        ui::AcceptedFronts& fronts = fixture.workspace.seeds().acceptedFronts();
        QCOMPARE(fronts.areaMm2({1}), fixture.raisedMm2);
        QCOMPARE(fronts.areaMm2({1, 2}), 0.0);
        QCOMPARE(fronts.areaMm2({}), 0.0);
        const core::LeakAlarm narrow{.generation = 9, .narrow = 8, .areaUm2 = 40'500'000};
        fronts.accept(narrow, 0, {1, 2}, fixture.session());
        QCOMPARE(fronts.areaMm2({2}), 81.0);
        QCOMPARE(fronts.areaMm2({1, 2}), 81.0);
        QCOMPARE(fronts.areaMm2({1}), fixture.raisedMm2);
        fronts.forget({1});
        QCOMPARE(fronts.areaMm2({1}), 0.0);
        QCOMPARE(fronts.areaMm2({2}), 81.0);
    }

    void whoWasSketchedSinceTheAlarmIsNotMeant()
    {
        AcceptedLeak fixture;
        ui::AcceptedFronts& fronts = fixture.workspace.seeds().acceptedFronts();
        fixture.click("growShrink"); // something is left to grow
        fronts.clear();
        fixture.apply(test::newSegment(QStringLiteral("Other"), 1));
        fixture.apply(test::seedAt(2, {fixture.placeOf({2, 2, 2})}));
        fixture.alarm(300'000'000);
        fixture.click("leakAccept");
        QCOMPARE(fronts.areaMm2({1}), 600.0);
        QCOMPARE(fronts.areaMm2({2}), 0.0);
    }

    /// In a large volume it takes a moment until what has grown is a row.
    void anAnswerBeforeTheRowCounts()
    {
        AcceptedLeak fixture;
        fixture.click("growShrink");
        ui::AcceptedFronts& fronts = fixture.workspace.seeds().acceptedFronts();
        fronts.clear();
        core::GrowSteps edit = fixture.panel.growEdit();
        edit.steps = 1;
        edit.guard.factor.reset();
        const std::uint32_t before = fixture.session().document().generation(0);
        QVERIFY(fixture.session().apply(edit));
        QVERIFY(!fixture.session().idle());
        const core::LeakAlarm alarm{
            .generation = before + 1, .narrow = before, .areaUm2 = 40'500'000};
        fronts.accept(alarm, 0, {1}, fixture.session());
        fixture.settle();
        QCOMPARE(fixture.session().document().generation(0), alarm.generation);
        QCOMPARE(fronts.areaMm2({1}), 81.0);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fronts.areaMm2({1}), 0.0);
    }

    /// A recipe of before may have counted voxels, which are no area.
    void voxelsRaiseNothing()
    {
        AcceptedLeak fixture;
        fixture.workspace.seeds().acceptedFronts().clear();
        fixture.alarm(0);
        fixture.click("leakAccept");
        QVERIFY(fixture.workspace.seeds().acceptedFronts().isEmpty());
        QCOMPARE(fixture.nextMm2(), fixture.setMm2());
    }

    void anotherStudyIsAskedAbout()
    {
        reference::ReferenceEngine other;
        AcceptedLeak fixture;
        auto session = core::EditSession::create(other, test::loadedVolume(leakyVessel()), {});
        QVERIFY(session);
        fixture.workspace.setSession(std::move(*session));
        QVERIFY(fixture.workspace.seeds().acceptedFronts().isEmpty());
        QVERIFY(!fixture.isTold());
    }
};

BURIN_WINDOW_TEST(AcceptedFrontsUiTest)

} // namespace acceptedFrontsUiTest

#include "AcceptedFrontsUiTest.moc"
