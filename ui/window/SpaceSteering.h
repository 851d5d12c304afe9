// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/SpaceMouse.h"

#include <QObject>

namespace ui {

class MainWindow;

/// Moves the scene with a 6-DoF device, by the hand that does not draw (seed B §3). The object in
/// the 3D view follows the cap: it is shifted, rotated about any axis, and grows as the cap is
/// pulled. While the first button is held, or the pointer is over the pen view, the cutting plane
/// follows the cap instead. The second button shows the whole volume again.
///
/// While a stroke or drag is going on in a view, that view does not move; the other one can be
/// moved meanwhile. Nothing happens while another program or a dialog has the keyboard, since the
/// driver reports the device to every program.
class SpaceSteering : public QObject {
    Q_OBJECT

public:
    /// Looks for the driver now and whenever the window becomes active. @p window becomes the
    /// owner.
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
    bool m_holdsPlane = false; ///< the first button is held, so the plane follows
};

} // namespace ui
