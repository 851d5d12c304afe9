// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/PacsRetrieve.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace pacsTlsTest {

using core::ErrorCode;

/// A node that takes only secured connections, of those it knows.
class PacsTlsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void studyComesBack();
    void withoutTls();
    void strangersAreRefused();
    void otherServerIsNotTrusted();
    void filesThatAreNone();

private:
    /// The node as one that knows its certificate and shows ours sees it.
    [[nodiscard]] core::PacsNode node() const
    {
        core::PacsNode node = m_server->node();
        node.timeoutSeconds = 10;
        node.tls = {.authorityFile = m_files.serverCertificate,
            .certificateFile = m_files.clientCertificate,
            .keyFile = m_files.clientKey};
        return node;
    }

    QTemporaryDir m_folder;
    test::TlsFiles m_files;
    std::unique_ptr<test::PacsServer> m_server;
};

void PacsTlsTest::initTestCase()
{
    m_files = test::TlsFiles::make(m_folder.path());
    if (m_files.serverKey.isEmpty())
        QSKIP("openssl is not installed");
    m_server = std::make_unique<test::PacsServer>(test::PacsServer::Program::Orthanc, m_files);
    if (!m_server->absent().isEmpty())
        QSKIP(qPrintable(m_server->absent()));
    QVERIFY2(m_server->problem().isEmpty(), qPrintable(m_server->problem()));
}

void PacsTlsTest::studyComesBack()
{
    const auto answered = core::echoNode(node(), core::Progress());
    VERIFY_DONE(answered);
    test::SyntheticSeries series;
    series.size = {64, 64, 5};
    const QStringList files = test::writeSeries(series, m_folder.filePath(QStringLiteral("sent")));
    VERIFY_DONE(core::sendFiles(node(), files, core::Progress()));
    const QString target = m_folder.filePath(QStringLiteral("got"));
    const auto got = core::retrieve(
        node(), {.studyUid = series.studyUid, .seriesUid = {}}, target, {}, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 5);
    // Objects of a C-MOVE would come unsecured.
    const auto moved = core::retrieve(node(), {.studyUid = series.studyUid, .seriesUid = {}},
        target + u'2', {.movePort = m_server->movePort()}, core::Progress());
    QVERIFY(!moved.has_value());
    QCOMPARE(moved.error().code, ErrorCode::InvalidField);
    QVERIFY(!QFileInfo::exists(target + u'2'));
}

void PacsTlsTest::withoutTls()
{
    core::PacsNode plain = node();
    plain.tls = {};
    const auto answered = core::echoNode(plain, core::Progress());
    QVERIFY(!answered.has_value());
    QVERIFY2(answered.error().code == ErrorCode::NodeLost
            || answered.error().code == ErrorCode::NodeNonsense,
        qPrintable(ui::errorText(answered.error())));
}

void PacsTlsTest::strangersAreRefused()
{
    core::PacsNode anonymous = node();
    anonymous.tls.certificateFile.clear();
    anonymous.tls.keyFile.clear();
    const auto answered = core::echoNode(anonymous, core::Progress());
    QVERIFY(!answered.has_value());
    QVERIFY2(answered.error().code == ErrorCode::NodeLost
            || answered.error().code == ErrorCode::NodeUnreachable,
        qPrintable(ui::errorText(answered.error())));
}

void PacsTlsTest::otherServerIsNotTrusted()
{
    core::PacsNode other = node();
    other.tls.authorityFile = m_files.clientCertificate;
    const auto answered = core::echoNode(other, core::Progress());
    QVERIFY(!answered.has_value());
    QCOMPARE(answered.error().code, ErrorCode::NodeUnreachable);
    QVERIFY2(answered.error().arguments.value(1).startsWith(QLatin1String("no secure connection")),
        qPrintable(ui::errorText(answered.error())));
}

void PacsTlsTest::filesThatAreNone()
{
    for (QString core::PacsTls::*file :
        {&core::PacsTls::authorityFile, &core::PacsTls::certificateFile, &core::PacsTls::keyFile}) {
        core::PacsNode wrong = node();
        wrong.tls.*file = m_folder.filePath(QStringLiteral("no.such.file"));
        const auto answered = core::echoNode(wrong, core::Progress());
        QVERIFY(!answered.has_value());
        QCOMPARE(answered.error().code, ErrorCode::FileUnreadable);
    }
}

BURIN_TEST(PacsTlsTest)

} // namespace pacsTlsTest

#include "PacsTlsTest.moc"
