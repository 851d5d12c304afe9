// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/SessionState.h"

namespace core {

/// One thing that a session was asked to do. Operations wait in line; the first one is started,
/// told what engine and worker answer, and leaves when it is done. Nothing here waits.
class Operation {
public:
    virtual ~Operation() = default;

    virtual void start(SessionState& state) = 0;
    /// A result that nobody else waits for: the operation's own, or one it no longer cares for.
    virtual void takeResult(SessionState&, EngineResult&&) { }
    virtual void takeDifferences(SessionState&, Result<RowDifferences>&&) { }
    /// SessionState::chunks has something new.
    virtual void takeChunks(SessionState&) { }
    /// It cannot go on until takeChunks().
    [[nodiscard]] virtual bool awaitsChunks() const { return false; }
    [[nodiscard]] virtual bool done() const = 0;
    /// Something in one of the above has thrown @p error: what has begun is taken back, and told.
    /// @return false: it cannot be, the engine may hold what no row tells of
    [[nodiscard]] virtual bool abandon(SessionState&, const Error&) { return false; }

    /// What it will make of the document, for checks of what waits behind it.
    /// @return false if that cannot be told yet
    [[nodiscard]] virtual bool foresee(Document&) const { return true; }
};

/// One that the user goes on telling until it is ended: a stroke under the pen, a growth that runs.
class OpenOperation : public Operation {
public:
    [[nodiscard]] virtual bool open() const = 0;
    virtual void extendPath(
        SessionState& state, const std::vector<glm::dvec3>& pointsLps, bool lifted) = 0;
    virtual void end(SessionState& state, Ending ending) = 0;
    /// Open without a pen that is down: whatever comes next closes it.
    [[nodiscard]] virtual bool standsOpen() const { return false; }
    /// How it ends by itself.
    [[nodiscard]] virtual Ending usualEnding() const { return Ending::Rollback; }
};

} // namespace core
