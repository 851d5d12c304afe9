// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/ChunkName.h"

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/Chunks.h"
#include "core/session/past/RowWords.h"

#include <QStringList>

namespace core {

using namespace rowWords;

QString chunksName(const Chunks& edit, const Document& document)
{
    return QStringLiteral("Divide around %1 into chunks, %2")
        .arg(quoted(segmentName(edit.segment, document)), millimetres(edit.marginMm));
}

QString chunksName(
    const ChunkToggle& edit, const std::vector<BrickChange>& changes, const Document& document)
{
    std::int64_t gained = 0;
    std::int64_t lost = 0;
    for (const BrickChange& change : changes) {
        if (change.key.field != Field::Labels)
            continue;
        for (std::size_t i = 0; i < std::size_t(BrickGrid::voxelsPerBrick); ++i) {
            const int before = change.before.empty() ? 0 : change.before[i];
            const int after = change.after.empty() ? 0 : change.after[i];
            gained += before != after && after == edit.segment ? 1 : 0;
            lost += before != after && before == edit.segment ? 1 : 0;
        }
    }
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
