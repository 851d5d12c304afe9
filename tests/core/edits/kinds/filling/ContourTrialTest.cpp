// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/ContourTrial.h"
#include "core/contour/ContourRule.h"
#include "core/contour/ContourWatch.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/sculpt/labels/HeldVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/MemoryLimit.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace contourTrialTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;

LoadedVolume noisyHead()
{
    LoadedVolume study = test::smallStudy();
    std::mt19937 random(11);
    for (std::uint16_t& code : study.codes)
        code = std::uint16_t(std::max(0, int(code) - 150 + int(random() % 301)));
    return study;
}

/// Three segments in noise: Organ is a ball, Other touches it, Locked does so and is locked.
struct Bench {
    Bench()
        : session(*EditSession::create(engine, study, {.file = {}}))
    {
        for (const char* name : {"Organ", "Other", "Locked"})
            done(test::addSegment(name));
        done(test::paintAt(1, {at({20.0, 18.0, 16.0})}, 4.0));
        done(test::paintAt(2, {at({26.0, 18.0, 16.0})}, 3.0));
        done(test::paintAt(3, {at({20.0, 23.0, 16.0})}, 3.0));
        done(test::lockSegment(3));
    }
    void done(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& index) const
    {
        return study.volume.geometry.toWorld(index);
    }
    [[nodiscard]] Labels labels() { return *session->questions().labels(0); }

    LoadedVolume study = noisyHead();
    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

/// What a window has of a contour.
struct Watched {
    ContourTrack track;
    ContourState state; ///< at the generation that the track shows
    void goTo(int generation)
    {
        state.pass(track.between(track.shown(), generation));
        track.goTo(generation);
    }
};

/// What a window would make of an edit, by way of a ground for all its generations.
std::optional<Watched> watchedOf(const EvolveContour& edit, Bench& bench)
{
    const Document& document = bench.session->document();
    const Labels labels = bench.labels();
    const std::vector<LabelPlane> planes{{.plane = 0, .labels = labels}};
    const auto read = contourPlanes(edit, document);
    if (!read || *read != std::set<std::uint8_t>{0})
        return std::nullopt;
    Result<ContourGround> ground = trialGround(edit, document, planes);
    const Result<ContourRule> rule = contourRule(edit, document);
    if (!ground || !rule)
        return std::nullopt;
    const glm::ivec3 size = ground->volumeSize;
    for (int z = ground->box.minimum.z; z < ground->box.maximum.z; ++z) {
        for (int y = ground->box.minimum.y; y < ground->box.maximum.y; ++y) {
            for (int x = ground->box.minimum.x; x < ground->box.maximum.x; ++x)
                ground->codes.push_back(
                    bench.study.codes[std::size_t((z * size.y + y) * size.x + x)]);
        }
    }
    if (!holdUneditable(edit, document, planes, *ground))
        return std::nullopt;
    std::optional<Watched> watched;
    const ContourReports reports{.begun =
                                     [&](const std::shared_ptr<ContourTrack>& track,
                                         const std::shared_ptr<const ContourState>& state) {
                                         watched = Watched{*track, *state};
                                     },
        .further =
            [&](std::vector<ContourGeneration> generations) {
                for (ContourGeneration& each : generations)
                    watched->track.append(std::move(each));
            }};
    const ContourEnd end = watchContour(*rule, *ground,
        {.generations = edit.generations, .silent = 1, .bytes = allowedBytes()}, Progress(),
        reports);
    if (end == ContourEnd::OutOfMemory)
        return std::nullopt;
    return watched;
}

std::vector<bool> shownBy(const ContourState& state, const glm::ivec3& size)
{
    std::vector<bool> shown;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                shown.push_back(state.isInside({x, y, z}));
        }
    }
    return shown;
}

} // namespace

class ContourTrialTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// At each generation: the voxels that the edit writes for it, whatever may not change.
    void everyGenerationIsWhatIsWritten_data()
    {
        QTest::addColumn<bool>("bubble");
        QTest::addColumn<bool>("over");
        QTest::addColumn<int>("range"); // which editable range
        QTest::addColumn<bool>("erase");
        for (const bool bubble : {false, true}) {
            for (int range = 0; range < 6; ++range) {
                for (const bool over : {false, true})
                    QTest::addRow(
                        "bubble %d, over others %d, range %d", int(bubble), int(over), range)
                        << bubble << over << range << false;
                QTest::addRow("bubble %d, erasing, range %d", int(bubble), range)
                    << bubble << false << range << true;
            }
        }
    }
    void everyGenerationIsWhatIsWritten()
    {
        QFETCH(const bool, bubble);
        QFETCH(const bool, over);
        QFETCH(const int, range);
        QFETCH(const bool, erase);
        Bench bench;
        EvolveContour edit{.segment = 1,
            .lower = -200.0,
            .upper = 300.0,
            .softness = 120.0,
            .edge = 40,
            .edgeGradient = 200.0,
            .smoothness = 45,
            .generations = 12,
            .overwriteUnlocked = over};
        if (bubble) {
            edit.bubbleLps = bench.at(erase ? glm::dvec3(20.0, 18.0, 16.0) // in the segment
                                            : glm::dvec3(22.0, 19.0, 19.0));
            edit.bubbleMm = erase ? 1.6 : 4.1;
        }
        if (erase)
            edit.erase = true;
        const std::optional<EditableRange> ranges[] = {std::nullopt,
            EditableRange{.lower = -60.0, .upper = 130.0},
            EditableRange{
                .box = GrowBox{bench.at({16.0, 10.0, 8.0}), bench.at({27.0, 20.0, 20.0})}},
            EditableRange{.inside = std::vector<int>{1, 2}},
            EditableRange{.outside = std::vector<int>{2}},
            EditableRange{.inside = std::vector<int>{}}};
        edit.editable = ranges[range];
        edit = quantised(edit).get<EvolveContour>();
        std::optional<Watched> watched = watchedOf(edit, bench);
        QVERIFY(watched);
        const ContourTrack& track = watched->track;
        QVERIFY(track.known() >= 3);
        QVERIFY(!erase || track.gained() == 0);
        const Labels before = bench.labels();
        for (const int generation : {1, 2, 3, track.known()}) {
            watched->goTo(generation);
            EvolveContour one = edit;
            one.generations = generation;
            const std::size_t rows = bench.session->history().rows().size();
            bench.done(one);
            const Labels after = bench.labels();
            std::vector<bool> has;
            for (const std::uint8_t label : after)
                has.push_back(label == 1);
            QVERIFY(shownBy(watched->state, bench.study.volume.geometry.size) == has);
            const auto owned = [](const Labels& labels) {
                return std::int64_t(std::count(labels.begin(), labels.end(), 1));
            };
            QCOMPARE(track.gained() - track.lost(), owned(after) - owned(before));
            if (range == 5)
                QVERIFY(after == before); // nothing may change
            else if (bench.session->history().rows().size() > rows)
                QVERIFY(bench.session->undo() && bench.session->settle());
            QVERIFY(bench.labels() == before);
        }
    }

    void whatCannotBeIsRefused()
    {
        Bench bench;
        const Document& document = bench.session->document();
        const Labels labels = bench.labels();
        const std::vector<LabelPlane> planes{{.plane = 0, .labels = labels}};
        const auto refusal = [&](const EvolveContour& edit) {
            const auto ground = trialGround(edit, document, planes);
            const auto read = contourPlanes(edit, document);
            return ground || read || ground.error().code != read.error().code ? ErrorCode::Internal
                                                                              : ground.error().code;
        };
        QVERIFY(refusal({.segment = 3}) == ErrorCode::SegmentLocked);
        QVERIFY(refusal({.segment = 9}) == ErrorCode::UnknownSegment);
        QVERIFY(refusal({.segment = 1, .lower = 5.0, .upper = 4.0}) == ErrorCode::InvalidField);
        QVERIFY(refusal({.segment = 1, .editable = EditableRange{.inside = std::vector<int>{7}}})
            == ErrorCode::UnknownSegment);
        // A segment without voxels has no ground.
        bench.done(test::addSegment("Empty"));
        const auto ground = trialGround({.segment = 4}, bench.session->document(), planes);
        QVERIFY(ground && ground->box.empty());
    }
};

BURIN_TEST(ContourTrialTest)

} // namespace contourTrialTest

#include "ContourTrialTest.moc"
