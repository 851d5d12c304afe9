// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"
#include "core/edits/open/OpenStroke.h"
#include "core/session/state/SessionState.h"

#include <map>

namespace core {

class Edit;
struct StrokeExtension;

/// Where the history will stand after operations that wait.
struct ForeseenPosition {
    RowId row = 0;
    std::map<RowId, RowId> visited{}; ///< by parent: the child that was visited last by then
};

/// One thing that a session was asked to do. Operations wait in a queue; the first one is started,
/// receives the answers of engine and worker, and is removed when it is done. Nothing here blocks.
class Operation {
public:
    virtual ~Operation() = default;

    virtual void start(SessionState& state) = 0;
    /// Receives a result that nobody else waits for: one of its own, or one that it may ignore.
    virtual void takeResult(SessionState&, EngineResult&&) { }
    /// Receives the differences of awaitedRow().
    virtual void takeDifferences(SessionState&, Result<RowDifferences>&&) { }
    /// The row whose differences are being read for it; 0: none. Those of other rows are of
    /// operations that are gone.
    [[nodiscard]] virtual RowId awaitedRow() const { return 0; }
    /// Called when SessionState::chunks has news.
    virtual void takeChunks(SessionState&) { }
    /// Whether it cannot continue before takeChunks().
    [[nodiscard]] virtual bool awaitsChunks() const { return false; }
    [[nodiscard]] virtual bool done() const = 0;
    /// Called when one of the functions above has thrown @p error: takes back what was begun and
    /// reports the error. @return false: that is impossible, and the engine may hold changes of
    /// which no row knows
    [[nodiscard]] virtual bool abandon(SessionState&, const Error&) { return false; }

    /// Applies what it will change to a document, to check the operations that wait behind it.
    /// @return false if that is not known yet
    [[nodiscard]] virtual bool foresee(Document&) const { return true; }
    /// Moves a position in the history as it will move it.
    /// @return false if that is not known yet: it may become a row
    [[nodiscard]] virtual bool foreseePosition(const History&, ForeseenPosition&) const
    {
        return false;
    }
};

/// The interface of operations whose work may take long: the side thread first computes what is to
/// be changed, or whether it may be changed; or the engine goes through much of the volume.
class AbortableWork {
public:
    virtual ~AbortableWork() = default;
    /// Aborts it, if it is abortable: it ends with Cancelled and changes nothing.
    virtual void abort(SessionState& state) = 0;
    [[nodiscard]] virtual bool isAbortable() const = 0;
    /// How much of the work is done; less than 0 before it has begun, or if it is unknown.
    [[nodiscard]] virtual int percent(const SessionState& state) const = 0;
    /// Whether a session that ends waits for it; otherwise it aborts it, because minutes may be
    /// left.
    [[nodiscard]] virtual bool isAwaitedAtEnd() const { return false; }
};

/// An operation that the user continues until it is ended: an open stroke, a running growth, a
/// preview.
class OpenOperation : public Operation {
public:
    [[nodiscard]] virtual bool open() const = 0;
    /// What does not apply to its edit is ignored.
    virtual void extend(SessionState& state, const StrokeExtension& extension) = 0;
    virtual void end(SessionState& state, Ending ending) = 0;
    [[nodiscard]] virtual const Edit& edit() const = 0;
    [[nodiscard]] virtual OpenManner manner() const = 0;
    /// Whether answers to questions asked from now on include its effect.
    [[nodiscard]] virtual bool hasBegun() const = 0;
    /// Whether nothing of it will remain, however it is ended.
    [[nodiscard]] virtual bool refused() const { return false; }
};

} // namespace core
