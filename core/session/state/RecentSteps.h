// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/session/state/CommitWorker.h"

#include <cstddef>
#include <list>
#include <map>
#include <optional>
#include <vector>

namespace core {

/// The bricks before and after the steps that were carried out or undone last, up to a number of
/// bytes, so that undo and redo over them need no disk. Part of SessionState; one thread.
class RecentSteps {
public:
    static constexpr std::size_t usualBytes = std::size_t(256) << 20;

    /// Sets the limit and drops at once what exceeds it.
    void setMostBytes(std::size_t bytes);

    /// Keeps what carrying out a row, or taking it back, has changed.
    void keep(RowId row, const Changes& changes, bool takenBack);
    /// The bricks with or without the row; none: they are not in memory.
    [[nodiscard]] std::optional<std::vector<BrickImage>> images(RowId row, bool withRow);

private:
    struct Step {
        RowId row = 0;
        Changes changes;
        bool takenBack = false;
        std::size_t bytes = 0;
    };
    void shrink();

    std::list<Step> m_steps; ///< least recently used first
    std::map<RowId, std::list<Step>::iterator> m_places;
    std::size_t m_mostBytes = usualBytes;
    std::size_t m_bytes = 0;
};

} // namespace core
