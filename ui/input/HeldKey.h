// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

class QAction;

namespace ui {

/// Lets the key of a checkable action also work while it is held: a short press switches the state;
/// a long press switches it and switches it back on release. It also switches back when the window
/// loses the keyboard while the key is down, because no release would be reported then.
class HeldKey : public QObject {
    Q_OBJECT

public:
    /// A press of at least this length counts as held.
    static constexpr int heldMilliseconds = 350;

    /// @param action becomes the owner of this object. Its first shortcut is the key, a letter
    /// without modifier keys.
    explicit HeldKey(QAction& action);

    /// Whether the key is down and has switched the action.
    [[nodiscard]] bool isDown() const { return m_switched; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void letGo(bool wasHeld);

    QAction& m_action;
    int m_key = 0;
    bool m_pressed = false;
    bool m_switched = false; ///< the present press has switched the action
    QTimer m_short; ///< runs as long as the press still counts as short
};

} // namespace ui
