// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionContents.h"

#include <algorithm>

namespace core {

Error SessionDamage::error(const QString& path) const
{
    return {ErrorCode::SessionDamaged,
        {path, reason, QString::number(row), name, QString::number(after)}};
}

std::optional<SessionDamage> SessionDamage::of(const Error& error)
{
    const Clauses& arguments = error.arguments;
    if (error.code != ErrorCode::SessionDamaged || arguments.size() != 5)
        return std::nullopt;
    return SessionDamage{.row = arguments[2].toLongLong(),
        .name = arguments[3],
        .after = arguments[4].toLongLong(),
        .reason = arguments[1]};
}

void SessionContents::cut(const SessionDamage& at)
{
    damage = at;
    if (at.row > 0)
        rows.resize(std::min(rows.size(), std::size_t(at.row - 1)));
    const auto last = RowId(rows.size());
    if (position < 0 || position > last) {
        position = last;
        positionLost = true;
    }
    visited.erase(std::remove_if(visited.begin(), visited.end(),
                      [this, last](const std::pair<RowId, RowId>& step) {
                          const auto [parent, child] = step;
                          return child <= 0 || child > last
                              || rows[std::size_t(child - 1)].parent != parent;
                      }),
        visited.end());
    redo.erase(std::remove_if(redo.begin(), redo.end(),
                   [last](const SessionDamage& lost) { return lost.row > last; }),
        redo.end());
    keyframes.erase(std::remove_if(keyframes.begin(), keyframes.end(),
                        [last](const Keyframe& keyframe) { return keyframe.row > last; }),
        keyframes.end());
}

} // namespace core
