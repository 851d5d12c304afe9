// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionState.h"

#include "core/edits/DocumentEdits.h"
#include "core/session/RowName.h"

#include <QJsonDocument>

#include <utility>

namespace core {

namespace {

void count(const std::vector<std::uint8_t>& labels, std::int64_t sign,
    std::array<std::int64_t, 256>& voxels)
{
    for (const std::uint8_t label : labels)
        voxels[label] += sign;
}

} // namespace

SessionState::SessionState(EditEngine& lentEngine, Volume volume)
    : engine(lentEngine)
    , document(initialDocument(std::move(volume)))
    , origin([] { return presentOrigin(); })
{
}

void SessionState::commit(const Edit& edit, std::vector<BrickChange> changes,
    const EditStatistics& statistics, std::optional<std::uint32_t> generation)
{
    takeIn(changes);
    HistoryRow row;
    row.name = rowName(edit, statistics, changes, document, history,
        std::holds_alternative<SeedStroke>(edit) ? lastSketched : std::nullopt);
    if (generation)
        document.growths.front().generation = *generation;
    // What carries an edit out has made sure that it can be.
    static_cast<void>(applyToDocument(edit, document));
    placeSegments();
    muteLayers();
    row.edit = edit;
    row.statistics = statistics;
    row.origin = origin();
    row.growthGeneration = document.growths.front().generation;
    const RowId id = history.append(std::move(row));
    if (file)
        file->addRow(history.row(id));
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(changes));
    worker->commit(id, shared, documentJson());
    recent.keep(id, shared, false);
    if (const std::optional<DocumentChange::What> part = changedPart(edit))
        tell(*part);
    tell(DocumentChange::What::History);
}

void SessionState::complete(RowId row, std::vector<BrickChange> changes)
{
    takeIn(changes);
    history.moveTo(row);
    placeDocument();
    if (file)
        file->setPosition(row);
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(changes));
    worker->commit(row, shared, documentJson());
    recent.keep(row, shared, false);
    tell(DocumentChange::What::History);
}

void SessionState::moveTo(RowId position, RowId over, std::vector<BrickChange> changes)
{
    takeIn(changes);
    history.moveTo(position);
    placeDocument();
    if (file)
        file->setPosition(position);
    const auto shared = std::make_shared<const std::vector<BrickChange>>(std::move(changes));
    worker->move(shared);
    recent.keep(over, shared, position != over);
    tell(DocumentChange::What::Segments);
    tell(DocumentChange::What::Layers);
    tell(DocumentChange::What::Bookmarks);
    tell(DocumentChange::What::Pieces);
    tell(DocumentChange::What::Measurements);
    tell(DocumentChange::What::Chunks);
    tell(DocumentChange::What::Growth);
    tell(DocumentChange::What::History);
}

void SessionState::begin(std::vector<BrickImage> bricks)
{
    for (const BrickImage& brick : bricks) {
        if (brick.key.field == Field::Labels)
            count(brick.bytes, 1, m_voxels);
    }
    placeDocument();
    worker->start(std::move(bricks));
}

/// Counts voxels of segments and tells where something is different.
void SessionState::takeIn(const std::vector<BrickChange>& changes)
{
    const BrickGrid grid{document.volumes.front().geometry.size};
    VoxelBox coverage;
    VoxelBox labels;
    VoxelBox seeds;
    for (const BrickChange& change : changes) {
        const VoxelBox box = grid.boxOf(int(change.key.brick));
        switch (change.key.field) {
        case Field::Coverage:
            coverage = coverage.united(box);
            break;
        case Field::Labels:
            count(change.before, -1, m_voxels);
            count(change.after, 1, m_voxels);
            labels = labels.united(box);
            break;
        case Field::SeedWords:
            seeds = seeds.united(box);
            break;
        case Field::Beneath: // nothing that is seen
            break;
        }
    }
    if (!coverage.empty())
        tell(DocumentChange::What::Coverage, coverage);
    if (!labels.empty()) {
        tell(DocumentChange::What::Labels, labels);
        tell(DocumentChange::What::Segments);
    }
    if (!seeds.empty())
        tell(DocumentChange::What::Growth, seeds);
}

RowId SessionState::divisionRow() const
{
    if (!document.chunks)
        return 0;
    for (RowId id = history.position(); id != 0; id = history.row(id).parent) {
        if (std::holds_alternative<Chunks>(history.row(id).edit))
            return id;
    }
    return 0;
}

void SessionState::wantChunks()
{
    if (const RowId row = divisionRow(); row != 0)
        chunks->want(row, std::get<Chunks>(history.row(row).edit));
}

/// What the edits on the way there made of the first one.
Document SessionState::documentAt(RowId at) const
{
    Document placed = initialDocument({});
    for (const RowId id : history.pathTo(at)) {
        const HistoryRow& row = history.row(id);
        // An edit that is in the history was carried out once, so it cannot fail on the way.
        static_cast<void>(applyToDocument(row.edit, placed));
        placed.growths.front().generation = row.growthGeneration;
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

/// The engine knows which layers are muted before it is told anything that reads what is carved.
void SessionState::muteLayers()
{
    MuteLayers mute;
    for (const SculptLayer& layer : document.layers)
        mute.muted[layer.id] = !document.carves(layer);
    if (mute.muted == m_muted)
        return;
    m_muted = mute.muted;
    engine.submit(mute);
}

/// What a segment shows besides what the history says.
void SessionState::placeSegments()
{
    for (Segment& segment : document.segments) {
        segment.voxels = m_voxels[segment.label];
        segment.visible = m_hidden.count(segment.label) == 0;
    }
}

void SessionState::setVisible(int label, bool visible)
{
    const bool changed = visible ? m_hidden.erase(label) > 0 : m_hidden.insert(label).second;
    if (!changed)
        return;
    placeSegments();
    if (file)
        file->setHiddenSegments({m_hidden.begin(), m_hidden.end()});
    tell(DocumentChange::What::Segments);
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

void SessionState::tell(DocumentChange::What what, const VoxelBox& box)
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
    return QJsonDocument(document.hashedState()).toJson(QJsonDocument::Compact);
}

} // namespace core
