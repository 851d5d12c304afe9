// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"
#include "ui/panels/growth/SpreadBar.h"

#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/workspace/SegmentActions.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

namespace spreadBarUiTest {

using test::WorkspaceFixture;
using ui::SpreadBar;

namespace {

/// A bar on screen; the middle's ventricle and the air around are seeded, for segments 1 and 2.
class SeededBar : public WorkspaceFixture {
public:
    SeededBar()
        : bar(workspace)
    {
        bar.show();
        if (!QTest::qWaitForWindowExposed(&bar) || !ui::addSegment(workspace)
            || !ui::addSegment(workspace))
            qFatal("no bar");
        bar.findChild<QToolButton*>(QStringLiteral("spreadFold"))->click();
        settle();
    }
    void seedBoth()
    {
        apply(middleSeed(1));
        apply(test::seedAt(2, {{-19.0, -19.0, -28.0}}));
        // The engine is asked which of them wait.
        (void)QTest::qWaitFor([this] {
            session().poll();
            return enabled("spreadPreview");
        });
    }
    void click(const char* name)
    {
        QTest::mouseClick(bar.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    [[nodiscard]] bool enabled(const char* name) const
    {
        return bar.findChild<QPushButton*>(QLatin1String(name))->isEnabled();
    }
    [[nodiscard]] QString text() const
    {
        return bar.findChild<QLabel*>(QStringLiteral("spreadText"))->text();
    }
    [[nodiscard]] int seenInTheMiddle() { return seenAt({20, 20, 20}); }
    /// The label that views show.
    [[nodiscard]] int seenAt(const glm::ivec3& voxel)
    {
        int seen = -1;
        session().questions().probe(
            {voxel}, [&seen](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                seen = probes->front().label;
            });
        (void)QTest::qWaitFor([this, &seen] {
            session().poll();
            return seen >= 0;
        });
        return seen;
    }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }
    /// An editable range from below all values to this one.
    void choose(double upper)
    {
        workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -1100.0, .upper = upper});
    }
    /// The end of the range to which the open preview keeps; 0: none is open, or without a range.
    [[nodiscard]] double upperOfPreview()
    {
        if (!session().isOpen<core::GrowFromSeeds>())
            return 0.0;
        const auto& range = session().openEdit()->get<core::GrowFromSeeds>().editable;
        return range ? range->upper.value_or(0.0) : 0.0;
    }

    SpreadBar bar;
};

} // namespace

class SpreadBarUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asksForTwoSeededSegments()
    {
        SeededBar fixture;
        QVERIFY(!fixture.enabled("spreadPreview"));
        QVERIFY(fixture.text().contains(QStringLiteral("two segments")));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        QVERIFY(!fixture.enabled("spreadPreview"));
        fixture.seedBoth();
        QVERIFY(fixture.enabled("spreadPreview"));
        QVERIFY(!fixture.enabled("spreadApply") && !fixture.enabled("spreadCancel"));
    }

    void theEditableRangeIsKept()
    {
        SeededBar fixture;
        QVERIFY(!fixture.bar.edit().editable);
        fixture.workspace.setEditableSettings({.on = true, .byValue = true, .upper = 900.0});
        QVERIFY(fixture.bar.edit().editable);
        QCOMPARE(fixture.bar.edit().editable, fixture.workspace.editableRange());
    }

    /// A preview is worked out anew for another range, but not over something else that is open.
    void anotherRangeLeavesARunningGrowthAlone()
    {
        SeededBar fixture;
        fixture.seedBoth();
        fixture.click("spreadPreview");
        const core::Edit growth = test::growBetween(-1100.0, 2000.0);
        QVERIFY(fixture.session().begin(growth));
        QVERIFY(fixture.bar.previewing());
        QVERIFY(fixture.session().isOpen<core::GrowSteps>());
        fixture.choose(900.0);
        for (int round = 0; round < 10; ++round) {
            QTest::qWait(40);
            fixture.session().poll();
            QVERIFY(fixture.session().isOpen<core::GrowSteps>());
        }
        fixture.session().end(core::Ending::Rollback);
        QTRY_VERIFY((fixture.session().poll(), fixture.upperOfPreview() == 900.0));
        fixture.click("spreadCancel");
        fixture.settle();
    }

    void anotherRangeIsFollowedOnce()
    {
        SeededBar fixture;
        fixture.seedBoth();
        fixture.choose(1000.0);
        const std::size_t rows = fixture.rows();
        fixture.click("spreadPreview");
        QCOMPARE(fixture.upperOfPreview(), 1000.0);
        fixture.choose(900.0);
        fixture.choose(800.0);
        QCOMPARE(fixture.upperOfPreview(), 1000.0);
        QTRY_COMPARE((fixture.session().poll(), fixture.upperOfPreview()), 800.0);
        // What is applied before it is worked out anew is what is chosen.
        fixture.choose(700.0);
        fixture.click("spreadApply");
        fixture.settle();
        QVERIFY(!fixture.bar.previewing());
        QCOMPARE(fixture.rows(), rows + 1);
        const core::Edit& kept = fixture.session().history().rows().back().edit;
        QCOMPARE(kept.get<core::GrowFromSeeds>().editable->upper.value(), 700.0);
    }

    void showsAndCancels()
    {
        SeededBar fixture;
        fixture.seedBoth();
        const std::size_t rows = fixture.rows();
        fixture.click("spreadPreview");
        QVERIFY(fixture.bar.previewing());
        QCOMPARE(fixture.seenInTheMiddle(), 1);
        QVERIFY(fixture.enabled("spreadApply") && fixture.enabled("spreadCancel"));
        fixture.click("spreadCancel");
        fixture.settle();
        QVERIFY(!fixture.bar.previewing());
        QCOMPARE(fixture.seenInTheMiddle(), 0);
        QCOMPARE(fixture.rows(), rows);
    }

    void applies()
    {
        SeededBar fixture;
        fixture.seedBoth();
        const std::size_t rows = fixture.rows();
        fixture.click("spreadPreview");
        fixture.click("spreadApply");
        fixture.settle();
        QVERIFY(!fixture.bar.previewing());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.seenInTheMiddle(), 1);
        QVERIFY(fixture.session().document().segments[1].voxels > 1000);
    }

    void followsAStroke()
    {
        SeededBar fixture;
        fixture.seedBoth();
        fixture.click("spreadPreview");
        QCOMPARE(fixture.seenInTheMiddle(), 1);
        // Some of the ventricle goes to the other segment; the preview comes back by itself.
        constexpr glm::ivec3 beside{23, 20, 20};
        QCOMPARE(fixture.seenAt(beside), 1);
        fixture.apply(test::paintAt(2, {{3.0, 0.0, 0.0}}, 1.5));
        QVERIFY(!fixture.session().isOpen<core::GrowFromSeeds>());
        QTRY_VERIFY(fixture.session().isOpen<core::GrowFromSeeds>());
        QVERIFY(fixture.bar.previewing());
        QCOMPARE(fixture.seenAt(beside), 2);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(!fixture.session().isOpen<core::GrowFromSeeds>());
        QTRY_VERIFY(fixture.session().isOpen<core::GrowFromSeeds>());
        QCOMPARE(fixture.seenAt(beside), 1);
        fixture.click("spreadCancel");
        fixture.settle();
    }

    void theWholeVolumeIfAskedFor()
    {
        SeededBar fixture;
        QVERIFY(!fixture.bar.edit().box);
        auto* extent = fixture.bar.findChild<QComboBox*>(QStringLiteral("spreadExtent"));
        extent->setCurrentIndex(1);
        const core::GrowFromSeeds edit = fixture.bar.edit();
        QVERIFY(edit.box);
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        QCOMPARE(geometry.toIndex(edit.box->toLps).x, double(geometry.size.x - 1));
    }
};

BURIN_WINDOW_TEST(SpreadBarUiTest)

} // namespace spreadBarUiTest

#include "SpreadBarUiTest.moc"
