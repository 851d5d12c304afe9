// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourRun.h"

#include "core/contour/ContourRule.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/filling/ContourTrial.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/sculpt/labels/HeldVoxels.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/MemoryLimit.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace ui {

namespace {

/// The engine is asked for so many values together; other work comes in between.
constexpr std::int64_t contourCodesAtOnce = 1 << 20;

/// When it looks again whether the session is at rest.
constexpr std::chrono::milliseconds soonAgain{20};

/// Whether both begin with the same voxels and read the same ones: they differ in the rule alone.
bool startsAlike(core::EvolveContour one, const core::EvolveContour& other)
{
    one.lower = other.lower;
    one.upper = other.upper;
    one.softness = other.softness;
    one.region = other.region;
    one.edge = other.edge;
    one.edgeGradient = other.edgeGradient;
    one.smoothness = other.smoothness;
    one.round = other.round;
    return one == other;
}

std::vector<core::LabelPlane> viewsOf(const LabelFetch::Planes& planes)
{
    std::vector<core::LabelPlane> views;
    for (const ExportJob::Plane& each : *planes)
        views.push_back({.plane = each.plane, .labels = each.labels});
    return views;
}

/// An edit of a segment that is not made yet, in the study as it would be with it.
struct ContourTrialStudy {
    core::EvolveContour edit;
    core::Document document;
};

core::Result<ContourTrialStudy> trialStudy(
    const core::EvolveContour& edit, const core::Document& document)
{
    ContourTrialStudy trial{edit, document};
    if (edit.segment != 0)
        return trial;
    const core::AddSegment added{
        .name = nextSegmentName(document), .rgb = nextSegmentColour(document)};
    if (const core::Result<bool> made = core::apply(added, trial.document); !made)
        return tl::unexpected(made.error());
    trial.edit.segment = trial.document.segments.back().label;
    return trial;
}

} // namespace

/// The other thread's while it works.
struct ContourRun::Reading {
    core::EvolveContour edit;
    core::Document document;
    LabelFetch::Planes planes;
    core::ContourGround ground;
    std::vector<std::vector<std::uint16_t>> slabs; ///< codes of the ground, one after the other
    int nextSlice = 0; ///< whose codes are asked for next

    [[nodiscard]] core::Result<void> findGround()
    {
        const std::vector<core::LabelPlane> views = viewsOf(planes);
        core::Result<core::ContourGround> found = core::trialGround(edit, document, views);
        if (!found)
            return tl::unexpected(found.error());
        ground = *std::move(found);
        nextSlice = ground.box.minimum.z;
        return core::checkBytes(core::watchedContourBytes(ground.voxels.size(), 0),
            core::Clause::saying("the box in which the contour is watched"));
    }
    [[nodiscard]] core::Result<void> joinCodes()
    {
        ground.codes.reserve(ground.voxels.size());
        for (std::vector<std::uint16_t>& slab : slabs) {
            ground.codes.insert(ground.codes.end(), slab.begin(), slab.end());
            std::vector<std::uint16_t>().swap(slab);
        }
        return core::holdUneditable(edit, document, viewsOf(planes), ground);
    }
};

ContourRun::ContourRun(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_mostBytes(core::allowedBytes())
{
    m_again.setSingleShot(true);
    setPace(60);
    connect(&m_again, &QTimer::timeout, this, &ContourRun::fetch);
    connect(&m_playing, &QTimer::timeout, this, &ContourRun::playOn);
    connect(&workspace, &Workspace::sessionClosing, this, &ContourRun::drop);
    connect(&workspace, &Workspace::sessionChanged, this, &ContourRun::drop);
    connect(&workspace, &Workspace::documentChanged, this, &ContourRun::follow);
    connect(&m_fetch, &LabelFetch::finished, this, &ContourRun::takeLabels);
    connect(&m_fetch, &LabelFetch::failed, this, [this](const core::Error& error) {
        if (m_fetch.mayTryAgain(error))
            m_again.start(soonAgain); // labels changed while they were fetched
        else
            fail(error);
    });
}

void ContourRun::begin(const core::EvolveContour& edit)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const std::optional<core::EvolveContour> before = m_edit;
    // With the numbers that it will have when it is carried out.
    m_edit = core::quantised(edit).get<core::EvolveContour>();
    if (before == m_edit)
        return; // it is on its way, or there
    const bool readAlready = before && startsAlike(*before, *m_edit);
    if (!before) {
        session->closeOpen();
        m_wanted = 0;
        m_playing.start();
    }
    if (!readAlready)
        read();
    else if (m_ground)
        evolve(); // else it is being read, and then evolves by this rule
    Q_EMIT changed();
}

void ContourRun::stop()
{
    m_again.stop();
    m_fetch.cancel();
    m_background.cancel();
    m_reading.reset();
    m_ground.reset();
    m_locks.clear();
    m_trackStands = false;
    m_isWorking = false;
    m_end.reset();
}

void ContourRun::drop()
{
    if (!m_edit)
        return;
    stop();
    m_playing.stop();
    m_showing.cancel();
    m_edit.reset();
    m_track.reset();
    m_state.reset();
    m_wanted = 0;
    Q_EMIT changed();
}

void ContourRun::fail(const core::Error& error)
{
    drop();
    Q_EMIT failed(error);
}

void ContourRun::follow(const core::DocumentChange& change)
{
    using What = core::DocumentChange::What;
    const core::EditSession* session = m_workspace.session();
    if (!m_edit || !session)
        return;
    if (change.what == What::Labels) {
        read();
        Q_EMIT changed();
    } else if (change.what == What::Segments && !m_locks.empty()) {
        Locks locks;
        for (const core::Segment& segment : session->document().segments)
            locks.emplace_back(segment.label, segment.locked);
        if (locks == m_locks)
            return;
        read();
        Q_EMIT changed();
    }
}

void ContourRun::read()
{
    stop();
    m_isWorking = true;
    // Who tells of a change may be in the midst of it.
    m_again.start(std::chrono::milliseconds(0));
}

void ContourRun::fetch()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_edit)
        return;
    // What stands open would be closed by the question, and what waits may change labels.
    if (session->transactionOpen() || !session->idle())
        return m_again.start(soonAgain);
    const core::Result<ContourTrialStudy> trial = trialStudy(*m_edit, session->document());
    if (!trial)
        return fail(trial.error());
    const auto planes = core::contourPlanes(trial->edit, trial->document);
    if (!planes)
        return fail(planes.error());
    m_fetch.start(*session, *planes);
}

void ContourRun::takeLabels(const LabelFetch::Planes& planes)
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !m_edit)
        return;
    core::Result<ContourTrialStudy> trial = trialStudy(*m_edit, session->document());
    if (!trial)
        return fail(trial.error());
    m_reading = std::make_shared<Reading>(Reading{
        .edit = std::move(trial->edit), .document = std::move(trial->document), .planes = planes});
    for (const core::Segment& segment : session->document().segments)
        m_locks.emplace_back(segment.label, segment.locked);
    m_background.start(
        this, [reading = m_reading] { return reading->findGround(); },
        [this, reading = m_reading](const core::Result<void>& found) {
            if (m_reading != reading)
                return;
            if (!found)
                return fail(found.error());
            if (reading->ground.box.empty()) {
                drop();
                return Q_EMIT foundNothing();
            }
            askForCodes();
        });
}

void ContourRun::askForCodes()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    core::VoxelBox slab = m_reading->ground.box;
    if (m_reading->nextSlice >= slab.maximum.z)
        return join();
    const glm::ivec3 extent = slab.maximum - slab.minimum;
    const std::int64_t slices =
        std::max<std::int64_t>(1, contourCodesAtOnce / (std::int64_t(extent.x) * extent.y));
    slab.minimum.z = m_reading->nextSlice;
    slab.maximum.z = int(std::min<std::int64_t>(slab.maximum.z, slab.minimum.z + slices));
    m_reading->nextSlice = slab.maximum.z;
    session->questions().codes(slab,
        [self = QPointer(this), reading = m_reading](
            core::Result<std::vector<std::uint16_t>> codes) {
            if (!self || self->m_reading != reading)
                return;
            if (!codes)
                return self->fail(codes.error());
            reading->slabs.push_back(*std::move(codes));
            self->askForCodes();
        });
}

void ContourRun::join()
{
    m_background.start(
        this, [reading = m_reading] { return reading->joinCodes(); },
        [this, reading = m_reading](const core::Result<void>& joined) {
            if (m_reading != reading)
                return;
            if (!joined)
                return fail(joined.error());
            m_ground = std::make_shared<const core::ContourGround>(std::move(reading->ground));
            m_reading.reset();
            evolve();
        });
}

void ContourRun::evolve()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const core::Result<ContourTrialStudy> trial = trialStudy(*m_edit, session->document());
    if (!trial)
        return fail(trial.error());
    const core::Result<core::ContourRule> rule = core::contourRule(trial->edit, trial->document);
    if (!rule)
        return fail(rule.error());
    m_isWorking = true;
    m_end.reset();
    const core::ContourWish wish{
        .generations = m_edit->generations, .silent = m_wanted, .bytes = m_mostBytes};
    const auto work = [this, rule = *rule, ground = m_ground, edit = *m_edit, wish](
                          const core::Progress& progress,
                          const core::Background::Meanwhile& meanwhile) {
        const core::ContourReports reports{
            .begun =
                [&](const auto& track, const auto& state) {
                    meanwhile([this, track, state, edit] { takeTrack(track, state, edit); });
                },
            .further =
                [&](std::vector<core::ContourGeneration> generations) {
                    meanwhile([this, generations = std::move(generations)] {
                        takeGenerations(generations);
                    });
                }};
        return core::watchContour(rule, *ground, wish, progress, reports);
    };
    m_background.replace(this, work, [this](const core::Result<core::ContourEnd>& how) {
        if (!how)
            return fail(how.error());
        end(*how);
    });
}

void ContourRun::takeTrack(const std::shared_ptr<core::ContourTrack>& track,
    const std::shared_ptr<const core::ContourState>& state, const core::EvolveContour& edit)
{
    m_showing.cancel(); // it belongs to another one
    m_track = track;
    m_state = state;
    m_stateAt = track->shown();
    m_trackEdit = edit;
    m_trackStands = true;
    // Somebody may have wished for an earlier one meanwhile.
    show(m_wanted);
    Q_EMIT changed();
    Q_EMIT stateChanged();
}

void ContourRun::takeGenerations(std::vector<core::ContourGeneration> generations)
{
    for (core::ContourGeneration& each : generations)
        m_track->append(std::move(each));
    show(m_wanted);
    Q_EMIT changed();
}

void ContourRun::end(core::ContourEnd how)
{
    m_isWorking = false;
    m_end = how;
    m_wanted = std::min(m_wanted, m_track->known());
    Q_EMIT changed();
    if (how == core::ContourEnd::OutOfMemory)
        Q_EMIT ranOutOfMemory();
}

/// As far as it is known.
void ContourRun::show(int generation)
{
    m_track->goTo(std::min(generation, m_track->known()));
    bringIntoSight();
}

/// While a state is worked out others may be wished for; the newest wish is the next.
void ContourRun::bringIntoSight()
{
    if (!m_track || isInSight() || m_showing.busy())
        return;
    using State = std::shared_ptr<const core::ContourState>;
    const int to = m_track->shown();
    m_showing.start(
        this,
        [state = m_state, way = m_track->between(m_stateAt, to)]() -> State {
            const auto next = std::make_shared<core::ContourState>(*state);
            next->pass(way);
            return next;
        },
        [this, to](const core::Result<State>& next) {
            if (!next)
                return fail(next.error());
            m_state = *next;
            m_stateAt = to;
            Q_EMIT stateChanged();
            bringIntoSight();
        });
}

std::optional<core::EvolveContour> ContourRun::shownEdit() const
{
    if (!m_track || !m_trackStands)
        return std::nullopt;
    const bool isRestingBubble = m_trackEdit.bubbleLps && rests() && m_track->known() == 0;
    if (m_track->shown() == 0 && !isRestingBubble)
        return std::nullopt;
    core::EvolveContour edit = m_trackEdit;
    edit.generations = std::max(m_track->shown(), 1);
    return edit;
}

void ContourRun::goTo(int generation)
{
    if (!m_edit)
        return;
    m_playing.stop();
    const bool isAllKnown = m_track && !m_isWorking;
    m_wanted = std::clamp(generation, 0, isAllKnown ? m_track->known() : m_edit->generations);
    if (m_track)
        show(m_wanted);
    Q_EMIT changed();
}

void ContourRun::setPlaying(bool playing)
{
    if (!m_edit || playing == isPlaying())
        return;
    if (!playing)
        return goTo(m_track ? m_track->shown() : 0);
    if (m_track && !m_isWorking && m_track->shown() >= m_track->known())
        goTo(0);
    m_playing.start();
    Q_EMIT changed();
}

void ContourRun::playOn()
{
    if (!m_track || m_track->shown() < m_wanted)
        return;
    if (m_track->shown() < m_track->known()) {
        m_wanted = m_track->shown() + 1;
        show(m_wanted);
    } else if (!m_isWorking) {
        m_playing.stop();
    } else {
        return;
    }
    Q_EMIT changed();
}

} // namespace ui
