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
    const std::vector<glm::dvec2>& path, const ViewContext& slice, const core::Volume& volume)
{
    return voxelsAt(alongPath(path, sketchStepPixels(volume, slice)), slice, volume);
}

std::vector<glm::ivec3> voxelsAt(
    const std::vector<glm::dvec2>& pixels, const ViewContext& slice, const core::Volume& volume)
{
    std::vector<glm::ivec3> voxels;
    for (const glm::dvec2& pixel : pixels) {
        const glm::dvec3 lps = slice.toLps({pixel.x, pixel.y});
        const glm::ivec3 voxel(glm::round(volume.geometry.toIndex(lps)));
        if (volume.geometry.contains(voxel))
            voxels.push_back(voxel);
    }
    return uniqueVoxels(voxels);
}

std::vector<glm::dvec2> pointsCovered(
    const std::vector<glm::dvec2>& path, const std::vector<double>& radiiPixels, double stepPixels)
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
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) {
            const glm::dvec2 way = path[i] - path[i - 1];
            const double wider = radiiPixels[i] - radiiPixels[i - 1];
            const int pieces = std::max(1, int(std::ceil(glm::length(way) / stepPixels)));
            for (int piece = 1; piece < pieces; ++piece) {
                const double share = double(piece) / pieces;
                dab(path[i - 1] + way * share, radiiPixels[i - 1] + wider * share);
            }
        }
        dab(path[i], radiiPixels[i]);
    }
    return points;
}

std::vector<glm::dvec2> planePointsUnder(
    const std::vector<glm::dvec2>& path, const ViewContext& view, const core::Volume& volume)
{
    std::vector<glm::dvec2> planeMm;
    for (const glm::dvec2& pixel : alongPath(path, sketchStepPixels(volume, view)))
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

void SketchedVoxels::follow(const std::vector<glm::dvec2>& path)
{
    if (!m_view || !m_workspace.volume())
        return;
    m_path = path;
    if (!m_asking)
        askNext();
}

void SketchedVoxels::askNext()
{
    if (m_looked >= m_path.size())
        return;
    // The way from the last point that was looked at belongs to what is new.
    const auto from = m_path.begin() + std::ptrdiff_t(m_looked == 0 ? 0 : m_looked - 1);
    const std::vector<glm::dvec2> added(from, m_path.end());
    m_looked = m_path.size();
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
