// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/settings/EditableSettings.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/widgets/RangeSlider.h"
#include "ui/workspace/SegmentActions.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QLabel>
#include <QToolButton>
#include <QtTest>

namespace growCriteriaUiTest {

using test::WorkspaceFixture;

namespace {

class CriteriaPanel : public WorkspaceFixture {
public:
    CriteriaPanel()
        : panel(workspace)
    {
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel) || !ui::addSegment(workspace))
            qFatal("no panel");
        part<QToolButton>("growCriteria").click();
    }
    template <class Widget> Widget& part(const char* name)
    {
        auto* found = panel.findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    void setInterval(double lower, double upper)
    {
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = lower;
        settings.upper = upper;
        workspace.setGrowSettings(settings);
    }
    [[nodiscard]] core::GrowCriteria criteria() const
    {
        return ui::criteriaOf(workspace.growSettings());
    }
    /// Grows from the middle to closure. @return how many voxels the segment has
    [[nodiscard]] std::int64_t grown()
    {
        apply(middleSeed(1));
        panel.runToClosure();
        if (!QTest::qWaitFor([this] { return !panel.running(); }))
            qFatal("it grows on");
        settle();
        return session().document().segments[0].voxels;
    }
    ui::GrowthPanel panel;
};

} // namespace

class GrowCriteriaUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void atFirstNothingIsAsked()
    {
        CriteriaPanel fixture;
        core::GrowCriteria plain;
        plain.lower = fixture.criteria().lower;
        plain.upper = fixture.criteria().upper;
        QCOMPARE(fixture.criteria(), plain);
        QCOMPARE(fixture.part<QToolButton>("growCriteria").text(), QStringLiteral("Criteria"));
        // Every value is one that could be meant.
        for (const char* name : {"growSigmasValue", "growDifferenceValue", "growGradientValue",
                 "growGradientDifferenceValue", "growMajorityValue", "growPassageValue"})
            QVERIFY2(fixture.part<QDoubleSpinBox>(name).value() > 0.0, name);
    }

    void ticksAreCriteria()
    {
        CriteriaPanel fixture;
        for (const char* name :
            {"growSigmas", "growDifference", "growGradient", "growGradientDifference",
                "growMajority", "growSmoothing", "growPassage", "growOnlyVisible", "growBoxed"})
            fixture.part<QCheckBox>(name).click();
        const core::GrowCriteria criteria = fixture.criteria();
        QCOMPARE(criteria.sigmas.value_or(0.0), 2.5);
        QCOMPARE(criteria.perStroke, std::optional(true));
        QCOMPARE(criteria.majority.value_or(0), 14);
        QCOMPARE(criteria.smoothing, std::optional(true));
        QVERIFY(criteria.difference && criteria.gradient && criteria.gradientDifference);
        QCOMPARE(*criteria.gradient, fixture.part<QDoubleSpinBox>("growGradientValue").value());
        QVERIFY(criteria.onlyVisible && criteria.box && criteria.passage);
        QCOMPARE(
            fixture.part<QToolButton>("growCriteria").text(), QStringLiteral("Criteria · 9 on"));
        // The interval and what else the panel sets leave them alone.
        fixture.setInterval(0.0, 50.0);
        QMetaObject::invokeMethod(
            &fixture.part<QCheckBox>("growOverwrite"), "toggled", Q_ARG(bool, true));
        QVERIFY(fixture.criteria().majority.has_value());
        fixture.part<QCheckBox>("growMajority").click();
        QVERIFY(!fixture.criteria().majority);
    }

    void whoGivesAValueMeansIt()
    {
        CriteriaPanel fixture;
        fixture.part<QDoubleSpinBox>("growDifferenceValue").setValue(33.0);
        QVERIFY(fixture.part<QCheckBox>("growDifference").isChecked());
        QCOMPARE(fixture.criteria().difference.value_or(0.0), 33.0);
    }

    void whatIsSuspendedIsShownIfAskedFor()
    {
        CriteriaPanel fixture;
        auto& shown = fixture.part<QCheckBox>("growSuspended");
        QTRY_VERIFY(shown.isVisible());
        QVERIFY(!shown.isChecked() && !fixture.workspace.segmentDisplay().suspendedBodies);
        const core::GrowCriteria before = fixture.criteria();
        QTest::mouseClick(&shown, Qt::LeftButton, {}, {10, shown.height() / 2});
        QVERIFY(shown.isChecked() && fixture.workspace.segmentDisplay().suspendedBodies);
        // It is no criterion.
        QCOMPARE(fixture.criteria(), before);
        QCOMPARE(fixture.part<QToolButton>("growCriteria").text(), QStringLiteral("Criteria"));
        fixture.workspace.setViewOptions({});
        QVERIFY(!shown.isChecked() && !fixture.workspace.segmentDisplay().suspendedBodies);
    }

    /// Ventricle, brain and bone are 8, 40 and 900 HU: a step of 35 passes the first border alone.
    void aStepKeepsGrowthIn()
    {
        CriteriaPanel fixture;
        fixture.setInterval(-2000.0, 3000.0);
        fixture.part<QDoubleSpinBox>("growDifferenceValue").setValue(35.0);
        QCOMPARE(fixture.grown(),
            test::smallHead::voxelsOf(test::smallHead::ventricleHu)
                + test::smallHead::voxelsOf(test::smallHead::brainHu));
    }

    void theBandFollowsTheSeeds()
    {
        CriteriaPanel fixture;
        fixture.setInterval(0.0, 20.0);
        auto& text = fixture.part<QLabel>("growBandText");
        fixture.part<QCheckBox>("growSigmas").click();
        fixture.settle();
        QVERIFY(text.isHidden());
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.settle();
        QVERIFY(!text.isHidden());
        QVERIFY2(text.text().startsWith(QStringLiteral("8.0 … 8.0")), qPrintable(text.text()));
        fixture.setInterval(0.0, 50.0); // brain lies around the seed too
        fixture.settle();
        QVERIFY2(text.text().startsWith(QStringLiteral("0.0 …")), qPrintable(text.text()));
        fixture.part<QCheckBox>("growSigmas").click();
        QVERIFY(text.isHidden());
    }

    /// A stroke in the ventricle and one in the brain: two stretches, and what they are of.
    void everyStrokeHasItsStretch()
    {
        CriteriaPanel fixture;
        fixture.setInterval(0.0, 100.0);
        fixture.part<QDoubleSpinBox>("growSigmasValue").setValue(1.0);
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.settle();
        auto& text = fixture.part<QLabel>("growBandText");
        const QString one = text.text();
        QVERIFY2(one.count(QStringLiteral("…")) == 1 && !one.contains(QLatin1Char(':')),
            qPrintable(one));
        fixture.apply(test::seedAt(1, {{9.0, 0.0, 0.0}}));
        fixture.settle();
        const QString values = one.chopped(3); // without " HU"
        QCOMPARE(text.text(), QStringLiteral("2 strokes: %1, 40.0 … 40.0 HU").arg(values));
        // As the growth itself goes.
        fixture.panel.runToClosure();
        QVERIFY(QTest::qWaitFor([&] { return !fixture.panel.running(); }));
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels,
            test::smallHead::voxelsOf(test::smallHead::ventricleHu)
                + test::smallHead::voxelsOf(test::smallHead::brainHu));

        // Strokes of another segment are none of its, and painted seeds are told apart.
        fixture.apply(test::addSegment("Other"));
        fixture.apply(test::seedAt(2, {{0.0, 14.0, 0.0}}));
        fixture.settle();
        QVERIFY2(text.text().startsWith(QStringLiteral("2 strokes: ")), qPrintable(text.text()));
        fixture.apply(test::paintSeedsAt(1, {{0.0, -14.5, 0.0}}, 1.2));
        fixture.settle();
        QVERIFY2(text.text().startsWith(QStringLiteral("2 strokes")), qPrintable(text.text()));
        fixture.setInterval(0.0, 1000.0); // the bone that is painted counts, too
        fixture.settle();
        QVERIFY2(text.text().startsWith(QStringLiteral("2 strokes and other seeds: ")),
            qPrintable(text.text()));
        // Of the segment that is active.
        fixture.workspace.setActiveSegment(2);
        fixture.settle();
        QVERIFY2(!text.text().contains(QStringLiteral("stroke")), qPrintable(text.text()));
    }

    /// Between what asks nothing and what is refused.
    void aPassageIsAskedFor()
    {
        CriteriaPanel fixture;
        auto& width = fixture.part<QDoubleSpinBox>("growPassageValue");
        QCOMPARE(width.minimum(), 2.0);
        QCOMPARE(width.maximum(), 31.0);
        QCOMPARE(width.suffix(), QStringLiteral(" mm"));
        QCOMPARE(width.value(), 5.0);
        fixture.setInterval(0.0, 20.0);
        width.setValue(3.0);
        QVERIFY(fixture.part<QCheckBox>("growPassage").isChecked());
        QCOMPARE(fixture.criteria().passage.value_or(0.0), 3.0);
        const std::int64_t grown = fixture.grown();
        QVERIFY(grown > 1 && grown <= test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        // Where no ball holds the seed, it stays alone.
        CriteriaPanel alone;
        alone.setInterval(0.0, 20.0);
        alone.part<QDoubleSpinBox>("growPassageValue").setValue(31.0);
        QCOMPARE(alone.grown(), std::int64_t(1));
    }

    void aBoxBoundsGrowth()
    {
        CriteriaPanel fixture;
        fixture.setInterval(-2000.0, 3000.0);
        QVERIFY(fixture.part<ui::RangeSlider>("growBoxAxis0").parentWidget()->isHidden());
        fixture.part<QCheckBox>("growBoxed").click();
        QVERIFY(!fixture.part<ui::RangeSlider>("growBoxAxis0").parentWidget()->isHidden());
        // Axes 0 and 1: voxels 16 … 23 of 1 mm, axis 2: 18 … 21 of 1.5 mm.
        for (int axis = 0; axis < 3; ++axis) {
            auto& slider = fixture.part<ui::RangeSlider>(
                qPrintable(QStringLiteral("growBoxAxis%1").arg(axis)));
            Q_EMIT slider.valuesEdited(axis < 2 ? 16.2 : 27.0, axis < 2 ? 23.9 : 33.0);
        }
        QCOMPARE(fixture.grown(), std::int64_t(8 * 8 * 4));
    }

    /// One choice for all tools: the range of editing holds for growth, too, and the panel shows
    /// it.
    void theEditableRangeIsKept()
    {
        CriteriaPanel fixture;
        QVERIFY(!fixture.panel.growEdit().criteria.editable);
        ui::EditableSettings range;
        range.on = true;
        range.byValue = true;
        range.lower = test::smallHead::ventricleHu;
        range.upper = test::smallHead::ventricleHu;
        fixture.workspace.setEditableSettings(range);
        QVERIFY(fixture.workspace.editableRange());
        QCOMPARE(fixture.panel.growEdit().criteria.editable, fixture.workspace.editableRange());
        QVERIFY(fixture.part<QToolButton>("editableButton").text().contains(u"editable"));
        QCOMPARE(fixture.grown(), test::smallHead::voxelsOf(test::smallHead::ventricleHu));
    }

    void aBoxHoldsTheSeeds()
    {
        CriteriaPanel fixture;
        fixture.apply(test::seedAt(1, {{-17.0, 0.0, 0.0}, {0.0, 16.0, 0.0}}));
        fixture.part<QCheckBox>("growBoxed").click();
        const auto box = fixture.criteria().box;
        QVERIFY(box);
        QVERIFY(box->fromLps.x < -17.0 && box->toLps.y > 16.0);
        QVERIFY(box->toLps.x < 12.0 && box->fromLps.y > -12.0); // and not the whole volume
    }

    void theSessionKeepsThem()
    {
        ui::GrowSettings settings;
        settings.lower = 3.0;
        settings.upper = 9.0;
        settings.connectivity = 26;
        settings.sigmas = {.on = true, .value = 1.5};
        settings.difference = {.on = false, .value = 12.0};
        settings.gradient = {.on = true, .value = 80.5};
        settings.majority = {.on = true, .value = 27};
        settings.smoothing = true;
        settings.passage = {.on = true, .value = 3.5};
        settings.onlyVisible = true;
        settings.boxed = true;
        settings.box = core::GrowBox{{1.5, -2.0, 3.0}, {9.0, 8.0, 7.25}};
        const QByteArray text = QJsonDocument(growSettingsJson(settings)).toJson();
        ui::GrowSettings back;
        ui::readGrowSettings(QJsonDocument::fromJson(text).object(), back);
        QVERIFY(back == settings);
        // What makes no sense is passed over.
        ui::GrowSettings kept = settings;
        ui::readGrowSettings(QJsonObject{{QStringLiteral("connectivity"), 7},
                                 {QStringLiteral("box"), 3}, {QStringLiteral("sigmas"), true}},
            kept);
        QVERIFY(kept == settings);
    }
};

BURIN_WINDOW_TEST(GrowCriteriaUiTest)

} // namespace growCriteriaUiTest

#include "GrowCriteriaUiTest.moc"
