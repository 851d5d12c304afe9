// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/LiveComparison.h"

#include "core/brick/LabelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/export/common/ImportedSegments.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/SessionSurface.h"
#include "core/session/past/PastImports.h"
#include "ui/workspace/Refinement.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

namespace ui {

namespace {

/// The segments that imports gave voxels to, by label, with the names that the masks had: of those
/// that were deleted since there is no other.
std::vector<core::Segment> segmentsOf(const std::vector<core::DoneImport>& imports)
{
    std::map<int, core::Segment> segments;
    for (const core::DoneImport& done : imports) {
        for (std::size_t i = 0; i < done.labels.size(); ++i) {
            const core::ImportMask& edit = *done.edit;
            core::Segment segment;
            segment.label = std::uint8_t(done.labels[i]);
            segment.name = edit.as ? edit.as->name : (*edit.segments)[i].name;
            segments.emplace(done.labels[i], std::move(segment));
        }
    }
    std::vector<core::Segment> list;
    for (auto& [label, segment] : segments)
        list.push_back(std::move(segment));
    return list;
}

/// One of a reference's segments for each of these that has voxels.
struct Imported {
    std::vector<core::MaskSegment> masks;
    std::vector<int> labels;
};

Imported importedMasks(const std::vector<core::DoneImport>& imports, std::uint64_t voxels)
{
    Imported imported;
    const std::vector<core::Segment> segments = segmentsOf(imports);
    for (core::ImportedVoxels& its : core::importedAs(segments, imports, voxels)) {
        const auto segment = std::find_if(segments.begin(), segments.end(),
            [&](const core::Segment& each) { return each.label == its.label; });
        imported.masks.push_back(
            {.name = segment->name, .rgb = {}, .code = {}, .voxels = std::move(its.voxels)});
        imported.labels.push_back(its.label);
    }
    return imported;
}

} // namespace

/// The thread's, with copies of all it needs.
struct LiveComparison::Job {
    Outcome outcome;
    Labels labels; ///< of the segment's plane, x fastest; null: the surface's voxels count
    core::SimplexMesh mesh;
    Masks masks;
    std::size_t reference = 0; ///< place in masks
    core::VolumeGeometry geometry;

    [[nodiscard]] core::Result<Outcome> compared(const core::Progress& progress) const;
};

core::Result<LiveComparison::Outcome> LiveComparison::Job::compared(
    const core::Progress& progress) const
{
    const core::Result<core::VoxelRuns> voxels = labels
        ? core::Result<core::VoxelRuns>(core::labelRuns(*labels, std::uint8_t(outcome.segment)))
        : core::voxelsOf(mesh, geometry, progress);
    if (!voxels)
        return tl::unexpected(voxels.error());
    return core::compareMasks(*voxels, (*masks)[reference].voxels, geometry, progress)
        .map([this](const core::MaskComparison& comparison) {
            Outcome done = outcome;
            done.comparison = comparison;
            return done;
        });
}

LiveComparison::LiveComparison(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(std::chrono::milliseconds(250));
    connect(&m_timer, &QTimer::timeout, this, &LiveComparison::look);
    connect(&workspace, &Workspace::sessionClosing, this, &LiveComparison::forget);
    connect(&workspace, &Workspace::sessionChanged, this, &LiveComparison::forget);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &LiveComparison::followCompared);
    // A surface that is laid or dropped may make another segment the compared one.
    connect(&workspace.refinement(), &Refinement::changed, this, [this] {
        if (comparedLabel() != m_followed)
            followCompared();
        else
            later();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Labels)
                m_labels.reset();
            if (change.what == core::DocumentChange::What::History)
                followImports();
            later();
        });
    connect(&m_fetch, &LabelFetch::finished, this, [this](const LabelFetch::Planes& planes) {
        m_labels = {planes, &planes->front().labels};
        m_labelsPlane = planes->front().plane;
        compare();
    });
    // Edited meanwhile: once more.
    connect(&m_fetch, &LabelFetch::failed, this, &LiveComparison::later);
}

void LiveComparison::followCompared()
{
    m_followed = comparedLabel();
    const int place = m_masks ? placeFor(comparedSegment()) : -1;
    // A file's reference stays where none belongs to the segment.
    if (m_masks && (m_imported || (place >= 0 && place != m_chosen))) {
        m_chosen = place;
        m_outcome.reset();
    }
    later();
}

bool LiveComparison::isBehind() const
{
    return m_reading || m_timer.isActive() || m_fetch.running() || m_background.busy();
}

void LiveComparison::forget()
{
    m_timer.stop();
    m_fetch.cancel();
    m_labels.reset();
    m_background.cancel();
    m_path.clear();
    m_masks.reset();
    m_importedLabels.clear();
    m_importRows.clear();
    m_chosen = -1;
    m_byHand.clear();
    m_reading = false;
    m_imported = false;
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
    m_background.start(
        this,
        [path, volume = *volume](
            const core::Progress& progress) { return core::readMask(path, volume, progress); },
        [this](core::Result<core::MaskOnVolume>&& read) {
            takeMasks(std::move(read).map(
                          [](core::MaskOnVolume&& mask) { return std::move(mask.segments); }),
                {});
        });
    Q_EMIT changed();
}

bool LiveComparison::canTakeImported() const
{
    const core::EditSession* session = m_workspace.session();
    return session && !core::importRows(session->history()).empty();
}

void LiveComparison::takeImported()
{
    if (canTakeImported() && !m_reading)
        fetchImported();
}

void LiveComparison::fetchImported()
{
    const core::History& history = m_workspace.session()->history();
    forget();
    m_reading = true;
    m_imported = true;
    m_importRows = core::importRows(history);
    m_background.start(
        this,
        [imports = core::doneImports(history),
            voxels = m_workspace.volume()->geometry.voxelCount()] {
            return importedMasks(imports, voxels);
        },
        [this](core::Result<Imported>&& read) {
            std::vector<int> labels = read ? std::move(read->labels) : std::vector<int>();
            takeMasks(
                std::move(read).map([](Imported&& imported) { return std::move(imported.masks); }),
                std::move(labels));
        });
    Q_EMIT changed();
}

/// What was imported is what the steps to the present state have imported.
void LiveComparison::followImports()
{
    const core::EditSession* session = m_workspace.session();
    if (m_imported && session && core::importRows(session->history()) != m_importRows)
        fetchImported();
}

/// The reference that belongs to a segment: what was imported into it, or of a file the one that
/// was chosen for it, that of its name, or the only one; −1 if there is none.
int LiveComparison::placeFor(const core::Segment* segment) const
{
    if (!segment)
        return -1;
    // Names are not unique, and may have changed since.
    if (m_imported) {
        const auto its =
            std::find(m_importedLabels.begin(), m_importedLabels.end(), int(segment->label));
        return its == m_importedLabels.end() ? -1 : int(its - m_importedLabels.begin());
    }
    if (const auto chosen = m_byHand.find(segment->label); chosen != m_byHand.end())
        return chosen->second;
    const auto named = std::find_if(m_masks->begin(), m_masks->end(),
        [&](const core::MaskSegment& mask) { return mask.name == segment->name; });
    if (named != m_masks->end())
        return int(named - m_masks->begin());
    return m_masks->size() == 1 ? 0 : -1;
}

void LiveComparison::takeMasks(
    core::Result<std::vector<core::MaskSegment>>&& read, std::vector<int> labels)
{
    m_reading = false;
    if (!read) {
        m_path.clear();
        Q_EMIT changed();
        return Q_EMIT failed(read.error());
    }
    m_masks = std::make_shared<const std::vector<core::MaskSegment>>(*std::move(read));
    m_importedLabels = std::move(labels);
    m_followed = comparedLabel();
    m_chosen = placeFor(comparedSegment());
    if (m_chosen < 0 && !m_imported && !m_masks->empty())
        m_chosen = 0;
    later();
    Q_EMIT changed();
}

QStringList LiveComparison::references() const
{
    const core::EditSession* session = m_workspace.session();
    QStringList names;
    for (std::size_t i = 0; m_masks && i < m_masks->size(); ++i) {
        const core::Segment* today =
            m_imported && session ? session->document().segment(m_importedLabels[i]) : nullptr;
        names.append(today ? today->name : (*m_masks)[i].name);
    }
    return names;
}

std::shared_ptr<const core::VoxelRuns> LiveComparison::secondMask() const
{
    const core::EditSession* session = m_workspace.session();
    if (m_imported || !m_masks || !session)
        return nullptr;
    const int place = placeFor(session->document().segment(m_workspace.activeSegment()));
    if (place < 0)
        return nullptr;
    return {m_masks, &(*m_masks)[std::size_t(place)].voxels};
}

void LiveComparison::choose(int place)
{
    if (!m_masks || place < 0 || std::size_t(place) >= m_masks->size())
        return;
    // The one that is shown already may be chosen, too.
    const core::Segment* segment = comparedSegment();
    if (segment && !m_imported)
        m_byHand[segment->label] = place;
    if (place == m_chosen)
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

int LiveComparison::comparedLabel() const
{
    const core::Segment* segment = comparedSegment();
    return segment ? int(segment->label) : 0;
}

/// The labels of the plane before are not those of this segment.
bool LiveComparison::knowsLabelsOf(const core::Segment& segment) const
{
    return m_labels && m_labelsPlane == segment.plane;
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
    if (session->surface().mesh() || knowsLabelsOf(*segment))
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
    if (!mesh && !knowsLabelsOf(*segment))
        return later();
    Job job;
    job.outcome.segment = segment->label;
    job.outcome.ofSurface = mesh != nullptr;
    if (mesh)
        job.mesh = *mesh;
    else
        job.labels = m_labels;
    job.masks = m_masks;
    job.reference = std::size_t(m_chosen);
    job.geometry = m_workspace.volume()->geometry;
    m_background.replace(
        this,
        [job = std::move(job)](const core::Progress& progress) { return job.compared(progress); },
        [this](const core::Result<Outcome>& compared) {
            m_outcome.reset();
            if (compared)
                m_outcome = *compared;
            Q_EMIT changed();
        });
    Q_EMIT changed();
}

} // namespace ui
