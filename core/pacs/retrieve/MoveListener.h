// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "core/pacs/PacsNode.h"
#include "core/pacs/WatchedWire.h"
#include "core/pacs/retrieve/ObjectIntake.h"

#include <memory>
#include <optional>

struct T_ASC_Network;

namespace core {

class Association;

/// Where a node brings the objects of a C-MOVE: listens on a port, on a thread of its own, while
/// the move is under way; takes one association after the other, addressed to our title.
class MoveListener {
public:
    /// @param intake used by that thread until stop()
    /// InvalidField: the port is taken, or the node wants TLS, which this does not speak.
    [[nodiscard]] static Result<std::unique_ptr<MoveListener>> start(
        const PacsNode& node, int port, ObjectIntake& intake);
    MoveListener(const MoveListener&) = delete;
    MoveListener& operator=(const MoveListener&) = delete;
    ~MoveListener();

    /// Ends it within moments. @return the first error that did not come from stopping
    std::optional<Error> stop();

private:
    MoveListener(const PacsNode& node, ObjectIntake& intake);
    void work();
    [[nodiscard]] Result<void> serve();
    [[nodiscard]] Result<void> converse(Association& association);

    PacsNode m_node;
    ObjectIntake& m_intake;
    Progress m_ending; ///< cancelled by stop()
    WireState m_wire;
    std::unique_ptr<DcmTransportLayer> m_layer;
    T_ASC_Network* m_network = nullptr;
    std::optional<Error> m_trouble;
    /// Last: it uses all of the above. None: it has ended.
    std::optional<TaskThread> m_thread;
};

} // namespace core
