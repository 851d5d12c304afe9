// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/servers/LocalListener.h"

#include <QByteArray>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace test {

/// A server on loopback that keeps no protocol: what it says to whoever connects, and how fast, is
/// the test's. Several connections at a time.
class RudeServer {
public:
    /// One connection; ends with the client or with the server.
    class Client {
    public:
        Client(int socket, const std::atomic<bool>& ending)
            : m_socket(socket)
            , m_ending(ending)
        {
        }
        /// What the client says until it waits for an answer. Empty: it has gone.
        QByteArray hear() const;
        /// @return whether the client still listens
        bool say(const QByteArray& bytes) const;
        /// Byte after byte, with so much time between, for as long as the client listens.
        void drip(const QByteArray& bytes, int milliseconds) const;
        /// The same again and again, as fast as it goes, so often at most.
        void flood(const QByteArray& bytes, int often) const;
        /// Until the client has had enough.
        void beSilent() const;
        /// The connection is torn, not ended.
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
    std::vector<std::thread> m_talks; ///< of the thread below
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace test
