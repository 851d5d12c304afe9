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

/// A port of this machine on which nobody listens at the moment.
[[nodiscard]] int freePort();

/// Certificates of a server and of a client that know each other: each is its own authority.
struct TlsFiles {
    /// Makes them with openssl, new ones each time. @return empty names: openssl is not installed
    [[nodiscard]] static TlsFiles make(const QString& folder);

    QString serverCertificate;
    QString serverKey;
    QString clientCertificate;
    QString clientKey;
};

/// A real server of the field, on loopback, for as long as this lives. Empty when it starts.
class PacsServer {
public:
    enum class Program {
        Dcmqrscp, ///< DCMTK's; called QRDB
        Orthanc, ///< called ORTHANC
        OrthancWeb, ///< the same with its DICOMweb plugin, to tester:secret
    };
    /// @param tls of Orthanc: it answers only to that client, and only so
    explicit PacsServer(Program program, const TlsFiles& tls = {});
    PacsServer(const PacsServer&) = delete;
    PacsServer& operator=(const PacsServer&) = delete;
    ~PacsServer();

    /// The program that is not installed; empty: it is. A reason to skip.
    [[nodiscard]] const QString& absent() const { return m_absent; }
    /// Why it does not run although it is installed. A reason to fail.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// It knows us as BURIN, listening on movePort().
    [[nodiscard]] const core::PacsNode& node() const { return m_node; }
    /// Of OrthancWeb.
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

/// A connection to a server that fails: hands on what client and server say until the server has
/// said so many bytes, over all connections together. One connection after the other.
class FaultyWire {
public:
    enum class Fault {
        Cut, ///< then the connection ends, and no other comes about
        Stall, ///< then the server says nothing more
        Garbage, ///< then the server talks nonsense
        Drip, ///< then it says a byte every fifth of a second
        Slow, ///< then it says a kilobyte every fifth of a second
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
    LocalListener m_listener;
    std::atomic<bool> m_ending = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace test
