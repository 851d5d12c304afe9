// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"
#include "core/pacs/Patience.h"

#include <QString>

#include <memory>

class DcmTransportLayer;

namespace core {

/// What happened on a connection, which DCMTK's conditions do not tell apart.
struct WireState {
    const Progress* progress = nullptr; ///< asked while the connection waits
    int timeoutSeconds = 30;
    /// Begins when a connection is made; told of what is whole by who knows it.
    Patience::Seconds wholeSeconds{}; ///< for all of it; zero: no limit
    std::shared_ptr<Patience> patience;
    bool connected = false;
    bool timedOut = false;
    Patience::Lost lost = Patience::Lost::No; ///< how it did
    bool clockRanOut =
        false; ///< DCMTK's own, in whole seconds: it waits no more, and reads no more
    bool closed = false; ///< by the other side
    bool cancelled = false;
    QString trouble; ///< what the system said
    QString nonsense; ///< what it says that cannot be
    QString handshake; ///< why the connection could not be secured
};

/// The layer below an association: answers to cancelling within a tenth of a second, ends when
/// patience is lost, whatever DCMTK or TLS are waiting for, sends at once (without TCP_NODELAY each
/// of a series' images waits 40 ms), notes into @p state what ends it, and secures it where @p tls
/// says so. @p state outlives it. Only for sources of core/pacs.
/// InvalidField, FileUnreadable: certificates that cannot be used.
[[nodiscard]] Result<std::unique_ptr<DcmTransportLayer>> makeWatchedLayer(
    WireState& state, const PacsTls& tls);

} // namespace core
