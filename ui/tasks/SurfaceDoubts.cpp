// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/SurfaceDoubts.h"

#include "core/refine/fit/DoubtfulVertices.h"
#include "core/refine/mesh/ShownSurface.h"
#include "core/refine/voxels/BoxMask.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/WorldToIndex.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ui {

namespace {

constexpr double reachVoxels = 1.5; // of the finest spacing, to either side of the surface
constexpr double offVoxels = 1.5;
constexpr double walkVoxels = 4.0; // as the surface itself looks for the mask's boundary
constexpr std::size_t leastVertices = 6; // fewer are noise

double finestMm(const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min({spacing.x, spacing.y, spacing.z});
}

core::VoxelBox boxAround(
    const core::SurfaceMirror& surface, const core::VolumeGeometry& geometry, double marginMm)
{
    glm::dvec3 least(std::numeric_limits<double>::max());
    glm::dvec3 most(std::numeric_limits<double>::lowest());
    const core::WorldToIndex toIndex(geometry);
    surface.forEachVertex([&](core::VertexId, const core::SurfaceUpdate::Vertex& vertex) {
        const glm::dvec3 index = toIndex(vertex.positionLps);
        least = glm::min(least, index);
        most = glm::max(most, index);
    });
    const glm::dvec3 margin = marginMm / geometry.spacingMm() + 1.0;
    core::VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const int end = geometry.size[axis];
        box.minimum[axis] = std::clamp(int(std::floor(least[axis] - margin[axis])), 0, end - 1);
        box.maximum[axis] =
            std::clamp(int(std::ceil(most[axis] + margin[axis])) + 1, box.minimum[axis] + 1, end);
    }
    return box;
}

} // namespace

/// The thread's from when all is fetched.
struct SurfaceDoubts::Job {
    core::SurfaceMirror surface; ///< where it truly lies
    core::VolumeGeometry geometry;
    int label = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> labels; ///< of its plane, x fastest
    core::VoxelBox box;
    std::vector<std::uint16_t> codes; ///< of the box

    [[nodiscard]] std::vector<Doubt> found();
};

std::vector<SurfaceDoubts::Doubt> SurfaceDoubts::Job::found()
{
    const double voxelMm = finestMm(geometry);
    std::vector<Doubt> doubts;
    const auto add = [&](const std::vector<bool>& isDoubted, Doubt::Why why) {
        for (const core::MarkedRegion& region : surface.regions(isDoubted)) {
            if (region.vertices >= leastVertices)
                doubts.push_back({.why = why, .region = core::shownRegion(region, geometry)});
        }
    };
    const core::BoxMask mask = core::BoxMask::of(*labels, std::uint8_t(label), geometry.size);
    if (!mask.empty()) {
        const core::BoundaryForce boundary(mask, geometry, walkVoxels);
        add(core::offTheMask(surface, boundary, offVoxels * voxelMm), Doubt::Why::OffMask);
    }
    const core::GreyBox grey(geometry, box.minimum, box.maximum - box.minimum, std::move(codes));
    add(core::withoutAnEdge(surface, grey, reachVoxels * voxelMm), Doubt::Why::NoEdge);
    return doubts;
}

SurfaceDoubts::SurfaceDoubts(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &SurfaceDoubts::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &SurfaceDoubts::forget);
    connect(&workspace.refinement(), &Refinement::changed, this, [this] {
        if (!m_workspace.refinement().surface() && (m_job || m_hasFound))
            forget();
    });
    connect(&m_fetch, &LabelFetch::finished, this, [this](const LabelFetch::Planes& planes) {
        if (!m_job)
            return;
        m_job->labels = {planes, &planes->front().labels};
        askForCodes(m_job);
    });
    connect(&m_fetch, &LabelFetch::failed, this, &SurfaceDoubts::fail);
}

void SurfaceDoubts::forget()
{
    m_fetch.cancel();
    m_background.cancel();
    m_job.reset();
    m_doubts.clear();
    m_hasFound = false;
    Q_EMIT changed();
}

void SurfaceDoubts::fail(const core::Error& error)
{
    forget();
    Q_EMIT failed(error);
}

void SurfaceDoubts::look()
{
    core::EditSession* session = m_workspace.session();
    const std::optional<core::RefinedSurface> surface = m_workspace.refinement().surface();
    if (!session || !surface || m_workspace.refinement().mirror().empty())
        return;
    forget();
    m_job = std::make_shared<Job>();
    m_job->surface = m_workspace.refinement().trueMirror();
    m_job->geometry = m_workspace.volume()->geometry;
    m_job->label = surface->segment;
    m_job->box =
        boxAround(m_job->surface, m_job->geometry, 2.0 * reachVoxels * finestMm(m_job->geometry));
    m_fetch.start(*session, {session->document().segment(surface->segment)->plane});
    Q_EMIT changed();
}

void SurfaceDoubts::askForCodes(const std::shared_ptr<Job>& job)
{
    m_workspace.session()->questions().codes(
        job->box, [self = QPointer(this), job](core::Result<std::vector<std::uint16_t>> codes) {
            if (!self || self->m_job != job)
                return;
            if (!codes)
                return self->fail(codes.error());
            job->codes = *std::move(codes);
            self->workOut(job);
        });
}

void SurfaceDoubts::workOut(const std::shared_ptr<Job>& job)
{
    // What was under way when the question came has changed it since.
    job->surface = m_workspace.refinement().trueMirror();
    m_background.start(
        this, [job] { return job->found(); },
        [this](core::Result<std::vector<Doubt>>&& found) {
            if (!found)
                return fail(found.error());
            m_job.reset();
            m_doubts = *std::move(found);
            m_hasFound = true;
            Q_EMIT changed();
        });
}

} // namespace ui
