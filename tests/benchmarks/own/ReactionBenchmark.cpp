// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/ReactionBenchmark.h"

#include "core/demo/DemoStudy.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SessionChunks.h"
#include "tests/benchmarks/common/Desk.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/benchmarks/itk/GrowBenchmark.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QThread>

#include <algorithm>

namespace bench {

namespace {

constexpr gpu::ViewId stage = Desk::stage;
constexpr gpu::ViewId firstSlice = Desk::firstSlice;
constexpr int ticks = 24;
constexpr int rounds = 5;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Tells an edit in pieces, which leaves a row, and measures each. What the pieces show is compared
/// with the whole of it first, and then taken back.
/// @param told begins the edit and its first part, which is not measured
/// @param piece tells the next one; pieces that nothing follows from do not count
/// @return why the results are not right
QString measurePieces(PeerReport& report, Desk& desk, const char* id,
    const std::function<bool()>& told, const std::function<void(int)>& piece)
{
    const QString name = QString::fromLatin1(id);
    const Seen before = desk.seen();
    std::vector<double> times;
    const auto tell = [&] {
        times.clear();
        desk.move(true);
        if (!told())
            return false;
        desk.views().rest();
        for (int number = 0; number < ticks; ++number) {
            const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
            const std::optional<double> time =
                desk.views().untilSeen([&] { piece(number); }, {stage}, std::chrono::seconds(2));
            if (time) {
                RowTimes::took(id, begin, *time);
                times.push_back(*time);
            }
            desk.views().rest();
        }
        return desk.end();
    };
    // The first time compiles, too.
    if (!tell())
        return name + QStringLiteral(": refused");
    const Seen inPieces = desk.seen();
    const core::Edit whole = desk.lastEdit();
    if (inPieces == before || !desk.undo() || desk.seen() != before)
        return name + QStringLiteral(": undo leads elsewhere");
    if (!desk.apply(whole) || desk.seen() != inPieces)
        return name + QStringLiteral(": the whole is another than its pieces");
    if (!desk.undo() || !tell() || desk.seen() != inPieces)
        return name + QStringLiteral(": the second time is another than the first");
    if (times.size() < ticks / 2)
        return name + QStringLiteral(": only %1 pictures").arg(times.size());
    report.add({id, "Ms", median(times)});
    return {};
}

QString measureDrill(PeerReport& report, Desk& desk)
{
    std::vector<core::PenSample> samples;
    for (int tick = 0; tick <= ticks; ++tick)
        samples.push_back(
            {.xMm = 2.0 * tick - ticks, .yMm = 20.0, .pressure = 1.0, .tSeconds = tick / 60.0});
    const core::Edit stroke =
        test::drillWith({.view = core::OrthographicView{.eyeLps = {0.0, -430.0, 0.0},
                             .targetLps = {0.0, 0.0, 0.0},
                             .up = {0.0, 0.0, 1.0},
                             .heightMm = 240.0},
            .radiusMm = 6.0,
            .depthMm = 8.0,
            .surfaceThreshold = 200.0,
            .samples = samples});
    core::EditSession& session = desk.session();
    if (const QString why = measurePieces(
            report, desk, "frame.moving.drill",
            [&] {
                if (!session.begin(test::begunStroke(stroke)))
                    return false;
                session.extend(core::PenSamples{.samples = {samples.front()}});
                return true;
            },
            [&](int number) {
                session.extend(core::PenSamples{.samples = {samples[std::size_t(number) + 1]}});
            });
        !why.isEmpty())
        return why;

    const Seen drilled = desk.seen();
    std::vector<double> undoMs;
    std::vector<double> redoMs;
    for (int round = 0; round < rounds; ++round) {
        for (const bool back : {true, false}) {
            core::Result<void> asked;
            const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
            const std::optional<double> time = desk.views().untilSeen(
                [&] { asked = back ? session.undo() : session.redo(); }, {stage});
            if (!asked || !time || !session.settle())
                return QStringLiteral("history.drill.undo.picture: no picture");
            RowTimes::took(
                back ? "history.drill.undo.picture" : "history.drill.redo.picture", begin, *time);
            (back ? undoMs : redoMs).push_back(*time);
            desk.views().rest();
        }
    }
    if (desk.seen() != drilled)
        return QStringLiteral("history.drill.undo.picture: the way leads elsewhere");
    report.add({"history.drill.undo.picture", "Ms", median(undoMs)});
    report.add({"history.drill.redo.picture", "Ms", median(redoMs)});
    return {};
}

QString measureGrow(PeerReport& report, Desk& desk, const glm::dvec3& bone)
{
    if (!desk.apply(test::newSegment(QStringLiteral("Bone"), 0x59C07A))
        || !desk.apply(test::seedAt(1, {bone})))
        return QStringLiteral("frame.moving.grow: no seed");
    core::EditSession& session = desk.session();
    return measurePieces(
        report, desk, "frame.moving.grow",
        [&] {
            if (!session.begin(test::growBetween(300.0, 3000.0, 20)))
                return false;
            session.extend(core::GrowAdvance{.steps = 20});
            return true;
        },
        [&](int) { session.extend(core::GrowAdvance{.steps = 4}); });
}

/// The head, from the front and a little from above and from the side.
QString measureHead(PeerReport& report)
{
    const auto demo = core::makeDemoStudy({});
    if (!demo)
        return QStringLiteral("frame.moving: no demonstration study");
    core::LoadedVolume study;
    study.volume.geometry = demo->geometry;
    study.volume.encoding.rescaleIntercept = -1024.0;
    study.volume.unit = QStringLiteral("HU");
    study.codes = demoCodes(*demo);
    gpu::VolumeScene scene;
    scene.eyeLps = {-60.0, -430.0, 110.0};
    scene.heightMm = 240.0;
    scene.surfaceThreshold = 200.0;
    const auto desk = Desk::open(study, scene, glm::dvec3(0.0));
    if (!desk)
        return QStringLiteral("frame.moving: no engine");
    // The bone that a line from the front meets.
    const glm::ivec3 size = demo->geometry.size;
    glm::ivec3 bone(size.x / 2, 0, size.z / 2);
    const auto valueAt = [&](const glm::ivec3& at) {
        return demo->hounsfield[std::size_t((at.z * size.y + at.y) * size.x + at.x)];
    };
    while (bone.y < size.y - 1 && valueAt(bone) < 500)
        ++bone.y;
    if (const QString why = measureDrill(report, *desk); !why.isEmpty())
        return why;
    return measureGrow(report, *desk, demo->geometry.toWorld(glm::dvec3(bone)));
}

/// Two balls in noise, one of them a segment; a click on the other.
QString measureChunkClick(PeerReport& report)
{
    constexpr int side = 96;
    constexpr glm::dvec3 other(66.0, 50.0, 48.0);
    core::LoadedVolume study;
    study.volume.geometry.size = glm::ivec3(side);
    study.volume.maximum = 65535.0;
    test::Random random(5);
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::dvec3 at(x, y, z);
                const bool tissue = glm::distance(at, glm::dvec3(36, 46, 48)) < 22.0
                    || glm::distance(at, other) < 14.0;
                study.codes.push_back(
                    std::uint16_t(1000 + (tissue ? 200 : 0) + test::randomInt(random, -60, 60)));
            }
        }
    }
    gpu::VolumeScene scene;
    scene.targetLps = glm::dvec3(side / 2);
    scene.eyeLps = scene.targetLps + glm::dvec3(-60.0, -430.0, 110.0);
    scene.heightMm = 120.0;
    scene.surfaceThreshold = 60000.0; // segments only
    const auto desk = Desk::open(study, scene, other);
    if (!desk)
        return QStringLiteral("refine.chunks.click.picture: no engine");
    core::EditSession& session = desk->session();
    if (!desk->apply(test::newSegment(QStringLiteral("A"), 0x59C07A))
        || !desk->apply(test::paintAt(1, {glm::dvec3(36.0, 46.0, 48.0)}, 22.0))
        || !desk->apply(core::DivideSegment{.segment = 1, .marginMm = 25.0}))
        return QStringLiteral("refine.chunks.click.picture: no chunks");
    while (!session.chunks().map()) {
        if (session.chunks().whyNot())
            return QStringLiteral("refine.chunks.click.picture: chunks were refused");
        desk->engine().edits().finish();
        session.poll();
        QThread::msleep(1);
    }
    const core::ChunkToggle click{.segment = 1, .chunks = 40, .pointsLps = {other}};
    const Seen without = desk->seen();
    const std::int64_t voxels = session.document().segment(1)->voxels;
    if (!desk->apply(click) || session.document().segment(1)->voxels < voxels + 1000)
        return QStringLiteral("refine.chunks.click.picture: the chunk did not come");
    const Seen with = desk->seen();
    if (with == without || !desk->apply(click) || desk->seen().stage != without.stage)
        return QStringLiteral("refine.chunks.click.picture: the chunk did not go");
    std::vector<double> times;
    for (int round = 0; round < 2 * rounds; ++round) {
        core::Result<void> asked;
        const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
        const std::optional<double> time =
            desk->views().untilSeen([&] { asked = session.apply(click); },
                {stage, firstSlice, firstSlice + 1, firstSlice + 2});
        if (!asked || !time || !session.settle())
            return QStringLiteral("refine.chunks.click.picture: no picture");
        RowTimes::took("refine.chunks.click.picture", begin, *time);
        times.push_back(*time);
        desk->views().rest();
    }
    if (desk->seen().stage != without.stage)
        return QStringLiteral("refine.chunks.click.picture: clicks lead elsewhere");
    report.add({"refine.chunks.click.picture", "Ms", median(times)});
    return {};
}

} // namespace

QString measureReactions(PeerReport& report)
{
    for (const auto measure : {measureHead, measureChunkClick}) {
        if (const QString why = measure(report); !why.isEmpty())
            return why;
    }
    return {};
}

} // namespace bench
