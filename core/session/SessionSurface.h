// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"

#include <functional>

namespace core {

class OperationQueue;

/// The surface that is being refined (Document::surface). Part of EditSession.
class SessionSurface {
public:
    explicit SessionSurface(OperationQueue& queue);

    /// Null: there is none, or something is under way. Until the next call that changes anything.
    [[nodiscard]] const SimplexMesh* mesh() const;
    /// Told what is to be drawn anew of it: first, behind what waits, all that there is. Called on
    /// any thread, and must not wait for whoever draws. It lives as long as the session or until
    /// another one is told.
    void setListener(std::function<void(SurfaceUpdate)> listener);

private:
    OperationQueue& m_queue;
};

} // namespace core
