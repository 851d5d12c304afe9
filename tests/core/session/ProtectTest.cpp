// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace protectTest {

using namespace core;

namespace {

struct Bench {
    explicit Bench(const std::vector<Edit>& edits = {}, const QString& file = {})
    {
        session = *EditSession::create(engine, test::smallStudy(), {.file = file});
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        const Result<void> done = attempt(edit);
        QVERIFY2(done, qPrintable(done ? QString() : done.error().arguments.join(u' ')));
    }
    [[nodiscard]] Result<void> attempt(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        return applied ? session->settle() : applied;
    }
    /// Why an edit is refused; nothing may have changed then.
    [[nodiscard]] ErrorCode refusal(const Edit& edit)
    {
        const QByteArray before = session->stateHash();
        const std::size_t rows = session->history().rows().size();
        const Result<void> done = attempt(edit);
        if (done || session->stateHash() != before || session->history().rows().size() != rows)
            return ErrorCode::Internal;
        return done.error().code;
    }
    [[nodiscard]] reference::DenseArray<std::uint8_t> coverage(std::uint8_t layer = 1) const
    {
        reference::DenseFields fields = engine.fields();
        return fields.coverage(layer);
    }
    [[nodiscard]] reference::DenseArray<std::uint8_t> labels(std::uint8_t plane = 0) const
    {
        reference::DenseFields fields = engine.fields();
        return fields.labels(plane);
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

Edit protect(int segment, bool on = true)
{
    return test::protectSegment(segment, on);
}

/// In the shell of bone that the drill goes through.
std::vector<glm::dvec3> placeBelow()
{
    const OrthographicView view = test::factsOfStroke(test::drillAt(0)).view;
    const glm::dvec3 towards = glm::normalize(view.targetLps - view.eyeLps);
    const VolumeGeometry geometry = test::smallStudy().volume.geometry;
    const glm::dvec3 middle = geometry.toWorld(glm::dvec3(geometry.size - 1) / 2.0);
    return {middle - 15.0 * towards};
}

Edit paintIn(int segment)
{
    return test::paintAt(segment, placeBelow(), 3.0);
}

Edit deepDrill(double depthMm = 9.0)
{
    return test::drillWith(
        {.radiusMm = 7.0, .depthMm = depthMm, .throughGaps = true}, test::drillAt(0));
}

/// What fills that again.
Edit restoring()
{
    return test::drillWith({.restore = true}, deepDrill());
}

const Edit vessel = test::addSegment("Vessel");
/// Segment 2, which may overlap the vessel.
const Edit above = AddSegment{.name = QStringLiteral("Above"), .rgb = 0x40C080, .plane = 2};

/// Partly where paintIn() paints.
Edit paintAbove()
{
    std::vector<glm::dvec3> beside = placeBelow();
    beside.front() += glm::dvec3(2.0, 0.0, 1.0);
    return test::paintAt(2, beside, 3.0);
}

std::vector<Edit> cutsOfEveryTool()
{
    const test::StrokeFacts drill = test::factsOfStroke(deepDrill());
    const Edit laser = test::laserWith({.view = drill.view,
        .mask = drill.mask,
        .depthMm = 9.0,
        .surfaceThreshold = drill.surfaceThreshold,
        .samples = drill.samples});
    const std::vector<glm::dvec2> outline{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
    const Edit peel = test::peelWith(
        {.view = drill.view, .depthMm = 9.0, .surfaceThreshold = drill.surfaceThreshold}, outline);
    const Edit scissors = test::scissorsWith(
        {.view = drill.view, .surfaceThreshold = drill.surfaceThreshold}, outline);
    return {deepDrill(), laser, peel, scissors, test::carveAt(placeBelow(), 6.0)};
}

} // namespace

class ProtectTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Voxel by voxel: nothing of the segment is carved, and all else is as it would be anyway.
    void noToolCutsIt_data()
    {
        QTest::addColumn<int>("tool");
        int tool = 0;
        for (const char* name : {"drill", "laser", "peel", "scissors", "brush"})
            QTest::newRow(name) << tool++;
    }
    void noToolCutsIt()
    {
        QFETCH(int, tool);
        const Edit cut = cutsOfEveryTool()[std::size_t(tool)];
        const Bench plain({vessel, paintIn(1), cut});
        const Bench kept({vessel, paintIn(1), protect(1), cut});
        const auto free = plain.coverage();
        const auto protectedSegments = kept.coverage();
        const auto labels = kept.labels();
        int inside = 0;
        int outside = 0;
        for (std::size_t i = 0; i < labels.values.size(); ++i) {
            QCOMPARE(
                int(protectedSegments.values[i]), labels.values[i] == 1 ? 0 : int(free.values[i]));
            inside += labels.values[i] == 1 && free.values[i] >= 128;
            outside += labels.values[i] != 1 && free.values[i] >= 128;
        }
        QVERIFY2(inside > 30 && outside > 100, qPrintable(QString::number(inside)));
    }

    /// Nor one of a further label plane, alone or beside one of the first.
    void norOneOfAFurtherPlane_data() { noToolCutsIt_data(); }
    void norOneOfAFurtherPlane()
    {
        QFETCH(int, tool);
        const Edit cut = cutsOfEveryTool()[std::size_t(tool)];
        const std::vector<Edit> matter{vessel, above, paintIn(1), paintAbove()};
        Bench plain(matter);
        plain.run(cut);
        const auto free = plain.coverage();
        const auto first = plain.labels();
        const auto further = plain.labels(2);
        for (const bool both : {false, true}) {
            Bench kept(matter);
            if (both)
                kept.run(protect(1));
            kept.run(protect(2));
            kept.run(cut);
            const auto spared = kept.coverage();
            int inside = 0;
            int outside = 0;
            for (std::size_t i = 0; i < further.values.size(); ++i) {
                const bool isSpared = further.values[i] == 2 || (both && first.values[i] == 1);
                QCOMPARE(int(spared.values[i]), isSpared ? 0 : int(free.values[i]));
                inside += isSpared && free.values[i] >= 128;
                outside += !isSpared && free.values[i] >= 128;
            }
            QVERIFY2(inside > 20 && outside > 60, qPrintable(QString::number(inside)));
            const QByteArray hash = kept.session->stateHash();
            QVERIFY(kept.session->undo() && kept.session->settle());
            const auto undone = kept.coverage();
            QVERIFY(std::all_of(undone.values.begin(), undone.values.end(),
                [](std::uint8_t coverage) { return coverage == 0; }));
            QVERIFY(kept.session->redo() && kept.session->settle());
            QCOMPARE(kept.session->stateHash(), hash);
            // The row names both.
            const auto listed = kept.session->history().rows().back().edit;
            Bench again(matter);
            again.run(listed);
            QVERIFY(again.coverage().values == spared.values);
        }
    }

    /// What a cut read of a further plane holds its row, and older steps keep off that plane.
    void ofAFurtherPlaneItIsReadAndGuarded()
    {
        Bench bench({vessel, above, paintAbove(), protect(2), deepDrill()});
        QCOMPARE(bench.refusal(test::revertRows({3})), ErrorCode::StepsEntangled);
        bench.run(test::revertRows({5}));
        bench.run(test::revertRows({3}));

        Bench deeper({deepDrill(2.0), vessel, above, paintAbove(), protect(2)});
        QCOMPARE(
            deeper.refusal(ReviseStroke{.row = 1, .depthMm = 9.0}), ErrorCode::SegmentProtected);
        deeper.run(protect(2, false));
        deeper.run(ReviseStroke{.row = 1, .depthMm = 9.0});

        const Edit erase = test::eraseAt(2, placeBelow(), 20.0);
        Bench revised(
            {vessel, above, paintAbove(), protect(2), deepDrill(4.0), protect(2, false), erase});
        QCOMPARE(revised.session->document().segment(2)->voxels, 0);
        revised.run(ReviseStroke{.row = 5, .depthMm = 9.0});
        const Bench drawnSo({vessel, above, paintAbove(), protect(2), deepDrill(9.0)});
        QVERIFY(revised.coverage().values == drawnSo.coverage().values);
    }

    /// The edit itself says what it protected: it comes out the same where nothing is protected.
    void theEditNamesWhatItSpares()
    {
        Bench bench({vessel, paintIn(1), protect(1), deepDrill()});
        const Edit drill = bench.session->history().rows().back().edit;
        QCOMPARE(*test::factsOfStroke(drill).protectedSegments, std::vector<int>{1});
        const Bench again({vessel, paintIn(1), drill});
        QVERIFY(again.coverage().values == bench.coverage().values);
        bench.run(protect(1, false));
        bench.run(deepDrill());
        QVERIFY(
            !test::factsOfStroke(bench.session->history().rows().back().edit).protectedSegments);
        QVERIFY(bench.coverage().values != again.coverage().values);
        const Edit unknown =
            test::drillWith({.protectedSegments = std::vector<int>{1, 7}}, deepDrill());
        QCOMPARE(bench.refusal(unknown), ErrorCode::UnknownSegment);
        const Edit idle = test::drillWith({.protectedSegments = std::vector<int>{1}}, restoring());
        QCOMPARE(bench.refusal(idle), ErrorCode::InvalidField);
    }

    /// What was carved before it was protected comes back; what restores, protects nothing.
    void restoringFillsItToo()
    {
        const Edit restore = restoring();
        const std::vector<Edit> edits{vessel, paintIn(1), deepDrill(), restore};
        const std::vector<Edit> guarded{vessel, paintIn(1), deepDrill(), protect(1), restore};
        const Bench bench(guarded);
        QVERIFY(bench.coverage().values == Bench(edits).coverage().values);
        QVERIFY(
            bench.coverage().values != Bench({vessel, paintIn(1), deepDrill()}).coverage().values);
    }

    void segmentsThatAreProtectedBecomeNoLayer()
    {
        Bench bench({vessel, paintIn(1), protect(1)});
        QCOMPARE(
            bench.refusal(SegmentToLayer{.segment = 1, .layer = 1}), ErrorCode::SegmentProtected);
        bench.run(protect(1, false));
        bench.run(SegmentToLayer{.segment = 1, .layer = 1});
    }

    /// A cut that protects segments has read their labels: paint before it cannot go alone.
    void aCutHoldsTheLabelsThatItRead()
    {
        Bench bench({vessel, paintIn(1), protect(1), deepDrill()});
        QCOMPARE(bench.refusal(test::revertRows({2})), ErrorCode::StepsEntangled);
        bench.run(test::revertRows({4}));
        bench.run(test::revertRows({2}));
        // "Undo only" of the cut again: what it read must be there.
        QCOMPARE(bench.refusal(test::revertRows({5})), ErrorCode::StepsEntangled);
        Bench open({vessel, paintIn(1), deepDrill()});
        open.run(test::revertRows({2})); // that one has read nothing of it
    }

    /// A revision finds the labels as they were at its row, whatever has become of them since.
    void aRevisedCutSparesWhatItSpared()
    {
        const Edit erase = test::eraseAt(1, placeBelow(), 20.0);
        Bench bench({vessel, paintIn(1), protect(1), deepDrill(4.0), protect(1, false), erase});
        QCOMPARE(bench.session->document().segment(1)->voxels, 0);
        bench.run(ReviseStroke{.row = 4, .depthMm = 9.0});
        const Bench drawnSo({vessel, paintIn(1), protect(1), deepDrill(9.0)});
        QVERIFY(bench.coverage().values == drawnSo.coverage().values);
        QVERIFY(bench.labels().values != drawnSo.labels().values);
        // And a later cut, that is folded in, protects what it protected.
        Bench two({vessel, paintIn(1), deepDrill(3.0), protect(1), deepDrill(9.0),
            protect(1, false), erase});
        const auto before = two.coverage();
        two.run(ReviseStroke{.row = 3, .depthMm = 4.0});
        two.run(ReviseStroke{.row = 3, .depthMm = 3.0});
        QVERIFY(two.coverage().values == before.values);
    }

    /// Older cuts that come back, or grow deeper, do not cut what is protected by now.
    void whatIsProtectedSinceIsNotCutByOlderSteps()
    {
        const Edit restore = restoring();
        Bench bench({deepDrill(), restore, vessel, paintIn(1), protect(1)});
        QCOMPARE(bench.refusal(test::revertRows({2})), ErrorCode::SegmentProtected);
        bench.run(protect(1, false));
        bench.run(test::revertRows({2}));

        Bench deeper({deepDrill(2.0), vessel, paintIn(1), protect(1)});
        QCOMPARE(
            deeper.refusal(ReviseStroke{.row = 1, .depthMm = 9.0}), ErrorCode::SegmentProtected);
        deeper.run(ReviseStroke{.row = 1, .depthMm = 1.0}); // less is no cut
        deeper.run(protect(1, false));
        deeper.run(ReviseStroke{.row = 1, .depthMm = 9.0});
    }

    /// On from the file: the same state, the same rows, and the flag.
    void isInTheSession()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("protect.burin"));
        QByteArray hash;
        {
            Bench bench({vessel, paintIn(1), protect(1), deepDrill()}, file);
            hash = bench.session->stateHash();
        }
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(opened);
        QVERIFY((*opened)->document().segment(1)->uncarvable);
        QCOMPARE((*opened)->stateHash(), hash);
        QVERIFY((*opened)->undo());
        QVERIFY((*opened)->undo());
        QVERIFY((*opened)->settle());
        QVERIFY(!(*opened)->document().segment(1)->uncarvable);
    }
};

BURIN_TEST(ProtectTest)

} // namespace protectTest

#include "ProtectTest.moc"
