// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/RegionReader.h"

#include "core/measure/region/RegionVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t samplesAtOnce = 1 << 16; ///< so that frames come between

} // namespace

/// Used by one thread at a time: the other one while it chooses or counts, else the window's.
struct RegionReader::Job {
    Found found;
    std::function<void(const Found&)> done;
    std::unique_ptr<core::RegionVoxels> region;
    std::size_t boxesRead = 0;
    std::size_t samplesRead = 0;
};

RegionReader::RegionReader(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
}

void RegionReader::drop()
{
    m_background.cancel();
    m_job.reset();
}

void RegionReader::read(
    const core::Measurement& measurement, std::function<void(const Found&)> done)
{
    drop();
    if (!m_workspace.volume())
        return;
    m_job = std::make_shared<Job>();
    m_job->done = std::move(done);
    count(m_job, [job = m_job, measurement, volume = *m_workspace.volume()] {
        job->found.size = core::measuredSize(measurement, volume);
        job->region = std::make_unique<core::RegionVoxels>(measurement, volume.geometry);
    });
}

void RegionReader::count(const std::shared_ptr<Job>& job, std::function<void()> does)
{
    m_background.start(this, std::move(does), [this, job](const core::Result<void>& done) {
        if (!done)
            finish(done.error());
        else
            readOn(job);
    });
}

void RegionReader::readOn(const std::shared_ptr<Job>& job)
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
                    return self->finish(codes.error());
                self->count(job, [job, box, read = *std::move(codes)] {
                    job->found.tally.add(job->region->codesInside(box, read));
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
                    return self->finish(probes.error());
                self->count(job, [job, read = *std::move(probes)] {
                    std::vector<std::uint16_t> codes;
                    codes.reserve(read.size());
                    for (const core::ProbedVoxel& voxel : read)
                        codes.push_back(std::uint16_t(voxel.code));
                    job->found.tally.add(codes);
                });
            });
    } else {
        finish(std::nullopt);
    }
}

void RegionReader::finish(std::optional<core::Error> error)
{
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    if (!job)
        return;
    job->found.error = std::move(error);
    job->done(job->found);
}

} // namespace ui
