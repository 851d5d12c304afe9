// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "core/dicomweb/WebSend.h"
#include "core/export/ExportMask.h"
#include "core/sources/PacsSource.h"
#include "core/study/StudyLoader.h"
#include "tests/support/FailingLog.h"
#include "tests/support/PacsServers.h"
#include "tests/support/SharedData.h"
#include "tests/support/SmallSeries.h"
#include "tests/support/SyntheticSeries.h"
#include "ui/ErrorText.h"

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <string>

using core::ErrorCode;

#define VERIFY_DONE(result)                                                                        \
    QVERIFY2((result).has_value(), (result) ? "" : qPrintable(ui::errorText((result).error())))

#define VERIFY_ERROR(result, expected)                                                             \
    QVERIFY(!(result).has_value());                                                                \
    QVERIFY2((result).error().code == (expected), qPrintable(ui::errorText((result).error())))

namespace {

QStringList filesIn(const QString& folder)
{
    QStringList paths;
    QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext())
        paths.append(walk.next());
    return paths;
}

QByteArray hashOf(const QString& path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result().toHex()
                                                                 : QByteArray();
}

} // namespace

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
    const core::Progress progress([&told](const QString&, int done, int total) {
        told.append(QStringLiteral("%1/%2").arg(done).arg(total));
    });
    const auto got = core::retrieve(node, wish, target, progress);
    VERIFY_DONE(got);
    QCOMPARE(got->received, int(files.size()));
    QCOMPARE(got->kept, 0);
    QCOMPARE(told.size(), files.size());
    QCOMPARE(told.back(), QStringLiteral("40/40"));
    QCOMPARE(filesIn(target).size(), files.size());
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
    test::SyntheticSeries first;
    first.size = {8, 8, 3};
    first.studyUid = QStringLiteral("2.25.71");
    first.seriesUid = QStringLiteral("2.25.72");
    first.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
        set.putAndInsertString(DCM_PatientName, "M\xc3\xbcller^J\xc3\xb6rg");
        set.putAndInsertString(DCM_PatientID, "A1");
        set.putAndInsertString(DCM_StudyDate, "20200304");
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.73" + std::to_string(k)).c_str());
    };
    test::SyntheticSeries second = first;
    second.studyUid = QStringLiteral("2.25.81");
    second.seriesUid = QStringLiteral("2.25.82");
    second.modality = QStringLiteral("MR");
    second.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_PatientName, "Doe^Jane");
        set.putAndInsertString(DCM_PatientID, "B2");
        set.putAndInsertString(DCM_StudyDate, "20210506");
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.83" + std::to_string(k)).c_str());
    };
    QStringList files = test::writeSeries(first, folder.filePath(QStringLiteral("1")));
    files += test::writeSeries(second, folder.filePath(QStringLiteral("2")));
    VERIFY_DONE(core::sendFiles(node, files, core::Progress()));

    const auto found = [&](const core::StudyFilter& filter, int most = 100) {
        return core::findStudies(node, filter, most, core::Progress());
    };
    const auto all = found({});
    VERIFY_DONE(all);
    QVERIFY(all->hits.size() >= 2);
    QVERIFY(!all->more);
    const auto byName = found({.patientName = QStringLiteral("Do*")});
    VERIFY_DONE(byName);
    QCOMPARE(byName->hits.size(), std::size_t(1));
    const core::StudyHit& jane = byName->hits.front();
    QCOMPARE(jane.studyUid, second.studyUid);
    QCOMPARE(jane.patientName, QStringLiteral("Doe^Jane"));
    QCOMPARE(jane.studyDate, QStringLiteral("2021-05-06"));
    QCOMPARE(jane.modalities, QStringList{QStringLiteral("MR")});
    QCOMPARE(jane.series, 1);
    QCOMPARE(jane.instances, 3);
    const auto byId = found({.patientId = QStringLiteral("A1")});
    VERIFY_DONE(byId);
    QCOMPARE(byId->hits.size(), std::size_t(1));
    QCOMPARE(byId->hits.front().patientName, QStringLiteral("Müller^Jörg"));
    // Debian's Orthanc decodes no %C3%BC in an address: names are asked for in plain letters here.
    const auto byDate = found({.studyDate = QStringLiteral("20210101-20211231")});
    VERIFY_DONE(byDate);
    QCOMPARE(byDate->hits.size(), std::size_t(1));
    const auto byModality = found({.modality = QStringLiteral("MR")});
    VERIFY_DONE(byModality);
    QCOMPARE(byModality->hits.size(), std::size_t(1));
    const auto nobody = found({.patientId = QStringLiteral("C3")});
    VERIFY_DONE(nobody);
    QVERIFY(nobody->hits.empty());
    const auto few = found({}, 1);
    VERIFY_DONE(few);
    QCOMPARE(few->hits.size(), std::size_t(1));
    QVERIFY(few->more);

    const auto series = core::findSeries(node, second.studyUid, core::Progress());
    VERIFY_DONE(series);
    QCOMPARE(series->size(), std::size_t(1));
    QCOMPARE(series->front().seriesUid, second.seriesUid);
    QCOMPARE(series->front().modality, QStringLiteral("MR"));
    QCOMPARE(series->front().instances, 3);
    const auto instances =
        core::findInstances(node, second.studyUid, second.seriesUid, core::Progress());
    VERIFY_DONE(instances);
    QCOMPARE(instances->size(), std::size_t(3));
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
        QCOMPARE(filesIn(target).size(), 1);
    }
}

void DicomWebRoundTripTest::packedStudy()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("mr_multifragment_jpegll"));
    if (data.source.isEmpty())
        QSKIP("no shared data");
    NEED_SERVER;
    const QStringList files = filesIn(data.unpacked);
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
    QVERIFY(came.loadFile(filesIn(target).front().toUtf8().constData()).good());
    OFString syntax;
    QVERIFY(came.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax).good());
    QCOMPARE(QByteArray(syntax.c_str()), QByteArray("1.2.840.10008.1.2.4.70"));
}

void DicomWebRoundTripTest::maskComesBack()
{
    NEED_SERVER;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const std::size_t count =
        std::size_t(series.size.x) * std::size_t(series.size.y) * std::size_t(series.size.z);
    std::vector<std::uint8_t> labels(count);
    for (std::size_t i = 0; i < count; ++i)
        labels[i] = std::uint8_t(i % 7 < 3);
    const std::vector<core::LabelPlaneView> planes{{0, labels}};
    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("Schädel");
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    const QString mask = folder.filePath(QStringLiteral("mask.dcm"));
    const auto written = core::exportMask(
        volume, {.file = mask, .segments = {segment}, .planes = planes}, core::Progress());
    VERIFY_DONE(written);
    VERIFY_DONE(core::sendFiles(node, {mask}, core::Progress()));
    DcmFileFormat sent;
    QVERIFY(sent.loadFile(mask.toUtf8().constData()).good());
    OFString study;
    QVERIFY(sent.getDataset()->findAndGetOFString(DCM_StudyInstanceUID, study).good());
    const QString studyUid = QString::fromLatin1(study.c_str());
    const auto found = core::findSeries(node, studyUid, core::Progress());
    VERIFY_DONE(found);
    QCOMPARE(found->size(), std::size_t(1));
    QCOMPARE(found->front().modality, QStringLiteral("SEG"));
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got = core::retrieve(node,
        {.studyUid = studyUid, .seriesUid = found->front().seriesUid}, target, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 1);
    // The very file, to the last byte.
    QCOMPARE(hashOf(filesIn(target).front()), hashOf(mask));
    QCOMPARE(hashOf(mask), written->sha256.toLatin1());
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

QTEST_GUILESS_MAIN(DicomWebRoundTripTest)
#include "DicomWebRoundTripTest.moc"
