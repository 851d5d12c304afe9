// SPDX-License-Identifier: Apache-2.0
#include "ui/input/SpaceMouse.h"

#include <QFile>
#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace ui {

namespace {

using Record = std::array<std::int32_t, 8>;

enum RecordKind : std::int32_t { Motion = 0, Press = 1, Release = 2 };

// What devices report when the cap is held out as far as it goes.
constexpr double fullDeflection = 350.0;
// After a rest the driver tells how long the rest was; the cap was out only lately.
constexpr int longestMs = 50;
constexpr int usualMs = 16;

double deflection(std::int32_t value)
{
    return std::clamp(double(value) / fullDeflection, -1.0, 1.0);
}

SpaceMotion motionOf(const Record& record)
{
    const int milliseconds = record[7] > 0 ? std::min(int(record[7]), longestMs) : usualMs;
    const double seconds = milliseconds / 1000.0;
    // The third axis of the device points away from the user, and so does its rotation.
    return {.push = seconds
            * glm::dvec3(deflection(record[1]), deflection(record[2]), -deflection(record[3])),
        .turn = seconds
            * glm::dvec3(deflection(record[4]), deflection(record[5]), -deflection(record[6]))};
}

} // namespace

SpaceMouse::SpaceMouse(QObject* parent)
    : QObject(parent)
{
}

SpaceMouse::~SpaceMouse()
{
    disconnectFrom();
}

QString SpaceMouse::usualSocket()
{
    return qEnvironmentVariable("SPNAV_SOCKET", QStringLiteral("/var/run/spnav.sock"));
}

bool SpaceMouse::connectTo(const QString& socketPath)
{
    if (connected())
        return true;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const QByteArray path = QFile::encodeName(socketPath);
    if (path.isEmpty() || path.contains('\0')
        || std::size_t(path.size()) >= sizeof(address.sun_path))
        return false;
    std::copy(path.begin(), path.end(), address.sun_path);
    m_socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (m_socket < 0)
        return false;
    if (::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
        disconnectFrom();
        return false;
    }
    m_notifier = std::make_unique<QSocketNotifier>(m_socket, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &SpaceMouse::read);
    return true;
}

void SpaceMouse::disconnectFrom()
{
    if (m_notifier) {
        m_notifier->setEnabled(false);
        // It may be what called.
        m_notifier.release()->deleteLater();
    }
    if (m_socket >= 0)
        ::close(m_socket);
    m_socket = -1;
    m_rest.clear();
}

void SpaceMouse::read()
{
    SpaceMotion sum;
    bool hasMoved = false;
    const auto reportMotion = [&] {
        if (std::exchange(hasMoved, false))
            Q_EMIT moved(std::exchange(sum, {}));
    };
    // At most this much at once: a driver that never stops must not hold the window.
    std::array<char, 64 * sizeof(Record)> bytes;
    const ssize_t count = ::recv(m_socket, bytes.data(), bytes.size(), 0);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) {
        disconnectFrom();
        return Q_EMIT disconnected();
    }
    if (count < 0)
        return;
    m_rest.append(bytes.data(), count);
    const QByteArray whole = m_rest;
    const qsizetype records = whole.size() / qsizetype(sizeof(Record));
    m_rest = whole.sliced(records * qsizetype(sizeof(Record)));
    for (qsizetype i = 0; i < records; ++i) {
        Record record;
        std::memcpy(&record, whole.constData() + i * qsizetype(sizeof(Record)), sizeof(Record));
        if (record[0] == Motion) {
            const SpaceMotion motion = motionOf(record);
            sum.push += motion.push;
            sum.turn += motion.turn;
            hasMoved = true;
        } else if (record[0] == Press || record[0] == Release) {
            reportMotion(); // buttons decide what is moved
            Q_EMIT buttonChanged(record[1], record[0] == Press);
        }
    }
    reportMotion();
}

} // namespace ui
