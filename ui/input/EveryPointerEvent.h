// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

/// While one lives, every reading of pen and mouse is delivered; otherwise Qt may join several
/// moves into one, which is right for everything but a stroke. GUI thread; may be nested.
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
