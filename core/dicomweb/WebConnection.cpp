// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebConnection.h"

#include "core/base/Guarded.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QHostAddress>
#include <QHttpMultiPart>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslKey>
#include <QTimer>

#include <algorithm>
#include <optional>
#include <utility>

namespace core {

namespace {

/// What waits to be taken at most.
constexpr qint64 mostWaiting = 1 << 20;
constexpr int longestPauseMs = 30000;

bool isSuccess(int status)
{
    return status >= 200 && status < 300;
}

bool isBusy(int status)
{
    return status == 429 || status == 502 || status == 503 || status == 504;
}

bool isTransport(QNetworkReply::NetworkError error)
{
    return error != QNetworkReply::NoError && error < QNetworkReply::ContentAccessDenied;
}

QString statusName(const QNetworkReply& reply, int status)
{
    const QString reason =
        reply.attribute(QNetworkRequest::HttpReasonPhraseAttribute).toString().left(60);
    return QStringLiteral("HTTP %1 %2").arg(status).arg(reason).trimmed();
}

Result<QSslConfiguration> secured(const WebNode& node)
{
    QSslConfiguration tls = QSslConfiguration::defaultConfiguration();
    tls.setPeerVerifyMode(QSslSocket::VerifyPeer);
    const auto wrong = [](const char* field, const QString& file) {
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            Clause::saying("%1 holds none in PEM", file));
    };
    if (!node.authorityFile.isEmpty()) {
        const QList<QSslCertificate> authorities = QSslCertificate::fromPath(node.authorityFile);
        if (authorities.isEmpty())
            return wrong("authority", node.authorityFile);
        tls.setCaCertificates(authorities);
    }
    if (!node.certificateFile.isEmpty()) {
        const QList<QSslCertificate> own = QSslCertificate::fromPath(node.certificateFile);
        if (own.isEmpty())
            return wrong("certificate", node.certificateFile);
        tls.setLocalCertificateChain(own);
        QFile file(node.keyFile);
        const QByteArray pem = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        QSslKey key(pem, QSsl::Rsa);
        if (key.isNull())
            key = QSslKey(pem, QSsl::Ec);
        if (key.isNull())
            return wrong("key", node.keyFile);
        tls.setPrivateKey(key);
    }
    return tls;
}

/// A file as the one part of a body; owns it.
std::unique_ptr<QHttpMultiPart> bodyOf(const QString& path)
{
    auto body = std::make_unique<QHttpMultiPart>(QHttpMultiPart::RelatedType);
    auto* file = new QFile(path, body.get());
    if (!file->open(QIODevice::ReadOnly))
        return nullptr;
    QHttpPart part;
    part.setHeader(QNetworkRequest::ContentTypeHeader, QStringLiteral("application/dicom"));
    part.setBodyDevice(file);
    body->append(part);
    return body;
}

} // namespace

struct WebConnection::Parts {
    Parts(const WebNode& to, const Progress& told, Patience::Seconds whole)
        : node(to)
        , progress(told)
        , patience(Patience::Seconds(to.timeoutSeconds), whole)
    {
    }

    WebNode node;
    const Progress& progress;
    Patience patience;
    QByteArray authorization;
    QSslConfiguration tls;
    QNetworkAccessManager manager;
    int lastStatus = 0;
};

/// Of one try.
struct WebConnection::Outcome {
    WebAnswer answer;
    std::optional<Error> error;
    QString statusName;
    bool mayPassAway = false; ///< the next try may do better
    bool began = false; ///< the sink had something of it
    int pauseMs = 0; ///< that the server asks for
};

Result<WebConnection> WebConnection::open(
    const WebNode& node, const Progress& progress, Patience::Seconds whole)
{
    if (const Result<void> sound = node.check(); !sound)
        return tl::unexpected<Error>(sound.error());
    WebLogin login = node.login;
    if (!login.isGiven() && !node.loginFile.isEmpty()) {
        const Result<WebLogin> read = WebLogin::read(node.loginFile);
        if (!read)
            return tl::unexpected<Error>(read.error());
        login = *read;
    }
    const QString host = node.url.host();
    const bool stays = host == QLatin1String("localhost") || QHostAddress(host).isLoopback();
    if (login.isGiven() && node.url.scheme() == QLatin1String("http") && !stays
        && qEnvironmentVariable("BURIN_PLAIN_LOGIN") != QLatin1String("yes"))
        return failure(ErrorCode::InvalidField, QStringLiteral("login"),
            Clause::saying("it would go unencrypted to %1, where everybody on the way can read it; "
                           "take https, or say by BURIN_PLAIN_LOGIN=yes that the way is safe",
                host));
    Result<QSslConfiguration> tls = secured(node);
    if (!tls)
        return tl::unexpected<Error>(tls.error());
    auto parts = std::make_unique<Parts>(node, progress, whole);
    parts->authorization = login.header();
    parts->tls = std::move(*tls);
    parts->manager.setAutoDeleteReplies(false);
    return WebConnection(std::move(parts));
}

WebConnection::WebConnection(std::unique_ptr<Parts> parts)
    : m_parts(std::move(parts))
{
}

WebConnection::WebConnection(WebConnection&&) noexcept = default;
WebConnection::~WebConnection() = default;

const WebNode& WebConnection::node() const
{
    return m_parts->node;
}

int WebConnection::lastStatus() const
{
    return m_parts->lastStatus;
}

/// One question and its answer.
class WebConnection::Exchange {
public:
    Exchange(Parts& parts, WebSink& sink)
        : m_parts(parts)
        , m_sink(sink)
        , m_name(parts.node.name())
    {
    }

    /// @param file to be posted; null: nothing is
    [[nodiscard]] Outcome run(
        const QByteArray& path, const QByteArray& accept, const QString* file);

private:
    [[nodiscard]] QNetworkRequest request(const QByteArray& path, const QByteArray& accept) const;
    void begin();
    void take();
    void watch();
    void conclude();
    void end(Error error)
    {
        m_outcome.error = std::move(error);
        m_reply->abort();
    }
    /// For what the event loop calls. No exception may pass through the loop, and what was being
    /// taken when one was thrown is missing in the answer: the exchange ends with it.
    void calledByLoop(void (Exchange::*step)())
    {
        // Moved: copying it wants memory, which may be what is short.
        if (Result<void> done = guarded([&] { (this->*step)(); }); !done)
            end(std::move(done.error()));
    }

    Parts& m_parts;
    WebSink& m_sink;
    QString m_name;
    bool m_isPost = false;
    qint64 m_sent = 0;
    int m_wholeParts = 0;
    Outcome m_outcome;
    std::unique_ptr<QHttpMultiPart> m_body;
    std::unique_ptr<QNetworkReply> m_reply; ///< reads the body
};

QNetworkRequest WebConnection::Exchange::request(
    const QByteArray& path, const QByteArray& accept) const
{
    QNetworkRequest request(QUrl::fromEncoded(
        m_parts.node.url.toEncoded(QUrl::RemoveUserInfo) + path, QUrl::StrictMode));
    request.setRawHeader("Accept", accept);
    // Qt would unpack into memory what it cannot bound.
    request.setRawHeader("Accept-Encoding", "identity");
    if (!m_parts.authorization.isEmpty())
        request.setRawHeader("Authorization", m_parts.authorization);
    // Elsewhere nobody should learn the login. What is posted and led on would become a question:
    // its answer, a page for people to log in, would be taken for that of the storage. So nothing
    // that is posted is led on, not even where a server asks for it to be posted again (307, 308).
    request.setAttribute(QNetworkRequest::RedirectPolicyAttribute,
        m_isPost ? QNetworkRequest::ManualRedirectPolicy
                 : QNetworkRequest::SameOriginRedirectPolicy);
    request.setAttribute(QNetworkRequest::Http2AllowedAttribute, false);
    request.setAttribute(
        QNetworkRequest::CacheLoadControlAttribute, QNetworkRequest::AlwaysNetwork);
    request.setSslConfiguration(m_parts.tls);
    return request;
}

WebConnection::Outcome WebConnection::Exchange::run(
    const QByteArray& path, const QByteArray& accept, const QString* file)
{
    m_isPost = file != nullptr;
    QNetworkRequest asked = request(path, accept);
    if (file) {
        m_body = bodyOf(*file);
        if (!m_body) {
            m_outcome.error = Error{ErrorCode::FileUnreadable, {*file}};
            return m_outcome;
        }
        asked.setHeader(QNetworkRequest::ContentTypeHeader,
            QByteArray(
                "multipart/related; type=\"application/dicom\"; boundary=" + m_body->boundary()));
        m_reply.reset(m_parts.manager.post(asked, m_body.get()));
    } else {
        m_reply.reset(m_parts.manager.get(asked));
    }
    m_reply->setReadBufferSize(mostWaiting);
    m_parts.patience.whole();
    QEventLoop loop;
    QTimer clock;
    QObject::connect(
        m_reply.get(), &QNetworkReply::readyRead, &loop, [this] { calledByLoop(&Exchange::take); });
    QObject::connect(m_reply.get(), &QNetworkReply::uploadProgress, &loop, [this](qint64 sent) {
        m_parts.patience.passed(std::max<qint64>(0, sent - std::exchange(m_sent, sent)));
    });
    QObject::connect(
        m_reply.get(), &QNetworkReply::encrypted, &loop, [this] { m_parts.patience.whole(); });
    QObject::connect(m_reply.get(), &QNetworkReply::finished, &loop, &QEventLoop::quit);
    QObject::connect(&clock, &QTimer::timeout, &loop, [this] { calledByLoop(&Exchange::watch); });
    constexpr int watchMs = 50;
    clock.start(watchMs);
    if (!m_reply->isFinished())
        loop.exec();
    clock.stop();
    if (!m_outcome.error)
        conclude();
    return m_outcome;
}

void WebConnection::Exchange::begin()
{
    WebAnswer& answer = m_outcome.answer;
    if (answer.status != 0)
        return;
    answer.status = m_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    answer.contentType = m_reply->rawHeader("Content-Type");
    m_outcome.statusName = statusName(*m_reply, answer.status);
    if (!isSuccess(answer.status) && !(m_isPost && answer.status == 409))
        return;
    const QByteArray encoding = m_reply->rawHeader("Content-Encoding");
    if (!encoding.isEmpty() && encoding != "identity") {
        return end({ErrorCode::NodeNonsense,
            {m_name, Clause::saying("it packs its answer, which nobody asked for")}});
    }
    if (const Result<void> wanted = m_sink.begin(answer); !wanted)
        return end(wanted.error());
    m_outcome.began = true;
}

void WebConnection::Exchange::take()
{
    begin();
    while (!m_outcome.error && m_reply->bytesAvailable() > 0) {
        const QByteArray bytes = m_reply->read(mostWaiting);
        m_parts.patience.passed(bytes.size());
        if (!m_outcome.began)
            continue;
        if (const Result<void> taken = m_sink.take(bytes); !taken)
            end(taken.error());
    }
    const int wholeParts = m_sink.wholeParts();
    if (std::exchange(m_wholeParts, wholeParts) != wholeParts)
        m_parts.patience.whole();
}

void WebConnection::Exchange::watch()
{
    if (m_parts.progress.cancelled())
        return end({ErrorCode::Cancelled, {}});
    const Patience::Lost lost = m_parts.patience.lost();
    if (lost != Patience::Lost::No)
        end(m_parts.patience.error(m_name, lost));
}

void WebConnection::Exchange::conclude()
{
    const QNetworkReply::NetworkError trouble = m_reply->error();
    if (m_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).isValid())
        take();
    if (m_outcome.error)
        return;
    const int status = m_outcome.answer.status;
    if (isTransport(trouble)) {
        m_outcome.mayPassAway = status != 0 || trouble == QNetworkReply::RemoteHostClosedError
            || trouble == QNetworkReply::TemporaryNetworkFailureError
            || trouble == QNetworkReply::UnknownNetworkError;
        if (m_outcome.mayPassAway)
            m_outcome.error = Error{ErrorCode::NodeLost, {m_name}};
        else
            m_outcome.error = Error{ErrorCode::NodeUnreachable, {m_name, m_reply->errorString()}};
        return;
    }
    if (status == 0) {
        m_outcome.error = Error{ErrorCode::NodeNonsense,
            {m_name, Clause::saying("it does not answer as a web server")}};
        return;
    }
    m_outcome.mayPassAway = isBusy(status);
    bool isNumber = false;
    const int seconds = m_reply->rawHeader("Retry-After").toInt(&isNumber);
    if (isNumber)
        m_outcome.pauseMs = std::clamp(seconds, 0, longestPauseMs / 1000) * 1000;
}

Result<WebAnswer> WebConnection::exchange(const QByteArray& path, const QByteArray& accept,
    const QString* file, const Clause& what, WebSink& sink, bool repeatable)
{
    const WebNode& node = m_parts->node;
    int pauseMs = node.firstPauseMs;
    for (int retry = 0;; ++retry) {
        const Outcome outcome = Exchange(*m_parts, sink).run(path, accept, file);
        m_parts->lastStatus = outcome.answer.status;
        const bool again = outcome.mayPassAway && retry < node.retries
            && (repeatable || !outcome.began) && !(file && outcome.error);
        if (again) {
            if (const Result<void> waited = pause(std::max(pauseMs, outcome.pauseMs)); !waited)
                return tl::unexpected<Error>(waited.error());
            pauseMs = std::min(2 * pauseMs, longestPauseMs);
            continue;
        }
        if (outcome.error)
            return tl::unexpected<Error>(*outcome.error);
        const int status = outcome.answer.status;
        if (status == 401 || status == 403) {
            return failure(ErrorCode::NodeRejects, node.name(),
                Clause::saying("the login is missing, wrong or not allowed to do that (%1)",
                    outcome.statusName));
        }
        if (status == 404) {
            return failure(ErrorCode::NodeHasNone, node.name(),
                Clause::saying("page (%1)", outcome.statusName));
        }
        if (!outcome.began)
            return failure(ErrorCode::NodeFailed, node.name(), what, outcome.statusName);
        return outcome.answer;
    }
}

Result<WebAnswer> WebConnection::get(const QByteArray& path, const QByteArray& accept,
    const Clause& what, WebSink& sink, bool repeatable)
{
    return exchange(path, accept, nullptr, what, sink, repeatable);
}

Result<WebAnswer> WebConnection::postFile(
    const QByteArray& path, const QString& file, const Clause& what, WebSink& sink)
{
    return exchange(path, "application/dicom+json", &file, what, sink, false);
}

Result<void> WebConnection::pause(int milliseconds) const
{
    constexpr int step = 50;
    QElapsedTimer clock;
    clock.start();
    while (!clock.hasExpired(milliseconds)) {
        if (m_parts->progress.cancelled())
            return failure(ErrorCode::Cancelled);
        QEventLoop loop;
        QTimer::singleShot(step, &loop, &QEventLoop::quit);
        loop.exec();
    }
    return {};
}

} // namespace core
