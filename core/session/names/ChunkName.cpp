// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/ChunkName.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/Chunks.h"

#include <QStringList>

namespace core {

using namespace rowWords;

QString chunksName(const Chunks& edit, const Document& document)
{
    return QStringLiteral("Divide around %1 into chunks, %2")
        .arg(quoted(segmentName(edit.segment, document)), millimetres(edit.marginMm));
}

QString chunksName(const ChunkToggle& edit, const ChangeFacts& facts, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    const LabelFlow flow = facts.flow(segment ? segment->plane : std::uint8_t(0), edit.segment);
    const std::int64_t gained = flow.gained;
    const std::int64_t lost = flow.lost;
    QStringList figures;
    if (gained > 0)
        figures += QLatin1Char('+') + grouped(gained);
    if (lost > 0 || gained == 0)
        figures += QStringLiteral("−") + grouped(lost);
    const QString name = quoted(segmentName(edit.segment, document));
    const QString what = gained > 0 && lost > 0 ? QStringLiteral("Toggle chunks of ")
        : gained > 0                            ? QStringLiteral("Add chunks to ")
                                                : QStringLiteral("Take chunks from ");
    return what + name + QStringLiteral(", ") + figures.join(QLatin1Char(' '))
        + QStringLiteral(" voxels");
}

} // namespace core
