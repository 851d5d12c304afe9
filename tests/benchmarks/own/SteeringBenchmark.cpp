// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/SteeringBenchmark.h"

#include "core/engine/EngineCommands.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/benchmarks/common/WatchedViews.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

namespace bench {

namespace {

constexpr int side = 512;
constexpr int peak = 20000; ///< code in the middle of the ball
constexpr int codesPerVoxel = 100;
constexpr int radius = 134;
constexpr int rounds = 9;
constexpr int recoveries = 3;

double milliseconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<std::uint16_t> filled(int volumeSide, const std::function<int(glm::ivec3)>& codeAt)
{
    std::vector<std::uint16_t> codes;
    codes.reserve(std::size_t(volumeSide) * volumeSide * volumeSide);
    for (int z = 0; z < volumeSide; ++z)
        for (int y = 0; y < volumeSide; ++y)
            for (int x = 0; x < volumeSide; ++x)
                codes.push_back(std::uint16_t(codeAt(glm::ivec3(x, y, z) - volumeSide / 2)));
    return codes;
}

/// A bar of 99 × 99 voxels and a front across it.
class Bar {
public:
    explicit Bar(int volumeSide)
        : m_side(volumeSide)
    {
    }
    bool open()
    {
        auto engine = gpu::GpuEngine::create();
        if (!engine)
            return false;
        m_engine = std::move(*engine);
        const auto codes = filled(m_side, [](const glm::ivec3& at) {
            return std::max(std::abs(at.x), std::abs(at.y)) < 50 && at.z >= -60 ? 1000 : 0;
        });
        if (!m_engine->edits().openVolume(glm::ivec3(m_side), codes))
            return false;
        core::SeedPlacement seeds{.label = 1};
        for (int y = -49; y < 50; ++y)
            for (int x = -49; x < 50; ++x)
                seeds.voxels.push_back(glm::ivec3(x, y, -60) + m_side / 2);
        core::submitWhole(m_engine->edits(), seeds);
        m_engine->edits().submit(
            core::BeginEdit{core::GrowBurst{.lowCode = 1000, .highCode = 1000}});
        (void)generations(8); // compiles
        return true;
    }
    /// @return ms for one of them
    double generations(int count)
    {
        const double spent = milliseconds([&] {
            m_engine->edits().submit(core::ExtendEdit{core::GrowAdvance{count}});
            m_engine->edits().finish();
        });
        return spent / count;
    }
    [[nodiscard]] std::vector<std::uint32_t> fronts() const
    {
        return m_engine->edits().growthProgress().frontSizes;
    }

private:
    int m_side;
    std::unique_ptr<gpu::GpuEngine> m_engine;
};

QString measureGeneration(PeerReport& report)
{
    Bar small(128);
    Bar large(side);
    if (!small.open() || !large.open())
        return QStringLiteral("steer.generation: no room");
    std::vector<double> smallMs;
    std::vector<double> largeMs;
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        smallMs.push_back(small.generations(8));
        largeMs.push_back(large.generations(8));
        ratios.push_back(smallMs.back() / largeMs.back());
    }
    const std::vector<std::uint32_t> fronts = large.fronts();
    if (fronts != small.fronts() || fronts.size() < 8 * rounds || fronts.back() != 99 * 99)
        return QStringLiteral("steer.generation: not the same fronts");
    report.add({"steer.generation.512", "Ms", median(largeMs), "128 cubed",
        median(largeMs) * median(ratios)});
    return {};
}

/// The ball, grown.
class Ball {
public:
    bool open()
    {
        auto engine = gpu::GpuEngine::create();
        if (!engine)
            return false;
        m_engine = std::move(*engine);
        const auto codes = filled(side, codeAt);
        if (!edits().openVolume(glm::ivec3(side), codes))
            return false;
        core::submitWhole(
            edits(), core::SeedPlacement{.label = 1, .voxels = {glm::ivec3(side / 2)}});
        m_grown = ended(core::submitWhole(edits(),
            core::GrowBurst{.lowCode = lowCode(radius), .highCode = 65535}, {core::GrowAdvance{}}));
        return m_grown.atClosure && m_grown.statistics.voxelsChanged > 10'000'000;
    }
    [[nodiscard]] core::EditEngine& edits() { return m_engine->edits(); }
    [[nodiscard]] gpu::GpuEngine& engine() { return *m_engine; }
    [[nodiscard]] const core::EngineResult& grown() const { return m_grown; }
    /// @param at from the middle
    [[nodiscard]] static int codeAt(const glm::ivec3& at)
    {
        return int(std::max(0.0, peak - codesPerVoxel * glm::length(glm::dvec3(at))));
    }
    [[nodiscard]] static int lowCode(int voxels) { return peak - codesPerVoxel * voxels; }

    /// Makes undone what a committed edit has changed.
    void takeBack(const core::EngineResult& result)
    {
        core::SwapBricks swap;
        for (const core::BrickChange& change : result.changes)
            swap.bricks.push_back({change.key, change.before});
        edits().submit(std::move(swap));
        edits().finish();
    }

    /// The result of a ticket, once all is done.
    core::EngineResult ended(core::Ticket ticket)
    {
        edits().finish();
        for (core::EngineResult& result : edits().collect()) {
            if (result.ticket == ticket)
                return std::move(result);
        }
        return {};
    }

private:
    std::unique_ptr<gpu::GpuEngine> m_engine;
    core::EngineResult m_grown;
};

QString measureSlider(PeerReport& report, Ball& ball)
{
    core::EditEngine& edits = ball.edits();
    const auto at = [&ball](int voxels) {
        return core::GrowBurst{.lowCode = Ball::lowCode(voxels),
            .highCode = 65535,
            .opening = core::GrowOpening::Narrow,
            .generation = ball.grown().generation};
    };
    report.add({"steer.opening", "Ms", milliseconds([&] {
                    edits.submit(core::BeginEdit{at(radius)});
                    edits.finish();
                })});
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        const int voxels = radius + (round % 2 == 0 ? 2 : -2);
        times.push_back(milliseconds([&] {
            edits.submit(core::ExtendEdit{core::GrowAnew{at(voxels)}});
            edits.submit(core::ExtendEdit{core::GrowAdvance{}});
            edits.finish();
        }));
        RowTimes::ended("steer.slider", times.back());
        if (!edits.growthProgress().atClosure)
            return QStringLiteral("steer.slider: no closure");
    }
    const core::EngineResult result = ball.ended(edits.submit(core::EndEdit{core::Ending::Commit}));
    if (result.error || result.statistics.voxelsChanged < 100'000)
        return QStringLiteral("steer.slider: the interval took nothing");
    ball.takeBack(result);
    report.add({"steer.slider", "Ms", median(times)});
    return {};
}

/// What the interval has suspended comes back when it widens: the shell around the ball, in
/// which there are as many voxels as counting tells.
QString measureRecovery(PeerReport& report, Ball& ball)
{
    constexpr int wider = radius + 2;
    std::int64_t shell = 0;
    for (int z = -wider; z <= wider; ++z) {
        for (int y = -wider; y <= wider; ++y) {
            for (int x = -wider; x <= wider; ++x) {
                const int code = Ball::codeAt({x, y, z});
                shell += code >= Ball::lowCode(wider) && code < Ball::lowCode(radius) ? 1 : 0;
            }
        }
    }
    std::vector<double> times;
    for (int round = 0; round < recoveries; ++round) {
        core::EngineResult result;
        times.push_back(milliseconds([&] {
            result = ball.ended(core::submitWhole(ball.edits(),
                core::GrowBurst{.lowCode = Ball::lowCode(wider),
                    .highCode = 65535,
                    .generation = ball.grown().generation},
                {core::GrowAdvance{}}));
        }));
        RowTimes::ended("steer.recovery", times.back());
        if (result.error || result.statistics.voxelsChanged != shell)
            return QStringLiteral("steer.recovery: %1 voxels came back, not %2")
                .arg(qlonglong(result.statistics.voxelsChanged))
                .arg(qlonglong(shell));
        ball.takeBack(result);
    }
    report.add({"steer.recovery", "Ms", median(times)});
    return {};
}

QString measureScrub(PeerReport& report, Ball& ball)
{
    core::EditEngine& edits = ball.edits();
    const std::uint32_t last = ball.grown().generation;
    edits.submit(core::BeginEdit{core::ShrinkGrowth{.generation = last, .keep = last}});
    edits.finish();
    const auto go = [&edits](std::uint32_t keep) {
        return milliseconds([&] {
            edits.submit(core::ExtendEdit{core::ShrinkTo{keep}});
            edits.finish();
        });
    };
    (void)go(last / 2);
    std::vector<double> near;
    std::vector<double> far;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        near.push_back(go(last / 2 + 5 * (round + 1)));
        far.push_back(go(round % 2 == 0 ? last : 10));
        (void)go(last / 2 + 5 * (round + 1));
    }
    const core::EngineResult back = ball.ended(edits.submit(core::EndEdit{core::Ending::Rollback}));
    if (back.error)
        return QStringLiteral("steer.scrub: refused");
    report.add({"steer.scrub.near", "Ms", median(near)});
    report.add({"steer.scrub.far", "Ms", median(far)});
    return {};
}

QString measureSketch(PeerReport& report, Ball& ball)
{
    core::PickVoxels pick{.thresholdCode = Ball::lowCode(radius)};
    for (int i = 0; i < 600; ++i)
        pick.rays.push_back({.origin = glm::ivec3(106 + i / 2, side / 2, 0) << 16,
            .step = {0, 0, 1 << 15},
            .samples = 2 * side});
    std::vector<double> times;
    core::EngineResult result;
    for (int round = 0; round < rounds; ++round) {
        times.push_back(milliseconds([&] { result = ball.ended(ball.edits().submit(pick)); }));
        RowTimes::ended("steer.sketch", times.back());
    }
    for (std::size_t i = 0; i < pick.rays.size(); ++i) {
        const double aside = (pick.rays[i].origin.x >> 16) - side / 2;
        const double half = std::sqrt(std::max(0.0, radius * double(radius) - aside * aside));
        const bool seen = i < result.picks.size() && result.picks[i];
        if (seen ? std::abs(side / 2 - half - result.picks[i]->z) > 1.5 : half > 1.0)
            return QStringLiteral("steer.sketch: ray %1 does not find the ball").arg(i);
    }
    report.add({"steer.sketch", "Ms", median(times)});
    return {};
}

/// Of an event of the slider, to the first moving picture. What an interval shows in the end does
/// not depend on which one was there before.
QString measureSliderPicture(PeerReport& report, Ball& ball)
{
    constexpr gpu::ViewId view = 1;
    core::EditEngine& edits = ball.edits();
    core::VolumeGeometry geometry;
    geometry.size = glm::ivec3(side);
    ball.engine().setVolumeGeometry(geometry, {});
    WatchedViews views(ball.engine());
    gpu::FrameRequest request;
    request.view = view;
    request.sizePixels = {1230, 870};
    gpu::VolumeScene scene;
    scene.targetLps = glm::dvec3(side / 2);
    scene.eyeLps = scene.targetLps + glm::dvec3(-260.0, -430.0, 110.0);
    scene.heightMm = 400.0;
    scene.surfaceThreshold = 65535.0; // segments only
    request.scene = scene;
    request.segments.visible[1] = true;
    request.segments.rgb[1] = 0x59C07A;
    const auto at = [&ball](int voxels) {
        return core::GrowBurst{.lowCode = Ball::lowCode(voxels),
            .highCode = 65535,
            .opening = core::GrowOpening::Narrow,
            .generation = ball.grown().generation};
    };
    const auto go = [&](int voxels) {
        edits.submit(core::ExtendEdit{core::GrowAnew{at(voxels)}});
        edits.submit(core::ExtendEdit{core::GrowAdvance{}});
    };
    const auto finalAt = [&](int voxels) {
        go(voxels);
        edits.finish();
        request.interacting = false;
        views.show(request);
        // So much has changed that the textures of the picture follow only after a while.
        views.rest(std::chrono::seconds(3));
        const gpu::Frame frame = views.latest(view);
        return frame.rgba ? *frame.rgba : std::vector<std::uint8_t>();
    };
    views.show(request);
    edits.submit(core::BeginEdit{at(radius)});
    edits.finish();
    const std::vector<std::uint8_t> wide = finalAt(radius + 2);
    const std::vector<std::uint8_t> narrow = finalAt(radius - 2);
    if (wide.empty() || wide == narrow || finalAt(radius + 2) != wide)
        return QStringLiteral("steer.slider.picture: an interval shows another picture");
    request.interacting = true;
    views.show(request);
    views.rest();
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
        const std::optional<double> time =
            views.untilSeen([&] { go(radius + (round % 2 == 0 ? -2 : 2)); }, {view});
        if (!time)
            return QStringLiteral("steer.slider.picture: no picture");
        RowTimes::took("steer.slider.picture", begin, *time);
        times.push_back(*time);
        edits.finish();
        views.rest();
    }
    const core::EngineResult back = ball.ended(edits.submit(core::EndEdit{core::Ending::Rollback}));
    if (back.error)
        return QStringLiteral("steer.slider.picture: refused");
    report.add({"steer.slider.picture", "Ms", median(times)});
    return {};
}

} // namespace

QString measureSteering(PeerReport& report)
{
    if (const QString why = measureGeneration(report); !why.isEmpty())
        return why;
    Ball ball;
    if (!ball.open())
        return QStringLiteral("steer: the ball was not grown");
    const auto bricks = std::count_if(ball.grown().changes.begin(), ball.grown().changes.end(),
        [](const core::BrickChange& change) { return change.key.field == core::Field::SeedWords; });
    report.add({"steer.words", "Bytes per 1000",
        double(bricks) * 4096 * 4 * 1000 / double(ball.grown().statistics.voxelsChanged)});
    // The last one, as the engine works for its view from then on.
    for (const auto measure :
        {measureSlider, measureRecovery, measureScrub, measureSketch, measureSliderPicture}) {
        if (const QString why = measure(report, ball); !why.isEmpty())
            return why;
    }
    return {};
}

} // namespace bench
