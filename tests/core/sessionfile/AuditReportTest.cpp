// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/AuditReport.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionFile.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QCryptographicHash>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

#include <future>

namespace auditReportTest {

using namespace core;

namespace {

using Standing = AuditStep::Standing;

Result<AuditReport> auditOf(const QString& path)
{
    const auto file = SessionFile::open(path, SessionFile::Access::SoundPart);
    if (!file)
        return tl::unexpected(file.error());
    Result<AuditReport> report;
    (*file)->audit([&report](const Result<AuditReport>& made) { report = made; });
    if (const Result<void> waited = (*file)->flush(); !waited)
        return tl::unexpected(waited.error());
    return report;
}

void runSql(const QString& path, const char* sql)
{
    {
        QSqlDatabase database =
            QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("test"));
        database.setDatabaseName(path);
        QVERIFY(database.open());
        QSqlQuery query(database);
        QVERIFY(query.exec(QLatin1String(sql)));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("test"));
}

} // namespace

class AuditReportTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_path = m_folder.filePath(QString::fromLatin1(QTest::currentTestFunction()) + ".burin");
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {.file = m_path});
        const auto apply = [&session](const Edit& edit) {
            QVERIFY(session->apply(edit));
            QVERIFY(session->settle());
        };
        apply(test::addSegment("A")); // 1
        apply(test::drillAt(-6)); // 2: taken back by 4
        apply(test::renameSegment(1, QStringLiteral("Z"))); // 3
        apply(test::revertRows({2})); // 4
        apply(test::drillAt(0)); // 5: an old future, with 6
        apply(test::addSegment("B")); // 6
        QVERIFY(session->goTo(4));
        apply(test::addSegment("C")); // 7
        apply(test::addSegment("D")); // 8: undone
        QVERIFY(session->undo());
        session->keyframes().add(7, "seven");
        QVERIFY(session->settle());
    }

    void everyStepStandsWhereItDoes()
    {
        const Result<AuditReport> report = auditOf(m_path);
        QVERIFY(report);
        std::vector<Standing> standings;
        for (const AuditStep& step : report->steps)
            standings.push_back(step.standing);
        QCOMPARE(standings,
            (std::vector<Standing>{Standing::Done, Standing::TakenBack, Standing::Done,
                Standing::Done, Standing::OtherBranch, Standing::OtherBranch, Standing::Done,
                Standing::Undone}));
        QCOMPARE(report->steps[1].takenBackBy, RowId(4));
        QCOMPARE(report->position, RowId(7));
        QCOMPARE(report->branches.size(), std::size_t(2));
        QCOMPARE(report->branches[1].rows, (std::vector<RowId>{5, 6}));
        QCOMPARE(report->file, QStringLiteral("everyStepStandsWhereItDoes.burin"));
        QCOMPARE(report->sealed, 8);
        QVERIFY(report->damage.empty());
        QCOMPARE(report->keyframes.size(), std::size_t(1));
        QCOMPARE(report->keyframes.front().png, QByteArray("seven"));
    }

    /// A report of the file alone would be whole, and lack steps.
    void stepsThatWaitForTheDisk()
    {
        const QString path = m_folder.filePath(QStringLiteral("waiting.burin"));
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {.file = path});
        session->setErrorListener([](const Error&) {});
        const auto audited = [&session] {
            std::promise<Result<AuditReport>> made;
            session->storage().audit(
                [&made](const Result<AuditReport>& report) { made.set_value(report); });
            return made.get_future().get();
        };
        QVERIFY(session->apply(test::drillAt(-6)));
        QVERIFY(session->settle());
        {
            const test::FileSizeLimit limit(1);
            QVERIFY(session->apply(test::addSegment("A")));
            QVERIFY(!session->settle());
            const Result<AuditReport> refused = audited();
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::FileUnwritable);
            QCOMPARE(refused.error().arguments.value(0), path);
        }
        const Result<AuditReport> report = audited();
        QVERIFY(report);
        QVERIFY(report->damage.empty());
        QCOMPARE(report->steps.size(), std::size_t(2));
        QCOMPARE(report->sealed, 2);
        QVERIFY(!session->storage().trouble());
    }

    void laterStepsAreNamed()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("later.burin"));
        {
            reference::ReferenceEngine engine;
            const auto session = *EditSession::create(engine, test::smallStudy(), {.file = path});
            for (const Edit& edit : std::initializer_list<Edit>{test::drillAt(-2), test::drillAt(1),
                     ReviseStroke{.row = 1, .radiusMm = 6.0},
                     ReviseStroke{.row = 1, .removed = true}, test::revertRows({4}),
                     test::revertRows({5}), test::revertRows({6})}) {
                QVERIFY(session->apply(edit));
                QVERIFY(session->settle());
            }
        }
        const Result<AuditReport> report = auditOf(path);
        QVERIFY(report);
        QCOMPARE(report->steps.size(), std::size_t(7));
        QCOMPARE(report->steps[0].revisedBy, RowId(3)); // 4 was taken back, brought back, and again
        QCOMPARE(report->steps[3].takenBackBy, RowId(5));
        QCOMPARE(report->steps[4].takenBackBy, RowId(0));
        QCOMPARE(report->steps[5].takenBackBy, RowId(7));
        QCOMPARE(report->steps[3].standing, Standing::TakenBack);
        QCOMPARE(report->steps[4].standing, Standing::Done);
    }

    void theChainEndIsTheFilesLast()
    {
        const Result<AuditReport> report = auditOf(m_path);
        QVERIFY(report);
        QCOMPARE(report->chainEnd.size(), 64);
        runSql(m_path, "UPDATE row SET name='x' WHERE id=8");
        const Result<AuditReport> damaged = auditOf(m_path);
        QVERIFY(damaged);
        QCOMPARE(damaged->steps.size(), std::size_t(7));
        QCOMPARE(damaged->sealed, 7);
        QVERIFY(damaged->chainEnd != report->chainEnd);
        QCOMPARE(damaged->damage.size(), std::size_t(1));
        const auto lost = SessionDamage::of(damaged->damage.front());
        QVERIFY(lost);
        QCOMPARE(lost->row, RowId(8));
    }

    void damagedDifferencesAreNamed()
    {
        runSql(m_path, "UPDATE delta SET bytes=zeroblob(9) WHERE row=2");
        const Result<AuditReport> report = auditOf(m_path);
        QVERIFY(report);
        QCOMPARE(report->sealed, 7);
        QCOMPARE(report->damage.size(), std::size_t(1));
        QVERIFY(report->damage.front().arguments.value(1).startsWith(QLatin1String("row 2")));
    }

    void aStepWithoutItsSecondHalfIsNoDamage()
    {
        runSql(m_path, "UPDATE row SET stateHash=NULL, deltaSha256=NULL, seal=NULL WHERE id=8");
        const Result<AuditReport> report = auditOf(m_path);
        QVERIFY(report);
        QCOMPARE(report->sealed, 7);
        QVERIFY(report->damage.empty());
    }

    /// An audit of a session that is open says what its file holds, and disturbs nothing.
    void anOpenSessionIsAudited()
    {
        reference::ReferenceEngine engine;
        const auto session = *EditSession::open(engine, test::smallStudy(), m_path);
        QVERIFY(session->apply(test::drillAt(2)));
        QVERIFY(session->settle());
        Result<AuditReport> report;
        session->storage().audit([&report](const Result<AuditReport>& made) { report = made; });
        QVERIFY(session->apply(test::drillAt(3)));
        QVERIFY(session->settle()); // waits for the writer's thread
        QVERIFY(report);
        QCOMPARE(report->steps.size(), std::size_t(9));
        QCOMPARE(report->steps[8].row.stateHash, session->history().row(9).stateHash);
        QCOMPARE(session->history().rows().size(), std::size_t(10));
    }
};

BURIN_TEST(AuditReportTest)

} // namespace auditReportTest

#include "AuditReportTest.moc"
