// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QString>

#include <optional>

namespace core {

/// What to fetch from a node: a series, or with an empty seriesUid the whole study.
struct RetrieveWish {
    QString studyUid;
    QString seriesUid;
    QString instanceUid; ///< of the series only this object
};

/// How objects come from a node.
struct RetrieveWay {
    /// C-MOVE: the node connects to this port, under the address that it has for our title. None:
    /// C-GET, over the connection that asks.
    std::optional<int> movePort;
};

struct Retrieved {
    int received = 0;
    int kept = 0; ///< from an earlier download
};

/// Fetches objects into the folder @p target, which comes into being when all are there and sound.
/// What an earlier call left of the same is not fetched again. Waits for the network; call it on a
/// worker's thread.
///
/// Errors: as of Association::request(); NodeHasNone, NodeFailed; TransferIncomplete and whatever
/// ended the connection (what came is kept for the next call); FileUnwritable.
[[nodiscard]] Result<Retrieved> retrieve(const PacsNode& node, const RetrieveWish& wish,
    const QString& target, const RetrieveWay& way, const Progress& progress);

} // namespace core
