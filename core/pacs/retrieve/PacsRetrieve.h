// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QString>

#include <optional>

namespace core {

/// What to retrieve from a node: a series, or the whole study if seriesUid is empty.
struct RetrieveWish {
    QString studyUid;
    QString seriesUid;
    QString instanceUid; ///< only this object of the series
};

/// How objects are transferred from a node.
struct RetrieveWay {
    /// C-MOVE: the node connects to this port, at the address that it has for our title. None:
    /// C-GET, over the same connection.
    std::optional<int> movePort;
};

/// The result of retrieving.
struct Retrieved {
    int received = 0;
    int kept = 0; ///< from an earlier download
};

/// Retrieves objects into the folder @p target, which appears when all are there and undamaged.
/// Objects left by an earlier call are not retrieved again. Blocks; call it on a worker thread.
///
/// Errors: those of Association::request(); NodeHasNone, NodeFailed; TransferIncomplete and
/// whatever ended the connection (what was received is kept for the next call); FileUnwritable.
[[nodiscard]] Result<Retrieved> retrieve(const PacsNode& node, const RetrieveWish& wish,
    const QString& target, const RetrieveWay& way, const Progress& progress);

} // namespace core
