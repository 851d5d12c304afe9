// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace core {

class OperationQueue;

/// What a session keeps of how it is looked at. None of it is a step of undo. Part of EditSession.
class SessionDisplay {
public:
    explicit SessionDisplay(OperationQueue& queue);

    void setSegmentVisible(int label, bool visible);

    /// How the window looked at it, for the next time it is opened: an object that means nothing
    /// here (ui/window/DisplayState). Empty: none was kept.
    [[nodiscard]] const QJsonObject& kept() const;
    /// Goes to the file if it is another one; not for every movement of the mouse.
    void keep(const QJsonObject& display);

private:
    OperationQueue& m_queue;
};

} // namespace core
