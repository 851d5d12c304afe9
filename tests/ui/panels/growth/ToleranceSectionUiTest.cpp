// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/ToleranceSection.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/overlays/Readout.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/growth/ToleranceBar.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <utility>

namespace toleranceSectionUiTest {

namespace smallHead = test::smallHead;
using test::WorkspaceFixture;
using ui::ToleranceBar;
using ui::ToleranceSection;

namespace {

/// The section on screen, over the small head: from a seed in the ventricle the brain is 32 HU
/// away, bone 892, air 1008.
class Traced : public WorkspaceFixture {
public:
    explicit Traced(bool seeded = true, core::LoadedVolume volume = smallHead::volume())
        : WorkspaceFixture(std::move(volume))
        , section(workspace)
        , bar(*section.findChild<ToleranceBar*>())
        , button(*section.findChild<QPushButton*>(QStringLiteral("toleranceTrace")))
    {
        section.resize(280, 140);
        section.show();
        if (!QTest::qWaitForWindowExposed(&section) || !ui::addSegment(workspace)
            || !ui::addSegment(workspace))
            qFatal("no section");
        settle();
        workspace.setActiveSegment(1);
        if (seeded) {
            apply(middleSeed(1));
            trace();
        }
    }
    void trace()
    {
        if (!button.isChecked())
            QTest::mouseClick(&button, Qt::LeftButton);
        wait();
    }
    /// Until the field of all that was done stands.
    void wait()
    {
        if (!QTest::qWaitFor([this] {
                session().poll();
                return section.traced() && session().idle();
            }))
            qFatal("nothing was traced");
    }
    [[nodiscard]] QPoint at(int tolerance) const
    {
        return {int(std::lround(bar.xOf(tolerance))), bar.height() / 2};
    }
    /// Press, move there and there, release at the last.
    void drag(const std::vector<int>& tolerances, bool release = true)
    {
        QTest::mousePress(&bar, Qt::LeftButton, {}, at(tolerances.front()));
        for (const int tolerance : tolerances)
            QTest::mouseMove(&bar, at(tolerance));
        if (release)
            QTest::mouseRelease(&bar, Qt::LeftButton, {}, at(tolerances.back()));
    }
    [[nodiscard]] QString text() const
    {
        return section.findChild<QLabel*>(QStringLiteral("toleranceText"))->text();
    }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }

    ToleranceSection section;
    ToleranceBar& bar;
    QPushButton& button;
};

} // namespace

class ToleranceSectionUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asksForSeeds()
    {
        Traced fixture(false);
        QVERIFY(!fixture.bar.isVisible());
        QTest::mouseClick(&fixture.button, Qt::LeftButton);
        QTRY_VERIFY(
            (fixture.session().poll(), fixture.text().contains(QStringLiteral("no seeds"))));
        // Once there are some, it needs no second click.
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.wait();
        QVERIFY(fixture.bar.isVisible());
        QVERIFY(!fixture.text().contains(QStringLiteral("no seeds")));
    }

    /// In the panel it is one control with the slider of the sketch: one of both is shown.
    void theBarStandsInPlaceOfTheSlider()
    {
        WorkspaceFixture fixture;
        ui::GrowthPanel panel(fixture.workspace);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel) && ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        auto* slider = panel.findChild<QSlider*>(QStringLiteral("growTolerance"));
        const auto* bar = panel.findChild<ToleranceBar*>();
        auto* button = panel.findChild<QPushButton*>(QStringLiteral("toleranceTrace"));
        const auto isShown = [&](const QWidget* one, const QWidget* other) {
            return QTest::qWaitFor([&] {
                fixture.session().poll();
                return one->isVisible() && !other->isVisible();
            });
        };
        QVERIFY(isShown(slider, bar));
        QVERIFY(button->isVisible());
        const int top = slider->mapTo(&panel, QPoint()).y();
        QTest::mouseClick(button, Qt::LeftButton);
        slider->setSliderDown(true); // the curve comes while it is dragged
        QVERIFY(isShown(bar, slider));
        QVERIFY(!slider->isSliderDown());
        QVERIFY(bar->mapTo(&panel, QPoint()).y() < top + 2 * button->height());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(isShown(slider, bar));
        // Without seeds there is no bar that could stand there.
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::qWait(300);
        QVERIFY(isShown(slider, bar));
    }

    void drawsTheCurveAndItsJumps()
    {
        Traced fixture;
        const std::int64_t ventricle = smallHead::voxelsOf(smallHead::ventricleHu);
        const std::int64_t brain = smallHead::voxelsOf(smallHead::brainHu);
        const std::int64_t bone = smallHead::voxelsOf(smallHead::boneHu);
        const std::vector<std::int64_t>& members = fixture.bar.members();
        QCOMPARE(int(members.size()), 1009);
        QCOMPARE(members[0], ventricle);
        QCOMPARE(members[31], ventricle);
        QCOMPARE(members[32], ventricle + brain);
        QCOMPARE(members[891], ventricle + brain);
        QCOMPARE(members[892], ventricle + brain + bone);
        QCOMPARE(members[1008], std::int64_t(40 * 40 * 40));
        QCOMPARE(fixture.bar.jumps(), (std::vector<int>{32, 892, 1008}));
        QVERIFY(fixture.bar.textFor(32).startsWith(QStringLiteral("±32 HU · ")));
        QVERIFY(fixture.bar.textFor(32).contains(QStringLiteral("mL")));
    }

    /// Where the source does not say how large voxels are, they are counted.
    void unknownSpacingLeavesVoxels()
    {
        core::LoadedVolume head = smallHead::volume();
        head.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::SpacingAssumed}});
        const Traced fixture(true, std::move(head));
        const QString text = fixture.bar.textFor(32);
        const QString voxels = ui::countText(fixture.bar.members()[32]);
        QVERIFY2(text.endsWith(QStringLiteral(" · %1 voxels").arg(voxels)), qPrintable(text));
    }

    void showsWhatItWouldBeBothWays()
    {
        Traced fixture;
        QSignalSpy shown(&fixture.workspace, &ui::Workspace::atToleranceChanged);
        const std::size_t rows = fixture.rows();
        fixture.drag({100, 500, 900}, false);
        const auto far = fixture.workspace.atTolerance();
        QVERIFY(far && far->label == 1);
        QVERIFY(far->tolerance > 850);
        QCOMPARE(far->tolerance, fixture.bar.tolerance());
        QVERIFY(fixture.workspace.segmentDisplay().atTolerance == far);
        QTest::mouseMove(&fixture.bar, fixture.at(40));
        const auto near = fixture.workspace.atTolerance();
        QVERIFY(near && near->tolerance >= 36 && near->tolerance < 45);
        QVERIFY(fixture.text().startsWith(QStringLiteral("±%1 HU · ").arg(near->tolerance)));
        QVERIFY(fixture.text().contains(QStringLiteral("jumps at ±892 HU")));
        QVERIFY(shown.count() >= 4);
        // Nothing is done until it is let go.
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.voxels(), 0);
        QTest::keyClick(&fixture.bar, Qt::Key_Escape);
        QVERIFY(!fixture.workspace.atTolerance());
        QTest::mouseRelease(&fixture.bar, Qt::LeftButton, {}, fixture.at(40));
        fixture.settle();
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.bar.tolerance(), -1);
    }

    void lettingGoIsOneStep()
    {
        Traced fixture;
        const std::size_t rows = fixture.rows();
        fixture.drag({900, 300, 40});
        const int tolerance = fixture.bar.tolerance();
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        const core::HistoryRow& grown = fixture.session().history().rows().back();
        QVERIFY(grown.edit.is<core::GrowSteps>());
        QVERIFY(!grown.name.isEmpty());
        QCOMPARE(fixture.voxels(), fixture.bar.members()[std::size_t(tolerance)]);
        QCOMPARE(fixture.workspace.growSettings().lower, 8.0 - tolerance);
        QCOMPARE(fixture.workspace.growSettings().upper, 8.0 + tolerance);
        fixture.wait();
        QVERIFY(!fixture.workspace.atTolerance());

        // What has grown follows: wider, then narrower than before.
        for (const int other : {900, 4}) {
            fixture.drag({40, other});
            fixture.settle();
            const auto& edit = fixture.session().history().rows().back().edit;
            QVERIFY(edit.is<core::ChangeInterval>());
            QCOMPARE(fixture.voxels(), fixture.bar.members()[std::size_t(fixture.bar.tolerance())]);
            fixture.wait();
        }
        QCOMPARE(fixture.rows(), rows + 3);
        for (int i = 0; i < 3; ++i)
            QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.voxels(), 0);
    }

    void arrowKeysAndReturn()
    {
        Traced fixture;
        const std::size_t rows = fixture.rows();
        fixture.bar.setFocus();
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&fixture.bar, Qt::Key_Right);
        QTest::keyClick(&fixture.bar, Qt::Key_Left);
        QCOMPARE(fixture.bar.tolerance(), 2);
        QTest::keyClick(&fixture.bar, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(fixture.bar.tolerance(), 12);
        QVERIFY(fixture.workspace.atTolerance());
        QCOMPARE(fixture.rows(), rows);
        QTest::keyClick(&fixture.bar, Qt::Key_Return);
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(), smallHead::voxelsOf(smallHead::ventricleHu));
    }

    void readoutTellsWhereAVoxelJoins()
    {
        Traced fixture;
        ui::Readout readout(fixture.workspace);
        const auto pointAt = [&](const glm::dvec3& lps) {
            fixture.workspace.setPointedLps(lps);
            (void)QTest::qWaitFor([&] {
                fixture.session().poll();
                return readout.text().contains(QStringLiteral("HU"));
            });
            return readout.text();
        };
        QVERIFY(pointAt({9.0, 0.0, 0.0}).endsWith(QStringLiteral("joins at ±32 HU")));
        QVERIFY(pointAt({0.0, 14.0, 0.0}).endsWith(QStringLiteral("joins at ±892 HU")));
        QTest::mouseClick(&fixture.button, Qt::LeftButton); // off
        fixture.settle();
        QVERIFY(!pointAt({9.0, 1.0, 0.0}).contains(QStringLiteral("joins")));
        QVERIFY(!fixture.bar.isVisible());
    }

    void followsSeedsAndCriteria()
    {
        Traced fixture;
        // A second seed in the bone: the mean lies between.
        fixture.apply(test::seedAt(1, {{0.0, 14.0, 0.0}}));
        fixture.wait();
        QCOMPARE(fixture.bar.members()[0], 0);
        QVERIFY(!std::binary_search(fixture.bar.jumps().begin(), fixture.bar.jumps().end(), 32));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        fixture.wait();
        QCOMPARE(fixture.bar.members()[0], smallHead::voxelsOf(smallHead::ventricleHu));

        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.sigmas.on = true;
        fixture.workspace.setGrowSettings(settings);
        QTRY_VERIFY(
            (fixture.session().poll(), fixture.text().contains(QStringLiteral("Strokes' mean"))));
        QVERIFY(!fixture.bar.isVisible());
        settings.sigmas.on = false;
        fixture.workspace.setGrowSettings(settings);
        fixture.wait();
        QVERIFY(fixture.bar.isVisible());
        // Those that stand in front are told by their words there.
        for (const bool smooth : {true, false}) {
            settings.majority.on = smooth;
            settings.passage = {.on = !smooth, .value = 3.0};
            fixture.workspace.setGrowSettings(settings);
            const QString name = smooth ? QStringLiteral("“Smooth”")
                                        : QStringLiteral("“Stop at necks narrower than”");
            QTRY_VERIFY((fixture.session().poll(), fixture.text().contains(name)));
            QVERIFY2(
                !fixture.text().contains(QStringLiteral("Criteria")), qPrintable(fixture.text()));
        }
        settings.passage.on = false;
        settings.smoothing = true;
        fixture.workspace.setGrowSettings(settings);
        QTRY_VERIFY((fixture.session().poll(),
            fixture.text().contains(QStringLiteral("“Smooth noise” off under Criteria"))));
        QVERIFY(!fixture.bar.isVisible());
        settings.smoothing = false;
        fixture.workspace.setGrowSettings(settings);
        fixture.wait();
        QVERIFY(fixture.bar.isVisible());
    }

    /// What is traced is what comes of it: voxels that may not change are walls for both.
    void theEditableRangeIsKept()
    {
        Traced fixture;
        fixture.workspace.setEditableSettings({.on = true,
            .byValue = true,
            .lower = smallHead::ventricleHu,
            .upper = smallHead::ventricleHu});
        QVERIFY(QTest::qWaitFor([&fixture] {
            fixture.session().poll();
            return fixture.section.traced() && fixture.session().idle()
                && fixture.bar.members().back() == smallHead::voxelsOf(smallHead::ventricleHu);
        }));
        fixture.drag({0});
        fixture.settle();
        QCOMPARE(fixture.voxels(), smallHead::voxelsOf(smallHead::ventricleHu));
        const core::History& history = fixture.session().history();
        QCOMPARE(core::growCriteriaOf(history.row(history.position()).edit)->editable,
            fixture.workspace.editableRange());
    }

    /// What the bar shows was traced for another range: nothing comes of it until it is traced
    /// anew.
    void anotherRangeEndsTheMove()
    {
        Traced fixture;
        const std::size_t rows = fixture.rows();
        fixture.drag({20, 40}, false);
        QVERIFY(fixture.workspace.atTolerance());
        fixture.workspace.setEditableSettings({.on = true,
            .byValue = true,
            .lower = smallHead::ventricleHu,
            .upper = smallHead::ventricleHu});
        QTest::mouseMove(&fixture.bar, fixture.at(30));
        QVERIFY(!fixture.workspace.atTolerance());
        QTest::mouseRelease(&fixture.bar, Qt::LeftButton, {}, fixture.at(30));
        QVERIFY(!fixture.workspace.atTolerance());
        QCOMPARE(fixture.bar.tolerance(), -1);
        fixture.settle();
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(QTest::qWaitFor([&fixture] {
            fixture.session().poll();
            return fixture.section.traced() && fixture.session().idle()
                && fixture.bar.members().back() == smallHead::voxelsOf(smallHead::ventricleHu);
        }));
        fixture.drag({0});
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
    }

    /// What is being chosen for one segment is not applied to the one that becomes active.
    void anotherSegmentEndsTheMove_data()
    {
        QTest::addColumn<bool>("byMouse");
        QTest::newRow("keys") << false;
        QTest::newRow("mouse") << true;
    }
    void anotherSegmentEndsTheMove()
    {
        QFETCH(const bool, byMouse);
        Traced fixture;
        fixture.apply(test::seedAt(2, {{-19.0, -19.0, -28.0}}));
        fixture.wait();
        const std::int64_t ventricle = smallHead::voxelsOf(smallHead::ventricleHu);
        QCOMPARE(fixture.bar.members()[0], ventricle);
        const std::size_t rows = fixture.rows();
        fixture.bar.setFocus();
        if (byMouse) {
            fixture.drag({20, 40}, false);
        } else {
            QTest::keyClick(&fixture.bar, Qt::Key_Right);
            QTest::keyClick(&fixture.bar, Qt::Key_Right);
        }
        QVERIFY(fixture.bar.moving() && fixture.workspace.atTolerance());
        fixture.workspace.setActiveSegment(2);
        QVERIFY(!fixture.bar.moving() && !fixture.workspace.atTolerance());
        QCOMPARE(fixture.bar.tolerance(), -1);
        QTRY_VERIFY((fixture.session().poll(),
            !fixture.bar.members().empty() && fixture.bar.members()[0] != ventricle));
        if (byMouse)
            QTest::mouseRelease(&fixture.bar, Qt::LeftButton, {}, fixture.at(40));
        else
            QTest::keyClick(&fixture.bar, Qt::Key_Return);
        fixture.settle();
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(!fixture.workspace.atTolerance());
    }

    /// The tolerance was traced for one segment: seeds of others go on waiting.
    void othersStayAsTheyAre()
    {
        Traced fixture;
        fixture.apply(test::seedAt(2, {{-19.0, -19.0, -28.0}}));
        fixture.wait();
        fixture.drag({900, 40});
        fixture.settle();
        QCOMPARE(fixture.voxels(),
            smallHead::voxelsOf(smallHead::ventricleHu) + smallHead::voxelsOf(smallHead::brainHu));
        const core::History& history = fixture.session().history();
        const core::Edit& grown = history.row(history.position()).edit;
        QVERIFY(grown.is<core::GrowSteps>());
        QCOMPARE(core::growCriteriaOf(grown)->segments, std::optional(std::vector<int>{1}));
        QVERIFY(QTest::qWaitFor([&fixture] {
            fixture.settle();
            return fixture.workspace.seeds().seeds().size() == 1
                && fixture.workspace.seeds().hollow().empty();
        }));
    }
};

BURIN_WINDOW_TEST(ToleranceSectionUiTest)

} // namespace toleranceSectionUiTest

#include "ToleranceSectionUiTest.moc"
