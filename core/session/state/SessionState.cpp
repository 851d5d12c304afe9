// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/SessionState.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EngineCommands.h"
#include "core/history/MovedGrowth.h"
#include "core/session/names/TitleOfRow.h"
#include "core/session/past/FollowedInterval.h"

#include <QJsonDocument>

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// Whether voxels came to a segment or went from it.
bool changesSegment(const ChangeFacts& facts, const Segment& segment)
{
    const LabelFlow flow = facts.flow(segment.plane, segment.label);
    return flow.gained > 0 || flow.lost > 0;
}

std::vector<int> labelsOf(const Document& document)
{
    std::vector<int> labels;
    for (const Segment& segment : document.segments)
        labels.push_back(segment.label);
    return labels;
}

/// What a row made of a document.
void applyRow(RowId row, const Edit& edit, const EditStatistics& statistics, Document& document)
{
    // An edit that is in the history was carried out once, so it cannot fail on the way.
    static_cast<void>(applyToDocument(edit, document));
    if (document.surface && statistics.surfaceMaskChanged)
        document.surface->maskChanged = true;
    followIntervals(row, edit, statistics, document);
}

} // namespace

SessionState::SessionState(EditEngine& lentEngine, Volume volume)
    : engine(lentEngine)
    , document(initialDocument(std::move(volume)))
    , origin([] { return presentOrigin(); })
{
    surface.setGeometry(document.volumes.front().geometry);
}

/// A row for what was carried out, in memory and on its way to disk.
RowId SessionState::append(const Edit& edit, const ChangeFacts& facts,
    const EditStatistics& statistics, std::optional<std::uint32_t> generation,
    const std::optional<RowTitle>& remark)
{
    RowTitle title = titleOfRow(edit, statistics, facts, document, history,
        edit.is<SeedStroke>() ? lastSketched : std::nullopt);
    if (remark)
        title.then.push_back(*remark);
    HistoryRow row;
    row.name = canonicalName(title);
    row.title = std::move(title);
    const std::uint8_t growthPlane = recordedGrowthPlane(edit, history);
    if (generation)
        document.place({.plane = growthPlane, .generation = *generation});
    const std::optional<RefinedSurface> surfaceBefore = document.surface;
    row.statistics = statistics;
    if (const Segment* refined = surfaceBefore ? document.segment(surfaceBefore->segment) : nullptr)
        row.statistics.surfaceMaskChanged =
            !edit.is<WriteBack>() && changesSegment(facts, *refined);
    noteIntervals(edit, facts, row.statistics);
    const std::vector<int> labelsBefore = labelsOf(document);
    applyRow(RowId(history.rows().size()) + 1, edit, row.statistics, document);
    std::erase_if(row.statistics.intervalsLeft, // of what is deleted nobody wants to know
        [this](int label) { return !document.segment(label); });
    showNewSegments(labelsBefore);
    placeSegments();
    muteLayers();
    showSurface();
    if (row.statistics.followsInterval) // also where no label changed, and its interval did
        notify(DocumentChange::What::Segments);
    row.edit = edit;
    row.origin = origin();
    row.growthGeneration = document.generation(growthPlane);
    const RowId id = history.append(std::move(row));
    if (file)
        file->addRow(history.row(id));
    // One that writes to its segment changes what is said of the surface.
    if (document.surface != surfaceBefore && changedPart(edit) != DocumentChange::What::Surface)
        notify(DocumentChange::What::Surface);
    return id;
}

/// Which segments follow an interval from this edit on, or no more.
/// @pre voxels are counted as they are after it, and the document is as it was before it
void SessionState::noteIntervals(
    const Edit& edit, const ChangeFacts& facts, EditStatistics& statistics) const
{
    const auto* threshold = edit.as<ThresholdSegment>();
    const Segment* given = threshold ? document.segment(threshold->segment) : nullptr;
    if (given) {
        const LabelFlow flow = facts.flow(given->plane, given->label);
        const std::int64_t before = m_voxels[given->label] - flow.gained + flow.lost;
        statistics.followsInterval =
            givesAllOf(*threshold, before == 0, followedInterval(*given, history));
    }
    for (const Segment& segment : document.segments) {
        const bool followsAnew = statistics.followsInterval && &segment == given;
        if (segment.followsRow != 0 && !followsAnew && changesSegment(facts, segment))
            statistics.intervalsLeft.push_back(segment.label);
    }
}

void SessionState::notifyCommitted(const Edit& edit)
{
    if (const std::optional<DocumentChange::What> part = changedPart(edit))
        notify(*part);
    notify(DocumentChange::What::History);
}

void SessionState::commit(
    const Edit& edit, EngineResult&& result, std::optional<std::uint32_t> generation)
{
    takeIn(result.facts);
    const RowId id = append(edit, result.facts, result.statistics, generation);
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(result.changes));
    worker->commit(id, shared, documentJson());
    recent.keep(id, shared, false);
    notifyCommitted(edit);
}

void SessionState::commitSurface(const Edit& edit, std::shared_ptr<const SurfaceStep> step,
    const std::optional<RowTitle>& remark)
{
    EditStatistics statistics;
    statistics.verticesChanged = std::int64_t(step->mesh.vertices.size());
    const RowId id = append(edit, {}, statistics, {}, remark);
    surface.keep(id, step);
    worker->commit(id, std::move(step), documentJson());
    recent.keep(id, std::make_shared<const std::vector<BrickChange>>(), false);
    notifyCommitted(edit);
}

void SessionState::completeSurface(RowId row, std::shared_ptr<const SurfaceStep> step)
{
    history.moveTo(row);
    placeDocument();
    if (file)
        file->setPosition(row);
    surface.keep(row, step);
    worker->commit(row, std::move(step), documentJson());
    recent.keep(row, std::make_shared<const std::vector<BrickChange>>(), false);
    notify(DocumentChange::What::Surface);
    notify(DocumentChange::What::History);
}

void SessionState::complete(RowId row, EngineResult&& result)
{
    takeIn(result.facts);
    history.moveTo(row);
    placeDocument();
    if (file)
        file->setPosition(row);
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(result.changes));
    worker->commit(row, shared, documentJson());
    recent.keep(row, shared, false);
    notify(DocumentChange::What::History);
}

void SessionState::moveTo(RowId position, RowId over, EngineResult&& result)
{
    takeIn(result.facts);
    const bool isBack = position != over;
    history.moveTo(position);
    placeDocument();
    surface.moveOver(over, isBack);
    showSurface();
    if (file)
        file->setPosition(position);
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(result.changes));
    worker->move(shared);
    recent.keep(over, shared, isBack);
    notify(DocumentChange::What::Segments);
    notify(DocumentChange::What::Layers);
    notify(DocumentChange::What::Bookmarks);
    notify(DocumentChange::What::Pieces);
    notify(DocumentChange::What::Measurements);
    notify(DocumentChange::What::Surface);
    notify(DocumentChange::What::Chunks);
    notify(DocumentChange::What::Growth);
    notify(DocumentChange::What::History);
}

void SessionState::begin(std::vector<BrickImage> bricks)
{
    for (const BrickImage& brick : bricks) {
        if (brick.key.field != Field::Labels)
            continue;
        for (const std::uint8_t label : brick.bytes.read())
            ++m_voxels[label];
    }
    placeDocument();
    m_isSurfaceShown = document.surface.has_value();
    worker->start(std::move(bricks));
}

/// Counts voxels of segments and tells where something is different.
void SessionState::takeIn(const ChangeFacts& facts)
{
    for (const LabelFlow& flow : facts.flows)
        m_voxels[flow.label] += flow.gained - flow.lost;
    if (!facts.coverage.empty())
        notify(DocumentChange::What::Coverage, facts.coverage);
    if (!facts.labels.empty()) {
        notify(DocumentChange::What::Labels, facts.labels);
        notify(DocumentChange::What::Segments);
    }
    if (!facts.seedWords.empty())
        notify(DocumentChange::What::Growth, facts.seedWords);
}

RowId SessionState::divisionRow() const
{
    if (!document.chunks)
        return 0;
    for (RowId id = history.position(); id != 0; id = history.row(id).parent) {
        if (history.row(id).edit.is<DivideSegment>())
            return id;
    }
    return 0;
}

void SessionState::wantChunks()
{
    if (const RowId row = divisionRow(); row != 0)
        chunks->want(row, history.row(row).edit.get<DivideSegment>());
}

/// What the edits on the way there made of the first one.
Document SessionState::documentAt(RowId at) const
{
    Document placed = initialDocument({});
    for (const RowId id : history.pathTo(at)) {
        const HistoryRow& row = history.row(id);
        applyRow(id, row.edit, row.statistics, placed);
        placed.place(
            {.plane = recordedGrowthPlane(row.edit, history), .generation = row.growthGeneration});
    }
    return placed;
}

void SessionState::placeDocument()
{
    Document placed = documentAt(history.position());
    placed.volumes = std::move(document.volumes);
    document = std::move(placed);
    placeSegments();
    muteLayers();
}

/// Whoever draws the surface is told when there is one, and when there is none any more.
void SessionState::showSurface()
{
    if (m_isSurfaceShown == document.surface.has_value())
        return;
    m_isSurfaceShown = document.surface.has_value();
    surface.showAll(m_isSurfaceShown);
}

/// The engine knows which layers are muted before it is told anything that reads what is carved.
void SessionState::muteLayers()
{
    MuteLayers mute;
    for (const SculptLayer& layer : document.layers)
        mute.muted[layer.id] = !document.carves(layer);
    if (mute.muted == m_muted)
        return;
    m_muted = mute.muted;
    require(mute);
}

void SessionState::require(EngineCommand command)
{
    submitRequired({.command = std::make_shared<const EngineCommand>(std::move(command))});
}

void SessionState::submitRequired(Required required)
{
    const Ticket ticket = engine.submit(*required.command);
    if (std::holds_alternative<MuteLayers>(*required.command))
        m_lastMute = ticket;
    m_required.emplace(ticket, std::move(required));
}

void SessionState::afterRequired(std::function<void(SessionState&)> then)
{
    if (owes())
        m_afterRequired = std::move(then);
    else if (!m_lost)
        then(*this);
}

bool SessionState::noteResult(const EngineResult& result)
{
    constexpr int mostTries = 20;
    auto required = m_required.extract(result.ticket);
    const bool known = !required.empty();
    if (result.error && !m_lost) {
        if (result.error->code == ErrorCode::EngineLost
            || result.error->code == ErrorCode::ContextLost
            || (known && required.mapped().tries >= mostTries)) {
            lose(*result.error);
        } else if (known) {
            // Of two that mute the later one counts, whenever the earlier one is done.
            Required again = std::move(required.mapped());
            ++again.tries;
            if (!std::holds_alternative<MuteLayers>(*again.command) || result.ticket == m_lastMute)
                submitRequired(std::move(again));
        }
    }
    if (known && !owes() && m_afterRequired)
        std::exchange(m_afterRequired, {})(*this);
    return known;
}

void SessionState::lose(const Error& why)
{
    if (m_lost)
        return;
    const bool byEngine =
        why.code == ErrorCode::EngineLost || why.code == ErrorCode::GraphicsUnavailable;
    m_lost = byEngine
        ? Error{ErrorCode::EngineLost, why.arguments}
        : Error{why.code,
            {Clause::saying(
                "%1; close the study and open it again: every step so far is in its session",
                why.arguments.value(0))}};
    if (why.code == ErrorCode::ContextLost)
        m_lost = why;
    m_required.clear();
    m_afterRequired = {};
    fail(*m_lost);
}

/// What a segment shows besides what the history says.
void SessionState::placeSegments()
{
    for (Segment& segment : document.segments) {
        segment.voxels = m_voxels[segment.label];
        segment.visible = m_hidden.count(segment.label) == 0;
    }
}

/// The label of a segment that was undone may have been hidden, and is given again.
void SessionState::showNewSegments(const std::vector<int>& labelsBefore)
{
    std::size_t shown = 0;
    for (const int label : labelsOf(document)) {
        if (std::find(labelsBefore.begin(), labelsBefore.end(), label) == labelsBefore.end())
            shown += m_hidden.erase(label);
    }
    if (shown > 0 && file)
        file->setHiddenSegments({m_hidden.begin(), m_hidden.end()});
}

void SessionState::setVisible(const std::vector<std::pair<int, bool>>& segments)
{
    bool changed = false;
    for (const auto& [label, visible] : segments) {
        if (visible ? m_hidden.erase(label) > 0 : m_hidden.insert(label).second)
            changed = true;
    }
    if (!changed)
        return;
    placeSegments();
    if (file)
        file->setHiddenSegments({m_hidden.begin(), m_hidden.end()});
    notify(DocumentChange::What::Segments);
}

void SessionState::hide(const std::vector<int>& labels)
{
    m_hidden = {labels.begin(), labels.end()};
    placeSegments();
}

void SessionState::setDisplay(const QJsonObject& shown)
{
    if (shown == display)
        return;
    display = shown;
    if (file)
        file->setDisplay(display);
}

void SessionState::notify(DocumentChange::What what, const VoxelBox& box)
{
    for (DocumentChange& change : news) {
        if (change.what == what) {
            change.box = change.box.united(box);
            return;
        }
    }
    news.push_back({what, box});
}

void SessionState::fail(const Error& error)
{
    errors.push_back(error);
    if (!firstError)
        firstError = error;
}

QByteArray SessionState::documentJson() const
{
    QJsonObject hashed = document.hashedState();
    if (document.surface) {
        QJsonObject entry = hashed.value(QLatin1String("surface")).toObject();
        entry.insert(QStringLiteral("sha256"), QString::fromLatin1(surface.sha256));
        hashed.insert(QStringLiteral("surface"), entry);
    }
    return QJsonDocument(hashed).toJson(QJsonDocument::Compact);
}

} // namespace core
