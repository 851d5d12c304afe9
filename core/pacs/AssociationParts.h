// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/Association.h"
#include "core/pacs/WatchedWire.h"

struct T_ASC_Network;
struct T_ASC_Parameters;

namespace core {

/// The parts of an association, for the two sources that create them. They are freed from first to
/// last.
struct Association::Parts {
    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts();

    PacsNode node;
    WireState ownState;
    WireState* state = &ownState; ///< that of a listener if it created the association
    std::unique_ptr<DcmTransportLayer> layer;
    T_ASC_Network* network = nullptr; ///< null if a listener created the association
    T_ASC_Parameters* parameters = nullptr; ///< owned by the association once there is one
    T_ASC_Association* association = nullptr;
    bool released = false;
};

} // namespace core
