// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/PacsRetrieve.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/PacsObjects.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace pacsRoundTripTest {

using Program = test::PacsServer::Program;
} // namespace pacsRoundTripTest

Q_DECLARE_METATYPE(pacsRoundTripTest::Program)

namespace pacsRoundTripTest {

/// Against the servers of the field: what was sent is found and comes back as it was.
class PacsRoundTripTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void echo_data() { servers(); }
    void echo();
    void studyComesBack_data() { ways(); }
    void studyComesBack();
    void unusualKindComesByMove();
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
    QCOMPARE(test::filesBelow(target).size(), files.size());
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

/// Orthanc gives the whole move up if one kind of object is refused.
void PacsRoundTripTest::unusualKindComesByMove()
{
    test::PacsServer server(Program::Orthanc);
    if (!server.absent().isEmpty())
        QSKIP(qPrintable(server.absent()));
    QVERIFY2(server.problem().isEmpty(), qPrintable(server.problem()));
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {8, 8, 3};
    series.adjust = [](DcmDataset& set, int k) {
        if (k == 1)
            set.putAndInsertString(DCM_SOPClassUID, UID_XRayRadiationDoseSRStorage);
    };
    const QStringList files = test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
    VERIFY_DONE(core::sendFiles(server.node(), files, core::Progress()));
    const auto got = core::retrieve(server.node(), {.studyUid = series.studyUid, .seriesUid = {}},
        folder.filePath(QStringLiteral("got")), {.movePort = server.movePort()}, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 3);
}

void PacsRoundTripTest::searchFindsWhatItIsAskedFor()
{
    START_SERVER(server);
    const QTemporaryDir folder;
    const test::TwoStudies studies(folder.path());
    VERIFY_DONE(core::sendFiles(server.node(), studies.files, core::Progress()));
    test::compareSearch(server.node(), studies, true);
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
    const QStringList files = test::filesBelow(there);
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
    QVERIFY(one.loadFile(test::filesBelow(target).front().toUtf8().constData()).good());
    OFString found;
    QVERIFY(one.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, found).good());
    QVERIFY2(QByteArray(found.c_str()).startsWith(syntax), found.c_str());
}

void PacsRoundTripTest::maskComesBack()
{
    START_SERVER(server);
    const QTemporaryDir folder;
    const test::SmallMask mask(folder.path());
    QCOMPARE(mask.problem, QString());
    VERIFY_DONE(core::sendFiles(server.node(), {mask.file}, core::Progress()));
    DcmFileFormat sent;
    QVERIFY(sent.loadFile(mask.file.toUtf8().constData()).good());
    const QString target = folder.filePath(QStringLiteral("got"));
    const auto got = core::retrieve(
        server.node(), {.studyUid = mask.studyUid, .seriesUid = {}}, target, {}, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 1);
    DcmFileFormat came;
    QVERIFY(came.loadFile(test::filesBelow(target).front().toUtf8().constData()).good());
    // Bit for bit, whatever the form they travelled in.
    QCOMPARE(came.getDataset()->compare(*sent.getDataset()), 0);
}

BURIN_TEST(PacsRoundTripTest)

} // namespace pacsRoundTripTest

#include "PacsRoundTripTest.moc"
