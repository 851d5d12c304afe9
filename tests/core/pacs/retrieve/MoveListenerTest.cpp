// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/MoveListener.h"

#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/StorageContexts.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"

#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace moveListenerTest {

/// What comes during a C-MOVE, sent by ourselves.
class MoveListenerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A manufacturer's kind, and one of DICOM that Burin cannot open, beside usual ones.
    void kindsThatNobodyListed()
    {
        const QTemporaryDir folder;
        test::SyntheticSeries series;
        series.size = {8, 8, 3};
        series.adjust = [](DcmDataset& set, int k) {
            if (k > 0)
                set.putAndInsertString(
                    DCM_SOPClassUID, k == 1 ? "1.2.3.4.5" : UID_XRayRadiationDoseSRStorage);
        };
        const QStringList files =
            test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
        auto gathered = core::DownloadFolder::open(folder.filePath(QStringLiteral("got")));
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
        QCOMPARE(intake.received(), 3);
        QVERIFY(intake.missing().isEmpty());
    }

    /// Searches and moves are nothing that a listener is asked for.
    void storageIsToldFromServices()
    {
        for (const QByteArray& known : core::storageClasses())
            QVERIFY2(core::mayBeStorage(known), known.constData());
        QVERIFY(core::mayBeStorage("1.2.840.10008.5.1.4.1.1.9999"));
        QVERIFY(core::mayBeStorage("1.2.3.4.5"));
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
