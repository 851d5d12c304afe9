// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/chunks/ChunkStage.h"

#include <memory>
#include <optional>

namespace core {

class ChunkMap;
class SessionState;

/// The chunks that a session's segment is divided into (Document::chunks). They are worked out on a
/// thread of their own, for whoever wants them; DocumentChange::What::Chunks tells that something
/// is new here. Part of EditSession.
class SessionChunks {
public:
    explicit SessionChunks(SessionState& state);

    /// Null while they are worked out, which this begins, and where nothing is divided. Kept until
    /// another division is asked for.
    [[nodiscard]] std::shared_ptr<const ChunkMap> map();
    /// How far that is; none: nothing is under way.
    [[nodiscard]] std::optional<ChunkStage> stage() const;
    /// Why those that were wanted last never will be: the engine's reasons, OutOfMemory, Cancelled.
    [[nodiscard]] std::optional<Error> whyNot() const;
    /// What failed may be tried again.
    void forgetFailure();
    /// What is under way is given up.
    void cancel();

private:
    SessionState& m_state;
};

} // namespace core
