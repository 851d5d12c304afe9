// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

/// While an object of this class exists, every event of pen and mouse is delivered. Otherwise Qt
/// may merge several moves into one, which is good for everything except strokes. GUI thread; may
/// be nested.
class EveryPointerEvent {
public:
    EveryPointerEvent();
    ~EveryPointerEvent();
    EveryPointerEvent(const EveryPointerEvent&) = delete;
    EveryPointerEvent& operator=(const EveryPointerEvent&) = delete;

private:
    bool m_mouseBefore;
    bool m_penBefore;
};

} // namespace ui
