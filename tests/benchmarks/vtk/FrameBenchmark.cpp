// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/vtk/FrameBenchmark.h"

#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/Picture.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/benchmarks/itk/GrowBenchmark.h"
#include "tests/benchmarks/vtk/VtkVolumeView.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;
const glm::ivec2 frameSize(1230, 870);

/// Asks for frames and waits for the full one.
class FrameClock {
public:
    explicit FrameClock(gpu::GpuEngine& engine)
        : m_frames(engine.frames())
    {
        m_frames.setListener([this](const gpu::Frame& frame) { arrived(frame); });
    }

    struct Timed {
        gpu::Frame frame;
        double milliseconds = 0.0; ///< from the request, or from the coarse frame before it
        Clock::time_point start;
    };
    Timed draw(const gpu::VolumeScene& scene)
    {
        std::unique_lock lock(m_guard);
        m_full.reset();
        m_start = Clock::now();
        m_frames.request({.view = 1, .sizePixels = frameSize, .scene = scene, .segments = {}});
        m_changed.wait(lock, [this] { return m_full.has_value(); });
        const std::chrono::duration<double, std::milli> spent = m_end - m_start;
        return {*m_full, spent.count(), m_start};
    }
    /// Draws nothing more: neither the refinement of the last frame nor what a growth changes is to
    /// run beside what is timed next.
    void rest() { m_frames.forget(1); }

private:
    void arrived(const gpu::Frame& frame)
    {
        const std::lock_guard lock(m_guard);
        if (frame.quality == gpu::Frame::Quality::Coarse) {
            m_start = Clock::now();
        } else if (!m_full) {
            m_end = Clock::now();
            m_full = frame;
            m_changed.notify_all();
        }
    }

    gpu::FrameSource& m_frames;
    std::mutex m_guard;
    std::condition_variable m_changed;
    std::optional<gpu::Frame> m_full;
    Clock::time_point m_start;
    Clock::time_point m_end;
};

struct Work {
    const char* id;
    gpu::VolumeScene scene;
    /// What "equal" means: surfaces are lit by other formulas, a projection is not lit at all.
    double leastOverlap;
    double mostDifference;
    int background;
};

gpu::VolumeScene sceneOf(gpu::RenderMode mode)
{
    gpu::VolumeScene scene;
    scene.mode = mode;
    scene.eyeLps = {-260.0, -430.0, 110.0};
    scene.targetLps = {0.0, 0.0, 0.0};
    scene.heightMm = 240.0;
    scene.surfaceThreshold = 300.0;
    scene.transferFunction.points = {{150.0, 0x8a4b32, 0.0}, {250.0, 0xd9a066, 0.05},
        {600.0, 0xf2e4c4, 0.35}, {1800.0, 0xffffff, 0.8}};
    scene.mipWindow = {.centre = 700.0, .width = 1800.0};
    return scene;
}

/// A camera that is never quite where it was, so that nobody answers from memory.
gpu::VolumeScene nudged(gpu::VolumeScene scene)
{
    static int count = 0;
    scene.eyeLps.x += 0.02 * (++count % 64);
    return scene;
}

QString differs(const Work& work, const char* peer, const Picture& ours, const Picture& theirs)
{
    const Agreement agreement = compare(ours, theirs, work.background);
    std::fprintf(stderr, "%s, %s: silhouettes agree to %.4f, mean difference %.4f\n", work.id, peer,
        agreement.silhouetteOverlap, agreement.meanDifference);
    if (const char* folder = std::getenv("BURIN_BENCH_PICTURES")) {
        ours.save(std::string(folder) + '/' + work.id + "-burin.pgm");
        theirs.save(std::string(folder) + '/' + work.id + '-' + peer + ".pgm");
    }
    if (agreement.silhouetteOverlap >= work.leastOverlap
        && agreement.meanDifference <= work.mostDifference)
        return {};
    return QStringLiteral("%1: the picture differs from that of the %2")
        .arg(QLatin1String(work.id), QLatin1String(peer));
}

void registerPeer(const Work& work, const char* peer, std::shared_ptr<VtkVolumeView> view)
{
    benchmark::RegisterBenchmark((std::string(work.id) + '/' + peer).c_str(),
        [view = std::move(view), scene = work.scene](benchmark::State& state) {
            for (auto _ : state) {
                const gpu::VolumeScene next = nudged(scene);
                const Clock::time_point start = Clock::now();
                (void)view->draw(next);
                state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
            }
        })
        ->UseManualTime()
        ->Iterations(1);
}

/// @param voxels of the volume
void registerBurin(const Work& work, std::shared_ptr<FrameClock> clock, std::size_t voxels)
{
    RowTimes::moves(work.id, 2.0 * double(voxels) + 8.0 * frameSize.x * frameSize.y,
        "each voxel's value read, each pixel written and fetched");
    benchmark::RegisterBenchmark((std::string(work.id) + '/' + PeerReport::ours).c_str(),
        [clock = std::move(clock), scene = work.scene, id = work.id](benchmark::State& state) {
            (void)clock->draw(nudged(scene)); // another mode was shown before
            for (auto _ : state) {
                const FrameClock::Timed timed = clock->draw(nudged(scene));
                RowTimes::took(id, timed.start, timed.milliseconds);
                state.SetIterationTime(timed.milliseconds / 1000.0);
            }
            clock->rest();
        })
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace

QString registerFrames(gpu::GpuEngine& engine, const core::DemoStudy& study)
{
    if (!engine.edits().openVolume(study.geometry.size, demoCodes(study)))
        return QStringLiteral("the volume could not be opened");
    core::VoxelEncoding encoding;
    encoding.rescaleIntercept = -1024.0;
    engine.setVolumeGeometry(study.geometry, encoding);
    const auto clock = std::make_shared<FrameClock>(engine);
    // Burin's own step (gpu/render/raycast/RaycastPass.cpp).
    const double sampleMm = 0.8 * study.geometry.spacingMm().x;

    for (const Work& work : {
             Work{"frame.surface", sceneOf(gpu::RenderMode::Surface), 0.98, 0.12, 12},
             Work{"frame.dvr", sceneOf(gpu::RenderMode::Dvr), 0.97, 0.10, 12},
             Work{"frame.mip", sceneOf(gpu::RenderMode::Mip), 0.98, 0.01, 12},
         }) {
        const gpu::Frame frame = clock->draw(work.scene).frame;
        clock->rest();
        const Picture ours = Picture::fromRgba(frame.sizePixels, frame.rgba->data());
        for (const auto mapper : {VtkVolumeView::Mapper::Gpu, VtkVolumeView::Mapper::FixedPoint}) {
            const bool onGpu = mapper == VtkVolumeView::Mapper::Gpu;
            const char* peer = onGpu ? "VTK GPU mapper" : "VTK fixed-point mapper";
            // One view for each, so that nothing is compiled or uploaded while the clock runs.
            auto view = std::make_shared<VtkVolumeView>(
                study.geometry, study.hounsfield, frameSize, mapper);
            view->setUp(work.scene, sampleMm);
            const std::vector<std::uint8_t> rgba = view->draw(work.scene);
            const QString why =
                differs(work, peer, ours, Picture::fromRgba(frameSize, rgba.data()));
            if (!why.isEmpty())
                return why;
            if (view->rendererName() != engine.rendererName().toStdString())
                std::fprintf(
                    stderr, "%s draws on another GPU: %s\n", peer, view->rendererName().c_str());
            registerPeer(work, peer, std::move(view));
        }
        registerBurin(work, clock, study.geometry.voxelCount());
    }
    return {};
}

} // namespace bench
