// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/servers/LocalListener.h"

#include <QByteArray>
#include <QUrl>

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace test {

/// What a web server says to one question.
struct WebReply {
    int status = 200;
    QByteArray contentType = "application/dicom+json";
    QByteArray body;
    QByteArray moreHeaders; ///< whole lines, each with its end
    qint64 afterBytes = -1; ///< of the body: then the fault; −1: none
    enum class Fault {
        Cut, ///< the connection ends
        Stall, ///< nothing more comes
    } fault = Fault::Cut;
    bool withoutLength = false; ///< the body lasts until the connection ends
    int dripMs = 0; ///< after each thousand bytes
};

/// A web server on loopback that says what a test wants it to, one connection after the other.
class WebServer {
public:
    /// @param answer called on the server's thread with "GET /path?query" and the whole question
    using Answer = std::function<WebReply(const QByteArray& line, const QByteArray& question)>;
    explicit WebServer(Answer answer);
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;
    ~WebServer();

    [[nodiscard]] QUrl url() const;
    /// Their first lines, without the version.
    [[nodiscard]] std::vector<QByteArray> questions() const;

private:
    void work();
    void converse(int client);

    Answer m_answer;
    LocalListener m_listener;
    mutable std::mutex m_mutex;
    std::vector<QByteArray> m_questions;
    std::atomic<bool> m_ending = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace test
