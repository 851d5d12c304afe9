// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/LocalListener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

LocalListener::LocalListener()
    : m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* general = reinterpret_cast<sockaddr*>(&address);
    if (::bind(m_socket, general, size) == 0 && ::listen(m_socket, 8) == 0
        && ::getsockname(m_socket, general, &size) == 0)
        m_port = ntohs(address.sin_port);
}

LocalListener::~LocalListener()
{
    ::close(m_socket);
}

int LocalListener::accepted() const
{
    constexpr int momentMs = 20;
    pollfd waiting{m_socket, POLLIN, 0};
    if (::poll(&waiting, 1, momentMs) < 1)
        return -1;
    return ::accept4(m_socket, nullptr, nullptr, SOCK_CLOEXEC);
}

} // namespace test
