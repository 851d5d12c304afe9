// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsNode.h"
#include "tests/support/servers/LocalListener.h"

#include <QProcess>
#include <QString>
#include <QTemporaryDir>

#include <atomic>
#include <cstdint>
#include <thread>

class QJsonObject;

namespace test {

/// A port of this machine on which nothing listens at present.
[[nodiscard]] int freePort();

/// Certificates of a server and a client that trust each other; each is its own authority.
struct TlsFiles {
    /// Makes new ones with openssl.
    /// @return empty names if openssl is not installed
    [[nodiscard]] static TlsFiles make(const QString& folder);

    QString serverCertificate;
    QString serverKey;
    QString clientCertificate;
    QString clientKey;
};

/// A real PACS server on loopback, running while the object lives; empty when it starts.
class PacsServer {
public:
    enum class Program {
        Dcmqrscp, ///< DCMTK's server, with the title QRDB
        Orthanc, ///< with the title ORTHANC
        OrthancWeb, ///< with its DICOMweb plugin, for user tester, password secret
    };
    /// @param tls for Orthanc: it accepts only this client, and only with TLS
    explicit PacsServer(Program program, const TlsFiles& tls = {});
    PacsServer(const PacsServer&) = delete;
    PacsServer& operator=(const PacsServer&) = delete;
    ~PacsServer();

    /// The program that is not installed; empty if it is. A reason to skip.
    [[nodiscard]] const QString& absent() const { return m_absent; }
    /// Why it does not run although it is installed. A reason to fail.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// The server's node; it knows us as BURIN, listening on movePort().
    [[nodiscard]] const core::PacsNode& node() const { return m_node; }
    /// The node of OrthancWeb.
    [[nodiscard]] const core::WebNode& webNode() const { return m_webNode; }
    [[nodiscard]] int movePort() const { return m_movePort; }
    void stop();

private:
    [[nodiscard]] QStringList prepareDcmqrscp() const;
    [[nodiscard]] QStringList prepareOrthanc(const TlsFiles& tls) const;
    void addWeb(QJsonObject& configuration) const;

    QTemporaryDir m_folder;
    QProcess m_process;
    core::PacsNode m_node;
    core::WebNode m_webNode;
    int m_movePort = 0;
    QString m_absent;
    QString m_problem;
};

/// A faulty connection to a server: it forwards what client and server send until the server has
/// sent @p afterBytes, counted over all connections, and then fails. One connection at a time.
class FaultyWire {
public:
    enum class Fault {
        Cut, ///< the connection ends, and no other is accepted
        Stall, ///< the server sends nothing more
        Garbage, ///< the server sends garbage
        Drip, ///< it sends a byte every fifth of a second
        Slow, ///< it sends a kilobyte every fifth of a second
    };
    FaultyWire(int serverPort, Fault fault, std::int64_t afterBytes);
    FaultyWire(const FaultyWire&) = delete;
    FaultyWire& operator=(const FaultyWire&) = delete;
    ~FaultyWire();

    [[nodiscard]] int port() const { return m_listener.port(); }

private:
    void work();
    void handOn(int client, int server);
    [[nodiscard]] bool handOnSlowly(int client, const char* bytes, std::int64_t size) const;

    int m_serverPort;
    Fault m_fault;
    std::int64_t m_left;
    LocalListener m_listener; ///< the listening socket, which determines the port
    std::atomic<bool> m_ending = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace test
