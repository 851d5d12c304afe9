// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/panels/refine/ComparePanel.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace comparePanelUiTest {

namespace {

constexpr double radius = 10.0; // voxels

/// A ball as segment 1, and a mask's file with one that is a voxel wider.
class CompareFixture : public test::WorkspaceFixture {
public:
    explicit CompareFixture(core::LoadedVolume volume = test::smallHead::volume())
        : WorkspaceFixture(std::move(volume))
        , panel(workspace)
    {
        apply(test::ballMask(glm::ivec3(test::smallHead::side), radius));
        workspace.setActiveSegment(1);
        const core::VoxelRuns larger =
            test::ballRuns(glm::ivec3(test::smallHead::side), radius + 1.0);
        truth.assign(workspace.volume()->geometry.voxelCount(), 0);
        for (const core::VoxelRun& run : larger.runs())
            std::fill_n(truth.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
        QFile file(path());
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        // 1 x 1 x 1.5 mm about the origin, as the small head is.
        file.write("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 40 40 40\n"
                   "space: left-posterior-superior\n"
                   "space directions: (1,0,0) (0,1,0) (0,0,1.5)\n"
                   "space origin: (-20,-20,-30)\nencoding: raw\n\n");
        file.write(reinterpret_cast<const char*>(truth.data()), qint64(truth.size()));
    }
    [[nodiscard]] QString path() const { return folder.filePath(QStringLiteral("truth.nrrd")); }
    [[nodiscard]] QString text(const char* name) const
    {
        return panel.findChild<QLabel*>(QLatin1String(name))->text();
    }
    /// Edits are answered when somebody polls.
    [[nodiscard]] bool upToDate()
    {
        session().poll();
        QCoreApplication::processEvents();
        return panel.comparison().outcome() && !panel.comparison().isBehind();
    }
    [[nodiscard]] const core::MaskComparison& outcome()
    {
        return panel.comparison().outcome()->comparison;
    }

    QTemporaryDir folder;
    std::vector<std::uint8_t> truth;
    ui::ComparePanel panel;
};

/// A cube of voxels away from the ball. @param from its first voxel on each axis
core::ImportedSegment cubeAt(const char* name, int from, int side)
{
    constexpr int row = test::smallHead::side;
    core::VoxelRuns runs;
    for (int k = from; k < from + side; ++k) {
        for (int j = from; j < from + side; ++j)
            runs.append(std::uint64_t((k * row + j) * row + from), std::uint64_t(side));
    }
    return {.name = QLatin1String(name), .rgb = 0, .code = {}, .voxels = core::packedRuns(runs)};
}

core::ImportMask maskOf(
    std::vector<core::ImportedSegment> segments, std::optional<std::vector<int>> planes = {})
{
    core::ImportMask mask;
    mask.file = QStringLiteral("cubes");
    mask.size = glm::ivec3(test::smallHead::side);
    mask.segments = std::move(segments);
    mask.planes = std::move(planes);
    return mask;
}

/// The same by the definition (seed B §7.3), from labels.
double errorOf(const std::vector<std::uint8_t>& mask, const std::vector<std::uint8_t>& reference)
{
    double differ = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        differ += (mask[i] == 1) != (reference[i] == 1) ? 1.0 : 0.0;
        all += reference[i] == 1 ? 1.0 : 0.0;
    }
    return differ / all;
}

} // namespace

class ComparePanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itFollowsWhatIsPainted()
    {
        CompareFixture fixture;
        QVERIFY(fixture.panel.summary().isEmpty());
        fixture.panel.comparison().read(fixture.path());
        QTRY_VERIFY(fixture.upToDate());
        const auto errorNow = [&] {
            return errorOf(*fixture.session().questions().labels(0), fixture.truth);
        };
        const double error = errorNow();
        QVERIFY(error > 0.1 && error < 0.5);
        QCOMPARE(*fixture.outcome().relativeVolumeError, error);
        QCOMPARE(fixture.text("compareWhat"), QStringLiteral("Ball"));
        QVERIFY(fixture.text("compareError").endsWith(QStringLiteral(" %")));
        QVERIFY(fixture.text("compareHd95").endsWith(QStringLiteral(" mm")));
        QVERIFY(fixture.panel.summary().startsWith(QStringLiteral("Dice ")));

        fixture.apply(test::paintAt(1, {glm::dvec3(radius + 6.0, 0.0, 0.0)}, 4.0));
        QTRY_VERIFY(fixture.upToDate() && *fixture.outcome().relativeVolumeError != error);
        QCOMPARE(*fixture.outcome().relativeVolumeError, errorNow());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTRY_VERIFY(fixture.upToDate() && *fixture.outcome().relativeVolumeError == error);
    }

    /// What a network has made, against what the user makes of it.
    void whatWasImportedIsAReference()
    {
        CompareFixture fixture;
        auto* imported = fixture.panel.findChild<QPushButton*>(QStringLiteral("compareImported"));
        QVERIFY(imported->isEnabled());
        // What has nothing to say does not stand there.
        const auto* added = fixture.panel.findChild<QLabel*>(QStringLiteral("compareAdded"));
        const auto* list = fixture.panel.findChild<QComboBox*>(QStringLiteral("compareReference"));
        QVERIFY(!added->isVisibleTo(&fixture.panel) && !list->isVisibleTo(&fixture.panel));
        imported->click();
        QTRY_VERIFY(fixture.upToDate());
        QVERIFY(added->isVisibleTo(&fixture.panel) && list->isVisibleTo(&fixture.panel));
        QVERIFY(fixture.panel.comparison().isImported());
        QCOMPARE(fixture.outcome().dice, 1.0);
        QCOMPARE(fixture.panel.comparison().references(), QStringList{QStringLiteral("Ball")});
        const std::uint64_t before = fixture.outcome().voxels;
        fixture.apply(test::paintAt(1, {glm::dvec3(radius + 6.0, 0.0, 0.0)}, 4.0));
        QTRY_VERIFY(fixture.upToDate() && fixture.outcome().voxels > before);
        QCOMPARE(fixture.outcome().sharedVoxels, before);
        QCOMPARE(fixture.outcome().referenceVoxels, before);
        // 1.5 mm³ a voxel.
        const double addedMl = double(fixture.outcome().voxels - before) * 1.5 / 1000.0;
        QCOMPARE(fixture.text("compareAdded"),
            QLocale().toString(addedMl, 'f', 2) + QStringLiteral(" mL"));
        QCOMPARE(
            fixture.text("compareTaken"), QLocale().toString(0.0, 'f', 2) + QStringLiteral(" mL"));
        // Before the import there is nothing to compare with.
        QVERIFY(fixture.session().goTo(0));
        fixture.settle();
        QVERIFY(!imported->isEnabled());
    }

    void aSurfaceIsComparedBeforeItIsWrittenBack()
    {
        CompareFixture fixture;
        fixture.panel.comparison().read(fixture.path());
        QTRY_VERIFY(fixture.upToDate());
        const double before = *fixture.outcome().relativeVolumeError;
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        QTRY_VERIFY(fixture.upToDate() && fixture.panel.comparison().outcome()->ofSurface);
        QVERIFY(fixture.text("compareWhat").startsWith(QStringLiteral("Surface of Ball")));
        const double laid = *fixture.outcome().relativeVolumeError;
        QVERIFY(std::abs(laid - before) < 0.05);
        // A dent.
        fixture.apply(core::SpherePush{
            .path = {.radiusMm = 6.0, .pointsLps = {glm::dvec3(radius + 1.0, 0.0, 0.0)}}});
        QTRY_VERIFY(fixture.upToDate() && *fixture.outcome().relativeVolumeError > laid + 0.005);
        const double dented = *fixture.outcome().relativeVolumeError;
        fixture.apply(core::WriteBack{});
        fixture.apply(core::DropSurface{});
        // The voxels say the same, but for where the surface is not quite what it was laid around:
        // there they stay as they were.
        QTRY_VERIFY(fixture.upToDate() && !fixture.panel.comparison().outcome()->ofSurface);
        const double written = *fixture.outcome().relativeVolumeError;
        QVERIFY(written > before + 0.005);
        QVERIFY(std::abs((written - before) - (dented - laid)) < 0.005);
    }

    /// A voxel of a tilted series is less than the product of its edges; where the source does not
    /// say how large voxels are, they are counted, and no distance is told.
    void sizesAreTrue()
    {
        for (const bool isKnown : {true, false}) {
            core::LoadedVolume tilted = test::smallHead::volume();
            tilted.volume.geometry.indexToWorld[2].x = 1.0;
            if (!isKnown)
                tilted.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
                    .said = {core::ProblemCode::SpacingAssumed}});
            CompareFixture fixture(std::move(tilted));
            fixture.panel.comparison().takeImported();
            QTRY_VERIFY(fixture.upToDate());
            const std::uint64_t before = fixture.outcome().voxels;
            const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
            const glm::dvec3 beside = geometry.toWorld({20.0 + radius + 4.0, 20.0, 20.0});
            fixture.apply(test::paintAt(1, {beside}, 4.0));
            QTRY_VERIFY(fixture.upToDate() && fixture.outcome().voxels > before);
            const std::uint64_t added = fixture.outcome().voxels - before;
            QCOMPARE(fixture.text("compareAdded"),
                isKnown ? ui::numberText(double(added) * 1.5 / 1000.0, 2) + QStringLiteral(" mL")
                        : ui::countText(qlonglong(added)) + QStringLiteral(" voxels"));
            QCOMPARE(fixture.text("compareTaken"),
                isKnown ? QStringLiteral("0.00 mL") : QStringLiteral("0 voxels"));
            QVERIFY(fixture.outcome().distances);
            for (const char* distance : {"compareHd95", "compareMean"}) {
                const QString text = fixture.text(distance);
                QVERIFY2(
                    isKnown ? text.endsWith(QStringLiteral(" mm")) : text == QStringLiteral("–"),
                    qPrintable(text));
            }
        }
    }

    /// Labels of one plane say nothing of a segment of another one.
    void segmentsOfTwoPlanes()
    {
        CompareFixture fixture;
        fixture.apply(maskOf({cubeAt("Lower", 1, 4), cubeAt("Upper", 3, 5)}, {{0, 1}}));
        const core::Document& document = fixture.session().document();
        QVERIFY(document.segment(2)->plane != document.segment(3)->plane);
        fixture.workspace.setActiveSegment(2);
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(fixture.upToDate());
        QCOMPARE(fixture.outcome().voxels, std::uint64_t(4 * 4 * 4));
        QCOMPARE(fixture.outcome().dice, 1.0);
        fixture.workspace.setActiveSegment(3);
        QTRY_VERIFY(fixture.upToDate() && fixture.panel.comparison().outcome()->segment == 3);
        QCOMPARE(fixture.outcome().voxels, std::uint64_t(5 * 5 * 5));
        QCOMPARE(fixture.outcome().dice, 1.0);
    }

    /// What was imported belongs to the segment that it became, whatever that is called.
    void importsOfOneName()
    {
        CompareFixture fixture;
        fixture.apply(maskOf({cubeAt("Ball", 1, 4)}));
        const ui::LiveComparison& comparison = fixture.panel.comparison();
        const auto isComparedWith = [&](int segment) {
            return fixture.upToDate() && comparison.outcome()->segment == segment;
        };
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(isComparedWith(1));
        QCOMPARE(fixture.outcome().dice, 1.0);
        fixture.workspace.setActiveSegment(2);
        QTRY_VERIFY(isComparedWith(2));
        QCOMPARE(fixture.outcome().dice, 1.0);
        fixture.apply(test::renameSegment(2, QStringLiteral("Cube")));
        QTRY_COMPARE(
            comparison.references(), QStringList({QStringLiteral("Ball"), QStringLiteral("Cube")}));
        const auto* list = fixture.panel.findChild<QComboBox*>(QStringLiteral("compareReference"));
        QTRY_COMPARE(list->currentText(), QStringLiteral("Cube"));
        // Also if it is taken only now.
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(isComparedWith(2));
        QCOMPARE(fixture.outcome().dice, 1.0);
        // What was drawn was not imported, whatever its name.
        fixture.apply(test::newSegment(QStringLiteral("Ball")));
        fixture.workspace.setActiveSegment(3);
        QCOMPARE(comparison.chosen(), -1);
    }

    /// What is imported later is a reference, too, and no longer when it is undone.
    void importsThatComeAndGo()
    {
        CompareFixture fixture;
        const ui::LiveComparison& comparison = fixture.panel.comparison();
        const auto isComparedWith = [&](int segment) {
            return fixture.upToDate() && comparison.outcome()->segment == segment;
        };
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(isComparedWith(1));
        fixture.apply(maskOf({cubeAt("Cube", 1, 4)}));
        fixture.workspace.setActiveSegment(2);
        QTRY_VERIFY(isComparedWith(2));
        QCOMPARE(fixture.outcome().dice, 1.0);
        QCOMPARE(comparison.references().size(), 2);
        fixture.workspace.setActiveSegment(1);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTRY_VERIFY(isComparedWith(1) && comparison.references().size() == 1);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTRY_VERIFY(!comparison.isBehind() && comparison.references().isEmpty());
        QVERIFY(!comparison.outcome());
        QVERIFY(fixture.text("compareWhat").contains(QStringLiteral("Choose a mask")));
        QVERIFY(fixture.session().redo());
        fixture.settle();
        fixture.workspace.setActiveSegment(1);
        QTRY_VERIFY(isComparedWith(1));
        QCOMPARE(fixture.outcome().dice, 1.0);
    }

    /// As long as there is a surface its segment is compared, and then the active one.
    void theReferenceFollowsWhenASurfaceGoes()
    {
        CompareFixture fixture;
        fixture.apply(maskOf({cubeAt("Cube", 1, 4)}));
        const ui::LiveComparison& comparison = fixture.panel.comparison();
        const auto chosen = [&] { return comparison.references().value(comparison.chosen()); };
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(fixture.upToDate());
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        QTRY_VERIFY(fixture.upToDate() && comparison.outcome()->ofSurface);
        fixture.workspace.setActiveSegment(2);
        QTRY_VERIFY(fixture.upToDate() && comparison.outcome()->ofSurface);
        QCOMPARE(comparison.outcome()->segment, 1);
        QCOMPARE(chosen(), QStringLiteral("Ball"));
        fixture.apply(core::DropSurface{});
        QTRY_VERIFY(fixture.upToDate() && comparison.outcome()->segment == 2);
        QCOMPARE(chosen(), QStringLiteral("Cube"));
        QVERIFY(!comparison.outcome()->ofSurface);
        QCOMPARE(fixture.outcome().dice, 1.0);
    }

    void badFilesAreTold()
    {
        CompareFixture fixture;
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.panel.comparison().read(QStringLiteral("/nowhere/at/all.nrrd"));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed.first()
                    .first()
                    .value<core::Error>()
                    .arguments.join(QLatin1Char(' '))
                    .contains(QStringLiteral("all.nrrd")));
        QCOMPARE(fixture.panel.comparison().chosen(), -1);
        QVERIFY(fixture.text("compareWhat").contains(QStringLiteral("Choose a mask")));
    }

    void nothingIsComparedWithoutASegment()
    {
        CompareFixture fixture;
        fixture.panel.comparison().read(fixture.path());
        QTRY_VERIFY(fixture.upToDate());
        fixture.workspace.setActiveSegment(0);
        QTRY_VERIFY(!fixture.panel.comparison().outcome());
        QVERIFY(fixture.text("compareWhat").contains(QStringLiteral("Choose a segment")));
        // A study that is closed takes its reference along, also one that is being read.
        fixture.panel.comparison().read(fixture.path());
        fixture.workspace.setSession(nullptr);
        // What was read comes a moment later and is dropped, of which nothing tells.
        QTest::qWait(50);
        QVERIFY(!fixture.panel.comparison().isBehind());
        QVERIFY(fixture.panel.comparison().references().isEmpty());
    }
};

BURIN_WINDOW_TEST(ComparePanelUiTest)

} // namespace comparePanelUiTest

#include "ComparePanelUiTest.moc"
