// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/pacs/PacsNode.h"
#include "core/pacs/Patience.h"

#include <QString>

#include <memory>

class DcmTransportLayer;

namespace core {

/// What happened on a connection; DCMTK's conditions do not distinguish these cases.
struct WireState {
    const Progress* progress = nullptr; ///< checked while the connection waits
    int timeoutSeconds = 30;
    /// Created with the connection. Complete messages are reported to it from outside.
    Patience::Seconds wholeSeconds{}; ///< limit for everything; zero: none
    std::shared_ptr<Patience> patience;
    bool connected = false;
    bool timedOut = false;
    Patience::Lost lost = Patience::Lost::No; ///< which limit was exceeded
    /// DCMTK's own timeout, in whole seconds, has passed: it neither waits nor reads any more
    bool clockRanOut = false;
    bool closed = false; ///< by the other side
    bool cancelled = false;
    QString trouble; ///< the system's message
    Clause nonsense; ///< what was invalid in the data received
    Clause handshake; ///< why TLS could not be established
};

/// Creates the transport layer below an association. It reacts to cancelling within a tenth of a
/// second and ends when a limit of Patience is exceeded, whatever DCMTK or TLS are waiting for. It
/// sends at once (without TCP_NODELAY each image of a series would wait 40 ms), records in @p state
/// what ends the connection, and uses TLS if @p tls says so. @p state must outlive it. Only for
/// sources of core/pacs. Errors: InvalidField, FileUnreadable (certificates that cannot be used).
[[nodiscard]] Result<std::unique_ptr<DcmTransportLayer>> makeWatchedLayer(
    WireState& state, const PacsTls& tls);

} // namespace core
