// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/WatchedWire.h"

#include "core/pacs/WireWatch.h"

#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmtls/tlslayer.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

namespace core {

namespace {

class WatchedConnection final : public DcmTransportConnection {
public:
    WatchedConnection(int socket, std::unique_ptr<DcmTransportConnection> inner, WireState& state)
        : DcmTransportConnection(socket)
        , m_socket(socket)
        , m_inner(std::move(inner))
        , m_state(state)
        , m_watch(socket, state.progress, state.patience)
    {
    }

    OFCondition serverSideHandshake() override { return m_inner->serverSideHandshake(); }
    OFCondition clientSideHandshake() override
    {
        const OFCondition shaken = m_inner->clientSideHandshake();
        if (!endedByWatch() && shaken.bad())
            m_state.handshake = QString::fromUtf8(shaken.text());
        return shaken;
    }
    OFCondition renegotiate(const char* suite) override { return m_inner->renegotiate(suite); }
    void close() override
    {
        m_watch.end();
        m_inner->close();
    }
    void closeTransportConnection() override
    {
        m_watch.end();
        m_inner->closeTransportConnection();
    }
    unsigned long getPeerCertificateLength() override
    {
        return m_inner->getPeerCertificateLength();
    }
    unsigned long getPeerCertificate(void* bytes, unsigned long size) override
    {
        return m_inner->getPeerCertificate(bytes, size);
    }
    OFString& dumpConnectionParameters(OFString& text) override
    {
        return m_inner->dumpConnectionParameters(text);
    }
    // DCMTK would wait on the bare socket.
    OFBool isTransparentConnection() override { return OFFalse; }

    ssize_t read(void* bytes, size_t size) override
    {
        // Memory is asked for as the head of a message says; ours are a hundredth of that.
        constexpr size_t most = 16 << 20;
        if (size > most) {
            m_state.nonsense = Clause::saying("a message of %1 bytes", size);
            errno = EMSGSIZE;
            return -1;
        }
        // DCMTK asks before it reads the head of a message, but not before its body.
        if (!networkDataAvailable(m_state.timeoutSeconds)) {
            errno = m_state.cancelled ? ECANCELED : ETIMEDOUT;
            return -1;
        }
        const ssize_t count = m_inner->read(bytes, size);
        if (endedByWatch()) {
            errno = m_state.cancelled ? ECANCELED : ETIMEDOUT;
            return -1;
        }
        if (count > 0)
            m_state.patience->passed(count);
        m_state.clockRanOut = m_state.clockRanOut && count <= 0;
        // Many nodes hold small messages back until the last one is acknowledged (Nagle), which
        // the system puts off for 40 ms. It has to be told so again and again.
        const int on = 1;
        setsockopt(m_socket, IPPROTO_TCP, TCP_QUICKACK, &on, sizeof on);
        if (count == 0 && size > 0)
            m_state.closed = true;
        else if (count < 0)
            note(errno);
        return count;
    }
    ssize_t write(void* bytes, size_t size) override
    {
        if (isCancelled()) {
            errno = ECANCELED;
            return -1;
        }
        const ssize_t count = m_inner->write(bytes, size);
        if (count > 0)
            m_state.patience->passed(count);
        if (!endedByWatch() && count < 0)
            note(errno);
        return count;
    }
    OFBool networkDataAvailable(int timeout) override
    {
        using Clock = Patience::Clock;
        auto until = Clock::now() + std::chrono::seconds(timeout);
        for (;;) {
            if (isCancelled() || endedByWatch())
                return OFFalse;
            if (m_inner->networkDataAvailable(0))
                return OFTrue;
            // A sign of life may come on another connection, as objects of a C-MOVE do.
            if (timeout > 0)
                until =
                    std::max(until, m_state.patience->lastSign() + std::chrono::seconds(timeout));
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
            if (left.count() <= 0) {
                m_state.timedOut = m_state.timedOut || timeout > 0;
                m_state.clockRanOut = timeout <= 0;
                return OFFalse;
            }
            constexpr std::int64_t patience = 100;
            pollfd waited{m_socket, POLLIN, 0};
            ::poll(&waited, 1, int(std::min<std::int64_t>(patience, left.count())));
        }
    }

private:
    /// Whether the watch has ended the connection, which is noted.
    bool endedByWatch()
    {
        m_state.cancelled = m_state.cancelled || m_watch.cancelled();
        m_state.lost = m_watch.lost();
        m_state.timedOut = m_state.timedOut || m_state.lost != Patience::Lost::No;
        return m_watch.cancelled() || m_state.lost != Patience::Lost::No;
    }
    [[nodiscard]] bool isCancelled()
    {
        if (m_state.progress && m_state.progress->cancelled())
            m_state.cancelled = true;
        return m_state.cancelled;
    }
    void note(int error)
    {
        if (error == EAGAIN || error == EWOULDBLOCK)
            m_state.timedOut = true;
        else if (error == ECONNRESET || error == EPIPE)
            m_state.closed = true;
        else if (error != 0)
            m_state.trouble = QString::fromLocal8Bit(std::strerror(error));
    }

    int m_socket;
    std::unique_ptr<DcmTransportConnection> m_inner;
    WireState& m_state;
    WireWatch m_watch; ///< last: nobody is to look at a socket that is closed
};

class WatchedLayer final : public DcmTransportLayer {
public:
    WatchedLayer(WireState& state, std::unique_ptr<DcmTLSTransportLayer> tls)
        : m_state(state)
        , m_tls(std::move(tls))
    {
    }

    DcmTransportConnection* createConnection(
        DcmNativeSocketType socket, OFBool /*useSecureLayer*/) override
    {
        const int on = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        const timeval limit{m_state.timeoutSeconds, 0};
        setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
        setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        std::unique_ptr<DcmTransportConnection> inner(m_tls
                ? m_tls->createConnection(socket, OFTrue)
                : DcmTransportLayer::createConnection(socket, OFFalse));
        if (!inner)
            return nullptr;
        m_state.connected = true;
        m_state.patience = std::make_shared<Patience>(
            Patience::Seconds(m_state.timeoutSeconds), m_state.wholeSeconds);
        return new WatchedConnection(socket, std::move(inner), m_state);
    }

private:
    WireState& m_state;
    std::unique_ptr<DcmTLSTransportLayer> m_tls;
};

Result<std::unique_ptr<DcmTLSTransportLayer>> makeTls(const PacsTls& tls)
{
    static std::once_flag once;
    std::call_once(once, [] { DcmTLSTransportLayer::initializeOpenSSL(); });
    auto layer = std::make_unique<DcmTLSTransportLayer>(NET_REQUESTOR, nullptr, OFFalse);
    const auto name = [](const QString& file) { return QFile::encodeName(file); };
    if (layer->addTrustedCertificateFile(name(tls.authorityFile).constData(), DCF_Filetype_PEM)
            .bad()) {
        return failure(ErrorCode::FileUnreadable, tls.authorityFile,
            Clause::saying("it holds no certificates (PEM)"));
    }
    if (!tls.certificateFile.isEmpty()) {
        if (layer->setPrivateKeyFile(name(tls.keyFile).constData(), DCF_Filetype_PEM).bad()) {
            return failure(
                ErrorCode::FileUnreadable, tls.keyFile, Clause::saying("it holds no key (PEM)"));
        }
        if (layer->setCertificateFile(name(tls.certificateFile).constData(), DCF_Filetype_PEM).bad()
            || !layer->checkPrivateKeyMatchesCertificate()) {
            return failure(ErrorCode::FileUnreadable, tls.certificateFile,
                Clause::saying("it holds no certificate (PEM) of that key"));
        }
    }
    if (layer->setTLSProfile(TSP_Profile_BCP195).bad() || layer->activateCipherSuites().bad())
        return failure(ErrorCode::Internal, Clause::saying("TLS cannot be set up"));
    layer->setCertificateVerification(DCV_requireCertificate);
    return layer;
}

} // namespace

Result<std::unique_ptr<DcmTransportLayer>> makeWatchedLayer(WireState& state, const PacsTls& tls)
{
    std::unique_ptr<DcmTLSTransportLayer> secured;
    if (tls.wanted()) {
        Result<std::unique_ptr<DcmTLSTransportLayer>> made = makeTls(tls);
        if (!made)
            return tl::unexpected<Error>(made.error());
        secured = std::move(*made);
    }
    return std::make_unique<WatchedLayer>(state, std::move(secured));
}

} // namespace core
