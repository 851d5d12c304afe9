// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/PlainLimits.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/settings/growth/GrowPresets.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace plainLimitsUiTest {

using test::WorkspaceFixture;
namespace smallHead = test::smallHead;

namespace {

constexpr int side = smallHead::side;

std::size_t indexOf(const glm::ivec3& voxel)
{
    return (std::size_t(voxel.z) * side + std::size_t(voxel.y)) * side + std::size_t(voxel.x);
}

/// The small head, with a cube of 5³ voxels in its brain that has the ventricle's value, and a
/// thread of single voxels between the two.
core::LoadedVolume withThread()
{
    core::LoadedVolume loaded = smallHead::volume();
    const std::uint16_t ventricle = loaded.codes[indexOf(glm::ivec3(side / 2))];
    for (int x = 25; x <= 27; ++x)
        loaded.codes[indexOf({x, 20, 20})] = ventricle;
    for (int z = 18; z <= 22; ++z) {
        for (int y = 18; y <= 22; ++y) {
            for (int x = 28; x <= 32; ++x)
                loaded.codes[indexOf({x, y, z})] = ventricle;
        }
    }
    return loaded;
}

/// How many voxels of the middle's code have at least so many of it among the 27 around and at
/// them, and are connected with the middle over faces by such voxels. With noise smoothed they need
/// not be of that code, if half of what weighs around them is: there is no lesser one near.
std::int64_t connectedWith(const core::LoadedVolume& loaded, int majority, bool smoothing = false)
{
    const glm::ivec3 middle(side / 2);
    const auto isOne = [&](const glm::ivec3& voxel) {
        return loaded.codes[indexOf(voxel)] == loaded.codes[indexOf(middle)];
    };
    const auto qualifies = [&](const glm::ivec3& voxel) {
        int around = 0;
        int weight = isOne(voxel) ? 1 : 0;
        for (int place = 0; place < 27; ++place) {
            const glm::ivec3 step = glm::ivec3(place % 3, place / 3 % 3, place / 9) - 1;
            if (!isOne(voxel + step))
                continue;
            ++around;
            weight += 8 >> (step.x * step.x + step.y * step.y + step.z * step.z);
        }
        return (smoothing ? weight > 32 : isOne(voxel)) && around >= majority;
    };
    std::vector<bool> known(loaded.codes.size());
    std::vector<glm::ivec3> reached{middle};
    known[indexOf(middle)] = true;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        for (int direction = 0; direction < 6; ++direction) {
            glm::ivec3 next = reached[i];
            next[direction / 2] += direction % 2 == 0 ? 1 : -1;
            if (known[indexOf(next)] || !qualifies(next))
                continue;
            known[indexOf(next)] = true;
            reached.push_back(next);
        }
    }
    return std::int64_t(reached.size());
}

/// The growth panel on screen, with a seed in the ventricle and its interval.
class Limits : public WorkspaceFixture {
public:
    explicit Limits(core::LoadedVolume volume = smallHead::volume())
        : WorkspaceFixture(std::move(volume))
        , panel(workspace)
    {
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel) || !ui::addSegment(workspace))
            qFatal("no panel");
        apply(middleSeed(1));
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = 0.0;
        settings.upper = 20.0;
        settings.guard.on = false;
        workspace.setGrowSettings(settings);
    }
    template <class Widget> Widget& part(const char* name)
    {
        auto* found = panel.findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    QComboBox& smooth() { return part<QComboBox>("growSmooth"); }
    QCheckBox& necks() { return part<QCheckBox>("growNecks"); }
    QDoubleSpinBox& width() { return part<QDoubleSpinBox>("growNecksValue"); }
    void clickNecks()
    {
        QTest::mouseClick(&necks(), Qt::LeftButton, {}, {8, necks().height() / 2});
    }
    void typeWidth(const QString& text)
    {
        width().selectAll();
        QTest::keyClicks(&width(), text);
        QTest::keyClick(&width(), Qt::Key_Return);
    }
    void choosePreset(const QString& name)
    {
        for (QAction* action : part<QToolButton>("growPresets").menu()->actions()) {
            if (action->text() == name)
                return action->trigger();
        }
        qFatal("no preset %s", qPrintable(name));
    }
    /// The presets that are marked as what is set.
    [[nodiscard]] QStringList marked()
    {
        QStringList names;
        for (const QAction* action : part<QToolButton>("growPresets").menu()->actions()) {
            if (action->isChecked())
                names += action->text();
        }
        return names;
    }
    [[nodiscard]] core::GrowCriteria criteria() const
    {
        return ui::criteriaOf(workspace.growSettings());
    }
    /// Presses All. @return how many voxels the segment has
    [[nodiscard]] std::int64_t grown()
    {
        QTest::mouseClick(&part<QAbstractButton>("growToClosure"), Qt::LeftButton);
        if (!QTest::qWaitFor([this] { return !panel.running(); }))
            qFatal("it grows on");
        settle();
        return session().document().segments[0].voxels;
    }
    /// The criteria of the step that was made last.
    [[nodiscard]] core::GrowCriteria submitted()
    {
        const core::History& history = session().history();
        const core::Edit& growth = history.row(history.position()).edit;
        if (!growth.is<core::GrowSteps>())
            qFatal("no growth");
        return *core::growCriteriaOf(growth);
    }
    ui::GrowthPanel panel;
};

} // namespace

class PlainLimitsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// They are seen without unfolding anything, and nothing is on.
    void standInFront()
    {
        Limits fixture;
        QVERIFY(fixture.smooth().isVisible() && fixture.necks().isVisible());
        QVERIFY(fixture.width().isVisible());
        QVERIFY(!fixture.part<QCheckBox>("growMajority").isVisible());
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("off"));
        QVERIFY(!fixture.necks().isChecked());
        QVERIFY(!fixture.criteria().majority && !fixture.criteria().passage);
        // In this order: how tolerant, how smooth, grow.
        const auto top = [&](const QWidget& widget) {
            return widget.mapTo(&fixture.panel, QPoint(0, 0)).y();
        };
        QVERIFY(top(fixture.part<QWidget>("growTolerance")) < top(fixture.smooth()));
        QVERIFY(top(fixture.smooth()) < top(fixture.necks()));
        QVERIFY(top(fixture.necks()) < top(fixture.part<QWidget>("growPlay")));
    }

    void smoothIsTheNumberOfNeighbours_data()
    {
        QTest::addColumn<int>("steps");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("majority");
        QTest::newRow("a little") << 1 << QStringLiteral("a little") << 10;
        QTest::newRow("more") << 2 << QStringLiteral("more") << 14;
        QTest::newRow("strong") << 3 << QStringLiteral("strong") << 16;
    }
    void smoothIsTheNumberOfNeighbours()
    {
        QFETCH(int, steps);
        QFETCH(QString, text);
        QFETCH(int, majority);
        const core::LoadedVolume volume = withThread();
        Limits fixture(withThread());
        for (int step = 0; step < steps; ++step)
            QTest::keyClick(&fixture.smooth(), Qt::Key_Down);
        QCOMPARE(fixture.smooth().currentText(), text);
        // The exact number stays behind the fold, in step.
        QVERIFY(fixture.part<QCheckBox>("growMajority").isChecked());
        QCOMPARE(fixture.part<QDoubleSpinBox>("growMajorityValue").value(), double(majority));
        QCOMPARE(
            fixture.part<QToolButton>("growCriteria").text(), QStringLiteral("Criteria · 1 on"));
        QCOMPARE(fixture.grown(), connectedWith(volume, majority));
        QCOMPARE(fixture.submitted().majority, std::optional(majority));
        QVERIFY(!fixture.submitted().passage);
    }

    /// The thread leads growth into the cube; any smoothing keeps it out.
    void aThreadIsNotFollowed()
    {
        const core::LoadedVolume volume = withThread();
        const std::int64_t all = smallHead::voxelsOf(smallHead::ventricleHu) + 3 + 125;
        QCOMPARE(connectedWith(volume, 0), all);
        Limits fixture(withThread());
        QCOMPARE(fixture.grown(), all);
        QVERIFY(!fixture.submitted().majority);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTest::keyClick(&fixture.smooth(), Qt::Key_Down);
        const std::int64_t smooth = fixture.grown();
        QVERIFY(smooth <= smallHead::voxelsOf(smallHead::ventricleHu) + 1);
        QVERIFY(2 * smooth > smallHead::voxelsOf(smallHead::ventricleHu));
    }

    void switchingSmoothOffKeepsTheNumber()
    {
        Limits fixture;
        QTest::keyClick(&fixture.smooth(), Qt::Key_End);
        QCOMPARE(fixture.criteria().majority, std::optional(16));
        QTest::keyClick(&fixture.smooth(), Qt::Key_Home);
        QVERIFY(!fixture.criteria().majority);
        QVERIFY(!fixture.part<QCheckBox>("growMajority").isChecked());
        fixture.part<QCheckBox>("growMajority").click();
        QCOMPARE(fixture.criteria().majority, std::optional(16));
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("strong"));
    }

    /// A number that is none of the steps is told as it is, for as long as it is set.
    void anExactNumberIsTold()
    {
        Limits fixture;
        fixture.part<QDoubleSpinBox>("growMajorityValue").setValue(27.0);
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("27 of 27"));
        QCOMPARE(fixture.smooth().count(), 5);
        fixture.part<QDoubleSpinBox>("growMajorityValue").setValue(9.0);
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("9 of 27"));
        QCOMPARE(fixture.smooth().count(), 5);
        QCOMPARE(fixture.criteria().majority, std::optional(9)); // looking at it changes nothing
        fixture.part<QDoubleSpinBox>("growMajorityValue").setValue(14.0);
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("more"));
        QCOMPARE(fixture.smooth().count(), 4);
        fixture.part<QCheckBox>("growMajority").click();
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("off"));
    }

    void aNeckStopsIt()
    {
        Limits fixture(withThread());
        fixture.typeWidth(QStringLiteral("3"));
        QVERIFY(fixture.necks().isChecked()); // who gives a width means it
        QCOMPARE(fixture.criteria().passage, std::optional(3.0));
        QVERIFY(fixture.part<QCheckBox>("growPassage").isChecked());
        QCOMPARE(fixture.part<QDoubleSpinBox>("growPassageValue").value(), 3.0);
        const std::int64_t grown = fixture.grown();
        QCOMPARE(fixture.submitted().passage, std::optional(3.0));
        QVERIFY(!fixture.submitted().majority);
        QVERIFY(grown <= smallHead::voxelsOf(smallHead::ventricleHu));
        QVERIFY(2 * grown > smallHead::voxelsOf(smallHead::ventricleHu));
    }

    void necksAreSwitchedOffAndOn()
    {
        Limits fixture;
        QCOMPARE(fixture.width().suffix(), QStringLiteral(" mm"));
        QCOMPARE(fixture.width().minimum(), 2.0);
        QCOMPARE(fixture.width().maximum(), 31.0);
        const double width = fixture.width().value();
        fixture.clickNecks();
        QVERIFY(fixture.necks().isChecked());
        QCOMPARE(fixture.criteria().passage, std::optional(width));
        fixture.clickNecks();
        QVERIFY(!fixture.criteria().passage);
        // From behind the fold, too.
        fixture.part<QDoubleSpinBox>("growPassageValue").setValue(7.5);
        QVERIFY(fixture.necks().isChecked());
        QCOMPARE(fixture.width().value(), 7.5);
        fixture.part<QCheckBox>("growPassage").click();
        QVERIFY(!fixture.necks().isChecked());
        QCOMPARE(fixture.width().value(), 7.5); // kept for the next time
        fixture.clickNecks();
        QCOMPARE(fixture.criteria().passage, std::optional(7.5));
    }

    /// Every width that can be set is one that growth accepts, also where voxels are larger.
    void widthsAreThoseOfTheVolume()
    {
        core::LoadedVolume volume = smallHead::volume();
        for (int column = 0; column < 4; ++column) {
            glm::dvec4& each = volume.volume.geometry.indexToWorld[column];
            each = glm::dvec4(1.37 * glm::dvec3(each), each.w);
        }
        const double least = core::leastPassageMm(volume.volume.geometry);
        const double greatest = core::greatestPassageMm(volume.volume.geometry);
        Limits fixture(std::move(volume));
        const auto& exact = fixture.part<QDoubleSpinBox>("growPassageValue");
        const QDoubleSpinBox& width = fixture.width();
        QVERIFY(least - 1e-9 <= width.minimum() && width.minimum() < least + 0.011);
        QVERIFY(width.maximum() <= greatest + 1e-9 && greatest - 0.011 < width.maximum());
        QCOMPARE(exact.minimum(), width.minimum());
        QCOMPARE(exact.maximum(), width.maximum());
        QCOMPARE(exact.singleStep(), width.singleStep());
        QCOMPARE(exact.decimals(), width.decimals());
        QCOMPARE(exact.suffix(), width.suffix());

        fixture.width().setValue(width.minimum());
        QVERIFY(fixture.grown() > 1);
        QCOMPARE(fixture.submitted().passage, std::optional(width.minimum()));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        fixture.width().setValue(width.maximum());
        QCOMPARE(fixture.grown(), std::int64_t(1)); // no such ball holds the seed
        QCOMPARE(fixture.submitted().passage, std::optional(width.maximum()));
    }

    void aPresetSetsWhatSuitsAStructure_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("smooth");
        QTest::addColumn<int>("majority"); // 0: off
        QTest::addColumn<bool>("smoothing");
        QTest::addColumn<int>("connectivity");
        QTest::newRow("organ") << QStringLiteral("Organ, lesion or fluid")
                               << QStringLiteral("a little") << 10 << true << 6;
        QTest::newRow("noise") << QStringLiteral("The same in much noise") << QStringLiteral("more")
                               << 14 << true << 6;
        QTest::newRow("thin") << QStringLiteral("Vessels, airways or thin walls")
                              << QStringLiteral("off") << 0 << false << 26;
    }
    void aPresetSetsWhatSuitsAStructure()
    {
        QFETCH(QString, name);
        QFETCH(QString, smooth);
        QFETCH(int, majority);
        QFETCH(bool, smoothing);
        QFETCH(int, connectivity);
        const core::LoadedVolume volume = withThread();
        Limits fixture(withThread());
        // From something else in all that it sets, and something that it leaves.
        ui::GrowSettings before = fixture.workspace.growSettings();
        before.connectivity = 18;
        before.majority = {.on = true, .value = 27.0};
        before.smoothing = !smoothing;
        before.passage = {.on = true, .value = 7.5};
        before.onlyVisible = true;
        fixture.workspace.setGrowSettings(before);
        QCOMPARE(fixture.marked(), QStringList());

        fixture.choosePreset(name);
        QCOMPARE(fixture.marked(), QStringList(name));
        QCOMPARE(fixture.smooth().currentText(), smooth);
        QVERIFY(!fixture.necks().isChecked());
        QCOMPARE(fixture.width().value(), 7.5); // kept for the next time
        QCOMPARE(fixture.part<QComboBox>("growConnectivity").currentData().toInt(), connectivity);
        const core::GrowCriteria criteria = fixture.criteria();
        QCOMPARE(criteria.majority.value_or(0), majority);
        QCOMPARE(criteria.smoothing.value_or(false), smoothing);
        QCOMPARE(fixture.part<QCheckBox>("growSmoothing").isChecked(), smoothing);
        QVERIFY(!criteria.passage && criteria.onlyVisible);
        QCOMPARE(criteria.lower, 0.0);
        QCOMPARE(criteria.upper, 20.0);

        // Once more: it stays marked, and nothing changes.
        const ui::GrowSettings taken = fixture.workspace.growSettings();
        fixture.choosePreset(name);
        QCOMPARE(fixture.workspace.growSettings(), taken);
        QCOMPARE(fixture.marked(), QStringList(name));

        // With neighbours by corners the thread's end adds nothing that faces do not reach.
        QCOMPARE(fixture.grown(), connectedWith(volume, majority, smoothing));
        QCOMPARE(fixture.submitted().majority.value_or(0), majority);
        QCOMPARE(fixture.submitted().smoothing.value_or(false), smoothing);
        QCOMPARE(fixture.submitted().connectivity, connectivity);
        // What is changed by hand is of no preset any more.
        fixture.clickNecks();
        QCOMPARE(fixture.marked(), QStringList());
    }

    /// Single voxels of the ventricle have the value of bone, as noise may give it to them. Each is
    /// a hole, and with noise smoothed none is.
    void noiseLeavesNoHoles()
    {
        core::LoadedVolume noisy = smallHead::volume();
        const std::uint16_t bone = *std::max_element(noisy.codes.begin(), noisy.codes.end());
        const glm::ivec3 middle(side / 2);
        const std::vector<glm::ivec3> holes{middle + glm::ivec3(2, 0, 0),
            middle + glm::ivec3(-2, 1, 0), middle + glm::ivec3(0, 0, -2)};
        for (const glm::ivec3& hole : holes)
            noisy.codes[indexOf(hole)] = bone;
        const std::int64_t whole = connectedWith(smallHead::volume(), 0, true);
        QCOMPARE(connectedWith(noisy, 0), smallHead::voxelsOf(smallHead::ventricleHu) - 3);
        QCOMPARE(connectedWith(noisy, 0, true), whole);
        Limits fixture(noisy);
        QCOMPARE(fixture.grown(), smallHead::voxelsOf(smallHead::ventricleHu) - 3);
        QVERIFY(!fixture.submitted().smoothing);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        fixture.part<QToolButton>("growCriteria").click();
        auto& smoothing = fixture.part<QCheckBox>("growSmoothing");
        QTRY_VERIFY(smoothing.isVisible());
        QTest::mouseClick(&smoothing, Qt::LeftButton, {}, {10, smoothing.height() / 2});
        QVERIFY(smoothing.isChecked());
        QCOMPARE(
            fixture.part<QToolButton>("growCriteria").text(), QStringLiteral("Criteria · 1 on"));
        QCOMPARE(fixture.grown(), whole);
        QCOMPARE(fixture.submitted().smoothing, std::optional(true));
        reference::DenseFields fields = fixture.engine.fields();
        for (const glm::ivec3& hole : holes)
            QCOMPARE(int(fields.labels(0).at(hole)), 1);
    }

    /// What a session or a recipe has is shown, and none of it is changed by being shown.
    void whatIsSetElsewhereIsShown()
    {
        Limits fixture;
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.majority = {.on = true, .value = 10.0};
        settings.passage = {.on = true, .value = 4.125};
        fixture.workspace.setGrowSettings(settings);
        QCOMPARE(fixture.smooth().currentText(), QStringLiteral("a little"));
        QVERIFY(fixture.necks().isChecked());
        QCOMPARE(fixture.workspace.growSettings(), settings);
    }
};

BURIN_WINDOW_TEST(PlainLimitsUiTest)

} // namespace plainLimitsUiTest

#include "PlainLimitsUiTest.moc"
