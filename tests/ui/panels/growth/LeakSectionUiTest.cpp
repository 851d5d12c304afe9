// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/LeakSection.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/growth/GrowthProgress.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/panels/LeakyPanel.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GenerationBar.h"
#include "ui/tasks/growth/LiveInterval.h"
#include "ui/workspace/PendingSeeds.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QLabel>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QtTest>

#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace leakSectionUiTest {

using test::LeakyPanel;
using test::leakyVessel;
using test::WorkspaceFixture;

namespace {

/// The oracle, which tells of a growth until what has grown is handed out, as an engine does that
/// is still fetching it.
class LateEngine final : public reference::PassingEngine {
public:
    core::Ticket submit(core::EngineCommand command) override
    {
        if (std::holds_alternative<core::EndEdit>(command))
            m_ending = PassingEngine::growthProgress();
        return PassingEngine::submit(std::move(command));
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        m_ending.reset();
        return PassingEngine::collect();
    }
    [[nodiscard]] core::GrowthProgress growthProgress() const override
    {
        return m_ending ? *m_ending : PassingEngine::growthProgress();
    }

private:
    std::optional<core::GrowthProgress> m_ending;
};

} // namespace

class LeakSectionUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// In a panel that is scrolled away the question would be overlooked: growth would seem to have
    /// ended by itself.
    void theQuestionIsSeenWhereverThePanelStands()
    {
        LeakyPanel leaky;
        QScrollArea column;
        const auto parted = qScopeGuard([&column] { column.takeWidget()->setParent(nullptr); });
        column.setWidgetResizable(true);
        column.resize(leaky.panel.width(), 220);
        column.setWidget(&leaky.panel);
        column.show();
        QVERIFY(QTest::qWaitForWindowExposed(&column));
        QString said;
        connect(&leaky.workspace, &ui::Workspace::said, this,
            [&said](const QString& sentence) { said = sentence; });
        const auto isSeen = [&](const char* name) {
            auto& part = leaky.part<QWidget>(name);
            return part.isVisible()
                && part.visibleRegion().boundingRect() == QRect(QPoint(0, 0), part.size());
        };
        column.verticalScrollBar()->setValue(0);
        leaky.click("growPlay");
        QVERIFY(leaky.offered());
        QTRY_VERIFY(isSeen("leakText") && isSeen("leakPlug"));
        QVERIFY2(said.endsWith(QLatin1String("in the panel Growth")), qPrintable(said));
    }

    /// How much wider a leak is stands with what stops at leaks, not with the barriers.
    void bothWidthsStandTogether()
    {
        LeakyPanel leaky;
        const QRect times = leaky.part<QDoubleSpinBox>("growGuardFactor").geometry();
        const QRect by = leaky.part<QDoubleSpinBox>("growGuardArea").geometry();
        const QRect guard = leaky.part<QCheckBox>("growGuard").geometry();
        const QRect barriers = leaky.part<QCheckBox>("growBarriers").geometry();
        QVERIFY(by.top() == times.top() && by.left() > times.right());
        QVERIFY(guard.bottom() < times.top() && barriers.bottom() < times.top());
    }

    void barriersAreShownOrNot()
    {
        LeakyPanel fixture;
        auto& shown = fixture.part<QCheckBox>("growBarriers");
        QVERIFY(shown.isChecked() && fixture.workspace.segmentDisplay().showBarriers);
        QTest::mouseClick(&shown, Qt::LeftButton, {}, {10, shown.height() / 2});
        QVERIFY(!fixture.workspace.segmentDisplay().showBarriers);
        fixture.workspace.setViewOptions({});
        QVERIFY(shown.isChecked() && fixture.workspace.segmentDisplay().showBarriers);
    }

    void theGuardIsASetting()
    {
        WorkspaceFixture fixture;
        ui::LeakSection section(fixture.workspace);
        auto& guard = *section.findChild<QCheckBox*>(QStringLiteral("growGuard"));
        auto& factor = *section.findChild<QDoubleSpinBox*>(QStringLiteral("growGuardFactor"));
        auto& area = *section.findChild<QDoubleSpinBox*>(QStringLiteral("growGuardArea"));
        // A growth is watched unless the user says that it is not to be.
        QVERIFY(guard.isChecked() && factor.isEnabled());
        QCOMPARE(ui::growthOf(fixture.workspace.growSettings()).guard.factor.value_or(0.0), 2.0);
        guard.click();
        QVERIFY(!factor.isEnabled() && !area.isEnabled());
        QVERIFY(!ui::growthOf(fixture.workspace.growSettings()).guard.factor);
        guard.click();
        factor.setValue(3.5);
        QCOMPARE(ui::growthOf(fixture.workspace.growSettings()).guard.factor.value_or(0.0), 3.5);
        QCOMPARE(ui::growthOf(fixture.workspace.growSettings()).guard.areaMm2, 60.0);
        area.setValue(7.5);
        QCOMPARE(ui::growthOf(fixture.workspace.growSettings()).guard.areaMm2, 7.5);

        // The session keeps it, and what another window kept is shown.
        const QByteArray kept =
            QJsonDocument(ui::growSettingsJson(fixture.workspace.growSettings())).toJson();
        ui::GrowSettings settings;
        settings.guard.on = false;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY(!guard.isChecked());
        QCOMPARE(factor.value(), 2.0);
        QCOMPARE(area.value(), 60.0);
        ui::readGrowSettings(QJsonDocument::fromJson(kept).object(), settings);
        fixture.workspace.setGrowSettings(settings);
        QVERIFY(guard.isChecked());
        QCOMPARE(factor.value(), 3.5);
        QCOMPARE(area.value(), 7.5);
        // A factor that would alarm at everything is none.
        const QJsonObject odd{{QStringLiteral("guard"),
            QJsonObject{{QStringLiteral("on"), true}, {QStringLiteral("value"), 0.5}}}};
        ui::readGrowSettings(odd, settings);
        QCOMPARE(settings.guard.value, ui::leastGuard);
    }

    void anAlarmStopsAndOffers()
    {
        LeakyPanel fixture;
        QVERIFY(!fixture.offered());
        const std::size_t rows = fixture.rows();
        fixture.click("growPlay");
        QVERIFY(fixture.offered());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastEdit().is<core::GrowSteps>());
        QVERIFY(fixture.leaked() > 0);
        QVERIFY(fixture.leaked() * 50 < leakyVessel().leakVoxels);
        auto& text = fixture.part<QLabel>("leakText");
        QVERIFY2(
            text.text().contains(QString::number(fixture.generation())), qPrintable(text.text()));

        // The generation bar marks it, from the narrow place on.
        const auto& marked = fixture.panel.findChild<ui::GenerationBar*>()->leak();
        QVERIFY(marked);
        QVERIFY(marked->first < marked->second);
        QCOMPARE(marked->second, int(fixture.generation()));

        // The crosshair goes to the front that burst.
        Q_EMIT text.linkActivated(QStringLiteral("show"));
        const glm::dvec3 index =
            fixture.workspace.volume()->geometry.toIndex(fixture.workspace.crosshairLps());
        const glm::ivec3 voxel(glm::round(index));
        QVERIFY(leakyVessel().leak.at(voxel) != 0);
        const auto labels = *fixture.session().questions().labels(0);
        const glm::ivec3 size = leakyVessel().leak.size;
        QCOMPARE(int(labels[std::size_t(voxel.x + size.x * (voxel.y + size.y * voxel.z))]), 1);
    }

    /// Widened, a growth leaks as well as any.
    void aChangeOfIntervalIsGuardedToo()
    {
        LeakyPanel fixture;
        core::GrowSteps begun = ui::growthOf(fixture.workspace.growSettings());
        begun.steps = 2;
        begun.guard = {};
        fixture.apply(begun);
        QVERIFY(!fixture.offered());
        ui::LiveInterval interval(fixture.workspace);
        interval.move(leakyVessel().lowCode - 1.0, leakyVessel().highCode);
        interval.settle();
        fixture.settle();
        QVERIFY(fixture.lastEdit().is<core::ChangeInterval>());
        QVERIFY(fixture.offered());
        QVERIFY(fixture.leaked() * 50 < leakyVessel().leakVoxels);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(!fixture.offered());
    }

    void plugShutsAndGrowsOn()
    {
        LeakyPanel fixture;
        fixture.click("growPlay");
        QVERIFY(fixture.offered());
        const std::size_t rows = fixture.rows();
        const QByteArray stopped = fixture.session().stateHash();
        fixture.click("leakPlug");
        // The plug is a step, and what grew elsewhere since another.
        QCOMPARE(fixture.rows(), rows + 2);
        const core::History& history = fixture.session().history();
        QVERIFY(history.row(core::RowId(rows + 1)).edit.is<core::PlugLeak>());
        QVERIFY(fixture.lastEdit().is<core::GrowSteps>());
        QVERIFY(!fixture.offered());
        QCOMPARE(fixture.leaked(), std::int64_t(0));
        const std::int64_t grown = fixture.session().document().segments[0].voxels;
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), stopped);
        QVERIFY(grown > fixture.session().document().segments[0].voxels);
    }

    void rejectGoesBackToTheNarrowPlace()
    {
        LeakyPanel fixture;
        fixture.click("growPlay");
        const std::size_t rows = fixture.rows();
        const std::uint32_t alarmed = fixture.generation();
        const auto& marked = fixture.panel.findChild<ui::GenerationBar*>()->leak();
        QVERIFY(marked);
        const auto narrow = std::uint32_t(marked->first);
        const QByteArray stopped = fixture.session().stateHash();
        fixture.click("leakReject");
        QVERIFY(!fixture.offered());
        QVERIFY(!fixture.panel.findChild<ui::GenerationBar*>()->leak());
        QCOMPARE(fixture.rows(), rows + 1);
        const auto* shrink = fixture.lastEdit().as<core::ShrinkSteps>();
        QVERIFY(shrink && shrink->steps);
        QVERIFY(*shrink->steps > 0);
        QCOMPARE(fixture.generation(), alarmed - std::uint32_t(*shrink->steps));
        QCOMPARE(fixture.generation(), narrow);
        QVERIFY(fixture.leaked() * 500 < leakyVessel().leakVoxels); // the neck's mouth
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), stopped);
        QVERIFY(!fixture.offered()); // it was decided on
    }

    void acceptGrowsOn()
    {
        LeakyPanel fixture;
        fixture.click("growPlay");
        const std::size_t rows = fixture.rows();
        const QByteArray stopped = fixture.session().stateHash();
        const std::int64_t leaked = fixture.leaked();
        fixture.click("leakAccept");
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastEdit().is<core::GrowSteps>());
        QVERIFY(fixture.leaked() > leaked);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), stopped);
    }

    /// In a large volume it takes a moment until what has grown is a row.
    void anAnswerBeforeTheRowCountsOnce()
    {
        LateEngine engine;
        LeakyPanel fixture;
        auto session = core::EditSession::create(engine, test::loadedVolume(leakyVessel()), {});
        QVERIFY(session);
        fixture.workspace.setSession(std::move(*session));
        fixture.seed();
        const std::size_t rows = fixture.rows();
        QTest::mouseClick(&fixture.part<QAbstractButton>("growPlay"), Qt::LeftButton);
        const auto asks = [&fixture] {
            if (!fixture.offered())
                fixture.session().poll();
            return fixture.offered();
        };
        QVERIFY(QTest::qWaitFor(asks, 60000));
        QVERIFY(!fixture.session().idle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().document().segments[0].voxels, std::int64_t(0));

        QTest::mouseClick(&fixture.part<QAbstractButton>("leakAccept"), Qt::LeftButton);
        const double acceptedMm2 = fixture.workspace.seeds().acceptedFronts().areaMm2({1});
        QVERIFY(acceptedMm2 > fixture.workspace.growSettings().guardAreaMm2);
        // It is looked several times how far the next growth is, which waits in line.
        QTest::qWait(200);
        QVERIFY(fixture.panel.running() && !fixture.offered());
        const auto isRow = [&] {
            fixture.session().poll();
            return fixture.rows() > rows;
        };
        QVERIFY(QTest::qWaitFor(isRow, 60000));
        QVERIFY(!fixture.offered());
        fixture.stopped();
        QVERIFY(!fixture.offered());
        QCOMPARE(fixture.rows(), rows + 2);
        const auto* grown = fixture.lastEdit().as<core::GrowSteps>();
        QVERIFY(grown);
        QCOMPARE(grown->guard.areaMm2, acceptedMm2);
    }

    /// What was resumed goes on as it was, whatever the panel says by now.
    void whatWasResumedIsResumed_data()
    {
        QTest::addColumn<QByteArray>("by");
        QTest::newRow("accept") << QByteArray("leakAccept");
        QTest::newRow("plug") << QByteArray("leakPlug");
    }
    void whatWasResumedIsResumed()
    {
        QFETCH(QByteArray, by);
        LeakyPanel fixture;
        core::GrowSteps begun = ui::growthOf(fixture.workspace.growSettings());
        begun.steps = 2;
        fixture.apply(begun);
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.overwriteUnlocked = true;
        fixture.workspace.setGrowSettings(settings);
        fixture.click("growResume");
        QVERIFY(fixture.offered());
        const std::size_t rows = fixture.rows();
        fixture.click(by.constData());
        QVERIFY(fixture.rows() > rows);
        const auto* grown = fixture.lastEdit().as<core::GrowSteps>();
        QVERIFY(grown && !grown->criteria.overwriteUnlocked);
        QCOMPARE(grown->guard.areaMm2 > settings.guardAreaMm2, by == "leakAccept");
    }

    /// The turns of the growth whose leak was rejected are not those of the next one.
    void aRejectedGrowthDoesNotGoOnInAnothersPlace()
    {
        LeakyPanel fixture; // the vessel comes first, as its interval lies within the other one
        fixture.apply(test::newSegment(QStringLiteral("Other"), 1));
        fixture.apply(test::seedAt(2, {fixture.placeOf({2, 2, 2})}));
        fixture.workspace.setActiveSegment(2);
        ui::GrowSettings settings = fixture.workspace.growSettings();
        const double width = leakyVessel().highCode - leakyVessel().lowCode;
        settings.lower = leakyVessel().lowCode - 1.5 * width;
        settings.upper = leakyVessel().highCode + 1.5 * width;
        fixture.workspace.setGrowSettings(settings);
        const auto segmentsOf = [](const core::GrowSteps* growth) {
            return growth ? growth->criteria.segments.value_or(std::vector<int>())
                          : std::vector<int>();
        };
        fixture.click("growPlay");
        QVERIFY(fixture.offered());
        QCOMPARE(segmentsOf(fixture.lastEdit().as<core::GrowSteps>()), std::vector<int>{1});
        fixture.click("leakReject");
        QVERIFY(fixture.lastEdit().is<core::ShrinkSteps>());
        auto* section = fixture.panel.findChild<ui::LeakSection*>();
        Q_EMIT section->goOnRequested(0); // an alarm of the active segment was accepted
        const core::Edit* open = fixture.session().openEdit();
        QVERIFY(open);
        QCOMPARE(segmentsOf(open->as<core::GrowSteps>()), std::vector<int>{2});
        fixture.click("growPlay"); // pause: it has far to go
    }

    void theOfferGoesWithTheGrowth_data()
    {
        QTest::addColumn<QByteArray>("by");
        QTest::newRow("undo") << QByteArray();
        QTest::newRow("shrink") << QByteArray("growShrink");
        QTest::newRow("grow on") << QByteArray("growStep");
    }
    void theOfferGoesWithTheGrowth()
    {
        QFETCH(QByteArray, by);
        LeakyPanel fixture;
        fixture.click("growPlay");
        QVERIFY(fixture.offered());
        if (by.isEmpty()) {
            QVERIFY(fixture.session().undo());
            fixture.settle();
        } else {
            fixture.click(by.constData());
        }
        QVERIFY(!fixture.offered());
    }

    /// Else it would go to whatever comes next in the panel, and keys with it.
    void theFocusStays()
    {
        LeakyPanel fixture;
        fixture.panel.activateWindow();
        fixture.click("growPlay");
        fixture.part<QAbstractButton>("leakReject").setFocus();
        fixture.click("leakReject");
        QCOMPARE(fixture.panel.focusWidget(), &fixture.part<QCheckBox>("growGuard"));
    }
};

BURIN_WINDOW_TEST(LeakSectionUiTest)

} // namespace leakSectionUiTest

#include "LeakSectionUiTest.moc"
