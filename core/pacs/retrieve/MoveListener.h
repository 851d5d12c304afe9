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

/// Receives the objects of a C-MOVE: it listens on a port, on its own thread, during the move, and
/// accepts one association after the other that is addressed to our title, for objects of any kind,
/// in whatever form they are sent.
class MoveListener {
public:
    /// @param intake used by that thread until stop() Errors: InvalidField (the port is in use, or
    /// the node requires TLS, which is not supported here).
    [[nodiscard]] static Result<std::unique_ptr<MoveListener>> start(
        const PacsNode& node, int port, ObjectIntake& intake);
    MoveListener(const MoveListener&) = delete;
    MoveListener& operator=(const MoveListener&) = delete;
    ~MoveListener();

    /// Ends it soon. @return the first error that was not caused by stopping
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
    /// Last, since it uses all of the above. None: it has ended.
    std::optional<TaskThread> m_thread;
};

} // namespace core
