// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/AxesOfSegment.h"

#include "core/edits/kinds/views/Measurements.h"
#include "core/outline/SegmentAxes.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <bitset>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ui {

/// Used by one thread at a time: the other one while it chooses or finds, else the window's.
struct AxesOfSegment::Job {
    core::SliceLattice lattice;
    core::VolumeGeometry geometry;
    glm::ivec2 pixel{0};
    std::vector<std::uint8_t> planes; ///< to look into, in this order
    std::bitset<256> shown; ///< labels that are looked for first
    std::vector<core::BrickKey> keys{};
    std::vector<core::BrickImage> bricks{};
    std::optional<core::SegmentAxes> axes{};

    /// The voxel that a pixel shows; none beside the volume.
    [[nodiscard]] std::optional<glm::ivec3> voxelAt(int x, int y) const
    {
        const glm::dvec3 place =
            lattice.originLps + double(x) * lattice.columnLps + double(y) * lattice.rowLps;
        const glm::ivec3 voxel(glm::floor(geometry.toIndex(place) + 0.5));
        return geometry.contains(voxel) ? std::optional(voxel) : std::nullopt;
    }
    void chooseBricks()
    {
        const core::BrickGrid grid{geometry.size};
        std::set<int> chosen;
        for (int y = 0; y < lattice.size.y; ++y) {
            for (int x = 0; x < lattice.size.x; ++x) {
                if (const auto voxel = voxelAt(x, y))
                    chosen.insert(grid.brickOf(*voxel));
            }
        }
        for (const std::uint8_t plane : planes) {
            for (const int brick : chosen)
                keys.push_back({core::Field::Labels, plane, std::uint32_t(brick)});
        }
    }
    void findAxes()
    {
        for (const std::bitset<256>& wanted : {shown, ~shown}) {
            for (const std::uint8_t plane : planes) {
                if (findAxesIn(plane, wanted))
                    return;
            }
        }
    }
    /// @return whether one of the segments of the plane is there
    bool findAxesIn(std::uint8_t plane, const std::bitset<256>& wanted)
    {
        const core::BrickGrid grid{geometry.size};
        std::vector<const core::BrickImage*> ofBrick(std::size_t(grid.brickCount()), nullptr);
        for (const core::BrickImage& image : bricks) {
            if (!image.bytes.empty() && image.key.plane == plane)
                ofBrick[image.key.brick] = &image;
        }
        const auto labelAt = [&](int x, int y) -> std::uint8_t {
            const auto voxel = voxelAt(x, y);
            const core::BrickImage* image =
                voxel ? ofBrick[std::size_t(grid.brickOf(*voxel))] : nullptr;
            return image ? image->bytes.read()[std::size_t(core::BrickGrid::offsetInBrick(*voxel))]
                         : std::uint8_t(0);
        };
        const std::uint8_t label = labelAt(pixel.x, pixel.y);
        if (label == 0 || !wanted.test(label))
            return false;
        std::vector<std::uint8_t> inside;
        for (int y = 0; y < lattice.size.y; ++y) {
            for (int x = 0; x < lattice.size.x; ++x)
                inside.push_back(labelAt(x, y) == label ? 1 : 0);
        }
        axes = core::segmentAxes(lattice, geometry, inside, pixel);
        return true;
    }
};

AxesOfSegment::AxesOfSegment(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &AxesOfSegment::drop);
}

void AxesOfSegment::drop()
{
    m_background.cancel();
    m_job.reset();
}

void AxesOfSegment::suggest(const ViewContext& view, const glm::dvec3& placeLps)
{
    drop();
    const auto* scene = std::get_if<gpu::SliceScene>(&view.scene);
    core::EditSession* session = m_workspace.session();
    if (!scene || !session || !m_workspace.volume())
        return;
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const core::SliceLattice lattice =
        core::sliceLattice(geometry, scene->centreLps, scene->rightLps, scene->downLps);
    const std::optional<glm::ivec2> pixel = lattice.pixelAt(placeLps);
    if (!pixel)
        return m_workspace.say(tr("Nothing was measured: click on a segment"));
    // The active one's first, then higher ones before lower ones.
    std::vector<std::uint8_t> inOrder = session->document().labelPlanes();
    std::reverse(inOrder.begin(), inOrder.end());
    if (const core::Segment* active = session->document().segment(m_workspace.activeSegment()))
        std::stable_partition(inOrder.begin(), inOrder.end(),
            [active](std::uint8_t plane) { return plane == active->plane; });
    std::bitset<256> shown;
    for (const core::Segment& segment : session->document().segments)
        shown.set(segment.label, segment.visible);
    m_job = std::make_shared<Job>(Job{.lattice = lattice,
        .geometry = geometry,
        .pixel = *pixel,
        .planes = std::move(inOrder),
        .shown = shown});
    m_background.start(
        this, [job = m_job] { job->chooseBricks(); },
        [this, job = m_job](const core::Result<void>& chosen) {
            if (!chosen)
                fail(chosen.error());
            else
                read(job);
        });
}

void AxesOfSegment::read(const std::shared_ptr<Job>& job)
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_job != job)
        return;
    session->questions().bricks(job->keys,
        [self = QPointer(this), job](core::Result<std::vector<core::BrickImage>> bricks) {
            if (!self || self->m_job != job)
                return;
            if (!bricks)
                return self->fail(bricks.error());
            job->bricks = *std::move(bricks);
            self->find(job);
        });
}

void AxesOfSegment::find(const std::shared_ptr<Job>& job)
{
    m_background.start(
        this, [job] { job->findAxes(); },
        [this, job](const core::Result<void>& found) {
            if (!found)
                return fail(found.error());
            m_job.reset();
            keep(*job);
        });
}

void AxesOfSegment::keep(const Job& job)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (!job.axes)
        return m_workspace.say(tr("Nothing was measured: click on a segment"));
    const core::SegmentAxes& axes = *job.axes;
    for (const core::AddMeasurement& edit :
        {core::AddMeasurement{.fromLps = axes.longFromLps, .toLps = axes.longToLps},
            core::AddMeasurement{.fromLps = axes.shortFromLps, .toLps = axes.shortToLps}}) {
        if (const auto kept = session->apply(edit); !kept)
            return m_workspace.fail(kept.error());
    }
    const auto length = [this](const glm::dvec3& from, const glm::dvec3& to) {
        const core::Measurement measured{.pointsLps = {from, to}};
        return sizeLines(measured, core::measuredSize(measured, *m_workspace.volume())).front();
    };
    m_workspace.say(tr("Longest axis %1, across it %2")
                        .arg(length(axes.longFromLps, axes.longToLps),
                            length(axes.shortFromLps, axes.shortToLps)));
}

void AxesOfSegment::fail(const core::Error& error)
{
    drop();
    m_workspace.fail(error);
}

} // namespace ui
