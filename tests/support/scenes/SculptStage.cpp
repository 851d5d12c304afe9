// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/SculptStage.h"

#include "core/brick/BrickGrid.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/engine/EngineCommands.h"
#include "ui/tools/aim/PickQuestion.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <utility>

namespace test {

namespace {

constexpr double stepMm = 0.5;

/// Winding of a closed curve around a point; not 0: inside.
int winding(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p)
{
    int turns = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i] - p;
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()] - p;
        const double side = a.x * b.y - a.y * b.x;
        if (a.y <= 0.0 && b.y > 0.0 && side > 0.0)
            ++turns;
        if (a.y > 0.0 && b.y <= 0.0 && side < 0.0)
            --turns;
    }
    return turns;
}

double distanceTo(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p)
{
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 along = polygon[(i + 1) % polygon.size()] - a;
        const double length = glm::dot(along, along);
        const double t = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(p, a + t * along));
    }
    return nearest;
}

std::size_t indexOf(const glm::ivec3& size, const glm::ivec3& voxel)
{
    return std::size_t(voxel.x)
        + std::size_t(size.x) * (std::size_t(voxel.y) + std::size_t(size.y) * std::size_t(voxel.z));
}

/// Visits the voxels of rays a millimetre apart under a curve, half a millimetre a step, until the
/// visitor has seen enough.
void walkUnder(const core::VolumeGeometry& geometry, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& polygonMm, const std::function<void()>& begin,
    const std::function<bool(std::size_t voxel)>& visit, const std::function<void()>& end)
{
    const glm::dmat3 axes = *core::viewAxes(view, {});
    const glm::ivec3 size = geometry.size;
    glm::dvec2 low = polygonMm.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& point : polygonMm) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    for (double v = low.y; v <= high.y; v += 1.0) {
        for (double u = low.x; u <= high.x; u += 1.0) {
            if (winding(polygonMm, {u, v}) == 0)
                continue;
            const glm::dvec3 onPlane = view.targetLps + axes * glm::dvec3(u, v, 0.0);
            begin();
            bool more = true;
            for (double depth = -400.0; depth < 400.0 && more; depth += stepMm) {
                const glm::ivec3 voxel(glm::round(geometry.toIndex(onPlane + depth * axes[2])));
                if (glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0)))
                    && glm::all(glm::lessThan(voxel, size)))
                    more = visit(indexOf(size, voxel));
            }
            end();
        }
    }
}

/// How far a ray is with the shell.
struct ShellWalk {
    double gapMm = 0.0; ///< so much of something else ends it
    bool met = false;
    double behindMm = 0.0; ///< since it left it
    [[nodiscard]] bool isThrough() const { return met && behindMm >= gapMm; }
    void step(bool shell)
    {
        met = met || shell;
        behindMm = shell ? 0.0 : behindMm + stepMm;
    }
};

} // namespace

SculptStage::SculptStage(core::LoadedVolume study)
    : m_study(std::move(study))
{
    auto engine = gpu::GpuEngine::create();
    if (!engine)
        return;
    m_engine = *std::move(engine);
    auto session = core::EditSession::create(m_engine->edits(), m_study, {});
    if (!session)
        return;
    m_session = *std::move(session);
    m_engine->setVolumeGeometry(m_study.volume.geometry, m_study.volume.encoding);
}

QString SculptStage::apply(const core::Edit& edit)
{
    const std::size_t rows = m_session->history().rows().size();
    core::Result<void> result = m_session->apply(edit);
    if (result)
        result = m_session->settle();
    if (!result)
        return result.error().arguments.join(QStringLiteral(": "));
    return m_session->history().rows().size() > rows ? QString()
                                                     : QStringLiteral("changed nothing");
}

std::vector<std::uint8_t> SculptStage::voxels(core::Field field, std::uint8_t plane)
{
    const core::BrickGrid grid{m_study.volume.geometry.size};
    core::ReadBricks read;
    for (int brick = 0; brick < grid.brickCount(); ++brick)
        read.keys.push_back({field, plane, std::uint32_t(brick)});
    std::vector<std::uint8_t> dense(m_study.volume.geometry.voxelCount(), 0);
    core::EditEngine& engine = m_engine->edits();
    const core::Ticket ticket = engine.submit(std::move(read));
    engine.finish();
    for (const core::EngineResult& result : engine.collect()) {
        if (result.ticket != ticket)
            continue;
        for (const core::BrickChange& change : result.changes) {
            if (change.after.empty())
                continue;
            const core::VoxelBox box = grid.boxOf(int(change.key.brick));
            for (int k = box.minimum.z; k < box.maximum.z; ++k)
                for (int j = box.minimum.y; j < box.maximum.y; ++j)
                    for (int i = box.minimum.x; i < box.maximum.x; ++i)
                        dense[indexOf(grid.volumeSize, {i, j, k})] =
                            change.after
                                .read()[std::size_t(core::BrickGrid::offsetInBrick({i, j, k}))];
        }
    }
    return dense;
}

std::size_t SculptStage::placeOf(const glm::ivec3& voxel) const
{
    return indexOf(m_study.volume.geometry.size, voxel);
}

std::vector<glm::ivec3> SculptStage::seenVoxels(
    const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& pathMm)
{
    const core::VolumeGeometry& geometry = m_study.volume.geometry;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double step = std::min({spacing.x, spacing.y, spacing.z}) / 2.0;
    core::EditEngine& engine = m_engine->edits();
    core::PickQuestion question =
        ui::pickQuestion(scene, ui::alongPath(pathMm, step), m_study.volume);
    const core::Ticket ticket = engine.submit(core::PickVoxels{.rays = std::move(question.rays),
        .seenBy = question.seenBy,
        .thresholdCode = question.thresholdCode,
        .opacityOfCode = std::move(question.opacityOfCode)});
    engine.finish();
    std::vector<glm::ivec3> voxels;
    for (const core::EngineResult& result : engine.collect()) {
        if (result.ticket != ticket)
            continue;
        for (const std::optional<glm::ivec3>& pick : result.picks) {
            if (pick && std::find(voxels.begin(), voxels.end(), *pick) == voxels.end())
                voxels.push_back(*pick);
        }
    }
    return voxels;
}

gpu::Frame SculptStage::frame(const gpu::FrameRequest& request, gpu::Frame::Quality quality)
{
    std::mutex guard;
    std::condition_variable changed;
    std::optional<gpu::Frame> found;
    gpu::FrameSource& frames = m_engine->frames();
    frames.setListener([&](const gpu::Frame& frame) {
        const std::lock_guard lock(guard);
        if (frame.quality == quality && !found)
            found = frame;
        changed.notify_all();
    });
    frames.request(request);
    {
        std::unique_lock lock(guard);
        changed.wait(lock, [&] { return found.has_value(); });
    }
    frames.setListener({});
    frames.forget(request.view);
    return *found;
}

double SculptStage::fullFrameMs(const gpu::VolumeScene& scene, const glm::ivec2& size)
{
    return frame({.view = ++m_view, .sizePixels = size, .scene = scene, .segments = {}},
        gpu::Frame::Quality::Full)
        .renderMilliseconds;
}

void SculptStage::show(const core::SurfaceUpdate& surface)
{
    m_engine->frames().updateSurface(surface);
}

QImage SculptStage::draw(
    const gpu::VolumeScene& scene, const glm::ivec2& size, const gpu::SegmentDisplay& segments)
{
    const gpu::Frame finest =
        frame({.view = ++m_view, .sizePixels = size, .scene = scene, .segments = segments},
            gpu::Frame::Quality::Refined);
    return QImage(finest.rgba->data(), size.x, size.y, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB888);
}

std::vector<bool> behindShell(const core::VolumeGeometry& geometry,
    const core::OrthographicView& view, const std::vector<glm::dvec2>& polygonMm,
    const std::function<bool(std::size_t)>& isShell, double gapMm)
{
    std::vector<bool> behind(geometry.voxelCount(), false);
    ShellWalk walk;
    walkUnder(
        geometry, view, polygonMm, [&] { walk = {.gapMm = gapMm}; },
        [&](std::size_t voxel) {
            if (!walk.isThrough())
                walk.step(isShell(voxel));
            if (walk.isThrough())
                behind[voxel] = true;
            return true;
        },
        [] {});
    return behind;
}

BandShell bandShell(const core::VolumeGeometry& geometry, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& polygonMm, const std::function<double(std::size_t)>& valueOf,
    double surface, double band)
{
    constexpr auto farthest = std::ptrdiff_t(20.0 / stepMm); // from the surface to the band
    constexpr auto widestGap = std::ptrdiff_t(2.0 / stepMm); // within it
    BandShell shell;
    shell.over.assign(geometry.voxelCount(), false);
    shell.behind.assign(geometry.voxelCount(), false);
    std::vector<std::size_t> ray;
    int rays = 0;
    int met = 0;
    const auto look = [&] {
        ++rays;
        const auto reaches = [&](double least) {
            return [&valueOf, least](std::size_t voxel) { return valueOf(voxel) >= least; };
        };
        const auto first = std::find_if(ray.begin(), ray.end(), reaches(surface));
        const auto limit = ray.end() - first > farthest ? first + farthest : ray.end();
        auto last = std::find_if(first, limit, reaches(band));
        if (last == limit)
            return;
        ++met;
        for (auto next = last; next != ray.end() && next - last <= widestGap; ++next)
            last = valueOf(*next) >= band ? next : last;
        auto lowest = last;
        while (lowest + 1 != ray.end() && valueOf(lowest[1]) <= valueOf(*lowest))
            ++lowest;
        std::for_each(first, last + 1, [&](std::size_t voxel) { shell.over[voxel] = true; });
        std::for_each(
            lowest + 1, ray.end(), [&](std::size_t voxel) { shell.behind[voxel] = true; });
    };
    walkUnder(
        geometry, view, polygonMm, [&] { ray.clear(); },
        [&](std::size_t voxel) {
            ray.push_back(voxel);
            return true;
        },
        look);
    // Oblique rays pass through each other's voxels.
    for (std::size_t voxel = 0; voxel < shell.over.size(); ++voxel)
        shell.behind[voxel] = shell.behind[voxel] && !shell.over[voxel];
    shell.met = rays == 0 ? 0.0 : double(met) / rays;
    return shell;
}

Opening measureOpening(const core::VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& coverage, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& polygonMm, const std::function<bool(std::size_t)>& isShell,
    const std::function<bool(std::size_t)>& isSpared, double gapMm)
{
    Opening opening;
    int met = 0;
    int through = 0;
    ShellWalk walk;
    bool stands = false; // some of the shell
    walkUnder(
        geometry, view, polygonMm,
        [&] {
            walk = {.gapMm = gapMm};
            stands = false;
        },
        [&](std::size_t voxel) {
            const bool shell = isShell(voxel);
            walk.step(shell);
            stands = stands || (shell && coverage[voxel] < 128);
            return !walk.isThrough();
        },
        [&] {
            met += walk.met ? 1 : 0;
            through += walk.met && !stands ? 1 : 0;
        });
    opening.cutThrough = met == 0 ? 0.0 : double(through) / met;

    const glm::dmat3 axes = *core::viewAxes(view, {});
    const glm::ivec3 size = geometry.size;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double voxelMm = glm::length(spacing);
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const std::size_t at = indexOf(size, {i, j, k});
                const bool spared = isSpared(at);
                opening.spared += spared ? 1 : 0;
                if (coverage[at] < 128)
                    continue;
                ++opening.carved;
                opening.touched += spared ? 1 : 0;
                const glm::dvec3 away =
                    glm::transpose(axes) * (geometry.toWorld(glm::dvec3(i, j, k)) - view.targetLps);
                const glm::dvec2 place(away.x, away.y);
                if (winding(polygonMm, place) == 0 && distanceTo(polygonMm, place) > voxelMm)
                    ++opening.outside;
            }
        }
    }
    return opening;
}

} // namespace test
