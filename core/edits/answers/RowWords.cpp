// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/RowWords.h"

#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core::rowWords {

QString grouped(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

QString counted(std::int64_t count, const char* noun)
{
    return grouped(count) + QLatin1Char(' ') + QLatin1String(noun)
        + (count == 1 ? QString() : QStringLiteral("s"));
}

QString quoted(const QString& name)
{
    return QLatin1Char('\'') + name + QLatin1Char('\'');
}

QString millimetres(double mm)
{
    return QString::number(mm, 'f', 1) + QStringLiteral(" mm");
}

QString segmentName(int label, const Document& document)
{
    const Segment* segment = document.segment(label);
    return segment ? segment->name : QString::number(label);
}

QString layerName(int id, const Document& document)
{
    const SculptLayer* layer = document.layer(id);
    return quoted(layer ? layer->name : QString::number(id));
}

QString pieceName(int id, const Document& document)
{
    const Piece* piece = document.piece(id);
    return quoted(piece ? piece->name : QString::number(id));
}

QString targetName(const SegmentChoice& choice, const Document& document)
{
    return quoted(choice.segment ? segmentName(*choice.segment, document) : choice.name);
}

} // namespace core::rowWords
