// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/SpaceMouse.h"

#include <QObject>

namespace ui {

class MainWindow;

/// Moves the scene with a six-degrees-of-freedom device, for the hand that does not draw (seed B
/// §3). The 3D view's object follows the cap: it is shifted, turned about any axis, and grows as
/// the cap is pulled. While the first button is held, or the pointer is over the pen view, the
/// cutting plane follows the cap instead. The second button shows the whole volume again.
///
/// A view rests while a stroke or a drag is going on in it; the other one can be moved meanwhile.
/// Nothing happens while another program or a dialog has the keyboard: the driver tells every
/// program what the device does.
class SpaceSteering : public QObject {
    Q_OBJECT

public:
    /// @p window owns it. It looks for the driver now, and whenever the window becomes active.
    explicit SpaceSteering(MainWindow& window);

    [[nodiscard]] SpaceMouse& mouse() { return m_mouse; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(const SpaceMotion& motion);
    void followPlane(const SpaceMotion& motion);
    void followObject(const SpaceMotion& motion);
    void pressed(int button, bool down);
    [[nodiscard]] bool isInCharge() const;

    MainWindow& m_window;
    SpaceMouse m_mouse;
    bool m_holdsPlane = false; ///< the button for it is down
};

} // namespace ui
