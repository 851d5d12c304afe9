// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/SessionState.h"

namespace core {

/// One thing that a session was asked to do. Operations wait in line; the first one is started,
/// told what engine and worker answer, and leaves when it is done. Nothing here waits.
class Operation {
public:
    virtual ~Operation() = default;

    virtual void start(SessionState& state) = 0;
    /// A result that nobody else waits for: the operation's own, or one it no longer cares for.
    virtual void takeResult(SessionState&, EngineResult&&) { }
    virtual void takeDifferences(SessionState&, Result<std::vector<BrickImage>>&&) { }
    /// SessionState::chunks has something new.
    virtual void takeChunks(SessionState&) { }
    [[nodiscard]] virtual bool done() const = 0;

    /// What it will make of the document, for checks of what waits behind it.
    /// @return false if that cannot be told yet
    [[nodiscard]] virtual bool foresee(Document&) const { return true; }
};

} // namespace core
