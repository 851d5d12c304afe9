// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/servers/LocalListener.h"

#include <QByteArray>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace test {

/// A server on loopback that follows no protocol: the test decides what it sends to a client, and
/// how fast. Serves several connections at a time.
class RudeServer {
public:
    /// One connection; it ends with the client or with the server.
    class Client {
    public:
        Client(int socket, const std::atomic<bool>& ending)
            : m_socket(socket)
            , m_ending(ending)
        {
        }
        /// Receives what the client sends until it waits for an answer. Empty if it has gone.
        QByteArray hear() const;
        /// Sends bytes.
        /// @return whether the client still listens
        bool say(const QByteArray& bytes) const;
        /// Sends byte after byte, with a pause between, as long as the client listens.
        void drip(const QByteArray& bytes, int milliseconds) const;
        /// Sends the same bytes repeatedly, as fast as possible, at most @p often times.
        void flood(const QByteArray& bytes, int often) const;
        /// Sends nothing until the client gives up.
        void beSilent() const;
        /// Resets the connection instead of closing it.
        void reset() const;

    private:
        int m_socket;
        const std::atomic<bool>& m_ending;
    };

    explicit RudeServer(std::function<void(const Client&)> talk);
    RudeServer(const RudeServer&) = delete;
    RudeServer& operator=(const RudeServer&) = delete;
    ~RudeServer();

    [[nodiscard]] int port() const { return m_listener.port(); }

private:
    void work();

    std::function<void(const Client&)> m_talk;
    LocalListener m_listener;
    std::atomic<bool> m_ending = false;
    std::vector<std::thread> m_talks; ///< used by the thread below
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace test
