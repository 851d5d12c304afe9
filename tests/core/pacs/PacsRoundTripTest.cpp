// SPDX-License-Identifier: Apache-2.0
#include "core/export/ExportMask.h"
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsRetrieve.h"
#include "core/pacs/PacsSend.h"
#include "core/study/StudyLoader.h"
#include "tests/support/FailingLog.h"
#include "tests/support/PacsServers.h"
#include "tests/support/SharedData.h"
#include "tests/support/SmallSeries.h"
#include "tests/support/SyntheticSeries.h"
#include "ui/ErrorText.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <string>
#include <vector>

using Program = test::PacsServer::Program;
Q_DECLARE_METATYPE(Program)

namespace {

QStringList filesIn(const QString& folder)
{
    QStringList paths;
    QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext())
        paths.append(walk.next());
    return paths;
}

} // namespace

/// Against the servers of the field: what was sent is found and comes back as it was.
class PacsRoundTripTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void echo_data() { servers(); }
    void echo();
    void studyComesBack_data() { ways(); }
    void studyComesBack();
    void searchFindsWhatItIsAskedFor_data() { servers(); }
    void searchFindsWhatItIsAskedFor();
    void realStudy_data();
    void realStudy();
    void maskComesBack_data() { servers(); }
    void maskComesBack();

private:
    static void servers();
    static void ways();
};

void PacsRoundTripTest::servers()
{
    QTest::addColumn<Program>("program");
    QTest::newRow("dcmqrscp") << Program::Dcmqrscp;
    QTest::newRow("Orthanc") << Program::Orthanc;
}

void PacsRoundTripTest::ways()
{
    QTest::addColumn<Program>("program");
    QTest::addColumn<bool>("move");
    QTest::newRow("dcmqrscp, C-GET") << Program::Dcmqrscp << false;
    QTest::newRow("dcmqrscp, C-MOVE") << Program::Dcmqrscp << true;
    QTest::newRow("Orthanc, C-GET") << Program::Orthanc << false;
    QTest::newRow("Orthanc, C-MOVE") << Program::Orthanc << true;
}

#define START_SERVER(server)                                                                       \
    QFETCH(Program, program);                                                                      \
    test::PacsServer server(program);                                                              \
    if (!server.absent().isEmpty())                                                                \
        QSKIP(qPrintable(server.absent()));                                                        \
    QVERIFY2(server.problem().isEmpty(), qPrintable(server.problem()))

#define VERIFY_DONE(result)                                                                        \
    QVERIFY2((result).has_value(), (result) ? "" : qPrintable(ui::errorText((result).error())))

void PacsRoundTripTest::echo()
{
    START_SERVER(server);
    const core::Result<void> answered = core::echoNode(server.node(), core::Progress());
    VERIFY_DONE(answered);
}

void PacsRoundTripTest::studyComesBack()
{
    START_SERVER(server);
    QFETCH(bool, move);
    const QTemporaryDir folder;
    const QString there = folder.filePath(QStringLiteral("sent"));
    const test::SyntheticSeries series;
    const QStringList files = test::writeSeries(series, there);
    const core::Result<core::SentObjects> sent =
        core::sendFiles(server.node(), files, core::Progress());
    VERIFY_DONE(sent);
    QCOMPARE(sent->sent, int(files.size()));
    QVERIFY(sent->warnings.isEmpty());

    core::RetrieveWay way;
    if (move)
        way.movePort = server.movePort();
    const QString target = folder.filePath(QStringLiteral("got"));
    const core::RetrieveWish wish{.studyUid = series.studyUid, .seriesUid = series.seriesUid};
    const core::Result<core::Retrieved> got =
        core::retrieve(server.node(), wish, target, way, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, int(files.size()));
    QCOMPARE(got->kept, 0);
    QCOMPARE(filesIn(target).size(), files.size());
    // Beside the two folders there is nothing, hidden or not.
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        (QStringList{QStringLiteral("got"), QStringLiteral("sent")}));
    const core::Result<core::LoadedVolume> before = core::loadVolume(there);
    const core::Result<core::LoadedVolume> after = core::loadVolume(target);
    VERIFY_DONE(before);
    VERIFY_DONE(after);
    QCOMPARE(after->volume.voxelsSha256, before->volume.voxelsSha256);

    // Once more: everything is there and sound, nothing is fetched.
    const core::Result<core::Retrieved> again =
        core::retrieve(server.node(), wish, target, way, core::Progress());
    VERIFY_DONE(again);
    QCOMPARE(again->received, 0);
    QCOMPARE(again->kept, int(files.size()));
}

void PacsRoundTripTest::searchFindsWhatItIsAskedFor()
{
    START_SERVER(server);
    const QTemporaryDir folder;
    test::SyntheticSeries first;
    first.size = {8, 8, 3};
    first.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
        set.putAndInsertString(DCM_PatientName, "M\xc3\xbcller^J\xc3\xb6rg");
        set.putAndInsertString(DCM_PatientID, "A1");
        set.putAndInsertString(DCM_StudyDate, "20200304");
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
    VERIFY_DONE(core::sendFiles(server.node(), files, core::Progress()));

    const auto found = [&](const core::StudyFilter& filter, int most = 100) {
        return core::findStudies(server.node(), filter, most, core::Progress());
    };
    const auto all = found({});
    VERIFY_DONE(all);
    QCOMPARE(all->hits.size(), std::size_t(2));
    QVERIFY(!all->more);
    const auto byName = found({.patientName = QStringLiteral("Do*")});
    VERIFY_DONE(byName);
    QCOMPARE(byName->hits.size(), std::size_t(1));
    const core::StudyHit& jane = byName->hits.front();
    QCOMPARE(jane.studyUid, second.studyUid);
    QCOMPARE(jane.patientName, QStringLiteral("Doe^Jane"));
    QCOMPARE(jane.patientId, QStringLiteral("B2"));
    QCOMPARE(jane.studyDate, QStringLiteral("2021-05-06"));
    const auto byId = found({.patientId = QStringLiteral("A1")});
    VERIFY_DONE(byId);
    QCOMPARE(byId->hits.size(), std::size_t(1));
    QCOMPARE(byId->hits.front().patientName, QStringLiteral("Müller^Jörg"));
    const auto byDate = found({.studyDate = QStringLiteral("20210101-")});
    VERIFY_DONE(byDate);
    QCOMPARE(byDate->hits.size(), std::size_t(1));
    QCOMPARE(byDate->hits.front().studyUid, second.studyUid);
    const auto nobody = found({.patientId = QStringLiteral("C3")});
    VERIFY_DONE(nobody);
    QVERIFY(nobody->hits.empty());
    const auto few = found({}, 1);
    VERIFY_DONE(few);
    QCOMPARE(few->hits.size(), std::size_t(1));
    QVERIFY(few->more);

    const auto series = core::findSeries(server.node(), second.studyUid, core::Progress());
    VERIFY_DONE(series);
    QCOMPARE(series->size(), std::size_t(1));
    QCOMPARE(series->front().seriesUid, second.seriesUid);
    QCOMPARE(series->front().modality, QStringLiteral("MR"));
    const auto instances =
        core::findInstances(server.node(), second.studyUid, second.seriesUid, core::Progress());
    VERIFY_DONE(instances);
    QCOMPARE(instances->size(), std::size_t(3));
}

void PacsRoundTripTest::realStudy_data()
{
    QTest::addColumn<Program>("program");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("count");
    QTest::addColumn<QByteArray>("syntax");
    QTest::newRow("dcmqrscp, CT and RTSTRUCT")
        << Program::Dcmqrscp << QStringLiteral("ct_ibsi_lung_rtstruct") << 61
        << QByteArray("1.2.840.10008.1.2");
    // dcmqrscp 3.6.7 does not hand packed images over by C-GET.
    QTest::newRow("Orthanc, JPEG lossless in fragments")
        << Program::Orthanc << QStringLiteral("mr_multifragment_jpegll") << 96
        << QByteArray("1.2.840.10008.1.2.4.70");
}

void PacsRoundTripTest::realStudy()
{
    QFETCH(QString, name);
    QFETCH(int, count);
    QFETCH(QByteArray, syntax);
    const test::SharedCase data = test::sharedCase(name);
    if (data.source.isEmpty())
        QSKIP("no shared data");
    START_SERVER(server);
    const QString there = data.unpacked;
    const QStringList files = filesIn(there);
    QCOMPARE(files.size(), count);
    VERIFY_DONE(core::sendFiles(server.node(), files, core::Progress()));
    const auto studies = core::findStudies(server.node(), {}, 10, core::Progress());
    VERIFY_DONE(studies);
    QCOMPARE(studies->hits.size(), std::size_t(1));
    const QTemporaryDir folder;
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got =
        core::retrieve(server.node(), {.studyUid = studies->hits.front().studyUid, .seriesUid = {}},
            target, {}, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, int(files.size()));
    const auto before = core::loadVolume(there);
    const auto after = core::loadVolume(target);
    VERIFY_DONE(before);
    VERIFY_DONE(after);
    QCOMPARE(after->volume.voxelsSha256, before->volume.voxelsSha256);
    // Still packed where it was: nobody unpacked it on the way.
    DcmFileFormat one;
    QVERIFY(one.loadFile(filesIn(target).front().toUtf8().constData()).good());
    OFString found;
    QVERIFY(one.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, found).good());
    QVERIFY2(QByteArray(found.c_str()).startsWith(syntax), found.c_str());
}

void PacsRoundTripTest::maskComesBack()
{
    START_SERVER(server);
    const QTemporaryDir folder;
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
    VERIFY_DONE(core::exportMask(
        volume, {.file = mask, .segments = {segment}, .planes = planes}, core::Progress()));
    VERIFY_DONE(core::sendFiles(server.node(), {mask}, core::Progress()));
    DcmFileFormat sent;
    QVERIFY(sent.loadFile(mask.toUtf8().constData()).good());
    OFString study;
    QVERIFY(sent.getDataset()->findAndGetOFString(DCM_StudyInstanceUID, study).good());
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got = core::retrieve(server.node(),
        {.studyUid = QString::fromLatin1(study.c_str()), .seriesUid = {}}, target, {},
        core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 1);
    DcmFileFormat came;
    QVERIFY(came.loadFile(filesIn(target).front().toUtf8().constData()).good());
    // Bit for bit, whatever the form they travelled in.
    QCOMPARE(came.getDataset()->compare(*sent.getDataset()), 0);
}

QTEST_GUILESS_MAIN(PacsRoundTripTest)
#include "PacsRoundTripTest.moc"
