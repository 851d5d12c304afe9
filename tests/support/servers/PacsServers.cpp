// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/PacsServers.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

namespace {

const QString webPlugin = QStringLiteral("/usr/share/orthanc/plugins/libOrthancDicomWeb.so");

sockaddr_in loopback(int port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(std::uint16_t(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

int connected(int port)
{
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(port);
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return socket;
    ::close(socket);
    return -1;
}

bool write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

bool writeAll(int socket, const char* bytes, ssize_t size)
{
    while (size > 0) {
        const ssize_t sent = ::send(socket, bytes, std::size_t(size), MSG_NOSIGNAL);
        if (sent <= 0)
            return false;
        bytes += sent;
        size -= sent;
    }
    return true;
}

} // namespace

int freePort()
{
    return LocalListener().port();
}

TlsFiles TlsFiles::make(const QString& folder)
{
    const QString openssl = QStandardPaths::findExecutable(QStringLiteral("openssl"));
    if (openssl.isEmpty())
        return {};
    const auto pair = [&](const char* name) {
        const QString stem = folder + u'/' + QLatin1String(name);
        QProcess process;
        process.start(openssl,
            {QStringLiteral("req"), QStringLiteral("-x509"), QStringLiteral("-newkey"),
                QStringLiteral("rsa:2048"), QStringLiteral("-nodes"), QStringLiteral("-days"),
                QStringLiteral("2"), QStringLiteral("-subj"), QStringLiteral("/CN=localhost"),
                QStringLiteral("-keyout"), stem + QStringLiteral(".key"), QStringLiteral("-out"),
                stem + QStringLiteral(".crt")});
        process.waitForFinished(60000);
        return stem;
    };
    const QString server = pair("server");
    const QString client = pair("client");
    return {.serverCertificate = server + QStringLiteral(".crt"),
        .serverKey = server + QStringLiteral(".key"),
        .clientCertificate = client + QStringLiteral(".crt"),
        .clientKey = client + QStringLiteral(".key")};
}

PacsServer::PacsServer(Program program, const TlsFiles& tls)
    : m_movePort(freePort())
{
    const bool isOrthanc = program != Program::Dcmqrscp;
    const bool isWeb = program == Program::OrthancWeb;
    const QString name = isOrthanc ? QStringLiteral("Orthanc") : QStringLiteral("dcmqrscp");
    QString path = QStandardPaths::findExecutable(name);
    if (path.isEmpty())
        path = QStandardPaths::findExecutable(name, {QStringLiteral("/usr/sbin")});
    if (path.isEmpty()) {
        m_absent = name + QStringLiteral(" is not installed");
        return;
    }
    if (isWeb && !QFile::exists(webPlugin)) {
        m_absent = QStringLiteral("orthanc-dicomweb is not installed");
        return;
    }
    if (isWeb) {
        m_webNode.url = QUrl(QStringLiteral("http://localhost:%1/dicom-web").arg(freePort()));
        m_webNode.login = {
            .user = QStringLiteral("tester"), .password = QStringLiteral("secret"), .token = {}};
        m_webNode.firstPauseMs = 50;
    }
    m_node = {.aeTitle = isOrthanc ? QStringLiteral("ORTHANC") : QStringLiteral("QRDB"),
        .host = QStringLiteral("127.0.0.1"),
        .port = freePort(),
        .tls = {}};
    QDir(m_folder.path()).mkdir(QStringLiteral("store"));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TCP_NODELAY"), QStringLiteral("1"));
    m_process.setProcessEnvironment(environment);
    m_process.setStandardOutputFile(m_folder.filePath(QStringLiteral("log")));
    m_process.setStandardErrorFile(m_folder.filePath(QStringLiteral("errors")));
    m_process.setChildProcessModifier([] { ::setpgid(0, 0); });
    m_process.start(path, isOrthanc ? prepareOrthanc(tls) : prepareDcmqrscp());
    const QDeadlineTimer patience(30000);
    int socket = -1;
    while (socket < 0 && !patience.hasExpired() && m_process.state() != QProcess::NotRunning) {
        m_process.waitForFinished(50);
        socket = connected(isWeb ? m_webNode.url.port() : m_node.port);
    }
    if (socket >= 0) {
        ::close(socket);
        return;
    }
    QFile errors(m_folder.filePath(QStringLiteral("errors")));
    m_problem = name + QStringLiteral(" does not start");
    if (errors.open(QIODevice::ReadOnly))
        m_problem += QStringLiteral(": ") + QString::fromUtf8(errors.readAll()).trimmed();
}

PacsServer::~PacsServer()
{
    stop();
}

void PacsServer::stop()
{
    if (m_process.state() == QProcess::NotRunning)
        return;
    // With those it made for its connections.
    const auto group = pid_t(m_process.processId());
    ::kill(-group, SIGTERM);
    const bool ended = m_process.waitForFinished(5000);
    ::kill(-group, SIGKILL);
    if (!ended)
        m_process.waitForFinished(5000);
}

QStringList PacsServer::prepareDcmqrscp() const
{
    // Its host names are looked up; a number would be one it does not know.
    const QString text = QStringLiteral("NetworkTCPPort = %1\nMaxPDUSize = 131072\n"
                                        "MaxAssociations = 16\n"
                                        "HostTable BEGIN\nburin = (BURIN, localhost, %2)\n"
                                        "HostTable END\nVendorTable BEGIN\nVendorTable END\n"
                                        "AETable BEGIN\nQRDB %3 RW (500, 1024mb) ANY\n"
                                        "AETable END\n")
                             .arg(m_node.port)
                             .arg(m_movePort)
                             .arg(m_folder.filePath(QStringLiteral("store")));
    const QString file = m_folder.filePath(QStringLiteral("dcmqrscp.cfg"));
    if (!write(file, text.toUtf8()))
        return {};
    return {QStringLiteral("--config"), file, QStringLiteral("--prefer-lossless"),
        QStringLiteral("--propose-lossless"), QStringLiteral("--log-level"),
        QStringLiteral("warn")};
}

QStringList PacsServer::prepareOrthanc(const TlsFiles& tls) const
{
    const auto key = [](const char* name) { return QLatin1String(name); };
    const QString store = m_folder.filePath(QStringLiteral("store"));
    const QJsonObject burin{{key("AET"), QStringLiteral("BURIN")},
        {key("Host"), QStringLiteral("127.0.0.1")}, {key("Port"), m_movePort},
        {key("AllowEcho"), true}, {key("AllowStore"), true}, {key("AllowFind"), true},
        {key("AllowGet"), true}, {key("AllowMove"), true}};
    QJsonObject configuration{{key("Name"), QStringLiteral("TEST")},
        {key("StorageDirectory"), store}, {key("IndexDirectory"), store},
        {key("ConcurrentJobs"), 2}, {key("HttpServerEnabled"), false},
        {key("DicomAet"), m_node.aeTitle}, {key("DicomPort"), m_node.port},
        {key("DicomCheckCalledAet"), true}, {key("DicomAlwaysAllowEcho"), false},
        {key("DicomAlwaysAllowStore"), false}, {key("DicomCheckModalityHost"), true},
        {key("DicomModalities"), QJsonObject{{key("burin"), burin}}},
        {key("DefaultEncoding"), QStringLiteral("Utf8")}};
    if (!m_webNode.url.isEmpty()) {
        addWeb(configuration);
    } else if (!tls.serverKey.isEmpty()) {
        configuration.insert(key("DicomTlsEnabled"), true);
        configuration.insert(key("DicomTlsCertificate"), tls.serverCertificate);
        configuration.insert(key("DicomTlsPrivateKey"), tls.serverKey);
        configuration.insert(key("DicomTlsTrustedCertificates"), tls.clientCertificate);
        configuration.insert(key("DicomTlsRemoteCertificateRequired"), true);
    }
    const QString file = m_folder.filePath(QStringLiteral("orthanc.json"));
    if (!write(file, QJsonDocument(configuration).toJson()))
        return {};
    return {file};
}

void PacsServer::addWeb(QJsonObject& configuration) const
{
    const auto key = [](const char* name) { return QLatin1String(name); };
    configuration.insert(key("HttpServerEnabled"), true);
    configuration.insert(key("HttpPort"), m_webNode.url.port());
    configuration.insert(key("RemoteAccessAllowed"), false);
    configuration.insert(key("AuthenticationEnabled"), true);
    configuration.insert(
        key("RegisteredUsers"), QJsonObject{{m_webNode.login.user, m_webNode.login.password}});
    configuration.insert(key("Plugins"), QJsonArray{webPlugin});
    configuration.insert(key("DicomWeb"),
        QJsonObject{{key("Enable"), true}, {key("Root"), QStringLiteral("/dicom-web/")},
            {key("EnableWado"), false}, {key("Ssl"), false},
            {key("StudiesMetadata"), QStringLiteral("Full")},
            {key("SeriesMetadata"), QStringLiteral("Full")}});
}

FaultyWire::FaultyWire(int serverPort, Fault fault, std::int64_t afterBytes)
    : m_serverPort(serverPort)
    , m_fault(fault)
    , m_left(afterBytes)
    , m_thread([this] { work(); })
{
}

FaultyWire::~FaultyWire()
{
    m_ending = true;
    m_thread.join();
}

void FaultyWire::work()
{
    while (!m_ending) {
        const int client = m_listener.accepted();
        if (client < 0)
            continue;
        const bool isDead = m_left <= 0 && m_fault == Fault::Cut;
        const int server = isDead ? -1 : connected(m_serverPort);
        if (server >= 0)
            handOn(client, server);
        ::close(server);
        ::close(client);
    }
}

bool FaultyWire::handOnSlowly(int client, const char* bytes, std::int64_t size) const
{
    const std::int64_t step = m_fault == Fault::Drip ? 1 : 1000;
    for (std::int64_t at = 0; at < size && !m_ending; at += step) {
        if (!writeAll(client, bytes + at, ssize_t(std::min(step, size - at))))
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    return !m_ending;
}

void FaultyWire::handOn(int client, int server)
{
    std::array<char, 4096> bytes{};
    while (!m_ending) {
        std::array<pollfd, 2> sides{{{client, POLLIN, 0}, {server, POLLIN, 0}}};
        if (::poll(sides.data(), sides.size(), 20) < 1)
            continue;
        if (sides[0].revents != 0) {
            const ssize_t count = ::read(client, bytes.data(), bytes.size());
            if (count <= 0 || !writeAll(server, bytes.data(), count))
                return;
        }
        if (sides[1].revents != 0) {
            const ssize_t count = ::read(server, bytes.data(), bytes.size());
            if (count <= 0)
                return;
            const auto sound = ssize_t(std::clamp<std::int64_t>(m_left, 0, count));
            m_left -= count;
            if (m_fault == Fault::Garbage) {
                for (ssize_t i = sound; i < count; ++i)
                    bytes[std::size_t(i)] = char(0x5a);
            }
            const ssize_t said = m_fault == Fault::Garbage ? count : sound;
            if (!writeAll(client, bytes.data(), said))
                return;
            const bool isSlow = m_fault == Fault::Drip || m_fault == Fault::Slow;
            if (isSlow && !handOnSlowly(client, bytes.data() + said, count - said))
                return;
            if (m_left <= 0 && m_fault == Fault::Cut)
                return;
        }
    }
}

} // namespace test
