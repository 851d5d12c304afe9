// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SketchedVoxels.h"

#include "ui/tools/aim/PickQuestion.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <array>
#include <set>

namespace ui {

namespace {

/// Points along a path and, where it is wide, on a grid beside it, each once.
std::vector<glm::dvec2> pointsCovered(const SketchPath& path, double stepPixels)
{
    std::vector<glm::dvec2> points;
    std::set<std::array<int, 2>> taken;
    const auto dab = [&](const glm::dvec2& centre, double radius) {
        points.push_back(centre);
        const glm::ivec2 low(glm::ceil((centre - radius) / stepPixels));
        const glm::ivec2 high(glm::floor((centre + radius) / stepPixels));
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 point = stepPixels * glm::dvec2(x, y);
                if (glm::distance(point, centre) <= radius && taken.insert({x, y}).second)
                    points.push_back(point);
            }
        }
    };
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        if (i > 0) {
            const glm::dvec2 way = path.points[i] - path.points[i - 1];
            const double wider = path.radii[i] - path.radii[i - 1];
            const int pieces = std::max(1, int(std::ceil(glm::length(way) / stepPixels)));
            for (int piece = 1; piece < pieces; ++piece) {
                const double share = double(piece) / pieces;
                dab(path.points[i - 1] + way * share, path.radii[i - 1] + wider * share);
            }
        }
        dab(path.points[i], path.radii[i]);
    }
    return points;
}

} // namespace

void SketchPath::clear()
{
    points.clear();
    radii.clear();
}

std::vector<glm::ivec3> uniqueVoxels(const std::vector<glm::ivec3>& voxels)
{
    std::set<std::array<int, 3>> seen;
    std::vector<glm::ivec3> result;
    for (const glm::ivec3& voxel : voxels) {
        if (seen.insert({voxel.x, voxel.y, voxel.z}).second)
            result.push_back(voxel);
    }
    return result;
}

double sketchStepPixels(const core::Volume& volume, const ViewContext& view)
{
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    return 0.5 * std::min({spacing.x, spacing.y, spacing.z}) / view.mmPerPixel();
}

std::vector<glm::ivec3> voxelsUnder(
    const SketchPath& path, const ViewContext& slice, const core::Volume& volume)
{
    const double step = sketchStepPixels(volume, slice);
    std::vector<glm::ivec3> voxels;
    for (const glm::dvec2& pixel :
        path.radii.empty() ? alongPath(path.points, step) : pointsCovered(path, step)) {
        const glm::dvec3 lps = slice.toLps({pixel.x, pixel.y});
        const glm::ivec3 voxel(glm::round(volume.geometry.toIndex(lps)));
        if (volume.geometry.contains(voxel))
            voxels.push_back(voxel);
    }
    return uniqueVoxels(voxels);
}

std::vector<glm::dvec2> planePointsUnder(
    const SketchPath& path, const ViewContext& view, const core::Volume& volume)
{
    const double step = sketchStepPixels(volume, view);
    std::vector<glm::dvec2> planeMm;
    // Where it is wide, a ray for each voxel's width, since each of them is asked about.
    for (const glm::dvec2& pixel :
        path.radii.empty() ? alongPath(path.points, step) : pointsCovered(path, 2.0 * step))
        planeMm.push_back(view.toViewPlaneMm({pixel.x, pixel.y}));
    return planeMm;
}

SketchedVoxels::SketchedVoxels(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
}

void SketchedVoxels::begin(const ViewContext& view)
{
    end();
    m_view = view;
}

void SketchedVoxels::end()
{
    ++m_sketch;
    m_view.reset();
    m_path.clear();
    m_voxels.clear();
    m_looked = 0;
    m_asking = false;
}

void SketchedVoxels::follow(const SketchPath& path)
{
    if (!m_view || !m_workspace.volume())
        return;
    m_path = path;
    if (!m_asking)
        askNext();
}

void SketchedVoxels::askNext()
{
    if (m_looked >= m_path.points.size())
        return;
    // The way from the last point that was looked at belongs to what is new.
    const auto from = std::ptrdiff_t(m_looked == 0 ? 0 : m_looked - 1);
    SketchPath added{.points = {m_path.points.begin() + from, m_path.points.end()}};
    if (!m_path.radii.empty())
        added.radii.assign(m_path.radii.begin() + from, m_path.radii.end());
    m_looked = m_path.points.size();
    const core::Volume& volume = *m_workspace.volume();
    if (m_view->isSlice())
        return add(voxelsUnder(added, *m_view, volume));
    m_asking = true;
    askWhatIsSeen(m_workspace, std::get<gpu::VolumeScene>(m_view->scene),
        planePointsUnder(added, *m_view, volume),
        [sketched = QPointer<SketchedVoxels>(this), sketch = m_sketch](
            const core::Result<SeenVoxels>& seen) {
            if (!sketched || sketched->m_sketch != sketch)
                return;
            sketched->m_asking = false;
            std::vector<glm::ivec3> voxels;
            for (const auto& pick : seen.value_or(SeenVoxels{})) {
                if (pick)
                    voxels.push_back(pick->voxel);
            }
            sketched->add(voxels);
            sketched->askNext();
        });
}

void SketchedVoxels::add(const std::vector<glm::ivec3>& voxels)
{
    const std::size_t before = m_voxels.size();
    m_voxels.insert(m_voxels.end(), voxels.begin(), voxels.end());
    m_voxels = uniqueVoxels(m_voxels);
    if (m_voxels.size() > before)
        Q_EMIT grew();
}

} // namespace ui
