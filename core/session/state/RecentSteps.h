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

/// Bricks before and after the steps that were carried out or walked over last, up to so many
/// bytes: undo and redo over them need no disk. Part of SessionState; one thread.
class RecentSteps {
public:
    static constexpr std::size_t usualBytes = std::size_t(256) << 20;

    /// Lets go at once of what is more.
    void setMostBytes(std::size_t bytes);

    /// What carrying a row out changed, or taking it back.
    void keep(RowId row, const Changes& changes, bool takenBack);
    /// The bricks as they are without the row, or with it; none: it is not at hand.
    [[nodiscard]] std::optional<std::vector<BrickImage>> images(RowId row, bool withRow);

private:
    struct Step {
        RowId row = 0;
        Changes changes;
        bool takenBack = false;
        std::size_t bytes = 0;
    };
    void shrink();

    std::list<Step> m_steps; ///< the one that was used last at the end
    std::map<RowId, std::list<Step>::iterator> m_places;
    std::size_t m_mostBytes = usualBytes;
    std::size_t m_bytes = 0;
};

} // namespace core
