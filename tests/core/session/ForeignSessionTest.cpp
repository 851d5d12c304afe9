// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPreview.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/records/RowText.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace foreignSessionTest {

using namespace core;

namespace {

void put(QByteArray& bytes, qsizetype at, std::uint32_t value, int size)
{
    for (int i = size - 1; i >= 0; --i) {
        bytes[at + i] = char(value & 0xffU);
        value >>= 8;
    }
}

/// A page inside of a table's tree (https://www.sqlite.org/fileformat.html, 1.6) all of whose
/// children are the same page. The root of a table keeps its place; the others are put behind the
/// end of the file, which is told to have them.
QByteArray innerPage(int pageBytes, int cells, std::uint32_t child)
{
    constexpr int headBytes = 12;
    QByteArray page(pageBytes, '\0');
    page[0] = 5;
    put(page, 3, std::uint32_t(cells), 2);
    put(page, 8, child, 4);
    int content = pageBytes;
    for (int i = 0; i < cells; ++i) {
        content -= 5;
        put(page, content, child, 4);
        page[content + 4] = char(i + 1); // a key of one byte
        put(page, headBytes + 2 * i, std::uint32_t(content), 2);
    }
    put(page, 5, std::uint32_t(content), 2);
    return page;
}

void makeEndless(const QString& path, const QString& table)
{
    constexpr int levels = 12;
    constexpr int cells = 100;
    const int root = test::text(
        path, QStringLiteral("SELECT rootpage FROM sqlite_master WHERE name='%1'").arg(table))
                         .toInt();
    const int pageBytes = test::text(path, QStringLiteral("PRAGMA page_size")).toInt();
    QFile file(path);
    if (root < 2 || !file.open(QIODevice::ReadWrite))
        qFatal("no table %s", qPrintable(table));
    QByteArray bytes = file.readAll();
    const auto pages = std::uint32_t(bytes.size() / pageBytes);
    const QByteArray leaf = bytes.mid(qsizetype(root - 1) * pageBytes, pageBytes);
    bytes.replace(
        qsizetype(root - 1) * pageBytes, pageBytes, innerPage(pageBytes, cells, pages + 1));
    for (std::uint32_t level = 1; level < levels; ++level)
        bytes += innerPage(pageBytes, cells, pages + level + 1);
    bytes += leaf;
    put(bytes, 28, std::uint32_t(bytes.size() / pageBytes), 4);
    // The count of pages is believed where both counters of changes agree.
    bytes.replace(92, 4, bytes.mid(24, 4));
    file.seek(0);
    file.write(bytes);
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
        const QByteArray before = test::bytesOf(m_path);
        for (const auto access : {SessionAccess::ReadWrite, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(m_path, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::SessionDamaged);
            QVERIFY2(opened.error().arguments.value(1).contains(u"no part of a session"),
                qPrintable(opened.error().arguments.join(u' ')));
        }
        QCOMPARE(test::bytesOf(m_path), before);
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
        QCOMPARE(test::bytesOf(m_path), before);
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
        QTest::newRow("a table of other columns")
            << QStringList{QStringLiteral("ALTER TABLE state ADD COLUMN more TEXT")};
        QTest::newRow("a generated column") << QStringList{QStringLiteral("DROP TABLE visited"),
            QStringLiteral("CREATE TABLE visited (parent INTEGER PRIMARY KEY, child INTEGER AS "
                           "(parent + 1))")};
    }
    void whatOnlyLooksLikeASessionIsRefused()
    {
        QFETCH(QStringList, sql);
        for (const QString& statement : sql)
            test::runSql(m_path, statement);
        const QByteArray before = test::bytesOf(m_path);
        for (const auto access :
            {SessionAccess::ReadWrite, SessionAccess::SoundPart, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(m_path, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::UnsupportedFormat);
        }
        QVERIFY(!previewSession(m_path));
        QCOMPARE(test::bytesOf(m_path), before);
    }

    /// A row whose hashes are in order, but which takes back itself, or one that comes later:
    /// whoever followed that would go round for ever.
    void rowsThatNameNoEarlierOneAreDamaged_data()
    {
        QTest::addColumn<QString>("edit");
        const auto last = qlonglong(test::manyEdits().size());
        QTest::newRow("itself") << QStringLiteral(R"({"edit":"revert","rows":[%1]})").arg(last);
        QTest::newRow("one that is not there")
            << QStringLiteral(R"({"edit":"revert","rows":[1,%1]})").arg(last + 900);
        QTest::newRow("revised")
            << QStringLiteral(R"({"edit":"reviseStroke","removed":true,"row":%1})").arg(last);
    }
    void rowsThatNameNoEarlierOneAreDamaged()
    {
        QFETCH(QString, edit);
        const auto last = RowId(test::manyEdits().size());
        const auto ofRow = [this](RowId row, const char* column) {
            return test::text(m_path,
                QStringLiteral("SELECT %1 FROM row WHERE id=%2")
                    .arg(QLatin1String(column))
                    .arg(row));
        };
        RowText forged{.id = last,
            .parent = last - 1,
            .name = ofRow(last, "name"),
            .edit = edit,
            .statistics = ofRow(last, "statistics"),
            .growthGeneration = ofRow(last, "growthGeneration").toLongLong(),
            .at = ofRow(last, "at"),
            .author = ofRow(last, "author"),
            .program = ofRow(last, "program")};
        QCOMPARE(ofRow(last, "parent"), QString::number(last - 1));
        const QString chain = forged.chain(ofRow(last - 1, "chain"));
        const QString sealed = seal(chain, ofRow(last, "stateHash"), ofRow(last, "deltaSha256"));
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE row SET edit='%1', chain='%2', seal='%3' WHERE id=%4")
                .arg(edit, chain, sealed)
                .arg(last)));
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE state SET value='%1 %2' WHERE key='end'").arg(last).arg(chain)));
        const auto opened = SessionFile::open(m_path, SessionAccess::ReadWrite);
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::SessionDamaged);
        QVERIFY2(opened.error().arguments.join(u' ').contains(u"does not lie before it"),
            qPrintable(opened.error().arguments.join(u' ')));
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents && contents->damage);
        QCOMPARE(contents->rows.size(), std::size_t(last) - 1);
    }

    /// Where a session says that its study is, is looked only if it can be there.
    void pathsOfStrangersAreNotFollowed()
    {
        SessionSource source;
        for (const char* path : {"/", "//", "/..", "/proc", "/proc/self", "/sys", "/dev/zero",
                 "/run", "../../../..", "usr", ".", "/usr/../usr", "/usr/", "//usr/share", "/usr",
                 "/home", "/var", "/tmp"}) {
            source.path = QLatin1String(path);
            QVERIFY2(studyPlaces(m_path, source).isEmpty(), path);
        }
        source.path = QStringLiteral("/tmp/a") + QChar::Null + QStringLiteral("b");
        QVERIFY(studyPlaces(m_path, source).isEmpty());
        source.path = QLatin1Char('/') + QStringLiteral("a/").repeated(20000);
        QVERIFY(studyPlaces(m_path, source).isEmpty());
        source.path = m_folder->path();
        QCOMPARE(studyPlaces(m_path, source).value(0), m_folder->path());
        // Below /run only what is mounted there; a copy of it beside the session tells.
        const QString beside = m_folder->filePath(QStringLiteral("farStudy"));
        QVERIFY(QDir().mkpath(beside));
        for (const auto& [path, isFollowed] :
            {std::pair("/run/user/1000/gvfs/smb:share/farStudy", true),
                {"/run/media/stick/farStudy", true}, {"/run/user/1000/farStudy", false},
                {"/run/user/gvfs/farStudy", false}, {"/run/systemd/farStudy", false}}) {
            source.path = QLatin1String(path);
            QCOMPARE(studyPlaces(m_path, source), isFollowed ? QStringList{beside} : QStringList());
        }
    }

    /// Nor is a folder searched for long that only a session has named.
    void placesOfStrangersAreNotSearchedForLong()
    {
        const QString folder = m_folder->filePath(QStringLiteral("many"));
        QVERIFY(QDir().mkpath(folder));
        constexpr int most = 20'000;
        for (int i = 0; i <= most; ++i) {
            QFile file(QStringLiteral("%1/%2").arg(folder).arg(i));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        SessionSource source;
        source.path = folder;
        const auto found = loadSessionStudy(m_path, source);
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::SessionMismatch);
        QVERIFY2(found.error().arguments.join(QLatin1String(" ")).contains(QLatin1String("20000")),
            qPrintable(found.error().arguments.join(QLatin1String(" "))));
        QVERIFY(QFile::remove(QStringLiteral("%1/0").arg(folder)));
        const auto fewer = loadSessionStudy(m_path, source);
        QVERIFY(!fewer); // there is nothing in it, but it was looked through
        QVERIFY(!fewer.error().arguments.join(QLatin1String(" ")).contains(QLatin1String("20000")));
    }

    /// Pages of a tree that are each other's children: a small file with more rows than anybody can
    /// read. Whoever opens or looks at it is through in a moment.
    void whatHasNoEndIsNotRead_data()
    {
        QTest::addColumn<QString>("table");
        for (const char* table : {"visited", "row", "keyframe"})
            QTest::newRow(table) << QString::fromLatin1(table);
    }
    void whatHasNoEndIsNotRead()
    {
        QFETCH(QString, table);
        makeEndless(m_path, table);
        const QByteArray before = test::bytesOf(m_path);
        QElapsedTimer clock;
        clock.start();
        for (const auto access : {SessionAccess::ReadWrite, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(m_path, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::SessionDamaged);
            QVERIFY2(opened.error().arguments.value(1).contains(u"structure is damaged"),
                qPrintable(opened.error().arguments.join(u' ')));
        }
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(!contents || !contents->isWhole());
        static_cast<void>(previewSession(m_path));
        QVERIFY2(clock.elapsed() < 60'000, qPrintable(QString::number(clock.elapsed())));
        QCOMPARE(test::bytesOf(m_path), before);
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

} // namespace foreignSessionTest

#include "ForeignSessionTest.moc"
