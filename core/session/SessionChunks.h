// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/chunks/ChunkStage.h"

#include <memory>
#include <optional>

namespace core {

class ChunkMap;
struct CoarseChunks;
class SessionState;

/// The chunks into which a session's segment is divided (Document::chunks). They are computed on
/// their own thread when they are needed; DocumentChange::What::Chunks reports news. Part of
/// EditSession.
class SessionChunks {
public:
    explicit SessionChunks(SessionState& state);

    /// The chunks. Null if nothing is divided, or while they are being computed, which this call
    /// starts. They are kept until another division is requested.
    [[nodiscard]] std::shared_ptr<const ChunkMap> map();
    /// Roughly what they will be, for pictures, while those of a large box are being computed;
    /// null: not known.
    [[nodiscard]] std::shared_ptr<const CoarseChunks> coarse() const;
    /// The progress of the computation; none: it is not running.
    [[nodiscard]] std::optional<ChunkStage> stage() const;
    /// Why the chunks that were requested last cannot be computed: the engine's reasons,
    /// OutOfMemory, Cancelled.
    [[nodiscard]] std::optional<Error> whyNot() const;
    /// Allows a failed computation to be tried again.
    void forgetFailure();
    /// Cancels the computation.
    void cancel();

private:
    SessionState& m_state;
};

} // namespace core
