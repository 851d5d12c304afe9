// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicomweb/WebNode.h"
#include "core/pacs/Patience.h"

#include <QByteArray>
#include <QString>

#include <memory>

namespace core {

/// How a web server began its answer.
struct WebAnswer {
    int status = 0;
    QByteArray contentType;
};

/// Takes an answer as it arrives. Errors end the exchange, and are its outcome.
class WebSink {
public:
    WebSink() = default;
    WebSink(const WebSink&) = delete;
    WebSink& operator=(const WebSink&) = delete;
    virtual ~WebSink() = default;
    /// Before anything of an answer; again where the question is put again.
    [[nodiscard]] virtual Result<void> begin(const WebAnswer& answer) = 0;
    [[nodiscard]] virtual Result<void> take(const QByteArray& bytes) = 0;
    /// How many things of the answer are whole so far, where it consists of several.
    [[nodiscard]] virtual int wholeParts() const { return 0; }
};

/// The one place that talks HTTP. Belongs to the thread that made it, which waits in its functions;
/// waiting ends within a moment of cancelling. Only for sources of core/dicomweb.
///
/// Errors of its functions: NodeUnreachable, NodeRejects (the login), NodeTimeout, NodeLost,
/// Cancelled; NodeHasNone for status 404, NodeFailed for every other that is no success, with it as
/// its last argument.
class WebConnection {
public:
    /// Errors also: of WebLogin::read(), and InvalidField for files of certificates, and for a
    /// login that would go to another machine over plain http (BURIN_PLAIN_LOGIN=yes lets it).
    /// @param whole how long all that is asked by it may take; zero: as long as things come
    [[nodiscard]] static Result<WebConnection> open(
        const WebNode& node, const Progress& progress, Patience::Seconds whole = {});
    WebConnection(WebConnection&&) noexcept;
    ~WebConnection();

    /// @param path after the node's own, with its query, percent-encoded
    /// @param repeatable put again, after a pause, also when the connection ended amid the answer;
    /// otherwise only where nothing of it had come
    [[nodiscard]] Result<WebAnswer> get(const QByteArray& path, const QByteArray& accept,
        const QString& what, WebSink& sink, bool repeatable);
    /// One file as multipart/related (PS3.18 10.5). Status 409 is an answer like others.
    [[nodiscard]] Result<WebAnswer> postFile(
        const QByteArray& path, const QString& file, const QString& what, WebSink& sink);

    /// Waits before another try. Cancelled.
    [[nodiscard]] Result<void> pause(int milliseconds) const;
    [[nodiscard]] const WebNode& node() const;

    struct Parts;
    explicit WebConnection(std::unique_ptr<Parts> parts);

private:
    struct Outcome;
    class Exchange;
    [[nodiscard]] Result<WebAnswer> exchange(const QByteArray& path, const QByteArray& accept,
        const QString* file, const QString& what, WebSink& sink, bool repeatable);

    std::unique_ptr<Parts> m_parts;
};

} // namespace core
