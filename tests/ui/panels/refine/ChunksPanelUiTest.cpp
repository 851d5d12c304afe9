// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/session/SessionChunks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainMasks.h"
#include "ui/base/StudyTexts.h"
#include "ui/panels/refine/ChunksPanel.h"
#include "ui/settings/ChunkLeaves.h"
#include "ui/workspace/ChunkMembers.h"
#include "ui/workspace/Chunks.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include <algorithm>
#include <memory>
#include <numeric>

namespace chunksPanelUiTest {

namespace {

constexpr double marginMm = 8.0;
constexpr int missingFrom = 4; ///< mm along x: what the mask lacks of the brain

/// Of the small head: what lies inside of the skull, and on which side of the cut.
bool isBrain(const glm::dvec3& lps)
{
    return glm::length(lps) < 13.0;
}

/// The brain without a part, as segment 1, and the panel.
class PanelFixture : public test::WorkspaceFixture {
public:
    PanelFixture()
        : panel(workspace)
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        core::VoxelRuns runs;
        std::uint64_t at = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x, ++at) {
                    const glm::dvec3 lps = geometry.toWorld(glm::dvec3(x, y, z));
                    if (isBrain(lps) && lps.x < missingFrom)
                        runs.append(at, 1);
                }
            }
        }
        apply(test::maskImport(QStringLiteral("brain.nii"), geometry.size,
            {{QStringLiteral("Brain"), runs, 0x20A0C0}}));
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] ui::Chunks& chunks() { return workspace.chunks(); }
    [[nodiscard]] core::RowId position() { return session().history().position(); }
    template <class Widget> [[nodiscard]] Widget* find(const char* name)
    {
        return panel.findChild<Widget*>(QLatin1String(name));
    }
    /// Until chunks are there, and what is in doubt among them was looked for.
    void await()
    {
        const auto there = [this] {
            session().poll();
            return chunks().map() && session().settle() && !chunks().isCounting();
        };
        QVERIFY(QTest::qWaitFor(there, 60000));
        QCoreApplication::processEvents();
    }
    void divide()
    {
        chunks().divide(marginMm);
        settle();
        await();
    }
    [[nodiscard]] glm::ivec3 voxelAt(const glm::dvec3& lps)
    {
        return glm::ivec3(glm::round(workspace.volume()->geometry.toIndex(lps)));
    }
    /// What a slice draws around the chunk of a place; 0: no rim.
    [[nodiscard]] std::uint32_t rimAt(const glm::dvec3& lps)
    {
        const auto& shown = *chunks().areas();
        const glm::ivec3 sides = shown.box.maximum - shown.box.minimum;
        const glm::ivec3 within = voxelAt(lps) - shown.box.minimum;
        const int leaf =
            (*shown.leaves)[std::size_t((within.z * sides.y + within.y) * sides.x + within.x)];
        return shown.rims.empty() ? 0 : shown.rims[std::size_t(leaf - 1)];
    }

    ui::ChunksPanel panel;
};

constexpr glm::dvec3 inMissing(8.0, 0.0, 0.0);
constexpr glm::dvec3 inBone(-14.0, 0.0, 0.0);

} // namespace

/// What the panel of chunks offers to begin with.
class ChunksPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aNewDivisionBeginsWithTheSuggestion()
    {
        PanelFixture on;
        auto* suggested = on.find<QPushButton>("chunksSuggested");
        QVERIFY(!suggested->isVisibleTo(&on.panel));
        QVERIFY(!on.chunks().suggestedCount());
        on.divide();
        const auto count = on.chunks().suggestedCount();
        QVERIFY(count.has_value());
        QCOMPARE(on.chunks().look().count, *count);
        QVERIFY(suggested->isVisibleTo(&on.panel) && !suggested->isEnabled());
        QVERIFY2(
            suggested->text().contains(QString::number(*count)), qPrintable(suggested->text()));
        // What is missing is a chunk by itself: nothing of the skull, and most of the part.
        const auto missing = on.chunks().chunkAt(on.voxelAt(inMissing));
        QVERIFY(missing && !on.chunks().has(*missing));
        QVERIFY(missing != on.chunks().chunkAt(on.voxelAt(inBone)));
        int held = 0;
        int foreign = 0;
        on.chunks().map()->forEachVoxel(*missing, [&](const glm::ivec3& voxel) {
            const glm::dvec3 lps = on.workspace.volume()->geometry.toWorld(glm::dvec3(voxel));
            ++(isBrain(lps) && lps.x >= missingFrom ? held : foreign);
        });
        QVERIFY2(held > 1000 && 20 * foreign < held,
            qPrintable(QStringLiteral("%1 %2").arg(held).arg(foreign)));

        // Whoever has moved the slider comes back with a click.
        auto* slider = on.find<QSlider>("chunkCount");
        slider->setValue(slider->maximum());
        QVERIFY(suggested->isEnabled() && on.chunks().look().count != *count);
        suggested->click();
        QCOMPARE(on.chunks().look().count, *count);
        QVERIFY(!suggested->isEnabled());
        on.await();
    }

    /// A number that was chosen stays when the same division comes back.
    void undoAndRedoKeepTheChosenNumber()
    {
        PanelFixture on;
        on.divide();
        ui::Chunks::Look look = on.chunks().look();
        look.count = 300;
        on.chunks().setLook(look);
        on.await();
        QVERIFY(on.session().undo());
        on.settle();
        QVERIFY(on.chunks().likely().empty() && !on.chunks().suggestedCount());
        QVERIFY(on.session().redo());
        on.settle();
        on.await();
        QCOMPARE(on.chunks().look().count, 300);
        QVERIFY(on.chunks().suggestedCount().has_value());
    }

    /// Nor is it replaced where it was chosen while the chunks were worked out.
    void aNumberChosenMeanwhileStays()
    {
        PanelFixture on;
        on.chunks().divide(marginMm);
        ui::Chunks::Look look = on.chunks().look();
        look.count = 250;
        on.chunks().setLook(look);
        on.settle();
        on.await();
        QVERIFY(on.chunks().suggestedCount().has_value());
        QCOMPARE(on.chunks().look().count, 250);
    }

    /// What was asked for and led to no division does not make an older one a new one.
    void anOlderDivisionIsNoNewOne()
    {
        PanelFixture on;
        on.divide();
        const core::RowId first = on.position();
        ui::Chunks::Look look = on.chunks().look();
        look.count = 300;
        on.chunks().setLook(look);
        on.await();
        QVERIFY(on.session().undo());
        on.settle();
        on.chunks().divide(marginMm + 3.0);
        on.chunks().abort();
        on.settle();
        QVERIFY(on.session().goTo(first));
        look = on.chunks().look();
        look.shown = true;
        on.chunks().setLook(look);
        on.settle();
        on.await();
        QVERIFY(on.chunks().suggestedCount().has_value());
        QCOMPARE(on.chunks().look().count, 300);
    }

    /// Half of the voxels say nothing of what is missing: who looks waits for all of them.
    void countingTellsWhenItIsThrough()
    {
        PanelFixture on;
        on.divide();
        ui::ChunkMembers members(on.workspace, nullptr, 2);
        const auto sum = [&members] {
            return std::accumulate(members.own().begin(), members.own().end(), std::int64_t(0));
        };
        const std::int64_t all = on.session().document().segment(1)->voxels;
        int unfinished = 0;
        int finished = 0;
        QObject::connect(&members, &ui::ChunkMembers::changed, &members, [&] {
            if (members.isCounting()) {
                ++unfinished;
                QVERIFY(sum() <= all);
            }
        });
        QObject::connect(&members, &ui::ChunkMembers::counted, &members, [&] {
            ++finished;
            QCOMPARE(sum(), all);
        });
        members.begin(std::make_shared<const ui::ChunkLeaves>(on.session().chunks().map(), 1), 1);
        const auto through = [&] {
            on.session().poll();
            return finished > 0;
        };
        QVERIFY(QTest::qWaitFor(through, 60000));
        QVERIFY(unfinished > 2);
        QCOMPARE(finished, 1);
        QVERIFY(!members.isCounting());
    }

    void theListLeadsThere()
    {
        PanelFixture on;
        auto* list = on.find<QListWidget>("likelyChunks");
        QVERIFY(!list->isVisibleTo(&on.panel));
        on.divide();
        const std::vector<ui::Chunks::Likely> likely = on.chunks().likely();
        QVERIFY(!likely.empty() && likely.size() <= 3);
        QVERIFY(list->isVisibleTo(&on.panel));
        QCOMPARE(list->count(), int(likely.size()));
        QVERIFY(!likely.front().isInside);
        const QString first = list->item(0)->text();
        const QString volume =
            ui::volumeText(*on.workspace.volume(), on.chunks().voxels(likely.front().chunk));
        QCOMPARE(first, volume + QStringLiteral(" to add?"));
        QVERIFY2(volume.endsWith(QStringLiteral(" mL")), qPrintable(volume));
        QCOMPARE(on.chunks().chunkAt(on.voxelAt(inMissing)), std::optional(likely.front().chunk));
        QVERIFY(on.rimAt(inMissing) >> 24 == 255U);
        QCOMPARE(on.rimAt(inBone), 0U);
        QVERIFY(on.chunks().bodies()->rims == on.chunks().areas()->rims);

        // A click moves the crosshair and nothing else.
        const core::RowId before = on.position();
        on.workspace.setCrosshairLps({0.0, 0.0, 0.0});
        Q_EMIT list->itemClicked(list->item(0));
        const glm::dvec3 there = on.workspace.crosshairLps();
        QCOMPARE(on.chunks().chunkAt(on.voxelAt(there)), std::optional(likely.front().chunk));
        QVERIFY(isBrain(there) && there.x >= missingFrom);
        QCOMPARE(on.position(), before);
    }

    /// A chunk may bring a neighbour along: once one was added, the panel says how they are parted.
    void whereTooMuchCameAlongItIsSaid()
    {
        PanelFixture on;
        on.divide();
        const auto* hint = on.find<QLabel>("chunksHint");
        QVERIFY(hint && hint->isVisibleTo(&on.panel));
        const QString before = hint->text();
        const auto saysHow = [hint] {
            return hint->text().startsWith(QLatin1String("Too much came along? Press [ until"));
        };
        QVERIFY2(!before.isEmpty() && !saysHow(), qPrintable(before));
        const auto click = [&on](core::ChunkToggle::Mode mode) {
            const core::VolumeGeometry& geometry = on.workspace.volume()->geometry;
            on.apply(core::ChunkToggle{.segment = 1,
                .chunks = on.chunks().count(),
                .mode = mode,
                .pointsLps = {geometry.toWorld(glm::dvec3(on.voxelAt(inMissing)))}});
            on.await();
        };
        click(core::ChunkToggle::Mode::Toggle);
        QVERIFY2(saysHow(), qPrintable(hint->text()));
        // As long as it is being followed.
        ui::Chunks::Look look = on.chunks().look();
        look.count *= 2;
        on.chunks().setLook(look);
        on.await();
        QVERIFY(saysHow());
        QVERIFY(on.session().undo());
        on.settle();
        QCOMPARE(hint->text(), before);
        QVERIFY(on.session().redo());
        on.settle();
        QVERIFY(saysHow());
        click(core::ChunkToggle::Mode::Remove);
        QCOMPARE(hint->text(), before);
    }

    /// What was added is in doubt no more, until it is taken back.
    void whatIsAddedLeavesTheList()
    {
        PanelFixture on;
        on.divide();
        QVERIFY(!on.chunks().likely().empty());
        const ui::Chunks::Chunk missing = on.chunks().likely().front().chunk;
        const auto isListed = [&] {
            const auto& all = on.chunks().likely();
            return std::any_of(all.begin(), all.end(),
                [&](const ui::Chunks::Likely& likely) { return likely.chunk == missing; });
        };
        const core::VolumeGeometry& geometry = on.workspace.volume()->geometry;
        on.apply(core::ChunkToggle{.segment = 1,
            .chunks = on.chunks().count(),
            .pointsLps = {geometry.toWorld(glm::dvec3(on.voxelAt(inMissing)))}});
        on.await();
        QVERIFY(on.chunks().has(missing));
        QVERIFY(!isListed());
        QCOMPARE(on.rimAt(inMissing), 0U);
        QVERIFY(on.session().undo());
        on.settle();
        on.await();
        QVERIFY(isListed() && !on.chunks().has(missing));
    }
};

BURIN_WINDOW_TEST(ChunksPanelUiTest)

} // namespace chunksPanelUiTest

#include "ChunksPanelUiTest.moc"
