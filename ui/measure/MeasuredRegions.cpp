// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/MeasuredRegions.h"

#include "core/measure/region/RegionVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <functional>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t samplesAtOnce = 1 << 16; ///< so that frames come between

} // namespace

/// Used by one thread at a time: the other one while it chooses or counts, else the window's.
struct MeasuredRegions::Job {
    core::Measurement measurement;
    core::MeasuredSize size;
    std::unique_ptr<core::RegionVoxels> region;
    core::RegionTally tally;
    std::size_t boxesRead = 0;
    std::size_t samplesRead = 0;
};

MeasuredRegions::MeasuredRegions(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &MeasuredRegions::drop);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        drop();
        lookOn();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Measurements)
                lookOn();
        });
    lookOn();
}

void MeasuredRegions::drop()
{
    m_background.cancel();
    m_job.reset();
}

void MeasuredRegions::lookOn()
{
    const core::EditSession* session = m_workspace.session();
    if (m_job || !session || !m_workspace.volume())
        return;
    const std::vector<core::Measurement>& all = session->document().measurements;
    const auto next = std::find_if(all.begin(), all.end(),
        [this](const core::Measurement& each) { return m_workspace.measured(each) == nullptr; });
    if (next == all.end())
        return;
    m_job = std::make_shared<Job>();
    m_job->measurement = *next;
    count(m_job, [job = m_job, volume = *m_workspace.volume()] {
        job->size = core::measuredSize(job->measurement, volume);
        job->region = std::make_unique<core::RegionVoxels>(job->measurement, volume.geometry);
    });
}

void MeasuredRegions::count(const std::shared_ptr<Job>& job, std::function<void()> does)
{
    m_background.start(this, std::move(does), [this, job](const core::Result<void>& done) {
        if (!done)
            fail(done.error());
        else
            readOn(job);
    });
}

void MeasuredRegions::readOn(const std::shared_ptr<Job>& job)
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_job != job)
        return;
    const std::vector<core::VoxelBox>& boxes = job->region->boxes();
    const std::vector<glm::ivec3>& samples = job->region->samples();
    if (job->boxesRead < boxes.size()) {
        const core::VoxelBox box = boxes[job->boxesRead++];
        session->questions().codes(
            box, [self = QPointer(this), job, box](core::Result<std::vector<std::uint16_t>> codes) {
                if (!self || self->m_job != job)
                    return;
                if (!codes)
                    return self->fail(codes.error());
                self->count(job, [job, box, read = *std::move(codes)] {
                    job->tally.add(job->region->codesInside(box, read));
                });
            });
    } else if (job->samplesRead < samples.size()) {
        const std::size_t end = std::min(samples.size(), job->samplesRead + samplesAtOnce);
        std::vector<glm::ivec3> voxels(samples.begin() + std::ptrdiff_t(job->samplesRead),
            samples.begin() + std::ptrdiff_t(end));
        job->samplesRead = end;
        session->questions().probe(std::move(voxels),
            [self = QPointer(this), job](core::Result<std::vector<core::ProbedVoxel>> probes) {
                if (!self || self->m_job != job)
                    return;
                if (!probes)
                    return self->fail(probes.error());
                self->count(job, [job, read = *std::move(probes)] {
                    std::vector<std::uint16_t> codes;
                    codes.reserve(read.size());
                    for (const core::ProbedVoxel& voxel : read)
                        codes.push_back(std::uint16_t(voxel.code));
                    job->tally.add(codes);
                });
            });
    } else {
        // A few additions by code; the voxels are counted.
        const core::Measured found{.measurement = job->measurement,
            .size = job->size,
            .values = job->tally.statistics(m_workspace.volume()->encoding)};
        m_job.reset();
        m_workspace.setMeasured(found);
        lookOn();
    }
}

void MeasuredRegions::fail(const core::Error& error)
{
    // Not asked again: what failed once would fail at every change.
    const std::shared_ptr<Job> job = std::move(m_job);
    m_job.reset();
    if (job)
        m_workspace.setMeasured({.measurement = job->measurement, .size = job->size});
    m_workspace.fail(error);
    lookOn();
}

} // namespace ui
