// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/MovingBenchmark.h"

#include "core/demo/DemoStudy.h"
#include "core/study/StudyLoader.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/Picture.h"
#include "tests/benchmarks/itk/GrowBenchmark.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/base/ErrorText.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;
const glm::ivec2 frameSize(1230, 870);
constexpr int steps = 24; ///< of the camera, 3 degrees each
constexpr int rounds = 3;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Asks for a picture and waits until one of that quality is there.
class Viewer {
public:
    explicit Viewer(gpu::GpuEngine& engine)
        : m_frames(engine.frames())
    {
        m_frames.setListener([this](const gpu::Frame& frame) { arrived(frame); });
    }
    ~Viewer()
    {
        m_frames.forget(1);
        m_frames.setListener({});
    }
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    struct Timed {
        gpu::Frame frame; ///< without a picture if the engine refused to draw
        double milliseconds = 0.0; ///< from the request
    };
    Timed draw(const gpu::VolumeScene& scene, bool moving)
    {
        std::unique_lock lock(m_guard);
        m_wanted = scene;
        m_least = moving ? gpu::Frame::Quality::Coarse : gpu::Frame::Quality::Refined;
        m_frame.reset();
        const Clock::time_point start = Clock::now();
        m_frames.request({.view = 1,
            .sizePixels = frameSize,
            .scene = scene,
            .segments = {},
            .interacting = moving});
        m_changed.wait(lock, [this] { return m_frame.has_value(); });
        return {*m_frame, std::chrono::duration<double, std::milli>(m_end - start).count()};
    }

private:
    void arrived(const gpu::Frame& frame)
    {
        const std::lock_guard lock(m_guard);
        const auto* scene = std::get_if<gpu::VolumeScene>(&frame.scene);
        const bool wanted = frame.failure || frame.quality >= m_least;
        if (m_frame || !wanted || !scene || !(*scene == m_wanted))
            return;
        m_end = Clock::now();
        m_frame = frame;
        m_changed.notify_all();
    }

    gpu::FrameSource& m_frames;
    std::mutex m_guard;
    std::condition_variable m_changed;
    gpu::VolumeScene m_wanted;
    gpu::Frame::Quality m_least = gpu::Frame::Quality::Coarse;
    std::optional<gpu::Frame> m_frame;
    Clock::time_point m_end;
};

gpu::VolumeScene turned(gpu::VolumeScene scene, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    const glm::dvec3 away = scene.eyeLps - scene.targetLps;
    scene.eyeLps = scene.targetLps
        + glm::dvec3(away.x * std::cos(angle) - away.y * std::sin(angle),
            away.x * std::sin(angle) + away.y * std::cos(angle), away.z);
    return scene;
}

/// What is drawn, around the middle of a volume.
struct Stage {
    std::string id;
    glm::dvec3 middleLps{0.0};
    double heightMm = 240.0;
};

struct Mode {
    const char* id;
    gpu::RenderMode mode;
};
constexpr std::array<Mode, 3> modes{{{"surface", gpu::RenderMode::Surface},
    {"dvr", gpu::RenderMode::Dvr}, {"mip", gpu::RenderMode::Mip}}};

gpu::VolumeScene sceneOf(const Stage& stage, gpu::RenderMode mode)
{
    gpu::VolumeScene scene;
    scene.mode = mode;
    scene.targetLps = stage.middleLps;
    scene.eyeLps = stage.middleLps + glm::dvec3(-260.0, -430.0, 110.0);
    scene.heightMm = stage.heightMm;
    scene.surfaceThreshold = 300.0;
    scene.transferFunction.points = {{150.0, 0x8a4b32, 0.0}, {250.0, 0xd9a066, 0.05},
        {600.0, 0xf2e4c4, 0.35}, {1800.0, 0xffffff, 0.8}};
    scene.mipWindow = {.centre = 700.0, .width = 1800.0};
    return scene;
}

QString measureMode(PeerReport& report, Viewer& viewer, const Stage& stage, const Mode& mode)
{
    constexpr double leastOverlap = 0.9;
    constexpr int background = 12;
    const gpu::VolumeScene scene = sceneOf(stage, mode.mode);
    std::vector<double> moving;
    std::vector<double> settled;
    double degrees = 0.0;
    static_cast<void>(viewer.draw(scene, false)); // compiles, and learns what tiles cost
    for (int round = 0; round < rounds; ++round) {
        gpu::Frame last;
        for (int step = 0; step < steps; ++step) {
            degrees += 3.0;
            const Viewer::Timed timed = viewer.draw(turned(scene, degrees), true);
            moving.push_back(timed.milliseconds);
            last = timed.frame;
        }
        const Viewer::Timed rested = viewer.draw(turned(scene, degrees), false);
        settled.push_back(rested.milliseconds);
        if (!last.rgba || !rested.frame.rgba)
            return QStringLiteral("frame.moving: nothing was drawn");
        const Agreement agreement = compare(Picture::fromRgba(last.sizePixels, last.rgba->data()),
            Picture::fromRgba(rested.frame.sizePixels, rested.frame.rgba->data()), background);
        if (agreement.silhouetteOverlap < leastOverlap)
            return QStringLiteral("frame.moving: the moving picture is another (%1)")
                .arg(agreement.silhouetteOverlap);
    }
    const std::string end = stage.id + mode.id;
    report.add({"frame.moving." + end, "Ms", median(moving)});
    report.add({"frame.settled." + end, "Ms", median(settled)});
    return {};
}

QString measureStage(PeerReport& report, gpu::GpuEngine& engine, const Stage& stage)
{
    Viewer viewer(engine);
    for (const Mode& mode : modes) {
        if (const QString why = measureMode(report, viewer, stage, mode); !why.isEmpty())
            return why;
    }
    return {};
}

QString measureHead(PeerReport& report, gpu::GpuEngine& engine)
{
    const auto study = core::makeDemoStudy({});
    if (!study)
        return ui::errorText(study.error());
    if (!engine.edits().openVolume(study->geometry.size, demoCodes(*study)))
        return QStringLiteral("frame.moving: the volume could not be opened");
    core::VoxelEncoding encoding;
    encoding.rescaleIntercept = -1024.0;
    engine.setVolumeGeometry(study->geometry, encoding);
    return measureStage(report, engine, {});
}

/// Nothing is added where the shared data are not.
QString measureReal(PeerReport& report, gpu::GpuEngine& engine)
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("ct_cranium_inv3"));
    if (data.source.isEmpty()) {
        std::fprintf(stderr, "frame.moving.real: left out, the shared data are not there\n");
        return {};
    }
    const auto loaded = core::loadVolume(
        data.unpacked.isEmpty() ? data.source + QStringLiteral("/dicom") : data.unpacked);
    if (!loaded)
        return ui::errorText(loaded.error());
    const core::VolumeGeometry& geometry = loaded->volume.geometry;
    if (!engine.edits().openVolume(geometry.size, loaded->codes))
        return QStringLiteral("frame.moving.real: the volume could not be opened");
    engine.setVolumeGeometry(geometry, loaded->volume.encoding);
    const glm::dvec3 middle = glm::dvec3(geometry.size - 1) * 0.5;
    return measureStage(report, engine,
        {.id = "real.",
            .middleLps = glm::dvec3(geometry.indexToWorld * glm::dvec4(middle, 1.0)),
            .heightMm = 260.0});
}

} // namespace

QString measureMoving(PeerReport& report)
{
    const auto engine = gpu::GpuEngine::create();
    if (!engine)
        return ui::errorText(engine.error());
    for (const auto measure : {measureHead, measureReal}) {
        if (const QString why = measure(report, **engine); !why.isEmpty())
            return why;
    }
    return {};
}

} // namespace bench
