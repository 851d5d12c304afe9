// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GenerationText.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/volume/Volume.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace generationTextTest {

namespace {

core::Volume ofTwoMm3()
{
    core::Volume volume;
    volume.geometry.indexToWorld[2][2] = 2.0;
    return volume;
}

} // namespace

/// The line under the generation bar, for each kind of row that a growth consists of.
class GenerationTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatTheLastStepDidIsTold_data()
    {
        QTest::addColumn<core::Edit>("edit");
        QTest::addColumn<QString>("text");
        const QString added = QStringLiteral("Generation 12 · added 3.40 mL");
        const QString takenBack = QStringLiteral("Generation 12 · taken back 3.40 mL");
        const QString changed = QStringLiteral("Generation 12 · changed by 3.40 mL");
        const QString neither = QStringLiteral("Generation 12");
        QTest::newRow("grow") << core::Edit(core::GrowSteps()) << added;
        QTest::newRow("shrink") << core::Edit(core::ShrinkSteps()) << takenBack;
        QTest::newRow("shrink here") << core::Edit(core::ShrinkAt()) << takenBack;
        QTest::newRow("plug") << core::Edit(core::PlugLeak()) << takenBack;
        QTest::newRow("interval") << core::Edit(core::ChangeInterval()) << changed;
        QTest::newRow("seeds") << core::Edit(core::SeedStroke()) << neither;
        QTest::newRow("resume") << core::Edit(core::ResumeGrowth()) << neither;
        QTest::newRow("grow from seeds") << core::Edit(core::GrowFromSeeds()) << neither;
        QTest::newRow("barrier") << core::Edit(core::BarrierStroke()) << neither;
    }
    void whatTheLastStepDidIsTold()
    {
        QFETCH(core::Edit, edit);
        QFETCH(QString, text);
        core::HistoryRow row;
        row.edit = edit;
        row.statistics.voxelsChanged = 1700;
        core::Volume volume = ofTwoMm3();
        QCOMPARE(ui::generationText(12, &row, volume), text);
        // Nobody has measured what a voxel comes to whose size the source does not state.
        volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::SpacingAssumed}});
        const QString counted =
            QString(text).replace(QStringLiteral("3.40 mL"), QStringLiteral("1 700 voxels"));
        QCOMPARE(ui::generationText(12, &row, volume), counted);
    }

    void withoutAStepTheGenerationIsTold()
    {
        QCOMPARE(ui::generationText(123, nullptr, ofTwoMm3()), QStringLiteral("Generation 123"));
    }
};

BURIN_TEST(GenerationTextTest)

} // namespace generationTextTest

#include "GenerationTextTest.moc"
