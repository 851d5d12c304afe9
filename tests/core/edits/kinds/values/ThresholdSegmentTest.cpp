// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/growth/ProbedVoxel.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/strokes/StrokeScene.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <set>

namespace thresholdSegmentTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using Mode = ThresholdSegment::Mode;

/// A session with three segments.
struct Bench : test::SessionBench {
    explicit Bench(const LoadedVolume& volume = test::smallStudy())
        : SessionBench(true, volume)
    {
        for (const char* name : {"One", "Two", "Three"})
            run(test::addSegment(name));
    }
    [[nodiscard]] QString lastName() const { return rows().back().name; }
};

std::int64_t voxelsOfValue(double value)
{
    const LoadedVolume study = test::smallStudy();
    return std::count(study.codes.begin(), study.codes.end(), std::uint16_t(value + 1024));
}

/// What becomes of labels, by values and positions as a person would say it.
/// @param locked labels
void carryOut(Labels& labels, const ThresholdSegment& edit, const LoadedVolume& study,
    const std::set<int>& locked)
{
    const glm::ivec3& size = study.volume.geometry.size;
    glm::dvec3 low(-1.0);
    glm::dvec3 high(size);
    if (edit.box) {
        const glm::dvec3 from = study.volume.geometry.toIndex(edit.box->fromLps);
        const glm::dvec3 to = study.volume.geometry.toIndex(edit.box->toLps);
        low = glm::min(from, to) - 0.25; // corners lie at voxels
        high = glm::max(from, to) + 0.25;
    }
    std::size_t place = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++place) {
                const glm::dvec3 at(x, y, z);
                if (glm::any(glm::lessThan(at, low)) || glm::any(glm::greaterThan(at, high)))
                    continue;
                const VoxelEncoding& encoding = study.volume.encoding;
                const double value =
                    encoding.rescaleSlope * study.codes[place] + encoding.rescaleIntercept;
                const bool chosen =
                    value >= edit.lower.value_or(value) && value <= edit.upper.value_or(value);
                std::uint8_t& held = labels[place];
                const bool mayTake = held == 0 || held == edit.segment
                    || (edit.overwriteUnlocked && !locked.contains(held));
                if (chosen && edit.mode != Mode::Subtract && mayTake)
                    held = std::uint8_t(edit.segment);
                else if (held == edit.segment && chosen == (edit.mode == Mode::Subtract)
                    && edit.mode != Mode::Add)
                    held = 0;
            }
        }
    }
}

ThresholdSegment randomThreshold(const LoadedVolume& study, test::Random& random)
{
    ThresholdSegment edit{.segment = 1 + int(random() % 3), .mode = Mode(random() % 3)};
    // Many bounds are values that occur, which belong to the interval.
    const auto bound = [&] {
        const int code = test::randomInt(random, 0, 200);
        const VoxelEncoding& encoding = study.volume.encoding;
        return encoding.rescaleSlope * (code + (random() % 3 == 0 ? 0.5 : 0.0))
            + encoding.rescaleIntercept;
    };
    const double one = bound();
    const double other = bound();
    if (random() % 4)
        edit.lower = std::min(one, other);
    if (random() % 4)
        edit.upper = std::max(one, other);
    edit.overwriteUnlocked = random() % 2;
    if (random() % 3 == 0) {
        const VolumeGeometry& geometry = study.volume.geometry;
        edit.box = GrowBox{geometry.toWorld(glm::dvec3(test::randomVoxel(random, geometry.size))),
            geometry.toWorld(glm::dvec3(test::randomVoxel(random, geometry.size)))};
    }
    return edit;
}

} // namespace

/// A segment made of an interval of values, held to every voxel; undone, replayed, refused; shown
/// while it stands open, and taken back.
class ThresholdSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void everyVoxelByItsValue_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 12; ++number)
            QTest::addRow("%d", number) << number;
    }
    void everyVoxelByItsValue()
    {
        QFETCH(const int, number);
        test::Random random(std::uint32_t(700 + number));
        const glm::ivec3 size(24, 19, 18);
        const Document document = test::randomDocument(size, random, number % 2 == 1);
        LoadedVolume study = test::loaded(document, test::noiseVolume(size, 200, random));
        study.volume.encoding = {
            .rescaleSlope = number % 3 == 0 ? 0.25 : 2.0, .rescaleIntercept = -100.0};
        Bench bench(study);
        std::set<int> locked;
        Labels expected(study.codes.size(), 0);
        for (int step = 0; step < 14; ++step) {
            if (step == 8) {
                locked.insert(3);
                bench.run(test::lockSegment(3));
            }
            const ThresholdSegment edit = randomThreshold(study, random);
            if (locked.contains(edit.segment)) {
                QCOMPARE(bench.refusal(edit), ErrorCode::SegmentLocked);
                continue;
            }
            const std::size_t rows = bench.rows().size();
            const Labels before = expected;
            carryOut(expected, edit, study, locked);
            bench.run(edit);
            QVERIFY2(bench.labels() == expected, qPrintable(bench.lastName()));
            QCOMPARE(bench.rows().size(), expected == before ? rows : rows + 1);
        }
    }

    void whatItSays()
    {
        Bench bench;
        const std::int64_t bone = voxelsOfValue(1000.0);
        const std::int64_t brain = voxelsOfValue(40.0);
        QVERIFY(bone > 1000 && brain > 1000);
        bench.run(ThresholdSegment{.segment = 1, .lower = 226.0});
        QCOMPARE(bench.voxels(1), bone);
        QVERIFY2(bench.lastName().startsWith(QStringLiteral("Threshold 'One' to 226 … 1000 HU, +")),
            qPrintable(bench.lastName()));
        bench.run(ThresholdSegment{.segment = 1, .lower = 0.0, .upper = 100.0});
        QCOMPARE(bench.voxels(1), brain);
        QVERIFY2(bench.lastName().contains(QStringLiteral(" −")), qPrintable(bench.lastName()));
        bench.run(ThresholdSegment{.segment = 1, .lower = 1000.0, .mode = Mode::Add});
        QCOMPARE(bench.voxels(1), bone + brain);
        QVERIFY2(bench.lastName().startsWith(QStringLiteral("Add 1000 … 1000 HU to 'One', +")),
            qPrintable(bench.lastName()));
        bench.run(ThresholdSegment{.segment = 1, .upper = 40.0, .mode = Mode::Subtract});
        QCOMPARE(bench.voxels(1), bone);
        QVERIFY2(
            bench.lastName().startsWith(QStringLiteral("Subtract -1000 … 40 HU from 'One', −")),
            qPrintable(bench.lastName()));
        // Nothing is left to do: no step.
        const std::size_t rows = bench.rows().size();
        bench.run(ThresholdSegment{.segment = 1, .upper = 40.0, .mode = Mode::Subtract});
        bench.run(ThresholdSegment{.segment = 1, .lower = 41.0});
        bench.run(ThresholdSegment{.segment = 2, .lower = 1000.5});
        QCOMPARE(bench.rows().size(), rows);
        // Others keep theirs, unless they are taken.
        bench.run(ThresholdSegment{.segment = 2, .lower = 0.0});
        QCOMPARE(bench.voxels(1), bone);
        QCOMPARE(bench.voxels(2), brain);
        bench.run(ThresholdSegment{.segment = 2, .lower = 500.0, .overwriteUnlocked = true});
        QCOMPARE(bench.voxels(1), std::int64_t(0));
        QCOMPARE(bench.voxels(2), bone);
    }

    /// What is carved away stays as it is, if that is asked for; muted layers carve nothing.
    void onlyWhatIsVisible()
    {
        Bench bench;
        const std::int64_t bone = voxelsOfValue(1000.0);
        ThresholdSegment visible{.segment = 1, .lower = 226.0, .onlyVisible = true};
        bench.run(test::carveAt(test::pointsInBone(), 4.0));
        bench.run(visible);
        const std::int64_t seen = bench.voxels(1);
        QVERIFY(seen > 0 && seen < bone);
        visible.mode = Mode::Subtract;
        visible.lower.reset();
        bench.run(ThresholdSegment{.segment = 1, .lower = 226.0});
        QCOMPARE(bench.voxels(1), bone); // else carved voxels count as all others
        bench.run(visible);
        QCOMPARE(bench.voxels(1), bone - seen);
        bench.run(ChangeLayer{.layer = 1, .muted = true});
        bench.run(visible);
        QCOMPARE(bench.voxels(1), std::int64_t(0));
    }

    void whatCannotBe()
    {
        Bench bench;
        const auto refused = [&bench](ErrorCode code, const ThresholdSegment& edit) {
            QCOMPARE(bench.refusal(edit), code);
            const Result<void> begun = bench.session->begin(edit);
            QVERIFY(!begun && begun.error().code == code);
        };
        refused(ErrorCode::UnknownSegment, {.segment = 9, .lower = 1.0});
        refused(ErrorCode::InvalidField, {.segment = 1, .lower = 2.0, .upper = 1.0});
        const VolumeGeometry& geometry = bench.session->document().volumes.front().geometry;
        refused(ErrorCode::InvalidField,
            {.segment = 1,
                .box = GrowBox{
                    geometry.toWorld({-9.0, 0.0, 0.0}), geometry.toWorld({-2.0, 9.0, 9.0})}});
        bench.run(test::lockSegment(1));
        refused(ErrorCode::SegmentLocked, {.segment = 1, .lower = 1.0});
        QCOMPARE(bench.voxels(1), std::int64_t(0));
    }

    void thereAndBackAndAnew()
    {
        test::Random random(78);
        const LoadedVolume study = test::smallStudy();
        Bench bench;
        std::vector<QByteArray> hashes{bench.session->stateHash()};
        // A growth on the way, whose seed words are taken and given back.
        for (const Edit& edit : {test::seedInBrain(1), test::growBrain(3)}) {
            bench.run(edit);
            hashes.push_back(bench.session->stateHash());
        }
        for (int step = 0; step < 20; ++step) {
            ThresholdSegment edit = randomThreshold(study, random);
            edit.lower = random() % 2 ? 30.0 : -1024.0;
            edit.upper = random() % 2 ? 50.0 : 2000.0;
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            if (bench.rows().size() > rows)
                hashes.push_back(bench.session->stateHash());
        }
        QVERIFY(hashes.size() > 7);
        for (std::size_t back = hashes.size() - 1; back > 0; --back) {
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[back - 1]);
        }
        for (std::size_t on = 1; on < hashes.size(); ++on) {
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[on]);
        }
        reference::ReferenceEngine engine;
        const auto anew = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        for (const HistoryRow& row : bench.rows())
            QVERIFY(anew->apply(row.edit) && anew->settle());
        QCOMPARE(anew->stateHash(), hashes.back());
    }

    /// As a slider is dragged: it stands open, is begun anew, and is a step when it is taken.
    void standsOpen()
    {
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        QVERIFY(session->apply(test::addSegment("One")) && session->settle());
        const QByteArray before = session->stateHash();
        const auto labelInBone = [&] {
            const glm::ivec3 voxel(glm::floor(
                session->document().volumes.front().geometry.toIndex(test::pointsInBone().front())
                + 0.5));
            int label = -1;
            session->questions().probe(
                {voxel}, [&label](const Result<std::vector<ProbedVoxel>>& probes) {
                    label = probes && !probes->empty() ? int(probes->front().label) : -1;
                });
            session->poll();
            return label;
        };
        const ThresholdSegment brain{.segment = 1, .lower = 0.0, .upper = 100.0};
        const ThresholdSegment bone{.segment = 1, .lower = 226.0};
        QVERIFY(!session->isOpen<ThresholdSegment>());
        QVERIFY(session->begin(brain));
        session->poll();
        QVERIFY(session->isOpen<ThresholdSegment>() && session->transactionOpen());
        QVERIFY(!session->isOpen<GrowFromSeeds>());
        QCOMPARE(labelInBone(), 0);
        QVERIFY(session->begin(bone)); // takes the other back
        session->poll();
        QCOMPARE(labelInBone(), 1);
        QCOMPARE(session->history().rows().size(), std::size_t(1));
        session->end(Ending::Rollback);
        QVERIFY(!session->isOpen<ThresholdSegment>() && session->settle());
        QCOMPARE(session->stateHash(), before);
        QCOMPARE(labelInBone(), 0);

        // Whatever else is done takes it back.
        QVERIFY(session->begin(bone));
        session->poll();
        QVERIFY(session->apply(test::renameSegment(1, QStringLiteral("Other"))));
        QVERIFY(!session->isOpen<ThresholdSegment>() && session->settle());
        QCOMPARE(labelInBone(), 0);
        QVERIFY(session->begin(bone));
        QVERIFY(session->undo() && session->settle());
        QCOMPARE(session->stateHash(), before);
        QVERIFY(session->begin(bone) && session->settle()); // settling, too
        QCOMPARE(session->stateHash(), before);

        QVERIFY(session->begin(bone));
        session->end(Ending::Commit);
        QVERIFY(session->settle());
        QCOMPARE(labelInBone(), 1);
        QCOMPARE(session->document().segment(1)->voxels, voxelsOfValue(1000.0));
        const QByteArray taken = session->stateHash();
        QVERIFY(session->undo() && session->settle());
        QCOMPARE(session->stateHash(), before);
        QVERIFY(session->apply(bone) && session->settle());
        QCOMPARE(session->stateHash(), taken);
    }
};

BURIN_TEST(ThresholdSegmentTest)

} // namespace thresholdSegmentTest

#include "ThresholdSegmentTest.moc"
