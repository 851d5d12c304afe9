// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionFile.h"
#include "core/session/SessionPreview.h"
#include "core/session/SessionSalvage.h"
#include "core/session/SessionStudy.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/EngineCases.h"
#include "tests/support/FailingLog.h"
#include "tests/support/SessionFiles.h"
#include "tests/support/SmallStudy.h"
#include "tests/support/program/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

using namespace core;

namespace {

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// A session that somebody has prepared is as harmless as a picture: nothing in it runs, and its
/// rows are not written among things that are not a session's.
class ForeignSessionTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder.emplace();
        m_path = m_folder->filePath(QStringLiteral("a.burin"));
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {.file = m_path});
        for (const Edit& edit : test::manyEdits())
            QVERIFY(session->apply(edit));
        QVERIFY(session->settle());
    }

    void whatIsMoreThanASessionIsNotWrittenTo_data()
    {
        QTest::addColumn<QString>("sql");
        const auto row = [](const char* name, const char* sql) {
            QTest::newRow(name) << QString::fromLatin1(sql);
        };
        row("rows that are told and not kept",
            "CREATE TRIGGER t BEFORE INSERT ON row BEGIN SELECT RAISE(IGNORE); END;");
        row("a history that goes with the next row",
            "CREATE TRIGGER t AFTER INSERT ON row BEGIN DELETE FROM row; DELETE FROM delta; END;");
        row("a file that fills the disk",
            "CREATE TRIGGER t AFTER INSERT ON state BEGIN INSERT INTO keyframe SELECT "
            "abs(random()), '', zeroblob(100000000); END;");
        row("another table", "CREATE TABLE junk (b)");
        row("an index", "CREATE INDEX i ON row (name)");
        row("a view beside", "CREATE VIEW v AS SELECT * FROM row");
    }
    void whatIsMoreThanASessionIsNotWrittenTo()
    {
        QFETCH(QString, sql);
        test::runSql(m_path, sql);
        const QByteArray before = read(m_path);
        for (const auto access : {SessionAccess::ReadWrite, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(m_path, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::SessionDamaged);
            QVERIFY2(opened.error().arguments.value(1).contains(u"no part of a session"),
                qPrintable(opened.error().arguments.join(u' ')));
        }
        QCOMPARE(read(m_path), before);
        // What it holds of a session is offered as a new file.
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents);
        QVERIFY(!contents->isWhole() && !contents->damage);
        QCOMPARE(contents->rows.size(), test::manyEdits().size());
        const QString target = m_folder->filePath(QStringLiteral("b.burin"));
        QVERIFY(salvageSession(m_path, *contents, target));
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, test::smallStudy(), target);
        QVERIFY(session);
        QVERIFY((*session)->apply(test::drillAt(1)));
        QVERIFY((*session)->settle());
        QCOMPARE((*session)->history().rows().size(), test::manyEdits().size() + 1);
        QCOMPARE(read(m_path), before);
    }

    void whatOnlyLooksLikeASessionIsRefused_data()
    {
        QTest::addColumn<QStringList>("sql");
        QTest::newRow("a view in place of a table")
            << QStringList{QStringLiteral("ALTER TABLE row RENAME TO row0"),
                   QStringLiteral("CREATE VIEW row AS SELECT * FROM row0")};
        const QString endless = QStringLiteral(
            "CREATE VIEW visited AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x+1 FROM c) "
            "SELECT x AS parent, x AS child FROM c WHERE x<0");
        QTest::newRow("a view without end")
            << QStringList{QStringLiteral("DROP TABLE visited"), endless};
        QTest::newRow("a table of other columns") << QStringList{
            QStringLiteral("ALTER TABLE state ADD COLUMN more TEXT")};
        QTest::newRow("a generated column") << QStringList{QStringLiteral("DROP TABLE visited"),
            QStringLiteral("CREATE TABLE visited (parent INTEGER PRIMARY KEY, child INTEGER AS "
                           "(parent + 1))")};
    }
    void whatOnlyLooksLikeASessionIsRefused()
    {
        QFETCH(QStringList, sql);
        for (const QString& statement : sql)
            test::runSql(m_path, statement);
        const QByteArray before = read(m_path);
        for (const auto access :
            {SessionAccess::ReadWrite, SessionAccess::SoundPart, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(m_path, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::UnsupportedFormat);
        }
        QVERIFY(!previewSession(m_path));
        QCOMPARE(read(m_path), before);
    }

    /// Where a session says that its study is, is looked only if it can be there.
    void pathsOfStrangersAreNotFollowed()
    {
        SessionSource source;
        for (const char* path : {"/", "//", "/..", "/proc", "/proc/self", "/sys", "/dev/zero",
                 "/run", "../../../..", "usr", ".", "/usr/../usr", "/usr/", "//usr/share"}) {
            source.path = QLatin1String(path);
            QVERIFY2(studyPlaces(m_path, source).isEmpty(), path);
        }
        source.path = QStringLiteral("/tmp/a") + QChar::Null + QStringLiteral("b");
        QVERIFY(studyPlaces(m_path, source).isEmpty());
        source.path = QLatin1Char('/') + QStringLiteral("a/").repeated(20000);
        QVERIFY(studyPlaces(m_path, source).isEmpty());
        source.path = m_folder->path();
        QCOMPARE(studyPlaces(m_path, source).value(0), m_folder->path());
    }

    void whatIsTooLargeIsNotRead()
    {
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE row SET name=printf('%.*c', 50000000, 'N') WHERE id=2")));
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents && contents->damage);
        QCOMPARE(contents->damage->row, RowId(2));
        QVERIFY(contents->damage->name.size() <= 10000);
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE row SET edit=CAST(zeroblob(100000000) AS TEXT) WHERE id=1")));
        QVERIFY(!SessionFile::open(m_path, SessionAccess::ReadWrite));
    }
};

BURIN_TEST(ForeignSessionTest)
#include "ForeignSessionTest.moc"
