// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/SeedInterval.h"

#include "core/document/Piece.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/settings/growth/SeedValues.h"
#include "ui/tasks/growth/SketchLook.h"
#include "ui/tools/aim/LookingDirection.h"
#include "ui/window/display/ToolSettings.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QJsonArray>
#include <QJsonObject>
#include <QSlider>
#include <QtTest>

namespace seedIntervalUiTest {

using test::WorkspaceFixture;
using Interval = ui::SegmentIntervals::Interval;

namespace {

/// A panel, and one segment with a seed in the ventricle whose interval was offered.
class Offered : public WorkspaceFixture {
public:
    Offered()
        : panel(workspace)
    {
        panel.show();
        addSketched();
    }
    void addSketched()
    {
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        apply(middleSeed(1));
        if (!waitFor([this] { return interval(1).has_value(); }))
            qFatal("no interval was offered");
    }
    /// A second segment, sketched in the brain.
    void addOther()
    {
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        apply(test::seedAt(2, {{8.0, 0.0, 0.0}}));
        if (!waitFor([this] { return interval(2).has_value(); }))
            qFatal("no interval was offered");
    }
    template <class Condition> [[nodiscard]] bool waitFor(Condition condition)
    {
        return QTest::qWaitFor([&] {
            settle();
            return condition();
        });
    }
    [[nodiscard]] std::optional<Interval> interval(int label) const
    {
        return workspace.seeds().intervals().of(label);
    }
    [[nodiscard]] bool holds(double value) const
    {
        const auto& settings = workspace.growSettings();
        return settings.lower <= value && value <= settings.upper;
    }
    void setByHand(double lower, double upper)
    {
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = lower;
        settings.upper = upper;
        workspace.setGrowSettings(settings);
    }
    ui::GrowthPanel panel;
};

} // namespace

class SeedIntervalUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A drag of the slider is one row, at release; several steps by keys are one, too.
    void theToleranceIsOneRow()
    {
        Offered fixture;
        QTest::mouseClick(
            fixture.panel.findChild<QAbstractButton*>(QStringLiteral("growToClosure")),
            Qt::LeftButton);
        QVERIFY(fixture.waitFor([&] { return !fixture.panel.running(); }));
        auto* slider = fixture.panel.findChild<QSlider*>(QStringLiteral("growTolerance"));
        const core::History& history = fixture.session().history();
        const core::RowId grown = history.position();
        const Interval before = *fixture.interval(1);
        slider->setSliderDown(true);
        for (const int place : {12, 15, 18, 20}) {
            slider->setSliderPosition(place);
            QTest::qWait(20);
            fixture.settle();
            QCOMPARE(history.position(), grown);
            QVERIFY(!fixture.session().transactionOpen());
        }
        QVERIFY(fixture.interval(1) != before); // shown while it is held
        slider->setSliderDown(false);
        QVERIFY(fixture.waitFor([&] { return history.position() == grown + 1; }));

        // At once, so that no machine is too slow for them to be one.
        for (int step = 0; step < 4; ++step) {
            QKeyEvent press(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier);
            QCoreApplication::sendEvent(slider, &press);
        }
        QCOMPARE(history.position(), grown + 1);
        QVERIFY(fixture.waitFor([&] { return history.position() == grown + 2; }));
        QTest::qWait(700);
        fixture.settle();
        QCOMPARE(history.position(), grown + 2);
    }

    /// Each segment has its own place of the slider, also after reopening; an interval that is set
    /// by hand leaves it where it was.
    void theToleranceIsTheSegments()
    {
        Offered fixture;
        auto* slider = fixture.panel.findChild<QSlider*>(QStringLiteral("growTolerance"));
        const int usual = slider->value();
        slider->setValue(6);
        QCOMPARE(fixture.interval(1)->tolerance, 1.5);
        const Interval tight = *fixture.interval(1);
        fixture.addOther();
        QCOMPARE(slider->value(), usual);
        slider->setValue(18);
        QCOMPARE(fixture.interval(2)->tolerance, 4.5);
        fixture.workspace.setActiveSegment(1);
        QVERIFY(fixture.waitFor([&] { return slider->isEnabled(); }));
        QCOMPARE(slider->value(), 6);
        QCOMPARE(fixture.interval(1), std::optional(tight)); // coming back has changed nothing
        fixture.setByHand(500.0, 1500.0);
        QCOMPARE(fixture.interval(1)->tolerance, 1.5);

        QJsonObject state = ui::toolSettings(fixture.workspace, {});
        fixture.workspace.seeds().intervals().clear();
        ui::applyToolSettings(state, fixture.workspace, {});
        QCOMPARE(fixture.interval(1)->tolerance, 1.5);
        QCOMPARE(fixture.interval(2)->tolerance, 4.5);
        // Sessions of old do not tell; a file of a stranger tells anything.
        QJsonArray list = state[QLatin1String("intervals")].toArray();
        for (const QJsonValue& wild : {QJsonValue(QJsonValue::Undefined), QJsonValue(-1e300),
                 QJsonValue(1e300), QJsonValue(QStringLiteral("x"))}) {
            QJsonObject first = list[0].toObject();
            first[QLatin1String("tolerance")] = wild;
            list[0] = first;
            state[QLatin1String("intervals")] = list;
            ui::applyToolSettings(state, fixture.workspace, {});
            const double tolerance =
                fixture.interval(list[0][QLatin1String("segment")].toInt())->tolerance;
            QVERIFY(tolerance >= 0.0 && tolerance <= 100.0);
            if (!wild.isDouble())
                QCOMPARE(tolerance, ui::usualTolerance);
        }
    }

    /// An answer that another sketch has overtaken does not arrive.
    void anOutdatedAnswerIsDropped()
    {
        WorkspaceFixture fixture;
        ui::SketchLook look(fixture.workspace);
        QSignalSpy found(&look, &ui::SketchLook::found);
        const glm::ivec3 middle = fixture.workspace.volume()->geometry.size / 2;
        look.ask({{.voxels = {middle}}});
        look.ask({{.voxels = {glm::ivec3(0), middle}}});
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !found.empty();
        }));
        QTest::qWait(50);
        fixture.settle();
        QCOMPARE(found.count(), 1);
        QCOMPARE(found[0][1].value<std::vector<int>>().size(), std::size_t(2));
        look.ask({{.voxels = {middle}}});
        look.drop();
        QTest::qWait(50);
        fixture.settle();
        QCOMPARE(found.count(), 1);
    }

    void aLabelThatIsUsedAnewHasNoInterval()
    {
        Offered fixture;
        fixture.setByHand(500.0, 1500.0);
        QVERIFY(fixture.interval(1)->byHand);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.session().document().segments.empty());
        QVERIFY(!fixture.interval(1));
        // Redo brings it back with what the user had set.
        QVERIFY(fixture.session().redo());
        fixture.settle();
        QCOMPARE(fixture.interval(1),
            std::optional(Interval{.lower = 500.0, .upper = 1500.0, .byHand = true}));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        fixture.addSketched(); // label 1 again, in another branch
        QVERIFY(!fixture.interval(1)->byHand);
        QVERIFY(fixture.holds(8.0) && !fixture.holds(900.0));
    }

    /// A new segment begins with what the 3D view shows, not with the interval of another.
    void aNewSegmentHasNoIntervalOfAnother()
    {
        Offered fixture;
        QVERIFY(fixture.holds(8.0));
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.settle();
        QVERIFY(!fixture.interval(2));
        QCOMPARE(fixture.workspace.growSettings().lower, ui::shownValues(fixture.workspace).first);
        fixture.workspace.setActiveSegment(1);
        QVERIFY(fixture.holds(8.0));
    }

    /// What was set by hand is known after reopening, and what was offered is not called so.
    void reopeningKnowsWhatWasSetByHand()
    {
        Offered fixture;
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.settle();
        fixture.setByHand(500.0, 1500.0);
        QJsonObject state = ui::toolSettings(fixture.workspace, {});
        const Interval first = *fixture.interval(1);
        fixture.workspace.seeds().intervals().clear();
        ui::applyToolSettings(state, fixture.workspace, {});
        QCOMPARE(fixture.interval(1), std::optional(first));
        QVERIFY(!first.byHand);
        QVERIFY(fixture.interval(2)->byHand);
        // A seed for the second one changes nothing, one for the first does.
        fixture.apply(test::seedAt(2, {{8.0, 0.0, 0.0}}));
        QVERIFY(fixture.waitFor([&] {
            return fixture.panel.findChild<QSlider*>(QStringLiteral("growTolerance"))->isEnabled();
        }));
        QCOMPARE(fixture.workspace.growSettings().lower, 500.0);
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::seedAt(1, {{8.0, 0.0, 0.0}, {-8.0, 0.0, 0.0}}));
        QVERIFY(fixture.waitFor([&] { return fixture.holds(40.0); }));

        // A session of old has one interval, which no sketch changes.
        state.remove(QStringLiteral("intervals"));
        ui::applyToolSettings(state, fixture.workspace, {});
        QVERIFY(fixture.interval(1)->byHand && fixture.interval(2)->byHand);
        QCOMPARE(fixture.interval(1)->lower, 500.0);
    }

    void theDirectionOfViewIsKnownForEachSeed()
    {
        WorkspaceFixture fixture;
        ui::PendingSeeds& seeds = fixture.workspace.seeds();
        const glm::ivec3 a(1, 2, 3);
        const glm::ivec3 b(4, 5, 6);
        const glm::dvec3 along(0.0, 1.0, 0.0);
        seeds.noteSketch(1, {a, b}, {{a, along}, {b, along}});
        QVERIFY(ui::addSegment(fixture.workspace));
        const auto& geometry = fixture.workspace.volume()->geometry;
        const auto at = [&](const glm::ivec3& voxel) {
            return geometry.toWorld(glm::dvec3(voxel));
        };
        fixture.apply(core::SeedStroke{.segment = 1, .pointsLps = {at(a), at(b)}});
        fixture.apply(core::SeedStroke{.segment = 1, .pointsLps = {}, .takenLps = {{at(a)}}});
        QCOMPARE(seeds.seenAlong(1, b), std::optional(along));
        QVERIFY(!seeds.seenAlong(2, b));
        seeds.noteSketch(1, {b}, {}); // sketched again, on a slice
        QVERIFY(!seeds.seenAlong(1, b));
        QCOMPARE(seeds.seenAlong(1, a), std::optional(along));
    }

    /// On a piece that was turned the direction is turned back.
    void theDirectionOfViewFollowsThePose()
    {
        const core::VolumeGeometry geometry = test::smallHead::volume().volume.geometry;
        gpu::VolumeScene scene;
        scene.mode = gpu::RenderMode::Surface;
        scene.eyeLps = {0.0, -100.0, 0.0};
        scene.targetLps = {0.0, 0.0, 0.0};
        gpu::ScenePiece piece{.id = 3};
        piece.shownFromTrue = glm::dmat4(core::rotationMatrix({0.0, 0.0, 90.0}));
        scene.pieces.push_back(piece);
        const auto direction = [&](int id) {
            return glm::normalize(
                geometry.spacingMm() * *ui::lookingDirection(scene, id, geometry));
        };
        QVERIFY(glm::distance(direction(0), {0.0, 1.0, 0.0}) < 1e-9);
        // What points to x at home is shown to point to y.
        QVERIFY(glm::distance(direction(3), {1.0, 0.0, 0.0}) < 1e-9);
        scene.mode = gpu::RenderMode::Mip;
        QVERIFY(!ui::lookingDirection(scene, 3, geometry));
    }
};

BURIN_WINDOW_TEST(SeedIntervalUiTest)

} // namespace seedIntervalUiTest

#include "SeedIntervalUiTest.moc"
