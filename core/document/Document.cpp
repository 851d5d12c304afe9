// SPDX-License-Identifier: Apache-2.0
#include "core/document/Document.h"

#include <QJsonArray>

#include <algorithm>
#include <set>
#include <utility>

namespace core {

namespace {

QJsonArray json(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

QString measurementWord(Measurement::Kind kind)
{
    return QLatin1String(measurementWords[std::size_t(kind)]);
}

} // namespace

const Segment* Document::segment(int label) const
{
    const auto found = std::find_if(segments.begin(), segments.end(),
        [label](const Segment& candidate) { return candidate.label == label; });
    return found == segments.end() ? nullptr : &*found;
}

Segment* Document::segment(int label)
{
    return const_cast<Segment*>(std::as_const(*this).segment(label));
}

const SculptLayer* Document::layer(int id) const
{
    const auto found = std::find_if(layers.begin(), layers.end(),
        [id](const SculptLayer& candidate) { return candidate.id == id; });
    return found == layers.end() ? nullptr : &*found;
}

SculptLayer* Document::layer(int id)
{
    return const_cast<SculptLayer*>(std::as_const(*this).layer(id));
}

bool Document::carves(const SculptLayer& layer) const
{
    return whyItDoesNotCarve(layer).isEmpty();
}

Clause Document::whyItDoesNotCarve(const SculptLayer& layer) const
{
    if (layer.muted)
        return Clause::saying("is muted");
    const bool anySolo = std::any_of(
        layers.begin(), layers.end(), [](const SculptLayer& each) { return each.solo; });
    return anySolo && !layer.solo ? Clause::saying("is left out while another is solo") : Clause();
}

const CameraBookmark* Document::bookmark(int id) const
{
    const auto found = std::find_if(bookmarks.begin(), bookmarks.end(),
        [id](const CameraBookmark& candidate) { return candidate.id == id; });
    return found == bookmarks.end() ? nullptr : &*found;
}

const Measurement* Document::measurement(int id) const
{
    const auto found = std::find_if(measurements.begin(), measurements.end(),
        [id](const Measurement& candidate) { return candidate.id == id; });
    return found == measurements.end() ? nullptr : &*found;
}

const Piece* Document::piece(int id) const
{
    const auto found = std::find_if(
        pieces.begin(), pieces.end(), [id](const Piece& candidate) { return candidate.id == id; });
    return found == pieces.end() ? nullptr : &*found;
}

Piece* Document::piece(int id)
{
    return const_cast<Piece*>(std::as_const(*this).piece(id));
}

const Piece* Document::pieceOfLayer(int layer) const
{
    const auto found = std::find_if(pieces.begin(), pieces.end(),
        [layer](const Piece& candidate) { return candidate.layer == layer; });
    return found == pieces.end() ? nullptr : &*found;
}

std::vector<std::uint8_t> Document::labelPlanes() const
{
    std::set<std::uint8_t> planes{0};
    for (const Segment& segment : segments)
        planes.insert(segment.plane);
    return {planes.begin(), planes.end()};
}

std::optional<std::uint8_t> Document::planeWithoutSegments() const
{
    for (int plane = 0; plane < mostLabelPlanes; ++plane) {
        if (labelsIn(plane).none())
            return std::uint8_t(plane);
    }
    return std::nullopt;
}

std::bitset<256> Document::labelsIn(int plane) const
{
    return lockedLabels(plane) | unlockedLabels(plane);
}

std::bitset<256> Document::lockedLabels(int plane) const
{
    std::bitset<256> labels;
    for (const Segment& segment : segments)
        labels[segment.label] = segment.plane == plane && segment.locked;
    return labels;
}

std::bitset<256> Document::unlockedLabels(int plane) const
{
    std::bitset<256> labels;
    for (const Segment& segment : segments)
        labels[segment.label] = segment.plane == plane && !segment.locked;
    return labels;
}

int Document::lastLabelGiven() const
{
    int last = greatestRemovedLabel;
    for (const Segment& segment : segments)
        last = std::max<int>(last, segment.label);
    return last;
}

int Document::lastBookmarkGiven() const
{
    int last = greatestRemovedBookmark;
    for (const CameraBookmark& bookmark : bookmarks)
        last = std::max(last, bookmark.id);
    return last;
}

int Document::lastLayerGiven() const
{
    int last = greatestRemovedLayer;
    for (const SculptLayer& layer : layers)
        last = std::max<int>(last, layer.id);
    return last;
}

int Document::lastPieceGiven() const
{
    int last = greatestRemovedPiece;
    for (const Piece& piece : pieces)
        last = std::max(last, piece.id);
    return last;
}

int Document::lastMeasurementGiven() const
{
    int last = greatestRemovedMeasurement;
    for (const Measurement& measurement : measurements)
        last = std::max(last, measurement.id);
    return last;
}

int Document::lastChunksGiven() const
{
    return chunks ? chunks->id : greatestRemovedChunks;
}

const Growth* Document::growth(int plane) const
{
    const auto found = std::find_if(growths.begin(), growths.end(),
        [plane](const Growth& candidate) { return candidate.plane == plane; });
    return found == growths.end() ? nullptr : &*found;
}

std::uint32_t Document::generation(int plane) const
{
    const Growth* known = growth(plane);
    return known ? known->generation : 0;
}

void Document::place(const Growth& growth)
{
    const auto at = std::lower_bound(growths.begin(), growths.end(), growth,
        [](const Growth& a, const Growth& b) { return a.plane < b.plane; });
    if (at != growths.end() && at->plane == growth.plane)
        *at = growth;
    else
        growths.insert(at, growth);
}

QJsonObject Document::hashedState() const
{
    QJsonArray segmentList;
    for (const Segment& segment : segments) {
        QJsonObject entry{
            {QStringLiteral("code"),
                QJsonArray{segment.code.scheme, segment.code.value, segment.code.meaning}},
            {QStringLiteral("color"),
                QStringLiteral("#%1").arg(segment.rgb, 6, 16, QLatin1Char('0'))},
            {QStringLiteral("label"), int(segment.label)},
            {QStringLiteral("locked"), segment.locked},
            {QStringLiteral("name"), segment.name},
            {QStringLiteral("plane"), int(segment.plane)},
        };
        if (segment.uncarvable) // only where it says something, see below
            entry.insert(QStringLiteral("protected"), true);
        segmentList.append(entry);
    }
    QJsonArray layerList;
    for (const SculptLayer& layer : layers) {
        QJsonObject entry{
            {QStringLiteral("id"), int(layer.id)},
            {QStringLiteral("muted"), layer.muted},
            {QStringLiteral("name"), layer.name},
        };
        if (layer.solo)
            entry.insert(QStringLiteral("solo"), true);
        layerList.append(entry);
    }
    QJsonArray growthList;
    for (const Growth& growth : growths) {
        // A further plane without a growth is as one in which nothing has grown yet.
        if (growth.plane != 0 && growth.generation == 0)
            continue;
        growthList.append(QJsonObject{
            {QStringLiteral("generation"), qint64(growth.generation)},
            {QStringLiteral("plane"), int(growth.plane)},
        });
    }
    QJsonObject state{
        {QStringLiteral("growths"), growthList},
        {QStringLiteral("layers"), layerList},
        {QStringLiteral("segments"), segmentList},
    };
    // What follows stands there only where it says something, so that the states of a time that
    // did not know it keep their hashes.
    QJsonArray bookmarkList;
    for (const CameraBookmark& bookmark : bookmarks) {
        bookmarkList.append(QJsonObject{
            {QStringLiteral("crosshairLps"), json(bookmark.crosshairLps)},
            {QStringLiteral("eyeLps"), json(bookmark.view.eyeLps)},
            {QStringLiteral("heightMm"), bookmark.view.heightMm},
            {QStringLiteral("id"), bookmark.id},
            {QStringLiteral("name"), bookmark.name},
            {QStringLiteral("targetLps"), json(bookmark.view.targetLps)},
            {QStringLiteral("up"), json(bookmark.view.up)},
        });
    }
    if (!bookmarkList.isEmpty())
        state.insert(QStringLiteral("bookmarks"), bookmarkList);
    QJsonArray pieceList;
    for (const Piece& piece : pieces) {
        QJsonObject entry{
            {QStringLiteral("id"), piece.id},
            {QStringLiteral("name"), piece.name},
            {QStringLiteral("offsetMm"), json(piece.pose.offsetMm)},
            {QStringLiteral("rotationDegrees"), json(piece.pose.rotationDegrees)},
            {QStringLiteral("zoom"), piece.pose.zoom},
        };
        if (piece.layer > 0)
            entry.insert(QStringLiteral("layer"), piece.layer);
        if (piece.segment > 0)
            entry.insert(QStringLiteral("segment"), piece.segment);
        if (piece.pivotLps)
            entry.insert(QStringLiteral("pivotLps"), json(*piece.pivotLps));
        pieceList.append(entry);
    }
    if (!pieceList.isEmpty())
        state.insert(QStringLiteral("pieces"), pieceList);
    if (surface) {
        QJsonObject entry{{QStringLiteral("segment"), surface->segment}};
        if (surface->differs)
            entry.insert(QStringLiteral("differs"), true);
        state.insert(QStringLiteral("surface"), entry);
    }
    QJsonArray measurementList;
    for (const Measurement& measurement : measurements) {
        QJsonObject entry{{QStringLiteral("id"), measurement.id}};
        if (measurement.kind == Measurement::Kind::Distance) {
            entry.insert(QStringLiteral("fromLps"), json(measurement.pointsLps[0]));
            entry.insert(QStringLiteral("toLps"), json(measurement.pointsLps[1]));
        } else {
            QJsonArray points;
            for (const glm::dvec3& point : measurement.pointsLps)
                points.append(json(point));
            entry.insert(QStringLiteral("kind"), measurementWord(measurement.kind));
            entry.insert(QStringLiteral("pointsLps"), points);
        }
        if (measurement.piece > 0)
            entry.insert(QStringLiteral("piece"), measurement.piece);
        if (measurement.projected)
            entry.insert(QStringLiteral("projected"), true);
        if (!measurement.text.isEmpty())
            entry.insert(QStringLiteral("text"), measurement.text);
        measurementList.append(entry);
    }
    if (!measurementList.isEmpty())
        state.insert(QStringLiteral("measurements"), measurementList);
    if (chunks)
        state.insert(QStringLiteral("chunks"),
            QJsonObject{{QStringLiteral("id"), chunks->id},
                {QStringLiteral("marginMm"), chunks->marginMm},
                {QStringLiteral("segment"), chunks->segment}});
    else if (greatestRemovedChunks > 0)
        state.insert(QStringLiteral("lastChunks"), greatestRemovedChunks);
    if (greatestRemovedMeasurement > 0 && greatestRemovedMeasurement == lastMeasurementGiven())
        state.insert(QStringLiteral("lastMeasurement"), greatestRemovedMeasurement);
    if (greatestRemovedPiece > 0 && greatestRemovedPiece == lastPieceGiven())
        state.insert(QStringLiteral("lastPiece"), greatestRemovedPiece);
    if (greatestRemovedBookmark > 0 && greatestRemovedBookmark == lastBookmarkGiven())
        state.insert(QStringLiteral("lastBookmark"), greatestRemovedBookmark);
    if (greatestRemovedLabel > 0 && greatestRemovedLabel == lastLabelGiven())
        state.insert(QStringLiteral("lastLabel"), greatestRemovedLabel);
    if (greatestRemovedLayer > 0 && greatestRemovedLayer == lastLayerGiven())
        state.insert(QStringLiteral("lastLayer"), greatestRemovedLayer);
    return state;
}

} // namespace core
