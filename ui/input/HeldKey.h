// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

class QAction;

namespace ui {

/// Makes an action that its key switches on and off a look for as long as the key is held: a short
/// press switches; a long one switches, and switches back when the key is let go. It also switches
/// back when the window is left while the key is down, since nobody tells then that it was let go.
class HeldKey : public QObject {
    Q_OBJECT

public:
    /// From this long on a key was held.
    static constexpr int heldMilliseconds = 350;

    /// @param action owns this; its first shortcut is the key, a letter without others held down
    explicit HeldKey(QAction& action);

    [[nodiscard]] bool isDown() const { return m_switched; } ///< and has switched

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void letGo(bool wasHeld);

    QAction& m_action;
    int m_key = 0;
    bool m_pressed = false;
    bool m_switched = false; ///< by the press that has not ended yet
    QTimer m_short; ///< runs while the press is still a short one
};

} // namespace ui
