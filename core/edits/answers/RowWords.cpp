// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/RowWords.h"

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
