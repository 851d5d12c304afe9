// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/vtk/PlaneBenchmark.h"

#include "core/demo/DemoStudy.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/benchmarks/itk/GrowBenchmark.h"
#include "tests/benchmarks/vtk/VtkPlaneView.h"
#include "tests/support/fixtures/frames/DemoHeadScene.h"
#include "ui/base/ErrorText.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <vector>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;
const glm::ivec2 frameSize(1024, 1024);
constexpr int turns = 9;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Asks for pictures and tells what each level of them took.
class PlaneClock {
public:
    explicit PlaneClock(gpu::GpuEngine& engine)
        : m_frames(engine.frames())
    {
        m_frames.setListener([this](const gpu::Frame& frame) { arrived(frame); });
    }

    struct Timed {
        gpu::Frame linear;
        gpu::Frame cubic;
        double linearMs = 0.0; ///< from the request, or from the coarse picture before it
        double cubicMs = 0.0; ///< from the linear one
    };
    Timed draw(const gpu::Scene& scene)
    {
        std::unique_lock lock(m_guard);
        m_done = false;
        m_last = Clock::now();
        m_frames.request({.view = 1, .sizePixels = frameSize, .scene = scene, .segments = {}});
        m_changed.wait(lock, [this] { return m_done; });
        return m_timed;
    }

private:
    void arrived(const gpu::Frame& frame)
    {
        const std::lock_guard lock(m_guard);
        const double spent = since(m_last);
        m_last = Clock::now();
        if (frame.quality == gpu::Frame::Quality::Full) {
            m_timed.linear = frame;
            m_timed.linearMs = spent;
        } else if (frame.quality == gpu::Frame::Quality::Refined) {
            m_timed.cubic = frame;
            m_timed.cubicMs = spent;
            m_done = true;
            m_changed.notify_all();
        }
    }

    gpu::FrameSource& m_frames;
    std::mutex m_guard;
    std::condition_variable m_changed;
    Timed m_timed;
    bool m_done = false;
    Clock::time_point m_last;
};

gpu::SliceScene oblique(int turn)
{
    gpu::SliceScene scene;
    scene.centreLps = {0.0, -10.0 + 0.05 * turn, 5.0}; // never quite where it was
    scene.rightLps = glm::normalize(glm::dvec3(1.0, -0.6, 0.1));
    scene.downLps = glm::normalize(glm::cross(glm::dvec3(-0.8, -1.0, -0.25), scene.rightLps));
    scene.mmPerPixel = 0.2;
    scene.window = {60.0, 400.0};
    scene.interpolation = gpu::Interpolation::Cubic;
    scene.contour = gpu::SceneContour{};
    scene.contour->colours = {.rgb = 0xFF0000, .markOpacity = 0.0f};
    return scene;
}

/// Straight onto the same plane; nothing else is seen.
gpu::VolumeScene viewOf(const gpu::SliceScene& slice)
{
    gpu::VolumeScene view;
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    view.targetLps = slice.centreLps;
    view.eyeLps = slice.centreLps - 500.0 * normal;
    view.up = -slice.downLps;
    view.heightMm = slice.mmPerPixel * frameSize.y;
    view.surfaceThreshold = 64000.0;
    view.plane = gpu::ScenePlane{};
    view.plane->centreLps = slice.centreLps;
    view.plane->rightLps = slice.rightLps;
    view.plane->downLps = slice.downLps;
    view.plane->halfSizeMm = glm::dvec2(0.5 * view.heightMm);
    view.plane->window = slice.window;
    view.plane->contour = slice.contour;
    return view;
}

glm::ivec3 pixel(const gpu::Frame& frame, int x, int y)
{
    const std::uint8_t* bytes = &(*frame.rgba)[std::size_t(y * frame.sizePixels.x + x) * 4];
    return {bytes[0], bytes[1], bytes[2]};
}

/// Grey values away from the line: how far the two are apart, of 255.
QString differs(const char* what, const gpu::Frame& ours, const std::vector<double>& theirs,
    const gpu::SliceScene& scene, const core::VolumeGeometry& geometry)
{
    double most = 0.0;
    double sum = 0.0;
    int compared = 0;
    for (int y = 0; y < frameSize.y; ++y) {
        for (int x = 0; x < frameSize.x; ++x) {
            const glm::dvec3 lps = scene.centreLps
                + scene.mmPerPixel
                    * ((x + 0.5 - frameSize.x / 2.0) * scene.rightLps
                        + (y + 0.5 - frameSize.y / 2.0) * scene.downLps);
            const glm::dvec3 index = geometry.toIndex(lps);
            if (!glm::all(glm::greaterThan(index, glm::dvec3(2.0)))
                || !glm::all(glm::lessThan(index, glm::dvec3(geometry.size) - 3.0)))
                continue;
            const double value = theirs[std::size_t(y * frameSize.x + x)];
            const double part =
                (value - (scene.window.centre - 0.5)) / (scene.window.width - 1.0) + 0.5;
            const double apart = std::abs(pixel(ours, x, y).g - 255.0 * std::clamp(part, 0.0, 1.0));
            most = std::max(most, apart);
            sum += apart;
            ++compared;
        }
    }
    std::fprintf(stderr,
        "%s: %d pixels, grey values differ by %.2f of 255 at most, %.3f in the mean\n", what,
        compared, most, sum / std::max(compared, 1));
    // VTK rounds to whole values: 0.32 of a grey level.
    return compared > 100'000 && most <= 1.5
        ? QString()
        : QStringLiteral("%1: grey values differ").arg(QLatin1String(what));
}

double distanceTo(const glm::dvec2& at, const std::array<glm::dvec2, 2>& line)
{
    const glm::dvec2 along = line[1] - line[0];
    const double part = std::clamp(
        glm::dot(at - line[0], along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
    return glm::length(at - line[0] - along * part);
}

/// Pixels that the line covers by half and more lie on the peer's lines, and those on pixels.
QString linesDiffer(const gpu::Frame& ours, const std::vector<std::array<glm::dvec3, 2>>& theirs,
    const gpu::SliceScene& scene)
{
    std::vector<std::array<glm::dvec2, 2>> lines;
    for (const auto& line : theirs) {
        std::array<glm::dvec2, 2> ends;
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::dvec3 from = line[i] - scene.centreLps;
            ends[i] = glm::dvec2(frameSize) * 0.5
                + glm::dvec2(glm::dot(from, scene.rightLps), glm::dot(from, scene.downLps))
                    / scene.mmPerPixel;
        }
        lines.push_back(ends);
    }
    double sum = 0.0;
    double most = 0.0;
    int covered = 0;
    for (int y = 0; y < frameSize.y; ++y) {
        for (int x = 0; x < frameSize.x; ++x) {
            const glm::ivec3 rgb = pixel(ours, x, y);
            if (rgb.r - rgb.g < 160)
                continue;
            double least = 1e9;
            for (const auto& line : lines)
                least = std::min(least, distanceTo({x + 0.5, y + 0.5}, line));
            sum += least;
            most = std::max(most, least);
            ++covered;
        }
    }
    int missed = 0;
    for (const auto& line : lines) {
        const glm::ivec2 at(glm::floor(0.5 * (line[0] + line[1])));
        if (!glm::all(glm::greaterThan(at, glm::ivec2(1)))
            || !glm::all(glm::lessThan(at, frameSize - 2)))
            continue;
        const glm::ivec3 rgb = pixel(ours, at.x, at.y);
        missed += rgb.r - rgb.g < 60 ? 1 : 0;
    }
    std::fprintf(stderr,
        "contour: %d pixels %.3f of a pixel from %zu lines of the peer in the mean, %.3f at most; "
        "%d "
        "of those have no pixel\n",
        covered, sum / std::max(covered, 1), lines.size(), most, missed);
    return covered > 500 && sum < 0.5 * covered && most < 1.2 && missed == 0
        ? QString()
        : QStringLiteral("contours differ");
}

/// The triangles that Burin draws: fans around the middles of faces.
struct Triangles {
    std::vector<glm::dvec3> places;
    std::vector<std::array<std::uint32_t, 3>> corners;
};

Triangles trianglesOf(const core::SimplexMesh& mesh)
{
    Triangles triangles;
    triangles.places.assign(mesh.positions().begin(), mesh.positions().end());
    for (const core::FaceId id : mesh.faceIds()) {
        const core::FaceRing& ring = mesh.ring(id);
        glm::dvec3 sum(0.0);
        for (const core::VertexId vertex : ring)
            sum += mesh.position(vertex);
        const auto middle = std::uint32_t(triangles.places.size());
        triangles.places.push_back(sum / double(ring.size()));
        for (std::size_t i = 0; i < ring.size(); ++i)
            triangles.corners.push_back({ring[i], ring[(i + 1) % ring.size()], middle});
    }
    return triangles;
}

} // namespace

QString measurePlanes(PeerReport& report)
{
    const auto study = core::makeDemoStudy({});
    const auto engine = gpu::GpuEngine::create();
    if (!study || !engine)
        return ui::errorText(study ? engine.error() : study.error());
    if (!(*engine)->edits().openVolume(study->geometry.size, demoCodes(*study)))
        return QStringLiteral("the volume could not be opened");
    core::VoxelEncoding encoding;
    encoding.rescaleIntercept = -1024.0;
    (*engine)->setVolumeGeometry(study->geometry, encoding);
    const core::SimplexMesh mesh = test::demoBrain();
    (*engine)->frames().updateSurface(core::wholeUpdate(mesh));
    const Triangles triangles = trianglesOf(mesh);
    std::fprintf(stderr, "a surface of %zu vertices, on %s\n", mesh.vertexCount(),
        qPrintable((*engine)->rendererName()));
    VtkPlaneView vtk(study->geometry, study->hounsfield, triangles.places, triangles.corners);
    PlaneClock clock(**engine);

    const gpu::SliceScene scene = oblique(0);
    gpu::SliceScene plain = scene;
    plain.contour.reset();
    const PlaneClock::Timed greys = clock.draw(plain);
    vtk.update(scene, frameSize, false);
    if (QString why = differs("linear", greys.linear, vtk.values(), scene, study->geometry);
        !why.isEmpty())
        return why;
    if (QString why = linesDiffer(clock.draw(scene).linear, vtk.lines(), scene); !why.isEmpty())
        return why;
    vtk.update(scene, frameSize, true);
    if (QString why = differs("cubic", greys.cubic, vtk.values(), scene, study->geometry);
        !why.isEmpty())
        return why;
    (void)clock.draw(viewOf(scene));

    std::array<std::vector<double>, 5> spent;
    for (int turn = 1; turn <= turns; ++turn) {
        const gpu::SliceScene next = oblique(turn);
        const PlaneClock::Timed slice = clock.draw(next);
        RowTimes::ended("plane.cubic", slice.cubicMs);
        RowTimes::took("plane.linear",
            Clock::now()
                - std::chrono::microseconds(
                    std::int64_t(1000.0 * (slice.cubicMs + slice.linearMs))),
            slice.linearMs);
        const PlaneClock::Timed view = clock.draw(viewOf(next));
        spent[0].push_back(slice.linearMs);
        spent[1].push_back(slice.cubicMs);
        spent[2].push_back(view.linearMs);
        for (const bool cubic : {false, true}) {
            // Moved, or the lines would be those of the turn before.
            gpu::SliceScene moved = next;
            moved.centreLps.z += cubic ? 0.02 : 0.01;
            const Clock::time_point start = Clock::now();
            vtk.update(moved, frameSize, cubic);
            spent[cubic ? 4 : 3].push_back(since(start));
        }
    }
    for (const char* id : {"plane.linear", "plane.cubic"})
        RowTimes::moves(id, 10.0 * frameSize.x * frameSize.y,
            "a value read for each pixel, each pixel written and fetched");
    const char* peer = "vtkImageReslice + vtkCutter";
    report.add({"plane.linear", "Ms", median(spent[0]), peer, median(spent[3])});
    report.add({"plane.cubic", "Ms", median(spent[1]), peer, median(spent[4])});
    report.add({"plane.view", "Ms", median(spent[2])});
    return {};
}

} // namespace bench
