// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace sessionDamageTest {

using namespace core;

/// What comes before the damage opens, the rest is named, and the file keeps its bytes.
class SessionDamageTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QString m_target;
    QTemporaryDir m_pattern; ///< holds the session that tests copy
    SessionContents m_sound; ///< of that
    QByteArray m_bytes;
    QStringList m_indispensable;

    QStringList filesIn() const { return QDir(m_folder->path()).entryList(QDir::Files); }

    /// Whether @p rows are those that the whole session begins with.
    bool isBeginning(const std::vector<HistoryRow>& rows) const
    {
        bool same = rows.size() <= m_sound.rows.size();
        for (std::size_t i = 0; same && i < rows.size(); ++i) {
            const HistoryRow& row = rows[i];
            const HistoryRow& whole = m_sound.rows[i];
            same = row.parent == whole.parent && row.name == whole.name
                && editToJson(row.edit) == editToJson(whole.edit)
                && row.stateHash == whole.stateHash;
        }
        return same;
    }

    /// What nothing can be opened without, as SQL reads it; an answer is empty where it cannot be
    /// read.
    static QStringList indispensable(const QString& path)
    {
        QStringList answers;
        for (const char* query : {"PRAGMA application_id", "PRAGMA user_version",
                 "SELECT group_concat(sql) FROM sqlite_master",
                 "SELECT json || quote(images) || quote(headers) FROM source WHERE id = 1",
                 "SELECT parent || name || edit || statistics || growthGeneration || chain || "
                 "stateHash || deltaSha256 || seal || quote(at) || quote(author) || quote(program) "
                 "FROM row WHERE id = 1"})
            answers += test::text(path, QString::fromLatin1(query));
        return answers;
    }

    /// Salvages, opens what came of it, walks to every row and goes on.
    void salvageAndGoOn(const SessionContents& contents, bool everywhere = true)
    {
        const Result<void> salvaged = salvageSession(m_path, contents, m_target);
        QVERIFY2(
            salvaged, qPrintable(salvaged ? QString() : salvaged.error().arguments.join(u' ')));
        QCOMPARE(filesIn(), (QStringList{QStringLiteral("a.burin"), QStringLiteral("b.burin")}));
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, test::smallStudy(), m_target);
        QVERIFY2(session, qPrintable(session ? QString() : session.error().arguments.join(u' ')));
        const History& history = (*session)->history();
        QVERIFY(isBeginning(history.rows()));
        QCOMPARE(history.rows().size(), contents.rows.size());
        QCOMPARE(history.position(), contents.position);
        for (const HistoryRow& row : m_sound.rows) {
            if (row.id > RowId(history.rows().size()) || !everywhere)
                break;
            QVERIFY((*session)->goTo(row.id));
            QVERIFY((*session)->settle());
            QCOMPARE((*session)->stateHash(), row.stateHash);
        }
        QVERIFY((*session)->apply(test::drillAt(2.5)));
        QVERIFY((*session)->settle());
        QCOMPARE(history.rows().size(), contents.rows.size() + 1);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString path = m_pattern.filePath(QStringLiteral("a.burin"));
        QVERIFY(!test::makeSession(path).isEmpty());
        const Result<SessionContents> contents = checkSession(path);
        QVERIFY(contents);
        QVERIFY(!contents->damage);
        m_sound = *contents;
        m_indispensable = indispensable(path);
        QVERIFY(!m_indispensable.contains(QString()));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        m_bytes = file.readAll();
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.burin"));
        m_target = m_folder->filePath(QStringLiteral("b.burin"));
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_path));
    }

    void rowsBeforeTheDamageOpen_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("reason");
        // Its own name where none is given.
        const auto row = [this](const char* tag, int first, const char* sql, const char* reason,
                             std::optional<QString> name = std::nullopt) {
            QTest::newRow(tag) << QString(QLatin1String(sql)) << first
                               << name.value_or(first == 0
                                          ? QString()
                                          : m_sound.rows[std::size_t(first - 1)].name)
                               << QString(QLatin1String(reason));
        };
        row("an edit", 5,
            "UPDATE row SET edit=replace(edit,'\"depthMm\":5','\"depthMm\":6') WHERE id=5",
            "it was changed after it was written");
        row("a name", 3, "UPDATE row SET name='Nothing' WHERE id=3", "it was changed",
            QStringLiteral("Nothing"));
        // Row 11 goes on from row 4, but it stands behind row 6.
        row("a parent", 6, "UPDATE row SET parent=1 WHERE id=6", "it was changed");
        row("a state hash", 4,
            "UPDATE row SET stateHash=(SELECT stateHash FROM row WHERE id=2) WHERE id=4",
            "its hash was changed");
        row("a seal", 11,
            "UPDATE row SET seal=(CASE substr(seal,1,1) WHEN '0' THEN '1' ELSE '0' END)"
            "||substr(seal,2) WHERE id=11",
            "its hash");
        row("a row gone", 8, "DELETE FROM row WHERE id=8", "it is missing", QString());
        row("its last row replaced", 13,
            "UPDATE state SET value=replace(value,'13 ','13 0') WHERE key='end'",
            "it is not the row that stood there");
        row("how many there are", 0, "UPDATE state SET value='many' WHERE key='end'",
            "how many rows it has is not said");
        row("the position", 0, "UPDATE state SET value=99 WHERE key='position'",
            "its position is no row");
        row("where redo goes", 0, "UPDATE visited SET child=99 WHERE parent=4", "");
    }
    void rowsBeforeTheDamageOpen()
    {
        QFETCH(QString, sql);
        QFETCH(int, row);
        QFETCH(QString, name);
        QFETCH(QString, reason);
        QVERIFY(test::runSql(m_path, sql));
        const auto count = int(m_sound.rows.size());
        const QByteArray before = test::fingerprint(m_path);
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents);
        QVERIFY(contents->damage);
        const SessionDamage& damage = *contents->damage;
        QCOMPARE(damage.row, RowId(row));
        QCOMPARE(damage.name, name);
        QCOMPARE(damage.after, std::int64_t(row == 0 ? 0 : count - row));
        QVERIFY2(damage.reason.startsWith(reason), qPrintable(damage.reason));
        QCOMPARE(contents->rows.size(), row == 0 ? m_sound.rows.size() : std::size_t(row - 1));
        const RowId lost = row == 0 ? count + 1 : row;
        if (QByteArray(QTest::currentDataTag()) != "the position")
            QCOMPARE(contents->position, m_sound.position < lost ? m_sound.position : lost - 1);
        salvageAndGoOn(*contents);
        QCOMPARE(test::fingerprint(m_path), before);
    }

    void rowsMissingFromTheEndAreMissed()
    {
        const auto count = int(m_sound.rows.size());
        for (const int left : {count - 1, count - 3}) {
            QVERIFY(QFile::remove(m_path));
            QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_path));
            // As thoroughly as somebody would who knows the tables.
            for (const char* table :
                {"row WHERE id", "delta WHERE row", "visited WHERE child", "keyframe WHERE row"})
                test::runSql(m_path,
                    QStringLiteral("DELETE FROM %1>%2").arg(QLatin1String(table)).arg(left));
            test::runSql(
                m_path, QStringLiteral("UPDATE state SET value=%1 WHERE key='position'").arg(left));
            const Result<SessionContents> contents = checkSession(m_path);
            QVERIFY(contents && contents->damage);
            const SessionDamage& damage = *contents->damage;
            QCOMPARE(damage.row, RowId(left + 1));
            QCOMPARE(damage.name, QString());
            QCOMPARE(damage.after, std::int64_t(count - left - 1));
            QCOMPARE(
                damage.reason, QStringLiteral("it is missing; the session had %1 rows").arg(count));
            QCOMPARE(contents->rows.size(), std::size_t(left));
            QCOMPARE(contents->position, RowId(left));
            salvageAndGoOn(*contents);
            if (QTest::currentTestFailed())
                return;
            // What goes on says anew where it ends.
            const Result<SessionContents> goesOn = checkSession(m_target);
            QVERIFY(goesOn && goesOn->isWhole());
            QVERIFY(QFile::remove(m_target));
        }
    }

    /// Builds before did not say where a session ends; they may also have gone on with one that
    /// does.
    void sessionsThatDoNotSayWhereTheyEndOpen()
    {
        const QString first = QStringLiteral("SELECT chain FROM row WHERE id=5");
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE state SET value='5 %1' WHERE key='end'")
                .arg(test::text(m_path, first))));
        const Result<SessionContents> wentOn = checkSession(m_path);
        QVERIFY(wentOn && wentOn->isWhole());
        QVERIFY(test::runSql(m_path, QStringLiteral("DELETE FROM state WHERE key='end'")));
        const Result<SessionContents> before = checkSession(m_path);
        QVERIFY(before && before->isWhole());
        QCOMPARE(before->rows.size(), m_sound.rows.size());
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY(session);
            QVERIFY((*session)->apply(test::drillAt(2.5)));
            QVERIFY((*session)->settle());
        }
        QVERIFY(test::text(m_path, QStringLiteral("SELECT value FROM state WHERE key='end'"))
                    .startsWith(QStringLiteral("%1 ").arg(m_sound.rows.size() + 1)));
    }

    /// Its edit and its hash say what it was: nothing is lost.
    void aRowThatLacksItsDifferenceIsCarriedOutAgain_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QList<int>>("rows");
        const auto row = [](const char* name, const char* sql, const QList<int>& rows) {
            QTest::newRow(name) << QString(QLatin1String(sql)) << rows;
        };
        row("changed", "UPDATE delta SET bytes=zeroblob(20) WHERE row=7", {7});
        row("gone", "DELETE FROM delta WHERE row=12", {12});
        row("growth and cut", "UPDATE delta SET bytes=x'00' WHERE row=4 OR row=9", {4, 9});
        row("undo of one step", "DELETE FROM delta WHERE row=11", {11});
        row("all", "UPDATE delta SET bytes=bytes||x'00'", {});
    }
    void aRowThatLacksItsDifferenceIsCarriedOutAgain()
    {
        QFETCH(QString, sql);
        QFETCH(QList<int>, rows);
        QVERIFY(test::runSql(m_path, sql));
        const QByteArray before = test::fingerprint(m_path);
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents && !contents->damage);
        QList<int> redo;
        for (const SessionDamage& row : contents->redo)
            redo += int(row.row);
        if (!rows.isEmpty())
            QCOMPARE(redo, rows);
        QVERIFY(!redo.isEmpty());
        QCOMPARE(contents->rows.size(), m_sound.rows.size());
        salvageAndGoOn(*contents);
        QCOMPARE(test::fingerprint(m_path), before);
    }

    void whoDoesNotCarryOutAgainCutsThere()
    {
        QVERIFY(test::runSql(m_path, QStringLiteral("UPDATE row SET name='X' WHERE id=9")));
        QVERIFY(test::runSql(m_path, QStringLiteral("DELETE FROM delta WHERE row=5")));
        Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(contents && contents->damage);
        QCOMPARE(contents->damage->row, RowId(9));
        QCOMPARE(contents->redo.size(), std::size_t(1));
        const SessionDamage first = contents->redo.front();
        contents->cut(first);
        QVERIFY(contents->redo.empty());
        QCOMPARE(contents->damage->row, RowId(5));
        QCOMPARE(contents->damage->after, std::int64_t(m_sound.rows.size()) - 5);
        QCOMPARE(contents->rows.size(), std::size_t(4));
        salvageAndGoOn(*contents);
    }

    void whatHasNothingSoundIsRefused_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::newRow("source") << QStringLiteral(
            "UPDATE source SET json=replace(json,'nowhere','elsewhere')");
        QTest::newRow("no source") << QStringLiteral("DELETE FROM source");
        QTest::newRow("first row") << QStringLiteral("UPDATE row SET name='X' WHERE id=1");
    }
    void whatHasNothingSoundIsRefused()
    {
        QFETCH(QString, sql);
        QVERIFY(test::runSql(m_path, sql));
        const QByteArray before = test::fingerprint(m_path);
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(!contents);
        QCOMPARE(contents.error().code, ErrorCode::SessionDamaged);
        QCOMPARE(contents.error().arguments.value(0), m_path);
        QCOMPARE(test::fingerprint(m_path), before);
    }

    /// Real damage: bytes of the file itself, wherever they lie.
    void anyByteMayBeDamaged()
    {
        test::Random random(20261121);
        int cut = 0;
        int redone = 0;
        int refused = 0;
        for (int round = 0; round < (test::longRun() ? 600 : 40); ++round) {
            QByteArray bytes = m_bytes;
            const int length = test::randomInt(random, 0, 2) == 0 ? 1 : 300;
            const int start = test::randomInt(random, 0, int(bytes.size()) - length);
            for (int i = 0; i < length; ++i)
                bytes[start + i] = char(bytes[start + i] ^ test::randomInt(random, 1, 255));
            QFile file(m_path);
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
            QCOMPARE(file.write(bytes), qint64(bytes.size()));
            file.close();
            const Result<SessionContents> contents = checkSession(m_path);
            if (!contents) {
                ++refused;
                QVERIFY(QFile::copy(m_path, m_target));
                QVERIFY2(indispensable(m_target) != m_indispensable,
                    qPrintable(QString::number(start) + contents.error().arguments.join(u' ')));
                QVERIFY(QFile::remove(m_target));
            } else {
                QVERIFY2(isBeginning(contents->rows), qPrintable(QString::number(start)));
                QVERIFY(contents->damage || contents->rows.size() == m_sound.rows.size());
                cut += contents->damage ? 1 : 0;
                redone += contents->redo.empty() ? 0 : 1;
                salvageAndGoOn(*contents, round % 8 == 0);
                if (QTest::currentTestFailed())
                    return;
                QVERIFY(QFile::remove(m_target));
            }
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY(file.readAll() == bytes);
        }
        QVERIFY2(cut > 4 && redone > 0 && refused < cut,
            qPrintable(QStringLiteral("%1 %2 %3").arg(cut).arg(redone).arg(refused)));
    }

    void aFileCutShortOpensToWhereItEnds()
    {
        // Long enough for rows to lie all over the file; the last pages hold a picture.
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, test::smallStudy(), m_path);
            QVERIFY(session);
            for (int i = 0; i < 60; ++i)
                QVERIFY((*session)->apply(
                    test::renameSegment(1, QStringLiteral("Brain, look %1").arg(i))));
            QVERIFY((*session)->apply(test::drillAt(4)));
            QVERIFY((*session)->settle());
            (*session)->keyframes().add((*session)->history().position(), QByteArray(20000, 'p'));
            QVERIFY((*session)->settle());
        }
        const SessionContents before = std::exchange(m_sound, *checkSession(m_path));
        const auto back = qScopeGuard([&] { m_sound = before; });
        QByteArray bytes;
        {
            QFile file(m_path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            bytes = file.readAll();
        }
        const qint64 size = bytes.size();
        const QString told = QStringLiteral("the file is cut off: %1 of %2 bytes are there");
        int whole = 0;
        int partly = 0;
        int refused = 0;
        for (qint64 left = size - 1; left > 100; left -= size / (test::longRun() ? 200 : 24)) {
            QFile file(m_path);
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
            QCOMPARE(file.write(bytes.first(left)), left);
            file.close();
            const QString cutOff = told.arg(left).arg(size);
            const Result<SessionContents> contents = checkSession(m_path);
            if (contents) {
                QCOMPARE(contents->cutOff, cutOff);
                QVERIFY(!contents->isWhole());
                QVERIFY(contents->damage || contents->rows.size() == m_sound.rows.size());
                QVERIFY(isBeginning(contents->rows));
                ++(contents->rows.size() == m_sound.rows.size() ? whole : partly);
                salvageAndGoOn(*contents, left > size - 8192);
                if (QTest::currentTestFailed())
                    return;
                QVERIFY(QFile::remove(m_target));
            } else {
                ++refused;
                QCOMPARE(contents.error().code, ErrorCode::SessionDamaged);
                QCOMPARE(contents.error().arguments.value(0), m_path);
                QVERIFY2(contents.error().arguments.value(1).contains(cutOff),
                    qPrintable(contents.error().arguments.value(1)));
            }
            // Nobody goes on writing in it.
            const auto written = SessionFile::open(m_path, SessionFile::Access::ReadWrite);
            QVERIFY(!written);
            QCOMPARE(written.error().arguments.value(1), cutOff);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY(file.readAll() == bytes.first(left));
        }
        QVERIFY2(whole > 0 && partly > 0 && refused > 0,
            qPrintable(QStringLiteral("%1 %2 %3").arg(whole).arg(partly).arg(refused)));
    }

    void ofAFewBytesNothingOpens()
    {
        for (const int left : {1, 15, 60, 99}) {
            QFile file(m_path);
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
            file.write(m_bytes.first(left));
            file.close();
            const Result<SessionContents> contents = checkSession(m_path);
            QVERIFY(!contents);
            QCOMPARE(contents.error().arguments,
                (QStringList{m_path,
                    QStringLiteral("the file is cut off: only %1 bytes are there").arg(left)}));
        }
    }

    /// The main file of a session whose program was killed, copied alone.
    void withoutWhatLiesBesideItSaysSo()
    {
        const QString alone = m_folder->filePath(QStringLiteral("alone.burin"));
        {
            reference::ReferenceEngine engine;
            const QString path = m_folder->filePath(QStringLiteral("live.burin"));
            const auto session = EditSession::create(engine, test::smallStudy(), {.file = path});
            QVERIFY(session);
            QVERIFY((*session)->apply(test::drillAt(0)));
            QVERIFY((*session)->settle());
            QVERIFY(QFileInfo(path + QStringLiteral("-wal")).size() > 0);
            // Not as a plain file, which would drop the locks of this process.
            QCOMPARE(std::system(qPrintable(QStringLiteral("cp '%1' '%2'").arg(path, alone))), 0);
        }
        // The file itself says from the start of which study it is; what it lacks is named.
        const Result<SessionContents> contents = checkSession(alone);
        QVERIFY(contents);
        QVERIFY(contents->rows.empty());
        QCOMPARE(contents->source.toJson(), m_sound.source.toJson());
        QVERIFY2(QString(contents->leftOpen)
                     .contains(QStringLiteral(
                         "'alone.burin-wal', which may hold what was written last, is")),
            qPrintable(contents->leftOpen));
        // With steps that had got as far as the file itself they open, and the rest is named.
        const Result<SessionContents> closed = checkSession(m_path);
        QVERIFY(closed && closed->leftOpen.isEmpty());
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.seek(18) && file.write("\2\2", 2) == 2);
        file.close();
        const Result<SessionContents> left = checkSession(m_path);
        QVERIFY(left && left->isWhole());
        QCOMPARE(left->rows.size(), m_sound.rows.size());
        QVERIFY(!left->leftOpen.isEmpty());
        QVERIFY(!left->damage && left->redo.empty());
    }

    void aFileThatIsThereIsNotReplaced()
    {
        QVERIFY(test::runSql(m_path, QStringLiteral("UPDATE row SET name='X' WHERE id=5")));
        const Result<SessionContents> contents = checkSession(m_path);
        QVERIFY(QFile::copy(m_path, m_target));
        const QByteArray before = test::fingerprint(m_target);
        QCOMPARE(salvageSession(m_path, *contents, m_target).error().code, ErrorCode::FileExists);
        QCOMPARE(test::fingerprint(m_target), before);
    }
};

BURIN_TEST(SessionDamageTest)

} // namespace sessionDamageTest

#include "SessionDamageTest.moc"
