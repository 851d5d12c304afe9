// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/MoveListener.h"

#include "core/dicom/base/DicomFile.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/StorageContexts.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace moveListenerTest {

/// What comes during a C-MOVE, sent by ourselves.
class MoveListenerTest : public QObject {
    Q_OBJECT

    /// Has a listener collect in a folder what is sent to it, all of it.
    static void receive(const QStringList& files, const QString& target)
    {
        auto gathered = core::DownloadFolder::open(target);
        VERIFY_DONE(gathered);
        const core::Progress progress;
        core::ObjectIntake intake(*gathered, {}, true, progress);
        const core::PacsNode caller{
            .aeTitle = QStringLiteral("CALLER"), .host = QStringLiteral("127.0.0.1"), .tls = {}};
        const int port = test::freePort();
        const auto listener = core::MoveListener::start(caller, port, intake);
        VERIFY_DONE(listener);
        const core::PacsNode ourselves{.aeTitle = caller.ownAeTitle,
            .host = QStringLiteral("127.0.0.1"),
            .port = port,
            .ownAeTitle = caller.aeTitle,
            .tls = {}};
        const auto sent = core::sendFiles(ourselves, files, core::Progress());
        VERIFY_DONE(sent);
        QVERIFY(!(*listener)->stop());
        QCOMPARE(intake.received(), int(files.size()));
        QVERIFY(intake.missing().isEmpty());
        const auto finished = gathered->finish();
        VERIFY_DONE(finished);
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void everyFormComes_data()
    {
        QTest::addColumn<QByteArray>("syntax");
        QTest::newRow("compressed") << QByteArray("1.2.840.10008.1.2.4.70");
        // Burin has no decoder for it: JPEG 2000 of several components.
        QTest::newRow("unreadable") << QByteArray("1.2.840.10008.1.2.4.92");
    }

    /// What belongs to a study comes, unchanged, whether it can be opened or not.
    void everyFormComes()
    {
        QFETCH(QByteArray, syntax);
        const QTemporaryDir folder;
        test::SyntheticSeries series;
        series.size = {8, 8, 2};
        series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.70");
        const QStringList files =
            test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
        for (const QString& path : files) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QByteArray bytes = file.readAll();
            bytes.replace("1.2.840.10008.1.2.4.70", syntax);
            QVERIFY(file.seek(0));
            QCOMPARE(file.write(bytes), bytes.size());
        }
        receive(files, folder.filePath(QStringLiteral("got")));
        if (QTest::currentTestFailed())
            return;
        const QDir got(folder.filePath(QStringLiteral("got")));
        const QStringList names = got.entryList({QStringLiteral("*.dcm")}, QDir::Files);
        QCOMPARE(names.size(), 2);
        for (const QString& name : names) {
            const auto file = core::DicomFile::open(got.filePath(name));
            VERIFY_DONE(file);
            QCOMPARE(file->transferSyntaxUid().toLatin1(), syntax);
        }
    }

    /// A manufacturer's kind, and one of DICOM that Burin cannot open, beside usual ones.
    void kindsThatNobodyListed()
    {
        const QTemporaryDir folder;
        test::SyntheticSeries series;
        series.size = {8, 8, 4};
        series.adjust = [](DcmDataset& set, int k) {
            const char* kinds[] = {UID_CTImageStorage, "1.2.3.4.5", UID_XRayRadiationDoseSRStorage,
                "1.2.840.10008.5.1.4.34.7"};
            set.putAndInsertString(DCM_SOPClassUID, kinds[k]);
        };
        const QStringList files =
            test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
        receive(files, folder.filePath(QStringLiteral("got")));
    }

    /// Searches and moves are nothing that a listener is asked for.
    void storageIsToldFromServices()
    {
        for (const QByteArray& known : core::storageClasses())
            QVERIFY2(core::mayBeStorage(known), known.constData());
        QVERIFY(core::mayBeStorage("1.2.840.10008.5.1.4.1.1.9999"));
        QVERIFY(core::mayBeStorage("1.2.3.4.5"));
        // Instructions for radiotherapy, and the work lists beside them.
        QVERIFY(core::mayBeStorage("1.2.840.10008.5.1.4.34.7"));
        QVERIFY(core::mayBeStorage("1.2.840.10008.5.1.4.34.10"));
        QVERIFY(!core::mayBeStorage(UID_UnifiedProcedureStepPushSOPClass));
        QVERIFY(!core::mayBeStorage(UID_FINDStudyRootQueryRetrieveInformationModel));
        QVERIFY(!core::mayBeStorage(UID_MOVEStudyRootQueryRetrieveInformationModel));
        QVERIFY(!core::mayBeStorage(UID_StorageCommitmentPushModelSOPClass));
    }

    /// As many kinds as are proposed find room, each with its compressed forms.
    void everyKindIsProposed()
    {
        const std::vector<core::ProposedContext> contexts = core::retrieveContexts({});
        QCOMPARE(contexts.size(), 2 * core::storageClasses().size());
        QVERIFY(contexts.size() < 128);
    }
};

BURIN_TEST(MoveListenerTest)

} // namespace moveListenerTest

#include "MoveListenerTest.moc"
