// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionDisplay.h"

#include "core/session/operations/OperationQueue.h"

namespace core {

SessionDisplay::SessionDisplay(OperationQueue& queue)
    : m_queue(queue)
{
}

void SessionDisplay::setSegmentVisible(int label, bool visible)
{
    setSegmentsVisible({{label, visible}});
}

void SessionDisplay::setSegmentsVisible(const std::vector<std::pair<int, bool>>& segments)
{
    m_queue.state().setVisible(segments);
    m_queue.notifyListeners();
}

const QJsonObject& SessionDisplay::kept() const
{
    return m_queue.state().display;
}

void SessionDisplay::keep(const QJsonObject& display)
{
    m_queue.state().setDisplay(display);
}

} // namespace core
