// SPDX-License-Identifier: Apache-2.0
#include "ui/base/StudyTexts.h"

#include "tests/support/program/TestProgram.h"

#include <QLocale>
#include <QTest>

namespace studyTextsTest {

namespace {

/// Ten slices of voxels of 2 mm³.
core::Volume tenSlices()
{
    core::Volume volume;
    volume.geometry.size = {100, 100, 10};
    volume.geometry.indexToWorld[2][2] = 2.0;
    return volume;
}

} // namespace

class StudyTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void countsComeToMillilitres()
    {
        const core::Volume volume = tenSlices();
        QCOMPARE(ui::volumeText(volume, 9102), QStringLiteral("18.2 mL"));
        QCOMPARE(ui::volumeText(volume, 0), QStringLiteral("0.00 mL"));
        QCOMPARE(ui::millilitreText(volume, 1234), QStringLiteral("2.47 mL"));
        QCOMPARE(ui::millilitreText(volume, 0), QStringLiteral("—"));
        QCOMPARE(ui::countedText(volume, 9102), QStringLiteral("9 102 voxels, 18.2 mL"));
        QCOMPARE(ui::countedText(volume, 1), QStringLiteral("1 voxel, 0.00 mL"));
    }

    /// A count does not know in which slices its voxels lie.
    void unevenSlicesMakeThemEstimates()
    {
        core::Volume volume = tenSlices();
        for (int k = 0; k < 10; ++k)
            volume.geometry.slicePositions.emplace_back(0.0, 0.0, k < 5 ? k : 3.5 * k);
        QCOMPARE(ui::volumeText(volume, 9102), QStringLiteral("≈ 18.2 mL"));
        QCOMPARE(ui::volumeText(volume, 0), QStringLiteral("0.00 mL"));
        QCOMPARE(ui::millilitreText(volume, 1234), QStringLiteral("≈ 2.47 mL"));
        QCOMPARE(ui::millilitreText(volume, 0), QStringLiteral("—"));
        QCOMPARE(ui::countedText(volume, 9102), QStringLiteral("9 102 voxels, ≈ 18.2 mL"));
    }

    /// Also if only the distance of slices is unknown; a repair or a single image's thickness that
    /// its file states leave millilitres.
    void unknownSpacingLeavesVoxels()
    {
        for (const core::ProblemCode code :
            {core::ProblemCode::SpacingAssumed, core::ProblemCode::ThicknessAssumed}) {
            core::Volume volume = tenSlices();
            volume.problems.push_back(
                {.kind = core::VolumeProblem::Kind::AssumedSpacing, .said = {code}});
            QCOMPARE(ui::volumeText(volume, 9102), QStringLiteral("9 102 voxels"));
            QCOMPARE(ui::millilitreText(volume, 1), QStringLiteral("1 voxel"));
            QCOMPARE(ui::millilitreText(volume, 0), QStringLiteral("—"));
            QCOMPARE(ui::countedText(volume, 9102), QStringLiteral("9 102 voxels"));
            volume.problems.front().repairedBy = QStringLiteral("spacing");
            QCOMPARE(ui::volumeText(volume, 9102), QStringLiteral("18.2 mL"));
        }
        core::Volume single = tenSlices();
        single.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::DepthTakenFrom}});
        QCOMPARE(ui::volumeText(single, 9102), QStringLiteral("18.2 mL"));
    }
};

BURIN_TEST(StudyTextsTest)

} // namespace studyTextsTest

#include "StudyTextsTest.moc"
