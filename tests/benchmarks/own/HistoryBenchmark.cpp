// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/HistoryBenchmark.h"

#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/TorsoVolume.h"
#include "tests/benchmarks/own/SessionDriver.h"
#include "tests/benchmarks/own/WholeImageUndo.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/TypicalStrokes.h"
#include "ui/base/ErrorText.h"

#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <numeric>

namespace bench {

namespace {

using Voxels = std::vector<std::uint8_t>;

constexpr int strokeCount = 20;
constexpr int dabs = 60; ///< half a second of a pen

core::Edit liverGrowth()
{
    return test::growBetween(TorsoVolume::lowerHu, TorsoVolume::upperHu);
}

/// Along a curve of about 60 mm through the liver.
core::Edit seedStroke()
{
    std::vector<glm::dvec3> pointsLps;
    for (int i = 0; i < dabs; ++i)
        pointsLps.push_back(TorsoVolume::liverLps()
            + glm::dvec3(i - dabs / 2, 6.0 * std::sin(0.15 * i), 4.0 * std::sin(0.1 * i)));
    return test::seedAt(1, std::move(pointsLps));
}

/// From the front into the belly, with the tool's usual radius and depth: a curve of 60 mm.
core::Edit drillStroke(int number)
{
    const glm::dvec3 target((number % 5 - 2) * 45.0, 0.0, (number / 5 - 2) * 90.0 + 40.0);
    const core::OrthographicView view{.eyeLps = target - glm::dvec3(0.0, 600.0, 0.0),
        .targetLps = target,
        .up = {0.0, 0.0, 1.0},
        .heightMm = 400.0};
    std::vector<core::PenSample> samples;
    for (int i = 0; i < dabs; ++i)
        samples.push_back({.xMm = double(i) - dabs / 2,
            .yMm = 8.0 * std::sin(0.12 * i + number),
            .pressure = 0.6 + 0.4 * std::sin(0.05 * i),
            .tSeconds = i / 120.0});
    return test::drillWith({.view = view, .surfaceThreshold = -350.0, .samples = samples});
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Both fields, as a peer would have to keep them.
struct State {
    Voxels labels;
    Voxels coverage;
    bool operator==(const State&) const = default;
};

/// A kind of step whose last one is weighed and timed. Another one needs a stroke in work() and a
/// line in kinds().
struct Kind {
    const char* name;
    core::RowId row = 0;
    /// The field that it changes, and all there is after it, for the peers to keep; none: no peer.
    const Voxels* before = nullptr;
    const Voxels* after = nullptr;
    const Voxels* labels = nullptr;
    const Voxels* coverage = nullptr;
};

/// The scenario: a segment, a seed stroke, a liver, a paint stroke, twenty drill strokes; then back
/// and forth.
class Scenario {
public:
    Scenario(gpu::GpuEngine& engine, PeerReport& report)
        : m_engine(engine)
        , m_report(report)
    {
    }

    QString run()
    {
        if (!m_folder.isValid())
            return QStringLiteral("no temporary folder");
        std::fprintf(stderr, "history: making 512 x 512 x 600 voxels\n");
        m_volume = TorsoVolume::make();
        m_driver = SessionDriver::create(m_engine.edits(), m_volume, file());
        if (!m_driver)
            return QStringLiteral("no session");
        for (const auto step : {&Scenario::work, &Scenario::walkAndCompare, &Scenario::timeWalks,
                 &Scenario::reopen, &Scenario::close}) {
            if (const QString why = (this->*step)(); !why.isEmpty())
                return why;
        }
        return {};
    }

private:
    QString file() const { return m_folder.filePath(QStringLiteral("bench.burin")); }
    State state()
    {
        return {m_driver->dense(core::Field::Labels, 0), m_driver->dense(core::Field::Coverage, 1)};
    }

    QString work()
    {
        SessionDriver& session = *m_driver;
        session.apply(test::newSegment(QStringLiteral("Liver"), 0xB04030));
        session.apply(seedStroke());
        m_seedRow = session.lastRow();
        m_beforeGrowth = state();
        const SessionDriver::Commit growth = session.apply(liverGrowth());
        m_growthRow = session.lastRow();
        const auto litres = double(session.history().row(m_growthRow).statistics.voxelsChanged)
            * 0.75 * 0.75 * 1.0 / 1e6;
        std::fprintf(stderr, "history: grew %.2f L in %.0f ms\n", litres, growth.wallMs);
        if (litres < 1.2 || litres > 1.8)
            return QStringLiteral("history: the liver has %1 L").arg(litres);
        m_report.add({"history.growth.held", "Ms", growth.longestCallMs()});

        m_beforePaint = state();
        session.apply(test::newSegment(QStringLiteral("Lesion"), 0x40B030));
        session.apply(test::typicalPaintStroke(
            2, glm::dvec3(-TorsoVolume::liverLps().x, 0.0, 60.0), core::BrushPath::Shape::Ball));
        m_paintRow = session.lastRow();
        m_afterPaint = state();

        std::vector<double> longest;
        std::vector<double> sums;
        for (int number = 0; number < strokeCount; ++number) {
            if (number == strokeCount - 1)
                m_beforeDrill = state();
            const SessionDriver::Commit commit = session.stroke(drillStroke(number));
            longest.push_back(commit.longestCallMs());
            sums.push_back(std::accumulate(commit.callsMs.begin(), commit.callsMs.end(), 0.0));
        }
        m_drillRow = session.lastRow();
        m_afterDrill = state();
        if (session.history().rows().size() != strokeCount + 5)
            return QStringLiteral("history: a stroke changed nothing");
        m_heldMs = median(longest);
        m_report.add(
            {"history.drill.held.worst", "Ms", *std::max_element(longest.begin(), longest.end())});
        m_report.add({"history.drill.held.sum", "Ms", median(sums)});
        return session.problem();
    }

    std::vector<Kind> kinds() const
    {
        return {{.name = "drill",
                    .row = m_drillRow,
                    .before = &m_beforeDrill.coverage,
                    .after = &m_afterDrill.coverage,
                    .labels = &m_afterDrill.labels,
                    .coverage = &m_afterDrill.coverage},
            {.name = "growth",
                .row = m_growthRow,
                .before = &m_beforeGrowth.labels,
                .after = &m_beforePaint.labels,
                .labels = &m_beforePaint.labels,
                .coverage = &m_beforeGrowth.coverage},
            {.name = "paint",
                .row = m_paintRow,
                .before = &m_beforePaint.labels,
                .after = &m_afterPaint.labels,
                .labels = &m_afterPaint.labels,
                .coverage = &m_afterPaint.coverage},
            {.name = "seeds", .row = m_seedRow}};
    }

    /// Nothing is timed before this holds.
    QString walkAndCompare()
    {
        SessionDriver& session = *m_driver;
        const QByteArray hash = session.hash();
        const auto same = [this](const State& expected) { return state() == expected; };
        session.undo();
        if (!same(m_beforeDrill)
            || session.hash() != session.history().row(m_drillRow - 1).stateHash)
            return QStringLiteral("history: undo of a stroke leads elsewhere");
        session.redo();
        if (!same(m_afterDrill) || session.hash() != hash)
            return QStringLiteral("history: redo of a stroke leads elsewhere");
        session.goTo(m_paintRow);
        session.undo();
        if (!same(m_beforePaint))
            return QStringLiteral("history: undo of paint leads elsewhere");
        session.goTo(m_growthRow);
        session.undo();
        if (!same(m_beforeGrowth)
            || session.hash() != session.history().row(m_growthRow - 1).stateHash)
            return QStringLiteral("history: undo of the growth leads elsewhere");
        session.goTo(m_drillRow);
        if (!same(m_afterDrill) || session.hash() != hash)
            return QStringLiteral("history: the way back leads elsewhere");
        return session.problem();
    }

    QString timeWalks()
    {
        timePeers();
        for (const Kind& kind : kinds()) {
            for (const bool kept : {true, false})
                timeWalk(kind, kept);
        }
        benchmark::RunSpecifiedBenchmarks(&m_report);
        benchmark::ClearRegisteredBenchmarks();
        for (const auto& [id, milliseconds] : m_walkHeldMs)
            m_report.add({id, "Ms", milliseconds});
        m_driver->keepSteps(true);
        m_driver->goTo(m_drillRow);
        if (state() != m_afterDrill)
            return QStringLiteral("history: the timed walks lead elsewhere");
        return m_driver->problem();
    }
    /// Opened anew: what is on disk says the same.
    QString reopen()
    {
        m_driver.reset();
        m_driver = SessionDriver::open(m_engine.edits(), m_volume, file());
        if (!m_driver)
            return QStringLiteral("history: the session does not open again");
        if (m_driver->hash() != m_driver->history().row(m_drillRow).stateHash
            || state() != m_afterDrill)
            return QStringLiteral("history: the session opens with other voxels");
        return {};
    }

    /// From the call until the voxels are in place, back and forth over one row; what follows from
    /// that on the worker (the hash) is done before the next.
    void timeWalk(const Kind& kind, bool kept)
    {
        for (const bool back : {true, false}) {
            const std::string id = std::string("history.") + kind.name + (back ? ".undo" : ".redo")
                + (kept ? "" : ".file");
            benchmark::RegisterBenchmark((id + "/" + PeerReport::ours).c_str(),
                [this, id, row = kind.row, kept, back](benchmark::State& times) {
                    m_driver->goTo(row);
                    m_driver->keepSteps(kept);
                    if (kept) { // is at hand from now on
                        m_driver->undo();
                        m_driver->redo();
                    }
                    for (auto _ : times) {
                        m_driver->settle();
                        const SessionDriver::Commit undo = m_driver->undo();
                        m_driver->settle();
                        const SessionDriver::Commit redo = m_driver->redo();
                        const SessionDriver::Commit& timed = back ? undo : redo;
                        times.SetIterationTime(timed.wallMs / 1000.0);
                        double& held = m_walkHeldMs[id + ".held"];
                        held = std::max(held, timed.longestCallMs());
                    }
                })
                ->UseManualTime()
                ->Iterations(5);
        }
    }
    void timePeers()
    {
        const auto time = [](const char* who, auto work) {
            benchmark::RegisterBenchmark((std::string("history.drill.undo/") + who).c_str(),
                [work](benchmark::State& times) {
                    for (auto _ : times)
                        work();
                })
                ->Iterations(1);
        };
        const auto spare = std::make_shared<State>(m_afterDrill);
        time("full copy", [this, spare] {
            std::memcpy(spare->labels.data(), m_beforeDrill.labels.data(), spare->labels.size());
            std::memcpy(
                spare->coverage.data(), m_beforeDrill.coverage.data(), spare->coverage.size());
            benchmark::ClobberMemory();
        });
        const auto labels =
            std::make_shared<peer::RunLengthImage>(m_beforeDrill.labels, TorsoVolume::size.x);
        const auto coverage =
            std::make_shared<peer::RunLengthImage>(m_beforeDrill.coverage, TorsoVolume::size.x);
        time("whole-image RLE", [spare, labels, coverage] {
            labels->decode(spare->labels);
            coverage->decode(spare->coverage);
            benchmark::ClobberMemory();
        });
        const auto difference = std::make_shared<peer::RunLengthDifference>(
            m_beforeDrill.coverage, m_afterDrill.coverage);
        time("RLE of the difference", [spare, difference] {
            difference->apply(spare->coverage);
            benchmark::ClobberMemory();
        });
    }
    QString close()
    {
        m_driver.reset();
        for (const Kind& kind : kinds())
            addBytes(kind);
        const auto beginning = std::chrono::steady_clock::now();
        const State copy = m_afterDrill;
        const std::chrono::duration<double, std::milli> copied =
            std::chrono::steady_clock::now() - beginning;
        const peer::RunLengthImage labels(copy.labels, TorsoVolume::size.x);
        const peer::RunLengthImage coverage(copy.coverage, TorsoVolume::size.x);
        const std::chrono::duration<double, std::milli> encoded =
            std::chrono::steady_clock::now() - beginning - copied;
        m_report.add({"history.drill.held", "Ms", m_heldMs, "full copy", copied.count()});
        m_report.add({"history.drill.held", "Ms", m_heldMs, "whole-image RLE", encoded.count()});
        return {};
    }
    void addBytes(const Kind& kind)
    {
        const std::string id = std::string("history.") + kind.name + ".bytes";
        const auto own = double(bytesInFile(file(), kind.row));
        if (!kind.before) {
            m_report.add({id, "Bytes", own});
            return;
        }
        const double full = double(kind.labels->size() + kind.coverage->size());
        const peer::RunLengthImage labels(*kind.labels, TorsoVolume::size.x);
        const peer::RunLengthImage coverage(*kind.coverage, TorsoVolume::size.x);
        const peer::RunLengthDifference difference(*kind.before, *kind.after);
        m_report.add({id, "Bytes", own, "full copy", full});
        m_report.add(
            {id, "Bytes", own, "whole-image RLE", double(labels.bytes() + coverage.bytes())});
        m_report.add({id, "Bytes", own, "RLE of the difference", double(difference.bytes())});
    }

    gpu::GpuEngine& m_engine;
    PeerReport& m_report;
    QTemporaryDir m_folder;
    core::LoadedVolume m_volume;
    std::unique_ptr<SessionDriver> m_driver;
    core::RowId m_seedRow = 0;
    core::RowId m_growthRow = 0;
    core::RowId m_paintRow = 0;
    core::RowId m_drillRow = 0; ///< the last one
    State m_beforeGrowth;
    State m_beforePaint;
    State m_afterPaint;
    State m_beforeDrill; ///< before the last one
    State m_afterDrill;
    double m_heldMs = 0.0;
    std::map<std::string, double> m_walkHeldMs; ///< by id
};

/// Ten thousand small strokes on a small block, as fast as they go.
QString measureMemory(gpu::GpuEngine& engine, PeerReport& report)
{
    constexpr int strokes = 10000;
    constexpr int columns = 100;
    core::LoadedVolume block;
    block.volume.geometry.size = glm::ivec3(128);
    block.volume.encoding.rescaleIntercept = -1024.0;
    block.volume.voxelsSha256 = QByteArray(64, '1');
    block.codes.assign(block.volume.geometry.voxelCount(), 1100);
    const QTemporaryDir folder;
    const auto driver =
        SessionDriver::create(engine.edits(), block, folder.filePath(QStringLiteral("many.burin")));
    if (!driver)
        return QStringLiteral("no session");
    std::fprintf(stderr, "history: %d strokes on a small block\n", strokes);
    const auto begun = residentBytes();
    auto half = begun;
    for (int number = 0; number < strokes; ++number) {
        const glm::dvec3 target(64.0);
        const core::OrthographicView view{.eyeLps = target - glm::dvec3(0.0, 200.0, 0.0),
            .targetLps = target,
            .up = {0.0, 0.0, 1.0},
            .heightMm = 150.0};
        std::vector<core::PenSample> samples;
        const double x = (number % columns - columns / 2) * 1.2;
        const double y = (number / columns - columns / 2) * 1.2;
        for (int i = 0; i < 10; ++i)
            samples.push_back(
                {.xMm = x + 0.1 * i, .yMm = y, .pressure = 1.0, .tSeconds = i / 120.0});
        driver->apply(
            test::drillWith({.view = view, .radiusMm = 1.5, .depthMm = 4.0, .samples = samples}));
        // What waits for the disk is no memory that stays.
        if (number % 100 == 99)
            driver->settle();
        if (number + 1 == strokes / 2)
            half = residentBytes();
    }
    if (driver->history().rows().size() != strokes)
        return QStringLiteral("history: %1 of %2 strokes changed something")
            .arg(driver->history().rows().size())
            .arg(strokes);
    const auto ended = residentBytes();
    report.add({"history.memory.stroke", "Bytes", double(ended - begun) / strokes});
    report.add({"history.memory.laterStroke", "Bytes", double(ended - half) / (strokes / 2)});
    return driver->problem();
}

} // namespace

QString measureHistory(PeerReport& report)
{
    const auto engine = gpu::GpuEngine::create();
    if (!engine)
        return ui::errorText(engine.error());
    // First: what others have freed would hide what is taken.
    if (const QString why = measureMemory(**engine, report); !why.isEmpty())
        return why;
    return Scenario(**engine, report).run();
}

} // namespace bench
