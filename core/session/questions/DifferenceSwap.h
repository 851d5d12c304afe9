// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/SessionState.h"

#include <functional>
#include <optional>

namespace core {

/// Lays differences over the bricks as they are now: reads them, puts the differences on, swaps
/// them in. What undo, redo and "undo only here" have in common; part of their operations.
class DifferenceSwap {
public:
    /// Looks at the bricks before they are swapped in; an error stops that.
    /// @param now as they are (`after`) @param then as they would be, in the same order
    using Check = std::function<Result<void>(
        const std::vector<BrickChange>& now, const std::vector<BrickImage>& then)>;

    /// @param differences XOR images; a brick may stand there several times
    void start(SessionState& state, std::vector<BrickImage> differences, Check check = {});
    /// Where the bricks are known already.
    void put(SessionState& state, std::vector<BrickImage> images);
    /// The engine has been told to change something, and has not answered.
    [[nodiscard]] bool swapping() const { return m_swapping.has_value(); }

    /// @return the engine's result once the bricks are swapped in, or what went wrong; none: it
    /// goes on, or the result is somebody else's
    [[nodiscard]] std::optional<Result<EngineResult>> takeResult(
        SessionState& state, EngineResult&& result);

private:
    std::vector<BrickImage> m_differences; ///< by key
    Check m_check;
    std::optional<Ticket> m_reading;
    std::optional<Ticket> m_swapping;
};

} // namespace core
