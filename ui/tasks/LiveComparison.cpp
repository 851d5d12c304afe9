// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/LiveComparison.h"

#include "core/brick/LabelRuns.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/SessionSurface.h"
#include "ui/workspace/Refinement.h"

#include <chrono>
#include <utility>

namespace ui {

LiveComparison::LiveComparison(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(std::chrono::milliseconds(250));
    connect(&m_timer, &QTimer::timeout, this, &LiveComparison::look);
    connect(&workspace, &Workspace::sessionClosing, this, &LiveComparison::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &LiveComparison::forget);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &LiveComparison::later);
    connect(&workspace.refinement(), &Refinement::changed, this, &LiveComparison::later);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Labels)
                m_labels.reset();
            later();
        });
    connect(
        &m_fetch, &LabelFetch::finished, this, [this](const std::vector<ExportJob::Plane>& planes) {
            m_labels = std::make_shared<const std::vector<std::uint8_t>>(planes.front().labels);
            compare();
        });
    // Edited meanwhile: once more.
    connect(&m_fetch, &LabelFetch::failed, this, &LiveComparison::later);
}

LiveComparison::~LiveComparison()
{
    if (m_job)
        m_job->progress.cancel();
}

bool LiveComparison::isBehind() const
{
    return m_reading || m_timer.isActive() || m_fetch.running() || m_job;
}

void LiveComparison::forget()
{
    m_timer.stop();
    m_fetch.cancel();
    m_labels.reset();
    if (m_job)
        m_job->progress.cancel();
    m_job.reset();
    m_path.clear();
    m_masks.reset();
    m_chosen = -1;
    m_reading = false;
    m_outcome.reset();
    Q_EMIT changed();
}

void LiveComparison::read(const QString& path)
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || m_reading)
        return;
    forget();
    m_reading = true;
    m_path = path;
    // The thread ends before the object does; another study may be open by then.
    const auto tell = [this, path](const std::shared_ptr<core::Result<core::MaskOnVolume>>& done) {
        QMetaObject::invokeMethod(
            this, [this, path, done] { takeMasks(path, std::move(*done)); }, Qt::QueuedConnection);
    };
    m_thread.post(
        [tell, path, volume = std::make_shared<const core::Volume>(*volume)] {
            tell(std::make_shared<core::Result<core::MaskOnVolume>>(
                core::readMask(path, *volume, {})));
        },
        [tell](const core::Error& error) {
            tell(std::make_shared<core::Result<core::MaskOnVolume>>(tl::unexpected(error)));
        });
    Q_EMIT changed();
}

void LiveComparison::takeMasks(const QString& path, core::Result<core::MaskOnVolume>&& read)
{
    if (!m_reading || path != m_path)
        return;
    m_reading = false;
    if (!read) {
        m_path.clear();
        Q_EMIT changed();
        return Q_EMIT failed(read.error());
    }
    m_masks = std::make_shared<const std::vector<core::MaskSegment>>(std::move(read->segments));
    choose(0);
}

QStringList LiveComparison::references() const
{
    QStringList names;
    if (m_masks) {
        for (const core::MaskSegment& segment : *m_masks)
            names.append(segment.name);
    }
    return names;
}

void LiveComparison::choose(int place)
{
    if (!m_masks || place < 0 || std::size_t(place) >= m_masks->size() || place == m_chosen)
        return;
    m_chosen = place;
    m_outcome.reset();
    later();
    Q_EMIT changed();
}

const core::Segment* LiveComparison::comparedSegment() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return nullptr;
    const auto surface = m_workspace.refinement().surface();
    return session->document().segment(surface ? surface->segment : m_workspace.activeSegment());
}

void LiveComparison::later()
{
    if (m_chosen >= 0)
        m_timer.start();
}

void LiveComparison::look()
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_chosen < 0)
        return;
    const core::Segment* segment = comparedSegment();
    if (!segment) {
        m_outcome.reset();
        return Q_EMIT changed();
    }
    // What stands open would be closed by the question.
    if (session->transactionOpen() || !session->idle())
        return later();
    if (session->surface().mesh() || m_labels)
        compare();
    else
        m_fetch.start(*session, {segment->plane});
}

void LiveComparison::compare()
{
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment = comparedSegment();
    if (!segment || m_chosen < 0)
        return;
    const core::SimplexMesh* mesh = session->surface().mesh();
    // What was fetched may not be what is asked by now.
    if (!mesh && !m_labels)
        return later();
    if (m_job)
        m_job->progress.cancel();
    m_job = std::make_shared<Job>();
    m_job->outcome.segment = segment->label;
    m_job->outcome.ofSurface = mesh != nullptr;
    if (mesh)
        m_job->mesh = *mesh;
    else
        m_job->labels = m_labels;
    m_job->masks = m_masks;
    m_job->reference = std::size_t(m_chosen);
    m_job->geometry = m_workspace.volume()->geometry;
    const auto tell = [this, job = m_job](
                          const std::shared_ptr<core::Result<core::MaskComparison>>& done) {
        QMetaObject::invokeMethod(
            this, [this, job, done] { take(job, *done); }, Qt::QueuedConnection);
    };
    const auto compared = [job = m_job] {
        const Job& work = *job;
        const core::Result<core::VoxelRuns> voxels = work.labels
            ? core::Result<core::VoxelRuns>(
                core::labelRuns(*work.labels, std::uint8_t(work.outcome.segment)))
            : core::voxelsOf(work.mesh, work.geometry, work.progress);
        auto done = std::make_shared<core::Result<core::MaskComparison>>();
        if (voxels)
            *done = core::compareMasks(
                *voxels, (*work.masks)[work.reference].voxels, work.geometry, work.progress);
        else
            *done = tl::unexpected(voxels.error());
        return done;
    };
    m_thread.post([tell, compared] { tell(compared()); },
        [tell](const core::Error& error) {
            tell(std::make_shared<core::Result<core::MaskComparison>>(tl::unexpected(error)));
        });
    Q_EMIT changed();
}

void LiveComparison::take(
    const std::shared_ptr<Job>& job, const core::Result<core::MaskComparison>& done)
{
    if (job != m_job)
        return;
    m_job.reset();
    m_outcome.reset();
    if (done) {
        m_outcome = job->outcome;
        m_outcome->comparison = *done;
    }
    Q_EMIT changed();
}

} // namespace ui
