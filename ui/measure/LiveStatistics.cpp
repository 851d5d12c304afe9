// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/LiveStatistics.h"

#include "core/brick/LabelBox.h"
#include "core/brick/LabelRuns.h"
#include "core/export/common/ImportedSegments.h"
#include "core/export/common/SegmentMeter.h"
#include "core/session/past/PastImports.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace ui {

namespace {

/// The engine is asked for so many values together; other work comes in between.
constexpr std::int64_t valuesAtOnce = 1 << 20;

/// Whether a change there may have taken voxels of what was measured.
bool touches(const core::VoxelBox& box, const core::SegmentStatistics& measured)
{
    return glm::all(glm::lessThanEqual(box.minimum, measured.last))
        && glm::all(glm::greaterThan(box.maximum, measured.first));
}

} // namespace

/// The other thread's while it works.
struct LiveStatistics::Job {
    core::VolumeGeometry geometry;
    core::VoxelEncoding encoding;
    std::vector<core::Segment> segments{}; ///< to be measured, in turn
    std::vector<core::DoneImport> imports{};
    std::size_t current = 0;
    LabelFetch::Planes planes{};
    std::span<const std::uint8_t> labels{}; ///< of the current one's plane
    std::shared_ptr<const core::VoxelRuns>
        before{}; ///< its voxels when it was measured; null: never
    std::shared_ptr<const core::VoxelRuns> voxels{};
    bool isUnchanged = false;
    core::VoxelBox box{}; ///< around its voxels
    int nextSlice = 0; ///< of the box, the first that is not counted
    std::optional<core::SegmentMeter> meter{};

    [[nodiscard]] const core::Segment& segment() const { return segments[current]; }
    void find()
    {
        const core::Segment& its = segment();
        const auto plane = std::find_if(planes->begin(), planes->end(),
            [&its](const ExportJob::Plane& each) { return each.plane == its.plane; });
        labels = plane->labels;
        voxels = std::make_shared<const core::VoxelRuns>(core::labelRuns(labels, its.label));
        isUnchanged = before && *before == *voxels;
        if (isUnchanged || voxels->empty())
            return;
        box = core::boxOfLabel(labels, geometry.size, its.label);
        nextSlice = box.minimum.z;
        meter.emplace(geometry, encoding, its, labels);
    }
    [[nodiscard]] core::SegmentStatistics measured() const
    {
        core::SegmentStatistics found = meter->statistics();
        if (!imports.empty())
            found.sinceImport = core::changeSinceImport(*voxels, segment().label,
                core::importedAs({segment()}, imports, geometry.voxelCount()), geometry);
        return found;
    }
};

LiveStatistics::LiveStatistics(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(std::chrono::milliseconds(250));
    connect(&m_timer, &QTimer::timeout, this, &LiveStatistics::look);
    connect(&workspace, &Workspace::sessionClosing, this, &LiveStatistics::forget);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        forget();
        later();
    });
    connect(&workspace, &Workspace::documentChanged, this, &LiveStatistics::follow);
    connect(&m_fetch, &LabelFetch::finished, this, &LiveStatistics::takeLabels);
    connect(&m_fetch, &LabelFetch::failed, this, [this](const core::Error& error) {
        if (!m_fetch.mayTryAgain(error))
            return fail(error);
        m_job.reset();
        later();
    });
}

void LiveStatistics::setWatched(bool watched)
{
    if (std::exchange(m_watched, watched) == watched)
        return;
    stop();
    later();
    Q_EMIT changed();
}

const core::SegmentStatistics* LiveStatistics::of(int label) const
{
    const auto its = m_known.find(label);
    return its == m_known.end() ? nullptr : &its->second.statistics;
}

bool LiveStatistics::isBehind(int label) const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment || segment->voxels == 0)
        return false;
    const auto its = m_known.find(label);
    return its == m_known.end() || its->second.behind;
}

void LiveStatistics::forget()
{
    stop();
    m_known.clear();
    Q_EMIT changed();
}

void LiveStatistics::stop()
{
    m_timer.stop();
    m_fetch.cancel();
    m_background.cancel();
    m_job.reset();
}

void LiveStatistics::later()
{
    if (m_watched && m_workspace.session())
        m_timer.start();
}

void LiveStatistics::follow(const core::DocumentChange& change)
{
    using What = core::DocumentChange::What;
    if (change.what == What::Labels) {
        for (auto& [label, known] : m_known)
            known.behind = known.behind || touches(change.box, known.statistics);
        stop();
    } else if (change.what == What::Segments) {
        noteCounts();
        // What is being measured stays right: no voxel has changed.
        if (m_job)
            return Q_EMIT changed();
    } else {
        return;
    }
    later();
    // Who begins to watch is told then.
    if (m_watched)
        Q_EMIT changed();
}

/// A segment that has changed elsewhere than where it was has more voxels than it had, or none.
void LiveStatistics::noteCounts()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    for (auto its = m_known.begin(); its != m_known.end();) {
        const core::Segment* segment = session->document().segment(its->first);
        if (!segment || segment->voxels == 0) {
            its = m_known.erase(its);
            continue;
        }
        if (segment->voxels != its->second.statistics.voxels)
            its->second.behind = true;
        ++its;
    }
}

void LiveStatistics::look()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_watched)
        return;
    noteCounts();
    std::vector<core::Segment> wanted;
    std::set<std::uint8_t> planes;
    for (const core::Segment& segment : session->document().segments) {
        if (!isBehind(segment.label))
            continue;
        wanted.push_back(segment);
        planes.insert(segment.plane);
    }
    if (wanted.empty())
        return Q_EMIT changed();
    // What stands open would be closed by the question.
    if (session->transactionOpen() || !session->idle())
        return later();
    const core::Volume& volume = *m_workspace.volume();
    m_job = std::make_shared<Job>(Job{.geometry = volume.geometry,
        .encoding = volume.encoding,
        .segments = std::move(wanted),
        .imports = core::doneImports(session->history())});
    m_fetch.start(*session, planes);
}

void LiveStatistics::takeLabels(const LabelFetch::Planes& planes)
{
    if (!m_job)
        return;
    m_job->planes = planes;
    beginNext();
}

void LiveStatistics::beginNext()
{
    if (m_job->current == m_job->segments.size()) {
        m_job.reset();
        return Q_EMIT changed();
    }
    const int label = m_job->segment().label;
    const auto known = m_known.find(label);
    m_job->before = known == m_known.end() ? nullptr : known->second.voxels;
    m_background.start(
        this, [job = m_job] { job->find(); },
        [this, label](const core::Result<void>& found) {
            if (!found)
                return fail(found.error());
            if (!m_job->isUnchanged && !m_job->voxels->empty())
                return askForCodes();
            if (const auto its = m_known.find(label); its != m_known.end())
                its->second.behind = false;
            ++m_job->current;
            beginNext();
        });
}

void LiveStatistics::askForCodes()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return stop();
    const std::shared_ptr<Job>& job = m_job;
    core::VoxelBox part = job->box;
    part.minimum.z = job->nextSlice;
    if (part.minimum.z >= part.maximum.z)
        return measure();
    const glm::ivec3 size = part.maximum - part.minimum;
    const std::int64_t slices =
        std::max<std::int64_t>(1, valuesAtOnce / (std::int64_t(size.x) * size.y));
    part.maximum.z = int(std::min<std::int64_t>(part.maximum.z, part.minimum.z + slices));
    session->questions().codes(
        part, [self = QPointer(this), job, part](core::Result<std::vector<std::uint16_t>> codes) {
            if (!self || self->m_job != job)
                return;
            if (!codes)
                return self->fail(codes.error());
            job->nextSlice = part.maximum.z;
            self->count(part, *std::move(codes));
        });
}

void LiveStatistics::count(const core::VoxelBox& box, std::vector<std::uint16_t> codes)
{
    m_background.start(
        this, [job = m_job, box, codes = std::move(codes)] { job->meter->count(box, codes); },
        [this](const core::Result<void>& counted) {
            if (!counted)
                return fail(counted.error());
            askForCodes();
        });
}

void LiveStatistics::measure()
{
    m_background.start(
        this, [job = m_job] { return job->measured(); },
        [this](const core::Result<core::SegmentStatistics>& measured) {
            if (!measured)
                return fail(measured.error());
            m_known[m_job->segment().label] = {m_job->voxels, *measured};
            ++m_measuredSegments;
            ++m_job->current;
            // Later ones may take long.
            Q_EMIT changed();
            if (m_job)
                beginNext();
        });
}

void LiveStatistics::fail(const core::Error& error)
{
    stop();
    Q_EMIT changed();
    Q_EMIT failed(error);
}

} // namespace ui
