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

/// The reply of a web server to one request.
struct WebReply {
    int status = 200;
    QByteArray contentType = "application/dicom+json";
    QByteArray body;
    QByteArray moreHeaders; ///< complete lines, each with its line end
    qint64 afterBytes = -1; ///< number of body bytes before the fault; −1: no fault
    enum class Fault {
        Cut, ///< the connection ends
        Stall, ///< nothing more comes
    } fault = Fault::Cut;
    bool withoutLength = false; ///< no Content-Length: the body lasts until the connection ends
    int dripMs = 0; ///< pause after each thousand bytes
};

/// A web server on loopback that replies as a test wants, one connection at a time.
class WebServer {
public:
    /// @param line "GET /path?query"
    /// @param question the complete request. Called on the server's thread
    using Answer = std::function<WebReply(const QByteArray& line, const QByteArray& question)>;
    explicit WebServer(Answer answer);
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;
    ~WebServer();

    [[nodiscard]] QUrl url() const;
    /// The first lines of all requests, without the version.
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
