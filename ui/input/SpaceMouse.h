// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include <glm/glm.hpp>

#include <memory>

class QSocketNotifier;

namespace ui {

/// How far the cap of a 6-DoF device was deflected, multiplied by the time for which it was: 1 is
/// full deflection for one second. The axes are those of the user: right, up, towards the user.
struct SpaceMotion {
    glm::dvec3 push{0.0}; ///< displacement along the axes
    glm::dvec3 turn{0.0}; ///< rotation about the axes, by the right-hand rule
};

/// Reads a 6-DoF device ("space mouse") from spacenavd, the free driver of such devices, by version
/// 0 of its protocol: records of eight 32-bit integers over a local socket.
///
/// GUI thread. Without the driver this does nothing and reports no error, because most users have
/// no such device. Motions that have arrived together are added up into one signal, so the view
/// does not lag behind the hand when it draws slowly.
class SpaceMouse : public QObject {
    Q_OBJECT

public:
    explicit SpaceMouse(QObject* parent = nullptr);
    ~SpaceMouse() override;

    /// The path of the driver's socket: the value of the environment variable SPNAV_SOCKET, as in
    /// other programs, or else /var/run/spnav.sock.
    [[nodiscard]] static QString usualSocket();
    /// Connects to the driver if that has not been done yet. It does not block, because the driver
    /// runs on this machine.
    bool connectTo(const QString& socketPath = usualSocket());
    [[nodiscard]] bool connected() const { return m_notifier != nullptr; }

Q_SIGNALS:
    void moved(const ui::SpaceMotion& motion);
    void buttonChanged(int button, bool pressed); ///< counted from 0
    /// The driver has ended the connection; no button counts as pressed any longer.
    void disconnected();

private:
    void read();
    void disconnectFrom();

    int m_socket = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_rest; ///< the beginning of a record that has not arrived completely
};

} // namespace ui
