// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/RudeServer.h"

#include <QThread>

#include <array>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

QByteArray RudeServer::Client::hear() const
{
    constexpr int pauseMs = 50;
    QByteArray all;
    std::array<char, 65536> bytes{};
    while (!m_ending) {
        pollfd waiting{m_socket, POLLIN, 0};
        if (::poll(&waiting, 1, pauseMs) < 1) {
            if (!all.isEmpty())
                return all;
            continue;
        }
        const ssize_t count = ::read(m_socket, bytes.data(), bytes.size());
        if (count <= 0)
            return all;
        all.append(bytes.data(), count);
    }
    return all;
}

bool RudeServer::Client::say(const QByteArray& bytes) const
{
    for (qsizetype at = 0; at < bytes.size() && !m_ending;) {
        pollfd waiting{m_socket, POLLOUT, 0};
        if (::poll(&waiting, 1, 50) < 1)
            continue;
        const ssize_t sent = ::send(m_socket, bytes.constData() + at,
            std::size_t(bytes.size() - at), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent <= 0)
            return false;
        at += sent;
    }
    return !m_ending;
}

void RudeServer::Client::drip(const QByteArray& bytes, int milliseconds) const
{
    for (const char byte : bytes) {
        if (!say(QByteArray(1, byte)))
            return;
        QThread::msleep(ulong(milliseconds));
    }
}

void RudeServer::Client::flood(const QByteArray& bytes, int often) const
{
    for (int i = 0; i < often; ++i) {
        if (!say(bytes))
            return;
    }
}

void RudeServer::Client::beSilent() const
{
    while (!hear().isEmpty()) { }
}

void RudeServer::Client::reset() const
{
    const linger torn{1, 0};
    ::setsockopt(m_socket, SOL_SOCKET, SO_LINGER, &torn, sizeof torn);
}

RudeServer::RudeServer(std::function<void(const Client&)> talk)
    : m_talk(std::move(talk))
    , m_thread([this] { work(); })
{
}

RudeServer::~RudeServer()
{
    m_ending = true;
    m_thread.join();
}

void RudeServer::work()
{
    while (!m_ending) {
        const int socket = m_listener.accepted();
        if (socket < 0)
            continue;
        m_talks.emplace_back([this, socket] {
            m_talk(Client(socket, m_ending));
            ::close(socket);
        });
    }
    for (std::thread& talk : m_talks)
        talk.join();
}

} // namespace test
