// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

#include <utility>
#include <vector>

namespace core {

class OperationQueue;

/// The display state that is kept with a session. None of it is a step of undo. Part of
/// EditSession.
class SessionDisplay {
public:
    explicit SessionDisplay(OperationQueue& queue);

    void setSegmentVisible(int label, bool visible);
    /// The same for several segments, by label; listeners are notified only once.
    void setSegmentsVisible(const std::vector<std::pair<int, bool>>& segments);

    /// The state of the window when the session was last displayed: an object that core does not
    /// interpret (ui/window/display/DisplayState). Empty: none was kept.
    [[nodiscard]] const QJsonObject& kept() const;
    /// Writes it to the file if it has changed. Not meant to be called for every mouse movement.
    void keep(const QJsonObject& display);

private:
    OperationQueue& m_queue;
};

} // namespace core
