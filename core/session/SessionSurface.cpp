// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionSurface.h"

#include "core/session/operations/OperationQueue.h"
#include "core/session/operations/SurfaceOperation.h"

#include <utility>

namespace core {

SessionSurface::SessionSurface(OperationQueue& queue)
    : m_queue(queue)
{
}

const SimplexMesh* SessionSurface::mesh() const
{
    const SessionState& state = m_queue.state();
    return m_queue.idle() && state.document.surface ? &state.surface.mesh : nullptr;
}

void SessionSurface::abort()
{
    SurfaceOperation* operation = m_queue.runningSurface();
    if (!operation || !operation->isAbortable())
        return;
    operation->abort();
    if (operation->open())
        m_queue.end(*operation, Ending::Rollback);
}

bool SessionSurface::isAbortable() const
{
    const SurfaceOperation* operation = m_queue.runningSurface();
    return operation && operation->isAbortable();
}

void SessionSurface::setListener(std::function<void(SurfaceUpdate)> listener)
{
    m_queue.submit(std::make_unique<ShowSurface>(std::move(listener)));
}

} // namespace core
