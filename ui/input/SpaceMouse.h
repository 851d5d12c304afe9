// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include <glm/glm.hpp>

#include <memory>

class QSocketNotifier;

namespace ui {

/// How far the cap of a six-degrees-of-freedom device was held out of its rest, and for how long:
/// 1 is what full deflection does in a second. Axes as the user sees them: right, up, towards the
/// user.
struct SpaceMotion {
    glm::dvec3 push{0.0}; ///< along the axes
    glm::dvec3 turn{0.0}; ///< about the axes, by the right-hand rule
};

/// Reads a six-degrees-of-freedom device ("space mouse") from spacenavd, the free driver of such
/// devices, by version 0 of its protocol: records of eight 32-bit integers over a local socket.
///
/// GUI thread. Without the driver there is nothing to read, and nobody is told: such devices are
/// rare. What several waiting records say is added up, so that a slow picture does not lag behind
/// the hand.
class SpaceMouse : public QObject {
    Q_OBJECT

public:
    explicit SpaceMouse(QObject* parent = nullptr);
    ~SpaceMouse() override;

    /// What the environment variable SPNAV_SOCKET names, as for other programs, or else the usual
    /// place.
    [[nodiscard]] static QString usualSocket();
    /// Connects to the driver unless that has happened. Takes no time: the driver is on this
    /// machine.
    /// @return whether it is connected
    bool connectTo(const QString& socketPath = usualSocket());
    [[nodiscard]] bool connected() const { return m_notifier != nullptr; }

Q_SIGNALS:
    void moved(const ui::SpaceMotion& motion);
    void buttonChanged(int button, bool pressed); ///< counted from 0
    void disconnected(); ///< the driver has gone; no button is held any longer

private:
    void read();
    void disconnectFrom();

    int m_socket = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_rest; ///< the beginning of a record whose end has not come yet
};

} // namespace ui
