// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/SpaceDriver.h"

#include <QFile>

#include <algorithm>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace test {

SpaceDriver::SpaceDriver()
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const QByteArray path = QFile::encodeName(socketPath());
    if (std::size_t(path.size()) >= sizeof(address.sun_path))
        qFatal("the temporary folder's name is too long for a socket");
    std::copy(path.begin(), path.end(), address.sun_path);
    m_listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (m_listening < 0
        || ::bind(m_listening, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0
        || ::listen(m_listening, 4) != 0)
        qFatal("cannot listen at a local socket");
}

SpaceDriver::~SpaceDriver()
{
    hangUp();
    ::close(m_listening);
}

bool SpaceDriver::accept()
{
    constexpr int patienceMs = 10000;
    pollfd waiting{.fd = m_listening, .events = POLLIN, .revents = 0};
    if (::poll(&waiting, 1, patienceMs) != 1)
        return false;
    m_client = ::accept(m_listening, nullptr, nullptr);
    return m_client >= 0;
}

void SpaceDriver::say(const Record& record)
{
    sayBytes(record.data(), sizeof(record));
}

void SpaceDriver::sayBytes(const void* bytes, std::size_t count)
{
    if (::send(m_client, bytes, count, MSG_NOSIGNAL) != ssize_t(count))
        qFatal("the program does not listen");
}

void SpaceDriver::hangUp()
{
    if (m_client >= 0)
        ::close(m_client);
    m_client = -1;
}

SpaceDriver::Record SpaceDriver::motion(const std::array<std::int32_t, 6>& axes, int milliseconds)
{
    return {0, axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], milliseconds};
}

SpaceDriver::Record SpaceDriver::button(int number, bool pressed)
{
    return {pressed ? 1 : 2, number, 0, 0, 0, 0, 0, 0};
}

} // namespace test
