// SPDX-License-Identifier: Apache-2.0
#include "core/session/SegmentWork.h"

#include "core/session/operations/OperationQueue.h"

#include <algorithm>

namespace core {

SegmentWork::SegmentWork(OperationQueue& queue)
    : m_queue(queue)
{
}

std::optional<int> SegmentWork::percent() const
{
    const AbortableWork* operation = m_queue.runningAbortable();
    if (!operation || !operation->isAbortable())
        return std::nullopt;
    return std::max(0, operation->percent(m_queue.state()));
}

bool SegmentWork::isPreview() const
{
    const auto* operation = dynamic_cast<const OpenOperation*>(m_queue.runningAbortable());
    return operation && operation == m_queue.interactive() && operation->manner().withoutPen
        && operation->manner().usualEnding == Ending::Rollback;
}

void SegmentWork::abort()
{
    if (AbortableWork* operation = m_queue.runningAbortable())
        m_queue.guard([&] { operation->abort(m_queue.state()); });
}

} // namespace core
