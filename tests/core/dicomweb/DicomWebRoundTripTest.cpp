// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "core/dicomweb/WebSend.h"
#include "core/export/common/MaskSelection.h"
#include "core/sources/PacsSource.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/PacsObjects.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <string>

namespace dicomWebRoundTripTest {

using core::ErrorCode;

/// Against a real server of DICOMweb: what was sent is found and comes back as it was.
class DicomWebRoundTripTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void studyComesBack();
    void searchFindsWhatItIsAskedFor();
    void oneObject();
    void packedStudy();
    void maskComesBack();
    void loginIsNeeded();
    void unknownStudy();
    void tls();

private:
    std::unique_ptr<test::PacsServer> m_server;
};

#define NEED_SERVER                                                                                \
    if (!m_server->absent().isEmpty())                                                             \
        QSKIP(qPrintable(m_server->absent()));                                                     \
    const core::WebNode node = m_server->webNode();                                                \
    const QTemporaryDir folder

void DicomWebRoundTripTest::initTestCase()
{
    m_server = std::make_unique<test::PacsServer>(test::PacsServer::Program::OrthancWeb);
    QVERIFY2(m_server->problem().isEmpty(), qPrintable(m_server->problem()));
}

void DicomWebRoundTripTest::studyComesBack()
{
    NEED_SERVER;
    VERIFY_DONE(core::echoNode(node, core::Progress()));
    const QString there = folder.filePath(QStringLiteral("sent"));
    test::SyntheticSeries series;
    series.size = {64, 48, 40};
    const QStringList files = test::writeSeries(series, there);
    const auto sent = core::sendFiles(node, files, core::Progress());
    VERIFY_DONE(sent);
    QCOMPARE(sent->sent, int(files.size()));
    QCOMPARE(sent->warnings, QStringList());

    const QString target = folder.filePath(QStringLiteral("got"));
    const core::RetrieveWish wish{.studyUid = series.studyUid, .seriesUid = series.seriesUid};
    QStringList told;
    const core::Progress progress([&told](core::ProgressStep, int done, int total) {
        told.append(QStringLiteral("%1/%2").arg(done).arg(total));
    });
    const auto got = core::retrieve(node, wish, target, progress);
    VERIFY_DONE(got);
    QCOMPARE(got->received, int(files.size()));
    QCOMPARE(got->kept, 0);
    QCOMPARE(told.size(), files.size());
    QCOMPARE(told.back(), QStringLiteral("40/40"));
    QCOMPARE(test::filesBelow(target).size(), files.size());
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        (QStringList{QStringLiteral("got"), QStringLiteral("sent")}));
    const auto before = core::loadVolume(there);
    const auto after = core::loadVolume(target);
    VERIFY_DONE(before);
    VERIFY_DONE(after);
    QCOMPARE(after->volume.voxelsSha256, before->volume.voxelsSha256);

    const auto again = core::retrieve(node, wish, target, core::Progress());
    VERIFY_DONE(again);
    QCOMPARE(again->received, 0);
    QCOMPARE(again->kept, int(files.size()));
}

void DicomWebRoundTripTest::searchFindsWhatItIsAskedFor()
{
    NEED_SERVER;
    const test::TwoStudies studies(folder.path());
    VERIFY_DONE(core::sendFiles(node, studies.files, core::Progress()));
    test::compareSearch(node, studies, false);
    if (QTest::currentTestFailed())
        return;
    // What only servers of the web tell of a study.
    const auto byModality =
        core::findStudies(node, {.modality = QStringLiteral("MR")}, 100, core::Progress());
    VERIFY_DONE(byModality);
    QCOMPARE(byModality->hits.size(), std::size_t(1));
    const core::StudyHit& jane = byModality->hits.front();
    QCOMPARE(jane.modalities, QStringList{QStringLiteral("MR")});
    QCOMPARE(jane.series, 1);
    QCOMPARE(jane.instances, 3);
    const auto series = core::findSeries(node, studies.second.studyUid, core::Progress());
    VERIFY_DONE(series);
    QCOMPARE(series->front().instances, 3);
}

void DicomWebRoundTripTest::oneObject()
{
    NEED_SERVER;
    test::SyntheticSeries series;
    series.size = {8, 8, 5};
    series.studyUid = QStringLiteral("2.25.91");
    series.seriesUid = QStringLiteral("2.25.92");
    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.93" + std::to_string(k)).c_str());
        set.putAndInsertString(DCM_InstanceNumber, std::to_string(10 - k).c_str());
    };
    const QStringList files = test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
    VERIFY_DONE(core::sendFiles(node, files, core::Progress()));
    // By the one way and by the other.
    core::PacsNode dicom = m_server->node();
    for (const core::PacsSource& source :
        {core::PacsSource{.name = {}, .node = node, .movePort = {}},
            core::PacsSource{.name = {}, .node = dicom, .movePort = {}}}) {
        const QString target =
            folder.filePath(source.isWeb() ? QStringLiteral("web") : QStringLiteral("dicom"));
        const auto middle = core::retrieveMiddle(source,
            {.studyUid = series.studyUid, .seriesUid = series.seriesUid}, target, core::Progress());
        VERIFY_DONE(middle);
        QCOMPARE(*middle, target + QStringLiteral("/2.25.932.dcm"));
        QCOMPARE(test::filesBelow(target).size(), 1);
    }
}

void DicomWebRoundTripTest::packedStudy()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("mr_multifragment_jpegll"));
    if (data.source.isEmpty())
        QSKIP("no shared data");
    NEED_SERVER;
    const QStringList files = test::filesBelow(data.unpacked);
    VERIFY_DONE(core::sendFiles(node, files, core::Progress()));
    DcmFileFormat one;
    QVERIFY(one.loadFile(files.front().toUtf8().constData()).good());
    OFString study;
    QVERIFY(one.getDataset()->findAndGetOFString(DCM_StudyInstanceUID, study).good());
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got =
        core::retrieve(node, {.studyUid = QString::fromLatin1(study.c_str()), .seriesUid = {}},
            target, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, int(files.size()));
    const auto before = core::loadVolume(data.unpacked);
    const auto after = core::loadVolume(target);
    VERIFY_DONE(before);
    VERIFY_DONE(after);
    QCOMPARE(after->volume.voxelsSha256, before->volume.voxelsSha256);
    // Still packed.
    DcmFileFormat came;
    QVERIFY(came.loadFile(test::filesBelow(target).front().toUtf8().constData()).good());
    OFString syntax;
    QVERIFY(came.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax).good());
    QCOMPARE(QByteArray(syntax.c_str()), QByteArray("1.2.840.10008.1.2.4.70"));
}

void DicomWebRoundTripTest::maskComesBack()
{
    NEED_SERVER;
    const test::SmallMask mask(folder.path());
    QCOMPARE(mask.problem, QString());
    VERIFY_DONE(core::sendFiles(node, {mask.file}, core::Progress()));
    const auto found = core::findSeries(node, mask.studyUid, core::Progress());
    VERIFY_DONE(found);
    QCOMPARE(found->size(), std::size_t(1));
    QCOMPARE(found->front().modality, QStringLiteral("SEG"));
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got =
        core::retrieve(node, {.studyUid = mask.studyUid, .seriesUid = found->front().seriesUid},
            target, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 1);
    // The very file, to the last byte.
    const auto came = core::sha256OfFile(test::filesBelow(target).front());
    VERIFY_DONE(came);
    QCOMPARE(*came, mask.sha256);
}

void DicomWebRoundTripTest::loginIsNeeded()
{
    NEED_SERVER;
    core::WebNode stranger = node;
    stranger.login = {};
    VERIFY_ERROR(core::echoNode(stranger, core::Progress()), ErrorCode::NodeRejects);
    stranger.login = {
        .user = QStringLiteral("tester"), .password = QStringLiteral("guess"), .token = {}};
    const auto denied = core::findStudies(stranger, {}, 10, core::Progress());
    VERIFY_ERROR(denied, ErrorCode::NodeRejects);
    const QString sentence = ui::errorText(denied.error());
    QVERIFY2(
        sentence.contains(QLatin1String("is missing, wrong or not allowed to do that (HTTP 401")),
        qPrintable(sentence));
    QVERIFY(!sentence.contains(QLatin1String("guess")));
    // Out of a file that nobody else may read.
    stranger.login = {};
    stranger.loginFile = folder.filePath(QStringLiteral("login"));
    QFile file(stranger.loginFile);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("tester:secret\n");
    file.close();
    QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    VERIFY_ERROR(core::echoNode(stranger, core::Progress()), ErrorCode::FileUnreadable);
    QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    VERIFY_DONE(core::echoNode(stranger, core::Progress()));
}

void DicomWebRoundTripTest::unknownStudy()
{
    NEED_SERVER;
    const QString target = folder.filePath(QStringLiteral("got"));
    for (const char* uid : {"2.25.1", "../../../x", "1.2?a=b", ""}) {
        VERIFY_ERROR(core::retrieve(node, {.studyUid = QString::fromLatin1(uid), .seriesUid = {}},
                         target, core::Progress()),
            ErrorCode::NodeHasNone);
    }
    QVERIFY(QDir(folder.path()).isEmpty());
    core::WebNode wrong = node;
    wrong.url.setPath(QStringLiteral("/elsewhere"));
    VERIFY_ERROR(core::echoNode(wrong, core::Progress()), ErrorCode::NodeHasNone);
}

void DicomWebRoundTripTest::tls()
{
    const QTemporaryDir folder;
    const test::TlsFiles files = test::TlsFiles::make(folder.path());
    if (files.serverKey.isEmpty())
        QSKIP("openssl is not installed");
    // Not Orthanc: Debian's falls at the first connection by TLS.
    QProcess server;
    server.start(QStringLiteral("/usr/bin/python3"),
        {QStringLiteral(BURIN_SOURCE_DIR "/tests/support/python/https_server.py"),
            files.serverCertificate, files.serverKey, files.clientCertificate});
    QVERIFY(server.waitForStarted());
    const auto stop = qScopeGuard([&server] {
        server.kill();
        server.waitForFinished();
    });
    QVERIFY(server.waitForReadyRead());
    const int port = server.readLine().trimmed().toInt();

    core::WebNode node;
    node.url = QUrl(QStringLiteral("https://localhost:%1/dicom-web").arg(port));
    node.retries = 0;
    // Nobody whom the system trusts signed it.
    VERIFY_ERROR(core::echoNode(node, core::Progress()), ErrorCode::NodeUnreachable);
    node.authorityFile = files.clientCertificate;
    VERIFY_ERROR(core::echoNode(node, core::Progress()), ErrorCode::NodeUnreachable);
    node.authorityFile = files.serverCertificate;
    // It wants to know who we are.
    QVERIFY(!core::echoNode(node, core::Progress()).has_value());
    node.certificateFile = files.clientCertificate;
    node.keyFile = files.clientKey;
    VERIFY_DONE(core::echoNode(node, core::Progress()));
    // The right server under a name that its certificate does not have.
    node.url.setHost(QStringLiteral("127.0.0.1"));
    VERIFY_ERROR(core::echoNode(node, core::Progress()), ErrorCode::NodeUnreachable);
    node.authorityFile = files.serverKey;
    VERIFY_ERROR(core::echoNode(node, core::Progress()), ErrorCode::InvalidField);
}

BURIN_TEST(DicomWebRoundTripTest)

} // namespace dicomWebRoundTripTest

#include "DicomWebRoundTripTest.moc"
