// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/dicomweb/WebNode.h"
#include "core/pacs/Patience.h"

#include <QByteArray>
#include <QString>

#include <memory>

namespace core {

/// The beginning of a web server's answer.
struct WebAnswer {
    int status = 0;
    QByteArray contentType;
};

/// Receives an answer as it arrives. An error ends the exchange and becomes its result.
class WebSink {
public:
    WebSink() = default;
    WebSink(const WebSink&) = delete;
    WebSink& operator=(const WebSink&) = delete;
    virtual ~WebSink() = default;
    /// Called before any part of an answer, and again if the request is repeated.
    [[nodiscard]] virtual Result<void> begin(const WebAnswer& answer) = 0;
    [[nodiscard]] virtual Result<void> take(const QByteArray& bytes) = 0;
    /// The number of complete parts of the answer so far, if it has several.
    [[nodiscard]] virtual int wholeParts() const { return 0; }
};

/// A connection to a web server; all HTTP requests are made here. It belongs to the thread that
/// created it, which blocks in its functions; blocking ends shortly after cancelling. Only for
/// sources of core/dicomweb.
///
/// Errors of its functions: NodeUnreachable, NodeRejects (the login), NodeTimeout, NodeLost,
/// Cancelled; NodeHasNone for status 404; NodeFailed for every other status that is not success,
/// with the status as last argument.
class WebConnection {
public:
    /// Further errors: those of WebLogin::read(), and InvalidField for certificate files and for a
    /// login that would be sent to another machine over plain http (BURIN_PLAIN_LOGIN=yes allows
    /// it).
    /// @param whole limit for everything requested with it; zero: no limit while data arrive
    [[nodiscard]] static Result<WebConnection> open(
        const WebNode& node, const Progress& progress, Patience::Seconds whole = {});
    WebConnection(WebConnection&&) noexcept;
    ~WebConnection();

    /// @param path after the node's own, with its query, percent-encoded
    /// @param repeatable the request is repeated after a pause even if the connection ended within
    /// the answer; otherwise only if nothing of the answer had arrived
    [[nodiscard]] Result<WebAnswer> get(const QByteArray& path, const QByteArray& accept,
        const Clause& what, WebSink& sink, bool repeatable);
    /// Sends one file as multipart/related (PS3.18 10.5). Status 409 is returned like a success, a
    /// redirection is a failure.
    [[nodiscard]] Result<WebAnswer> postFile(
        const QByteArray& path, const QString& file, const Clause& what, WebSink& sink);

    /// Waits before another attempt. Errors: Cancelled.
    [[nodiscard]] Result<void> pause(int milliseconds) const;
    [[nodiscard]] const WebNode& node() const;
    /// The status of the last answer, whether success or not; 0: none came.
    [[nodiscard]] int lastStatus() const;

    struct Parts;
    explicit WebConnection(std::unique_ptr<Parts> parts);

private:
    struct Outcome;
    class Exchange;
    [[nodiscard]] Result<WebAnswer> exchange(const QByteArray& path, const QByteArray& accept,
        const QString* file, const Clause& what, WebSink& sink, bool repeatable);

    std::unique_ptr<Parts> m_parts;
};

} // namespace core
