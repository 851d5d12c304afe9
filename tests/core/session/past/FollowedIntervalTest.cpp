// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/FollowedInterval.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace followedIntervalTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using Mode = ThresholdSegment::Mode;

ThresholdSegment boneOfOne()
{
    return {.segment = 1, .lower = 226.0};
}

ThresholdSegment brainOfOne()
{
    return {.segment = 1, .lower = 0.0, .upper = 100.0};
}

/// A session with three segments.
struct Bench {
    explicit Bench(const QString& file = {})
        : session(*EditSession::create(engine, test::smallStudy(), {.file = file}))
    {
        for (const char* name : {"One", "Two", "Three"})
            run(test::addSegment(name));
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    void undo() { QVERIFY(session->undo() && session->settle()); }
    void redo() { QVERIFY(session->redo() && session->settle()); }
    [[nodiscard]] std::optional<ThresholdSegment> followed(int label = 1) const
    {
        return followedInterval(*session->document().segment(label), session->history());
    }
    [[nodiscard]] Labels labels() { return *session->questions().labels(0); }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }
    /// From one voxel to another.
    [[nodiscard]] GrowBox box(const glm::dvec3& from, const glm::dvec3& to) const
    {
        const VolumeGeometry& geometry = session->document().volumes.front().geometry;
        return {geometry.toWorld(from), geometry.toWorld(to)};
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

/// The labels of a volume in which a segment has all voxels of an interval, and nobody else any.
Labels thresholded(const ThresholdSegment& threshold)
{
    const LoadedVolume study = test::smallStudy();
    Labels labels(study.codes.size(), 0);
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        const double value = double(study.codes[voxel]) - 1024.0;
        if (value >= threshold.lower.value_or(value) && value <= threshold.upper.value_or(value))
            labels[voxel] = std::uint8_t(threshold.segment);
    }
    return labels;
}

bool changed(const Labels& before, const Labels& after, int label)
{
    for (std::size_t voxel = 0; voxel < before.size(); ++voxel) {
        if ((before[voxel] == label) != (after[voxel] == label))
            return true;
    }
    return false;
}

/// Whether all voxels of a label are of an interval.
bool lies(
    const Labels& labels, int label, const ThresholdSegment& interval, const LoadedVolume& study)
{
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        const double value = double(study.codes[voxel]) - 1024.0;
        if (labels[voxel] == label && (value < *interval.lower || value > *interval.upper))
            return false;
    }
    return true;
}

/// By label, from 1; which row each of three segments follows.
using Followed = std::array<RowId, 4>;

/// Who follows what after a row, by what labels were and are.
Followed expectedAfter(const HistoryRow& row, const History& history, Followed known,
    const Labels& before, const Labels& after)
{
    const auto* threshold = row.edit.as<ThresholdSegment>();
    for (int label = 1; label <= 3; ++label) {
        RowId& follows = known[std::size_t(label)];
        bool givesAll =
            threshold && threshold->segment == label && threshold->mode == Mode::Replace;
        if (givesAll && threshold->box) {
            const bool wasEmpty = std::count(before.begin(), before.end(), label) == 0;
            givesAll = wasEmpty
                || (follows != 0
                    && history.row(follows).edit.get<ThresholdSegment>().box == threshold->box);
        }
        if (givesAll)
            follows = row.id;
        else if (changed(before, after, label))
            follows = 0;
    }
    return known;
}

Edit randomEdit(const Bench& bench, test::Random& random)
{
    const int label = test::randomInt(random, 1, 3);
    const std::vector<glm::dvec3> points =
        test::randomInt(random, 0, 1) == 0 ? test::pointsInBrain() : test::pointsInBone();
    switch (test::randomInt(random, 0, 6)) {
    case 0:
        return test::paintAt(label, points, 2.5);
    case 1:
        return test::paintOverAt(label, points, 2.5);
    case 2:
        return test::eraseAt(label, points, 2.5);
    default:
        break;
    }
    ThresholdSegment edit{.segment = label};
    const std::array<std::pair<double, double>, 4> intervals{
        {{226.0, 1000.0}, {0.0, 100.0}, {40.0, 1000.0}, {-1000.0, -900.0}}};
    const auto [lower, upper] = intervals[std::size_t(test::randomInt(random, 0, 3))];
    edit.lower = lower;
    edit.upper = upper;
    if (test::randomInt(random, 0, 3) == 0)
        edit.mode = test::randomInt(random, 0, 1) == 0 ? Mode::Add : Mode::Subtract;
    edit.overwriteUnlocked = test::randomInt(random, 0, 1) == 0;
    if (test::randomInt(random, 0, 2) == 0)
        edit.box = bench.box({5.0, 5.0, 5.0}, {30.0, 30.0, 28.0});
    return edit;
}

} // namespace

/// A segment that was made by an interval follows it until anything else changes its voxels; held
/// to what the labels of every voxel were and are.
class FollowedIntervalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// What changes none of its voxels leaves it.
    void itFollowsMeanwhile()
    {
        Bench bench;
        QVERIFY(!bench.followed());
        bench.run(boneOfOne());
        QVERIFY(bench.followed() == boneOfOne());
        const RowId row = bench.session->history().position();
        QVERIFY(bench.lastRow().statistics.followsInterval);
        for (const Edit& edit : std::vector<Edit>{test::renameSegment(1, QStringLiteral("Bone")),
                 test::lockSegment(1), test::lockSegment(1, false),
                 test::carveAt(test::pointsInBone()), test::paintAt(2, test::pointsInBrain())}) {
            const RowId before = bench.session->history().position();
            bench.run(edit);
            QCOMPARE(bench.session->history().position(), before + 1);
            QCOMPARE(bench.session->document().segment(1)->followsRow, row);
            QVERIFY(!bench.followed(2));
            QVERIFY(bench.lastRow().statistics.intervalsLeft.empty());
        }
        // Nor does a threshold that is shown and taken back.
        QVERIFY(bench.session->begin(brainOfOne()));
        bench.session->end(Ending::Rollback);
        QVERIFY(bench.session->settle());
        QVERIFY(bench.followed() == boneOfOne());
        bench.run(RemoveSegment{.segment = 1});
        QVERIFY(bench.lastRow().statistics.intervalsLeft.empty());
        bench.undo();
        QVERIFY(bench.followed() == boneOfOne());
    }

    void whatEndsIt_data()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const char* name : {"erased", "painted", "painted over", "added", "subtracted",
                 "taken by another", "only in a box"})
            QTest::newRow(name) << number++;
    }
    void whatEndsIt()
    {
        QFETCH(const int, number);
        Bench bench;
        ThresholdSegment add = brainOfOne();
        add.mode = Mode::Add;
        ThresholdSegment subtract = boneOfOne();
        subtract.mode = Mode::Subtract;
        ThresholdSegment boxed = brainOfOne();
        boxed.box = bench.box({5.0, 5.0, 5.0}, {20.0, 20.0, 20.0});
        const std::vector<Edit> ends{test::eraseAt(1, test::pointsInBone()),
            test::paintAt(1, test::pointsInBrain()), test::paintOverAt(2, test::pointsInBone()),
            add, subtract,
            ThresholdSegment{.segment = 2, .lower = 500.0, .overwriteUnlocked = true}, boxed};
        bench.run(boneOfOne());
        bench.run(ends.at(std::size_t(number)));
        QVERIFY(!bench.followed());
        QCOMPARE(bench.session->document().segment(1)->followsRow, RowId(0));
        QCOMPARE(bench.lastRow().statistics.intervalsLeft, (std::vector<int>{1}));
        bench.undo();
        QVERIFY(bench.followed() == boneOfOne());
        bench.redo();
        QVERIFY(!bench.followed());
        // Worked out anew, it follows again.
        bench.run(brainOfOne());
        QVERIFY(bench.followed() == brainOfOne());
    }

    /// One row takes the place of what the interval gave, and undo gives it back.
    void aMovedIntervalIsInItsPlace()
    {
        Bench bench;
        bench.run(boneOfOne());
        QVERIFY(bench.labels() == thresholded(boneOfOne()));
        const QByteArray bone = bench.session->stateHash();
        const std::size_t rows = bench.session->history().rows().size();
        bench.run(brainOfOne());
        QCOMPARE(bench.session->history().rows().size(), rows + 1);
        QVERIFY(bench.labels() == thresholded(brainOfOne()));
        QVERIFY(bench.followed() == brainOfOne());
        QVERIFY(bench.lastRow().statistics.intervalsLeft.empty());
        const QByteArray brain = bench.session->stateHash();
        bench.undo();
        QCOMPARE(bench.session->stateHash(), bone);
        QVERIFY(bench.followed() == boneOfOne());
        bench.redo();
        QCOMPARE(bench.session->stateHash(), brain);
        QVERIFY(bench.followed() == brainOfOne());

        // Who follows what is no part of the hash, and comes to the same by the same edits.
        reference::ReferenceEngine engine;
        const auto anew = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        for (const HistoryRow& row : bench.session->history().rows())
            QVERIFY(anew->apply(row.edit) && anew->settle());
        QCOMPARE(anew->stateHash(), brain);
        QCOMPARE(anew->document().segment(1)->followsRow,
            bench.session->document().segment(1)->followsRow);
    }

    /// Within limits an interval is followed if they keep nothing that came otherwise.
    void limits()
    {
        Bench bench;
        ThresholdSegment boxed = boneOfOne();
        boxed.box = bench.box({5.0, 5.0, 5.0}, {20.0, 20.0, 20.0});
        bench.run(boxed);
        QVERIFY(bench.followed() && bench.followed()->box); // it was empty
        boxed = *bench.followed();
        boxed.lower = 0.0;
        bench.run(boxed);
        QVERIFY(bench.followed() == boxed); // the same box
        boxed.box = bench.box({15.0, 15.0, 15.0}, {30.0, 30.0, 28.0});
        boxed.lower = 500.0;
        bench.run(boxed);
        QVERIFY(!bench.followed()); // it has voxels of both
        QCOMPARE(bench.lastRow().statistics.intervalsLeft, (std::vector<int>{1}));
    }

    /// It is in the file, and for every position of the history.
    void itIsThereInAReopenedSession()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("followed.burin"));
        {
            Bench bench(file);
            bench.run(boneOfOne());
            bench.run(test::paintAt(2, test::pointsInBrain()));
            bench.run(test::eraseAt(1, test::pointsInBone()));
            bench.undo();
        }
        reference::ReferenceEngine engine;
        const auto again = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(again);
        const auto followed = [&again] {
            return followedInterval(*(*again)->document().segment(1), (*again)->history());
        };
        QVERIFY(followed() == boneOfOne());
        QVERIFY((*again)->redo() && (*again)->settle());
        QVERIFY(!followed());
        QVERIFY((*again)->undo() && (*again)->settle());
        QVERIFY(followed() == boneOfOne());
    }

    /// Whatever is done in whatever order, with undo and branches.
    void randomHistories()
    {
        int following = 0;
        int ended = 0;
        const LoadedVolume study = test::smallStudy();
        for (std::uint32_t seed = 0; seed < 3; ++seed) {
            test::Random random(1900 + seed);
            Bench bench;
            const History& history = bench.session->history();
            const RowId first = history.position();
            std::map<RowId, Followed> known{{first, Followed{}}};
            Labels labels = bench.labels();
            for (int step = 0; step < 30; ++step) {
                const RowId before = history.position();
                const std::size_t rows = history.rows().size();
                const int walk = test::randomInt(random, 0, 7);
                if (walk == 0 && before != first)
                    bench.undo();
                else if (walk == 1 && history.canRedo())
                    bench.redo();
                else
                    bench.run(randomEdit(bench, random));
                const Labels after = bench.labels();
                if (history.rows().size() > rows) {
                    known[history.position()] =
                        expectedAfter(bench.lastRow(), history, known.at(before), labels, after);
                    ended += bench.lastRow().statistics.intervalsLeft.empty() ? 0 : 1;
                }
                labels = after;
                for (int label = 1; label <= 3; ++label) {
                    QCOMPARE(bench.session->document().segment(label)->followsRow,
                        known.at(history.position())[std::size_t(label)]);
                    const std::optional<ThresholdSegment> interval = bench.followed(label);
                    if (!interval)
                        continue;
                    ++following;
                    // All that it has is of the interval.
                    QVERIFY(lies(labels, label, *interval, study));
                }
            }
        }
        QVERIFY2(following > 20, qPrintable(QString::number(following)));
        QVERIFY2(ended > 3, qPrintable(QString::number(ended)));
    }
};

BURIN_TEST(FollowedIntervalTest)

} // namespace followedIntervalTest

#include "FollowedIntervalTest.moc"
