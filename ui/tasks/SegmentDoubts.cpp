// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/SegmentDoubts.h"

#include "core/doubts/PlacesToLookAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace ui {

namespace {

/// The engine is asked for so many values together; other work comes in between.
constexpr std::int64_t codesAtOnce = 1 << 20;
/// A place that is found so near to one that was seen is the same.
constexpr double sameMm = 5.0;

} // namespace

/// The other thread's while it works.
struct SegmentDoubts::Job {
    core::VolumeGeometry geometry;
    int label = 0;
    std::uint8_t plane = 0;
    Mask second;
    std::shared_ptr<const std::vector<std::uint8_t>> labels; ///< of its plane, x fastest
    core::VoxelBox box;
    /// Of the box, as far as they have come. They are joined where there is time.
    std::vector<std::vector<std::uint16_t>> codes;
    int slicesRead = 0;
    bool editedSince = false; ///< after the labels were asked for

    [[nodiscard]] core::Result<Places> places(const core::Progress& progress) const
    {
        const glm::ivec3 size = box.maximum - box.minimum;
        std::vector<std::uint16_t> all;
        all.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        for (const std::vector<std::uint16_t>& portion : codes)
            all.insert(all.end(), portion.begin(), portion.end());
        const core::BorderSource source{.geometry = geometry,
            .labels = *labels,
            .label = std::uint8_t(label),
            .box = box,
            .codes = all};
        return core::placesToLookAt(source, second.get(), mostPlaces, progress);
    }
};

bool SegmentDoubts::Found::allSeen() const
{
    return std::all_of(
        entries.begin(), entries.end(), [](const Entry& entry) { return entry.seen; });
}

SegmentDoubts::SegmentDoubts(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_again.setSingleShot(true);
    m_again.setInterval(std::chrono::milliseconds(250));
    connect(&m_again, &QTimer::timeout, this, &SegmentDoubts::fetch);
    connect(&workspace, &Workspace::sessionClosing, this, &SegmentDoubts::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &SegmentDoubts::forget);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SegmentDoubts::changed);
    connect(&workspace, &Workspace::documentChanged, this, &SegmentDoubts::follow);
    connect(&m_fetch, &LabelFetch::finished, this, &SegmentDoubts::takeLabels);
    connect(&m_fetch, &LabelFetch::failed, this, [this](const core::Error& error) {
        if (m_fetch.mayTryAgain(error))
            m_again.start();
        else
            fail(error);
    });
}

const SegmentDoubts::Found* SegmentDoubts::found() const
{
    const auto its = m_found.find(m_workspace.activeSegment());
    return its == m_found.end() ? nullptr : &its->second;
}

void SegmentDoubts::setSeen(std::size_t entry, bool seen)
{
    const auto its = m_found.find(m_workspace.activeSegment());
    if (its == m_found.end() || entry >= its->second.entries.size()
        || its->second.entries[entry].seen == seen)
        return;
    its->second.entries[entry].seen = seen;
    Q_EMIT changed();
}

void SegmentDoubts::abort()
{
    m_again.stop();
    m_waits = false;
    m_fetch.cancel();
    m_background.cancel();
    m_job.reset();
    Q_EMIT changed();
}

void SegmentDoubts::forget()
{
    m_found.clear();
    abort();
}

void SegmentDoubts::fail(const core::Error& error)
{
    abort();
    Q_EMIT failed(error);
}

void SegmentDoubts::follow(const core::DocumentChange& change)
{
    using What = core::DocumentChange::What;
    const core::EditSession* session = m_workspace.session();
    if (change.what == What::Labels) {
        if (m_job)
            m_job->editedSince = true;
        bool isNews = false;
        for (auto& [label, found] : m_found)
            isNews = !std::exchange(found.editedSince, true) || isNews;
        // A stroke under the pen changes labels many times.
        if (isNews)
            Q_EMIT changed();
    } else if (change.what == What::Segments && session) {
        // A new segment may get the label of one that is gone.
        std::erase_if(
            m_found, [&](const auto& its) { return !session->document().segment(its.first); });
        if (m_job && !session->document().segment(m_job->label))
            abort();
    }
}

void SegmentDoubts::look(Mask second)
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment =
        session ? session->document().segment(m_workspace.activeSegment()) : nullptr;
    if (!segment)
        return;
    abort();
    m_job = std::make_shared<Job>();
    m_job->geometry = m_workspace.volume()->geometry;
    m_job->label = segment->label;
    m_job->plane = segment->plane;
    m_job->second = std::move(second);
    fetch();
    Q_EMIT changed();
}

void SegmentDoubts::fetch()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_job)
        return;
    // What stands open would be closed by the question.
    const bool waits = session->transactionOpen();
    // What was requested before counts as known, so it must not be told as news later.
    if (waits || !session->idle()) {
        m_again.start();
    } else {
        // From here on: a stroke that begins after the last answer is no row of the history yet.
        m_job->editedSince = false;
        m_fetch.start(*session, {m_job->plane});
    }
    if (std::exchange(m_waits, waits) != waits)
        Q_EMIT changed();
}

void SegmentDoubts::takeLabels(const LabelFetch::Planes& planes)
{
    if (!m_job)
        return;
    m_job->labels = {planes, &planes->front().labels};
    m_background.start(
        this,
        [job = m_job] {
            job->box =
                core::boxAroundBorder(*job->labels, job->geometry.size, std::uint8_t(job->label));
        },
        [this](const core::Result<void>& done) {
            if (!done)
                return fail(done.error());
            askForCodes();
        });
}

void SegmentDoubts::askForCodes()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return abort();
    const std::shared_ptr<Job>& job = m_job;
    core::VoxelBox part = job->box;
    part.minimum.z += job->slicesRead;
    if (part.minimum.z >= part.maximum.z)
        return workOut();
    const glm::ivec3 size = part.maximum - part.minimum;
    const std::int64_t slices =
        std::max<std::int64_t>(1, codesAtOnce / (std::int64_t(size.x) * size.y));
    part.maximum.z = int(std::min<std::int64_t>(part.maximum.z, part.minimum.z + slices));
    session->questions().codes(part,
        [self = QPointer(this), job, end = part.maximum.z](
            core::Result<std::vector<std::uint16_t>> codes) {
            if (!self || self->m_job != job)
                return;
            if (!codes)
                return self->fail(codes.error());
            job->codes.push_back(*std::move(codes));
            job->slicesRead = end - job->box.minimum.z;
            self->askForCodes();
        });
}

void SegmentDoubts::workOut()
{
    m_background.start(
        this, [job = m_job](const core::Progress& progress) { return job->places(progress); },
        [this](const core::Result<Places>& places) {
            if (!places)
                return fail(places.error());
            take(*places);
        });
}

void SegmentDoubts::take(const Places& places)
{
    Found found{.editedSince = m_job->editedSince};
    const std::vector<Entry>& before = m_found[m_job->label].entries;
    for (const core::DoubtfulPlace& place : places) {
        const bool seen = std::any_of(before.begin(), before.end(), [&](const Entry& entry) {
            return entry.seen && entry.place.why == place.why
                && glm::distance(entry.place.placeLps, place.placeLps) < sameMm;
        });
        found.entries.push_back({place, seen});
    }
    m_found[m_job->label] = std::move(found);
    m_job.reset();
    Q_EMIT changed();
}

} // namespace ui
