// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/Association.h"
#include "core/pacs/WatchedWire.h"

struct T_ASC_Network;
struct T_ASC_Parameters;

namespace core {

/// What an association consists of; for the two sources that make them. Freed from the top down.
struct Association::Parts {
    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts();

    PacsNode node;
    WireState ownState;
    WireState* state = &ownState; ///< a listener's, where it made the association
    std::unique_ptr<DcmTransportLayer> layer;
    T_ASC_Network* network = nullptr; ///< none where a listener made the association
    T_ASC_Parameters* parameters = nullptr; ///< the association's, once there is one
    T_ASC_Association* association = nullptr;
    bool released = false;
};

} // namespace core
