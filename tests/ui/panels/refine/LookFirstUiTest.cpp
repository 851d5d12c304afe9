// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "ui/panels/refine/ComparePanel.h"
#include "ui/panels/refine/LookFirstSection.h"

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <utility>

namespace lookFirstUiTest {

namespace {

using Why = core::DoubtfulPlace::Why;

/// The brain of the small head with its ventricle, which ends 6 mm to the right of the middle as if
/// a lobe had been missed.
class LookFixture : public test::WorkspaceFixture {
public:
    explicit LookFixture(core::LoadedVolume volume = test::smallHead::volume())
        : WorkspaceFixture(std::move(volume))
        , panel(workspace)
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        core::VoxelRuns runs;
        for (std::uint64_t at = 0; at < geometry.voxelCount(); ++at) {
            const glm::ivec3 voxel(int(at % 40), int(at / 40 % 40), int(at / 1600));
            const glm::dvec3 place = geometry.toWorld(glm::dvec3(voxel));
            const bool isBrain = glm::length(place) < 13.0;
            whole.push_back(isBrain ? 1 : 0);
            if (isBrain && place.x >= cut.x)
                runs.append(at, 1);
        }
        apply(test::maskImport(QStringLiteral("brain.nrrd"), geometry.size,
            {{QStringLiteral("Brain"), runs, 0x4080C0}}));
        workspace.setActiveSegment(1);
        panel.resize(300, 600);
        panel.setVisible(true);
    }
    [[nodiscard]] QPushButton& button() { return child<QPushButton>("lookForPlaces"); }
    [[nodiscard]] QListWidget& list() { return child<QListWidget>("placesToLookAt"); }
    [[nodiscard]] QString state() { return child<QLabel>("placesState").text(); }
    [[nodiscard]] ui::SegmentDoubts& doubts() { return panel.lookFirst().doubts(); }
    /// Questions are answered when somebody polls.
    [[nodiscard]] bool looked()
    {
        session().poll();
        QCoreApplication::processEvents();
        return !doubts().isLooking();
    }
    /// The whole brain, as a file.
    [[nodiscard]] QString wholeFile() const
    {
        return written(QStringLiteral("whole.nrrd"), whole, {});
    }
    /// The whole brain and, before it, something of 400 voxels far away from it.
    [[nodiscard]] QString fileOfTwo() const
    {
        std::vector<std::uint8_t> labels = whole;
        std::fill_n(labels.begin() + 1600, 400, std::uint8_t(2));
        return written(QStringLiteral("two.seg.nrrd"), labels,
            "Segment0_ID:=a\nSegment0_Name:=Other\nSegment0_LabelValue:=2\n"
            "Segment1_ID:=b\nSegment1_Name:=Brain\nSegment1_LabelValue:=1\n");
    }
    /// Of the mask that a search would compare with; 0: none.
    [[nodiscard]] std::int64_t secondVoxels()
    {
        const auto mask = panel.comparison().secondMask();
        return mask ? std::int64_t(mask->voxelCount()) : 0;
    }

    const glm::dvec3 cut{-6.0, 0.0, 0.0};
    QTemporaryDir folder;
    std::vector<std::uint8_t> whole;
    ui::ComparePanel panel;

private:
    [[nodiscard]] QString written(
        const QString& name, const std::vector<std::uint8_t>& labels, const QByteArray& keys) const
    {
        const QString path = folder.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 40 40 40\n"
                   "space: left-posterior-superior\n"
                   "space directions: (1,0,0) (0,1,0) (0,0,1.5)\n"
                   "space origin: (-20,-20,-30)\nencoding: raw\n"
            + keys + "\n");
        file.write(reinterpret_cast<const char*>(labels.data()), qint64(labels.size()));
        return path;
    }
    template <class T> [[nodiscard]] T& child(const char* name)
    {
        return *panel.findChild<T*>(QLatin1String(name));
    }
};

} // namespace

/// The list of places to look at first in a segment.
class LookFirstUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aClickLeadsThere()
    {
        LookFixture fixture;
        QVERIFY(!fixture.list().isVisible());
        QVERIFY(fixture.state().isEmpty());
        QTest::mouseClick(&fixture.button(), Qt::LeftButton);
        QVERIFY(fixture.doubts().isLooking());
        QTRY_VERIFY(fixture.looked());
        QVERIFY(fixture.list().isVisible());
        const auto& entries = fixture.doubts().found()->entries;
        QCOMPARE(fixture.list().count(), int(entries.size()));
        QVERIFY(entries.size() <= ui::SegmentDoubts::mostPlaces);
        QCOMPARE(entries.front().place.why, Why::NoEdge);
        QVERIFY(fixture.list().item(0)->text().startsWith(QStringLiteral("No edge")));

        const std::int64_t rows = fixture.session().history().position();
        fixture.workspace.setCrosshairLps({10.0, 10.0, 10.0});
        QCoreApplication::processEvents();
        const QRect row = fixture.list().visualItemRect(fixture.list().item(0));
        QTest::mouseClick(fixture.list().viewport(), Qt::LeftButton, {}, row.center());
        QVERIFY(glm::distance(fixture.workspace.crosshairLps(), fixture.cut) < 3.0);
        QCOMPARE(std::int64_t(fixture.session().history().position()), rows);
    }

    /// Where the source does not say how large voxels are, nobody has measured an area.
    void anAreaIsTold()
    {
        for (const bool isKnown : {true, false}) {
            core::LoadedVolume head = test::smallHead::volume();
            if (!isKnown)
                head.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
                    .said = {core::ProblemCode::SpacingAssumed}});
            LookFixture fixture(std::move(head));
            fixture.button().click();
            QTRY_VERIFY(fixture.looked());
            QVERIFY(fixture.list().count() > 0);
            const QString text = fixture.list().item(0)->text();
            QVERIFY2(isKnown ? text.startsWith(QStringLiteral("No edge · "))
                        && text.endsWith(QStringLiteral(" cm²"))
                             : text == QStringLiteral("No edge"),
                qPrintable(text));
        }
    }

    void aTickStaysAndLeadsNowhere()
    {
        LookFixture fixture;
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        QVERIFY(!fixture.doubts().found()->entries.empty());
        QVERIFY(!fixture.doubts().found()->allSeen());
        const glm::dvec3 elsewhere(10.0, 10.0, 10.0);
        fixture.workspace.setCrosshairLps(elsewhere);
        QListWidget& list = fixture.list();
        QListWidgetItem* first = list.item(0);
        // As a click on the tick's box does.
        Q_EMIT list.itemPressed(first);
        first->setCheckState(Qt::Checked);
        Q_EMIT list.itemClicked(first);
        QCOMPARE(fixture.workspace.crosshairLps(), elsewhere);
        QVERIFY(fixture.doubts().found()->entries.front().seen);
        // The next click leads there.
        Q_EMIT list.itemPressed(first);
        Q_EMIT list.itemClicked(first);
        QVERIFY(glm::distance(fixture.workspace.crosshairLps(), fixture.cut) < 3.0);

        // It is kept when the segment is looked at again, and while another one is active.
        fixture.apply(test::newSegment(QStringLiteral("Other")));
        fixture.workspace.setActiveSegment(2);
        QCOMPARE(list.count(), 0);
        fixture.workspace.setActiveSegment(1);
        QVERIFY(list.count() > 0);
        QCOMPARE(list.item(0)->checkState(), Qt::Checked);
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        QCOMPARE(list.item(0)->checkState(), Qt::Checked);
        // A key takes it away.
        list.setCurrentRow(0);
        QTest::keyClick(&list, Qt::Key_Space);
        QVERIFY(!fixture.doubts().found()->entries.front().seen);
        // Another session knows nothing of it.
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.doubts().found());
        QCOMPARE(list.count(), 0);
        QVERIFY(!fixture.button().isEnabled());
    }

    void editsMakeItOld()
    {
        LookFixture fixture;
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        QVERIFY(fixture.state().isEmpty());
        // What is missing is added.
        std::vector<glm::dvec3> lobe;
        for (double y = -8.0; y <= 8.0; y += 2.0)
            lobe.push_back({-9.0, y, 0.0});
        fixture.apply(test::paintAt(1, lobe, 4.0));
        QVERIFY(fixture.doubts().found()->editedSince);
        QVERIFY(!fixture.state().isEmpty());
        // What is up to date is not looked at again without being asked.
        fixture.panel.lookFirst().lookOnce();
        QTRY_VERIFY(fixture.looked());
        QVERIFY(!fixture.doubts().found()->editedSince);
        fixture.panel.lookFirst().lookOnce();
        QVERIFY(!fixture.doubts().isLooking());
    }

    /// What the reference has is told, unless the reference is what was imported.
    void aReferenceThatDisagrees()
    {
        LookFixture fixture;
        fixture.panel.comparison().takeImported();
        QTRY_VERIFY(fixture.looked() && fixture.panel.comparison().outcome());
        QVERIFY(!fixture.panel.comparison().secondMask());
        fixture.panel.comparison().read(fixture.wholeFile());
        QTRY_VERIFY(fixture.looked() && fixture.panel.comparison().outcome());
        QVERIFY(fixture.panel.comparison().secondMask());
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        const auto& entries = fixture.doubts().found()->entries;
        QVERIFY(!entries.empty());
        QCOMPARE(entries.front().place.why, Why::OnlyThere);
        QVERIFY(entries.front().place.placeLps.x < fixture.cut.x);
        QVERIFY(entries.front().place.volumeMm3 > 500.0);
        // The cut lies beside it and is not told twice.
        QVERIFY(std::none_of(entries.begin(), entries.end(), [&](const auto& entry) {
            return entry.place.why == Why::NoEdge
                && glm::distance(entry.place.placeLps, fixture.cut) < 4.0;
        }));
    }

    /// Of several segments of a file, only the one that belongs to the active segment disagrees.
    void aReferenceOfSeveralSegments()
    {
        LookFixture fixture;
        ui::LiveComparison& comparison = fixture.panel.comparison();
        const auto brain =
            std::int64_t(std::count(fixture.whole.begin(), fixture.whole.end(), std::uint8_t(1)));
        const auto isRead = [&] { return fixture.looked() && comparison.outcome().has_value(); };
        comparison.read(fixture.fileOfTwo());
        QTRY_VERIFY(isRead());
        QCOMPARE(comparison.references(),
            QStringList({QStringLiteral("Other"), QStringLiteral("Brain")}));
        QCOMPARE(comparison.chosen(), 1);
        QCOMPARE(fixture.secondVoxels(), brain);
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        const auto& entries = fixture.doubts().found()->entries;
        QVERIFY(!entries.empty());
        QCOMPARE(entries.front().place.why, Why::OnlyThere);
        QVERIFY(entries.front().place.placeLps.x < fixture.cut.x);

        // A choice stands for the segment that it was made for.
        comparison.choose(0);
        QCOMPARE(fixture.secondVoxels(), std::int64_t(400));
        fixture.apply(test::newSegment(QStringLiteral("Kidney")));
        fixture.workspace.setActiveSegment(2);
        QCOMPARE(fixture.secondVoxels(), std::int64_t(0));
        // It is what the list shows already.
        QCOMPARE(comparison.chosen(), 0);
        comparison.choose(0);
        QCOMPARE(fixture.secondVoxels(), std::int64_t(400));
        fixture.workspace.setActiveSegment(1);
        QCOMPARE(comparison.chosen(), 0);
        // And for the file.
        comparison.read(fixture.fileOfTwo());
        QTRY_VERIFY(isRead());
        QCOMPARE(comparison.chosen(), 1);
        QCOMPARE(fixture.secondVoxels(), brain);
    }

    void itWaitsForAnOpenStep()
    {
        LookFixture fixture;
        QVERIFY(fixture.session().begin(test::paintAt(1, {{-9.0, 0.0, 0.0}}, 3.0)));
        QVERIFY(fixture.session().transactionOpen());
        fixture.button().click();
        QVERIFY(fixture.doubts().isLooking());
        QVERIFY(fixture.doubts().isWaiting());
        const QString waiting = fixture.state();
        fixture.session().end(core::Ending::Commit);
        fixture.settle();
        QTRY_VERIFY(fixture.looked());
        QVERIFY(!fixture.doubts().isWaiting());
        QVERIFY(fixture.doubts().found() && !fixture.doubts().found()->editedSince);
        QVERIFY(fixture.state() != waiting);
        fixture.button().click();
        QVERIFY(fixture.doubts().isLooking() && !fixture.doubts().isWaiting());
        QVERIFY(fixture.state() != waiting);
    }

    void itCanBeAborted()
    {
        LookFixture fixture;
        fixture.button().click();
        QVERIFY(fixture.doubts().isLooking());
        const QString abort = fixture.button().text();
        fixture.button().click();
        QVERIFY(!fixture.doubts().isLooking());
        QVERIFY(fixture.button().text() != abort);
        for (int i = 0; i < 20; ++i) {
            QVERIFY(fixture.looked());
            QTest::qWait(10);
        }
        QVERIFY(!fixture.doubts().found());
        // And in the middle of it the session may go.
        fixture.button().click();
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.doubts().isLooking());
        QTest::qWait(50);
        QVERIFY(!fixture.doubts().found());
    }

    void anEmptySegment()
    {
        LookFixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Empty")));
        fixture.workspace.setActiveSegment(2);
        fixture.button().click();
        QTRY_VERIFY(fixture.looked());
        QVERIFY(fixture.doubts().found());
        QVERIFY(fixture.doubts().found()->entries.empty());
        QVERIFY(!fixture.state().isEmpty());
        QVERIFY(!fixture.list().isVisible());
    }
};

BURIN_WINDOW_TEST(LookFirstUiTest)

} // namespace lookFirstUiTest

#include "LookFirstUiTest.moc"
