// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/RevertRows.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/records/SessionTables.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <optional>

namespace rowTitlesTest {

using namespace core;

namespace {

/// As Burin wrote sessions before there were titles.
void makeOld(const QString& path)
{
    test::runSql(path, QStringLiteral("DROP TABLE title"));
    test::runSql(path, QStringLiteral("PRAGMA user_version=5"));
}

QString format(const QString& path)
{
    return test::text(path, QStringLiteral("PRAGMA user_version"));
}

bool areTitled(const std::vector<HistoryRow>& rows)
{
    return !rows.empty() && std::all_of(rows.begin(), rows.end(), [](const HistoryRow& row) {
        return row.title && canonicalName(*row.title) == row.name;
    });
}

bool areUntitled(const std::vector<HistoryRow>& rows)
{
    return !rows.empty() && std::none_of(rows.begin(), rows.end(), [](const HistoryRow& row) {
        return row.title.has_value() || row.name.isEmpty();
    });
}

} // namespace

/// What rows say is kept beside their names, in no hash; files of before have none, and nobody can
/// put another one there.
class RowTitlesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_pattern; ///< holds the session that tests copy
    std::optional<QTemporaryDir> m_folder;
    QString m_path;

    QString beside(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    static std::vector<HistoryRow> rowsOf(const QString& path)
    {
        const Result<SessionContents> contents = checkSession(path);
        return contents && contents->isWhole() ? contents->rows : std::vector<HistoryRow>();
    }

private Q_SLOTS:
    void initTestCase() { test::makeSession(m_pattern.filePath(QStringLiteral("a.burin"))); }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder.emplace();
        m_path = beside("a.burin");
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_path));
    }

    void comeBackWithTheSession()
    {
        QCOMPARE(format(m_path), QStringLiteral("6"));
        QVERIFY(areTitled(rowsOf(m_path)));
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, test::smallStudy(), m_path);
        QVERIFY(session);
        QVERIFY(areTitled((*session)->history().rows()));
    }

    void aSessionOfBeforeStaysAsItIsUntilARowIsAdded()
    {
        makeOld(m_path);
        const std::vector<HistoryRow> before = rowsOf(m_path);
        QVERIFY(areUntitled(before));
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY(session);
            for (RowId row = RowId(before.size()); row > 0; --row) {
                QVERIFY((*session)->goTo(row) && (*session)->settle());
                QCOMPARE((*session)->stateHash(), before[std::size_t(row - 1)].stateHash);
            }
        }
        QCOMPARE(format(m_path), QStringLiteral("5"));
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY((*session)->goTo(4) && (*session)->settle());
            QVERIFY((*session)->apply(test::drillAt(2.5)) && (*session)->settle());
            QVERIFY((*session)->apply(test::drillAt(3.5)) && (*session)->settle());
        }
        QCOMPARE(format(m_path), QStringLiteral("6"));
        const std::vector<HistoryRow> after = rowsOf(m_path);
        QCOMPARE(after.size(), before.size() + 2);
        QVERIFY(areUntitled({after.begin(), after.end() - 2}));
        QVERIFY(areTitled({after.end() - 2, after.end()}));
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(after[i].name, before[i].name);
    }

    /// A row that quotes one without a title has its name; else the title itself.
    /// It is none of ours, whatever makes up its columns, and SQLite asks for no capitals.
    void aTableOfTitlesInAFileOfBeforeIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("title") << QStringLiteral("title");
        QTest::newRow("Title") << QStringLiteral("Title");
    }
    void aTableOfTitlesInAFileOfBeforeIsRefused()
    {
        QFETCH(const QString, name);
        makeOld(m_path);
        test::runSql(m_path,
            QStringLiteral("CREATE TABLE %1 (row INTEGER PRIMARY KEY, "
                           "json TEXT AS (hex(zeroblob(100))))")
                .arg(name));
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(!contents);
        QCOMPARE(contents.error().code, ErrorCode::UnsupportedFormat);
    }

    void quotedRowsKeepWhatTheySay_data()
    {
        QTest::addColumn<bool>("old");
        QTest::newRow("of before") << true;
        QTest::newRow("of now") << false;
    }
    void quotedRowsKeepWhatTheySay()
    {
        QFETCH(const bool, old);
        constexpr RowId drilled = 8;
        if (old)
            makeOld(m_path);
        {
            reference::ReferenceEngine engine;
            const auto session = *EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY(session->goTo(10) && session->settle());
            QVERIFY(session->apply(RevertRows{{drilled}}) && session->settle());
        }
        const std::vector<HistoryRow> rows = rowsOf(m_path);
        QVERIFY(rows.size() > std::size_t(drilled));
        const QString quoted =
            rows[std::size_t(drilled - 1)].name.section(QStringLiteral(", "), 0, 0);
        QVERIFY(rows.back().name.startsWith(QStringLiteral("Undo only '%1', ").arg(quoted)));
        QVERIFY(areTitled({rows.back()}));
        const auto titles = std::get<std::vector<RowTitle>>(rows.back().title->arguments.front());
        QCOMPARE(titles.front().code == RowTitleCode::StoredName, old);
        QCOMPARE(canonicalName(titles.front()), quoted);
    }

    void whatSaysSomethingElseIsNotTaken_data()
    {
        QTest::addColumn<QString>("sql");
        const auto row = [](const char* name, const char* sql) {
            QTest::newRow(name) << QString::fromUtf8(sql);
        };
        row("another title", R"(UPDATE title SET json='{"code":"plugLeak"}')");
        row("a sentence",
            R"(UPDATE title SET json='{"code":"storedName","arguments":["All is well"]}')");
        row("no JSON", "UPDATE title SET json='drill'");
        row("a newer code", R"(UPDATE title SET json='{"code":"somethingNewer"}')");
        row("bytes", "UPDATE title SET json=randomblob(100)");
        row("a long one", "UPDATE title SET json=printf('%.*c', 100000, '[')");
        row("none", "DELETE FROM title");
        row("of rows that are not there", "UPDATE title SET row=row+1000");
        row("of other rows", "UPDATE title SET row=-row");
        row("no table", "DROP TABLE title");
    }
    void whatSaysSomethingElseIsNotTaken()
    {
        QFETCH(const QString, sql);
        test::runSql(m_path, sql);
        const std::vector<HistoryRow> rows = rowsOf(m_path); // whole: no hash knows of them
        QVERIFY(areUntitled(rows));
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY(session);
            QVERIFY((*session)->apply(test::drillAt(2.5)) && (*session)->settle());
        }
        const std::vector<HistoryRow> after = rowsOf(m_path);
        QCOMPARE(after.size(), rows.size() + 1);
        QVERIFY(areTitled({after.back()}));
    }

    void aTitleThatSaysTheNameItselfIsHarmless()
    {
        test::runSql(m_path,
            QStringLiteral("UPDATE title SET json=(SELECT json_object('code', 'storedName', "
                           "'arguments', json_array(name)) FROM row WHERE id=title.row)"));
        QVERIFY(areTitled(rowsOf(m_path)));
    }

    void goIntoCopies_data()
    {
        QTest::addColumn<bool>("old");
        QTest::newRow("of before") << true;
        QTest::newRow("of now") << false;
    }
    void goIntoCopies()
    {
        QFETCH(const bool, old);
        if (old)
            makeOld(m_path);
        const auto areAsBefore = [old](const QString& path) {
            return old ? areUntitled(rowsOf(path)) : areTitled(rowsOf(path));
        };
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents);
        {
            SessionTables tables(m_path);
            QVERIFY(tables.open(SessionAccess::ReadWrite));
            QVERIFY(tables.copyInto(beside("whole.burin")));
            QVERIFY(QFile(beside("history.burin")).open(QIODevice::WriteOnly));
            SessionTables empty(beside("history.burin"));
            QVERIFY(empty.create(contents->source));
        }
        {
            SessionTables tables(m_path);
            QVERIFY(tables.open(SessionAccess::ReadWrite));
            QVERIFY(tables.copyHistoryInto(beside("history.burin")));
        }
        QVERIFY(salvageSession(m_path, *contents, beside("salvaged.burin")));
        for (const char* copy : {"whole.burin", "history.burin", "salvaged.burin"})
            QVERIFY2(areAsBefore(beside(copy)), copy);
    }
};

BURIN_TEST(RowTitlesTest)

} // namespace rowTitlesTest

#include "RowTitlesTest.moc"
