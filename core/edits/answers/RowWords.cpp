// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/RowWords.h"

#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core::rowWords {

RowTitle figure(RowTitleCode code, std::int64_t count)
{
    return {.code = code, .arguments = {TitleCount{count}}};
}

RowTitle flowTitle(std::int64_t gained, std::int64_t lost)
{
    if (gained <= 0)
        return figure(RowTitleCode::FlowOut, lost);
    if (lost <= 0)
        return figure(RowTitleCode::FlowIn, gained);
    return {
        .code = RowTitleCode::FlowInAndOut, .arguments = {TitleCount{gained}, TitleCount{lost}}};
}

RowTitle segmentChanged(RowTitleCode code, int label, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(label);
    return {.code = code,
        .arguments = {segmentName(label, row.document)},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

RowTitle voxelsOrSeedsLost(bool erases, const RowFacts& row)
{
    const std::int64_t voxels = row.statistics.voxelsChanged;
    if (voxels == 0)
        return figure(RowTitleCode::SeedVoxelsLost, row.facts.seedWordsChanged);
    return figure(erases ? RowTitleCode::VoxelsLost : RowTitleCode::VoxelsGained, voxels);
}

QString segmentName(int label, const Document& document)
{
    const Segment* segment = document.segment(label);
    return segment ? segment->name : QString::number(label);
}

QString layerName(int id, const Document& document)
{
    const SculptLayer* layer = document.layer(id);
    return layer ? layer->name : QString::number(id);
}

QString pieceName(int id, const Document& document)
{
    const Piece* piece = document.piece(id);
    return piece ? piece->name : QString::number(id);
}

QString targetName(const SegmentChoice& choice, const Document& document)
{
    return choice.segment ? segmentName(*choice.segment, document) : choice.name;
}

} // namespace core::rowWords
