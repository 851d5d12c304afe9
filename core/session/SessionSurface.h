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

    /// The mesh, valid until the next call that changes anything; null if there is no surface or an
    /// edit is running.
    [[nodiscard]] const SimplexMesh* mesh() const;
    /// @param listener told what must be drawn anew: first everything, after the operations that
    /// are waiting. It is called on any thread and must not wait for the code that draws. It must
    /// live as long as the session, or until another listener is set.
    void setListener(std::function<void(SurfaceUpdate)> listener);

    /// Abandons the laying of a surface, the following of a mask, or a template that still moves
    /// the surface. It is reported as Cancelled, and the surface and the history stay as they were.
    void abort();
    /// Whether there is something that abort() would end.
    [[nodiscard]] bool isAbortable() const;

private:
    OperationQueue& m_queue;
};

} // namespace core
