// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"
#include "core/edits/kinds/EditParts.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/database/SessionDatabase.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/Signal.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

namespace sessionFileTest {

using namespace core;

namespace {

struct Opened {
    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

RowOrigin origin()
{
    return {.at = QDateTime({2026, 11, 21}, {14, 2, 3, 45}, Qt::UTC),
        .author = QStringLiteral("Dr. Jörg \"J\" Müller"),
        .program = QStringLiteral("burin 0.1.0")};
}

Result<void> openSession(Opened& opened, const QString& path)
{
    Result<std::unique_ptr<EditSession>> session =
        EditSession::open(opened.engine, test::smallStudy(), path);
    if (!session)
        return tl::unexpected(session.error());
    opened.session = *std::move(session);
    return {};
}

QStringList filesIn(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::Files);
}

} // namespace

class SessionFileTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QTemporaryDir m_pattern; ///< holds the session that tests copy
    QByteArray m_hash; ///< at its position

    QByteArray makeSession(const QString& path) const
    {
        const bool copied = QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), path);
        return copied ? m_hash : QByteArray();
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_hash = test::makeSession(m_pattern.filePath(QStringLiteral("a.burin")), origin);
        QCOMPARE(m_hash.size(), 64);
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.burin"));
    }

    void continuesWhereItStopped()
    {
        const QByteArray hash = makeSession(m_path);
        Opened opened;
        const Result<void> result = openSession(opened, m_path);
        QVERIFY2(result, qPrintable(result ? QString() : result.error().arguments.join(u' ')));
        QCOMPARE(opened.session->stateHash(), hash);
        const History& history = opened.session->history();
        QCOMPARE(history.rows().size(), test::manyEdits().size() + 2);
        QCOMPARE(history.position(), RowId(test::manyEdits().size() + 1));
        QCOMPARE(history.redoTarget(), RowId(test::manyEdits().size() + 2));
        QCOMPARE(history.row(1).name, QStringLiteral("Add segment 'Brain'"));
        QVERIFY(!opened.session->document().segment(2)->visible);
        QVERIFY(opened.session->document().segment(1)->visible);

        // Every row can be reached again, from differences on disk alone.
        for (RowId row = 12; row >= 0; --row) {
            QVERIFY(opened.session->goTo(row));
            QVERIFY(opened.session->settle());
            if (row > 0)
                QCOMPARE(opened.session->stateHash(), history.row(row).stateHash);
        }
        QVERIFY(opened.engine.fields().occupiedBricks().empty());
    }

    void aClosedSessionIsOnePrivateFile()
    {
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::create(engine, test::smallStudy(), {.file = m_path});
            QVERIFY(session);
            QVERIFY((*session)->apply(test::drillAt(0)));
            QVERIFY((*session)->settle());
            const auto owner = QFileDevice::ReadOwner | QFileDevice::WriteOwner
                | QFileDevice::ReadUser | QFileDevice::WriteUser;
            for (const QString& file : filesIn(*m_folder))
                QCOMPARE(QFile::permissions(m_folder->filePath(file)), owner);
        }
        QCOMPARE(filesIn(*m_folder), QStringList{QStringLiteral("a.burin")});
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray head = file.read(100);
        QCOMPARE(head.mid(68, 4), QByteArray("Burn"));
        QCOMPARE(int(head[18]), 1); // rollback journal, not WAL
    }

    /// The file of an open session says that more is beside it: that must be there, too, before
    /// the first step, or a session whose program is killed by then seems to lack something.
    void whatIsBesideAnOpenSessionIsThereFromTheStart()
    {
        const QString beside = m_path + QStringLiteral("-wal");
        auto database = SessionDatabase::create(m_path, [](SessionDatabase&) { return true; });
        QVERIFY(database && QFile::exists(beside));
        database->reset();
        QVERIFY(!QFile::exists(beside));
        database = SessionDatabase::open(m_path, false);
        QVERIFY(database && QFile::exists(beside));
    }

    void nothingIsLostInACrash()
    {
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {.file = m_path});
        QVERIFY(session->apply(test::addSegment("A")));
        QVERIFY(session->apply(test::seedInBrain(1)));
        QVERIFY(session->apply(test::growBrain(3)));
        QVERIFY(session->settle());
        const QByteArray hash = session->stateHash();
        // What a crash would leave behind at this moment, with a stroke under the pen.
        const Edit stroke = test::drillAt(0);
        QVERIFY(session->begin(test::begunStroke(stroke)));
        session->extend(PenSamples{.samples = *penSamplesOf(stroke)});
        const QString copy = m_folder->filePath(QStringLiteral("copy.burin"));
        for (const char* suffix : {"", "-wal"})
            QVERIFY(QFile::copy(m_path + QLatin1String(suffix), copy + QLatin1String(suffix)));
        session->end(Ending::Rollback);

        Opened opened;
        QVERIFY(openSession(opened, copy));
        QCOMPARE(opened.session->history().rows().size(), std::size_t(3));
        QCOMPARE(opened.session->stateHash(), hash);
        QVERIFY(opened.session->apply(test::drillAt(0)));
        QVERIFY(opened.session->settle());
    }

    void aRowWithoutItsSecondHalfIsCarriedOutAgain_data()
    {
        QTest::addColumn<int>("from");
        QTest::addColumn<qint64>("position");
        QTest::newRow("the last") << 10 << qint64(10);
        QTest::newRow("all") << 1 << qint64(10);
        QTest::newRow("behind an undo") << 9 << qint64(5);
        QTest::newRow("a branch") << 4 << qint64(12);
    }
    void aRowWithoutItsSecondHalfIsCarriedOutAgain()
    {
        QFETCH(int, from);
        QFETCH(qint64, position);
        makeSession(m_path);
        std::vector<QByteArray> hashes;
        {
            Opened opened;
            QVERIFY(openSession(opened, m_path));
            for (const HistoryRow& row : opened.session->history().rows())
                hashes.push_back(row.stateHash);
        }
        QVERIFY(test::runSql(m_path,
            QStringLiteral(
                "UPDATE row SET stateHash=NULL, deltaSha256=NULL, seal=NULL WHERE id>=%1")
                .arg(from)));
        test::runSql(m_path, QStringLiteral("DELETE FROM delta WHERE row>=%1").arg(from));
        QVERIFY(test::runSql(m_path,
            QStringLiteral("UPDATE state SET value=%1 WHERE key='position'").arg(position)));
        for (int again = 0; again < 2; ++again) { // the second time everything is on disk
            Opened opened;
            const Result<void> result = openSession(opened, m_path);
            QVERIFY2(result, qPrintable(result ? QString() : result.error().arguments.join(u' ')));
            QCOMPARE(opened.session->history().position(), RowId(position));
            QCOMPARE(opened.session->stateHash(), hashes[std::size_t(position - 1)]);
            for (std::size_t i = 0; i < hashes.size(); ++i)
                QCOMPARE(opened.session->history().rows()[i].stateHash, hashes[i]);
        }
    }

    void damageIsNoticed_data()
    {
        QTest::addColumn<QString>("sql");
        const auto row = [](const char* name, const char* sql) {
            QTest::newRow(name) << QString(QLatin1String(sql));
        };
        row("an edit",
            "UPDATE row SET edit=replace(edit,'\"depthMm\":5','\"depthMm\":6') WHERE id=5");
        row("a name", "UPDATE row SET name='Nothing' WHERE id=3");
        row("a parent", "UPDATE row SET parent=1 WHERE id=6");
        row("a hash", "UPDATE row SET stateHash=(SELECT stateHash FROM row WHERE id=2) WHERE id=3");
        row("a difference", "UPDATE delta SET bytes=zeroblob(20) WHERE row=4");
        row("a difference gone", "DELETE FROM delta WHERE row=4");
        row("a row gone", "DELETE FROM row WHERE id=3");
        row("the source", "UPDATE source SET json=replace(json,'nowhere','elsewhere')");
        row("the time", "UPDATE row SET at=replace(at,'2026','2025') WHERE id=4");
        row("who", "UPDATE row SET author='Eve' WHERE id=2");
        row("the program", "UPDATE row SET program='burin 9' WHERE id=7");
        row("no origin", "UPDATE row SET at=NULL, author=NULL, program=NULL WHERE id=7");
        row("statistics", "UPDATE row SET statistics='{}' WHERE id=8");
        row("the position", "UPDATE state SET value=99 WHERE key='position'");
        row("where redo goes", "UPDATE visited SET child=99");
    }
    void damageIsNoticed()
    {
        QFETCH(QString, sql);
        makeSession(m_path);
        QVERIFY(test::runSql(m_path, sql));
        Opened opened;
        const Result<void> result = openSession(opened, m_path);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::SessionDamaged);
        QCOMPARE(result.error().arguments.value(0), m_path);
        QVERIFY(!result.error().arguments.value(1).isEmpty());
    }

    void damageOffThePathIsNoticedOnTheWay()
    {
        makeSession(m_path); // at row 11; row 8 lies on the other branch
        QVERIFY(test::runSql(
            m_path, QStringLiteral("UPDATE delta SET bytes=zeroblob(20) WHERE row=7")));
        Opened opened;
        QVERIFY(openSession(opened, m_path));
        QVERIFY(opened.session->goTo(10));
        const Result<void> result = opened.session->settle();
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::SessionDamaged);
        // It stands where the sound part ends, whole.
        QCOMPARE(opened.session->history().position(), RowId(6));
        QCOMPARE(opened.session->stateHash(), opened.session->history().row(6).stateHash);
    }

    void otherFilesAreNotSessions_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<int>("code");
        QTest::newRow("text") << QByteArray("not a session, just a text that is long enough")
                              << int(ErrorCode::UnsupportedFormat);
        QTest::newRow("empty") << QByteArray() << int(ErrorCode::FileTruncated);
    }
    void otherFilesAreNotSessions()
    {
        QFETCH(QByteArray, content);
        QFETCH(int, code);
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        Opened opened;
        const Result<void> result = openSession(opened, m_path);
        QVERIFY(!result);
        QCOMPARE(int(result.error().code), code);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), content);
    }

    void aTruncatedFileIsDamaged()
    {
        makeSession(m_path);
        QFile file(m_path);
        QVERIFY(file.resize(file.size() / 2));
        Opened opened;
        const Result<void> result = openSession(opened, m_path);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::SessionDamaged);
    }

    void otherSchemasAreRefused()
    {
        makeSession(m_path);
        for (const auto& [version, word] :
            {std::pair{7, "session format 7"}, std::pair{4, "format 4"}, std::pair{1, "format 1"},
                std::pair{0, "format 0"}, std::pair{-1, "format -1"}}) {
            test::runSql(m_path, QStringLiteral("PRAGMA user_version=%1").arg(version));
            const QByteArray before = test::bytesOf(m_path);
            Opened opened;
            const Result<void> result = openSession(opened, m_path);
            QCOMPARE(result.error().code, ErrorCode::UnsupportedFormat);
            QVERIFY(result.error().arguments.value(1).contains(QLatin1String(word)));
            QCOMPARE(test::bytesOf(m_path), before);
        }
    }

    void rowsSayWhoMadeThemAndWhen()
    {
        makeSession(m_path);
        Opened opened;
        QVERIFY(openSession(opened, m_path));
        for (const HistoryRow& row : opened.session->history().rows()) {
            QCOMPARE(row.origin.at, origin().at);
            QCOMPARE(row.origin.author, origin().author);
            QCOMPARE(row.origin.program, origin().program);
        }
        // Who names nobody is nobody, and not the login.
        const QDateTime before = QDateTime::currentDateTimeUtc();
        QVERIFY(opened.session->apply(test::drillAt(3)));
        QVERIFY(opened.session->settle());
        opened.session.reset();
        QVERIFY(openSession(opened, m_path));
        const RowOrigin& last = opened.session->history().rows().back().origin;
        QVERIFY(last.at >= before && last.at <= QDateTime::currentDateTimeUtc());
        QCOMPARE(last.author, QString());
    }

    void keyframesAreKept()
    {
        makeSession(m_path);
        const auto pictureAt = [](EditSession& session, RowId row) {
            QByteArray png;
            test::Signal done;
            session.keyframes().fetch(row, [&](const QByteArray& fetched) {
                png = fetched;
                done.release();
            });
            done.acquire();
            return png;
        };
        {
            Opened opened;
            QVERIFY(openSession(opened, m_path));
            QVERIFY(opened.session->keyframes().rows().empty());
            opened.session->keyframes().add(11, "eleven");
            opened.session->keyframes().add(4, "four");
            opened.session->keyframes().add(4, "four again");
            QCOMPARE(opened.session->keyframes().rows(), (std::vector<RowId>{4, 11}));
            QCOMPARE(pictureAt(*opened.session, 4), QByteArray("four again"));
            QVERIFY(opened.session->settle());
        }
        Opened opened;
        QVERIFY(openSession(opened, m_path));
        QCOMPARE(opened.session->keyframes().rows(), (std::vector<RowId>{4, 11}));
        QCOMPARE(pictureAt(*opened.session, 11), QByteArray("eleven"));
        QCOMPARE(pictureAt(*opened.session, 5), QByteArray());
        QCOMPARE(opened.session->stateHash(), m_hash);
        // A picture is no truth: another one breaks nothing.
        opened.session.reset();
        QVERIFY(test::runSql(
            m_path, QStringLiteral("UPDATE keyframe SET png=zeroblob(9) WHERE row=4")));
        QVERIFY(openSession(opened, m_path));
    }

    void anotherVolumeIsRefused()
    {
        makeSession(m_path);
        reference::ReferenceEngine engine;
        for (int difference = 0; difference < 3; ++difference) {
            LoadedVolume other = test::smallStudy();
            if (difference == 0)
                other.volume.voxelsSha256 = QByteArray(64, 'b');
            else if (difference == 1)
                other.volume.geometry.indexToWorld[3][0] += 0.5;
            else
                other.volume.identity.seriesUid = QStringLiteral("1.2.3.5");
            const auto session = EditSession::open(engine, other, m_path);
            QVERIFY(!session);
            QCOMPARE(session.error().code, ErrorCode::SessionMismatch);
        }
    }

    void twoProgramsDoNotShareASession()
    {
        reference::ReferenceEngine engine;
        const auto first = EditSession::create(engine, test::smallStudy(), {.file = m_path});
        QVERIFY(first);
        Opened second;
        const Result<void> result = openSession(second, m_path);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::FileUnreadable);
    }

    void existingFilesAreKeptUnlessToldOtherwise()
    {
        const QByteArray hash = makeSession(m_path);
        reference::ReferenceEngine engine;
        const auto refused = EditSession::create(engine, test::smallStudy(), {.file = m_path});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::FileExists);
        {
            Opened opened;
            QVERIFY(openSession(opened, m_path));
            QCOMPARE(opened.session->stateHash(), hash);
        }
    }

    void placesThatCannotBeWrittenAreNamed()
    {
        reference::ReferenceEngine engine;
        const QString inNoFolder = m_folder->filePath(QStringLiteral("no/such/a.burin"));
        const auto session = EditSession::create(engine, test::smallStudy(), {.file = inNoFolder});
        QVERIFY(!session);
        QCOMPARE(session.error().code, ErrorCode::FileUnwritable);
        QCOMPARE(session.error().arguments.value(0), inNoFolder);
        QCOMPARE(EditSession::create(engine, test::smallStudy(), {.file = m_folder->path()})
                     .error()
                     .code,
            ErrorCode::FileUnwritable);
    }

    /// No step is lost while the disk is full, and all are there once it is not.
    void aFullDiskKeepsWorkInMemory()
    {
        reference::ReferenceEngine engine;
        const std::vector<Edit> edits = test::manyEdits();
        QByteArray hash;
        {
            auto session = *EditSession::create(engine, test::smallStudy(), {.file = m_path});
            std::vector<ErrorCode> told;
            session->setErrorListener([&told](const Error& error) { told.push_back(error.code); });
            for (std::size_t i = 0; i < 4; ++i)
                QVERIFY(session->apply(edits[i]));
            QVERIFY(session->settle());
            {
                const test::FileSizeLimit limit(1);
                for (std::size_t i = 4; i < edits.size(); ++i) {
                    QVERIFY(session->apply(edits[i]));
                    const Result<void> settled = session->settle();
                    QVERIFY(!settled);
                    QCOMPARE(settled.error().code, ErrorCode::FileUnwritable);
                    QCOMPARE(settled.error().arguments.value(0), m_path);
                }
                QVERIFY(session->storage().trouble());
                QCOMPARE(told, std::vector<ErrorCode>{ErrorCode::SessionUnwritten}); // once
                hash = session->stateHash();
                QVERIFY(session->goTo(0));
                static_cast<void>(session->settle());
                QCOMPARE(session->history().position(), RowId(0));
                QVERIFY(session->goTo(RowId(edits.size())));
                static_cast<void>(session->settle());
                QCOMPARE(session->stateHash(), hash);
            }
            session->storage().retryWriting();
            const Result<void> settled = session->settle();
            QVERIFY2(
                settled, qPrintable(settled ? QString() : settled.error().arguments.join(u' ')));
            QVERIFY(!session->storage().trouble());
            QCOMPARE(told.size(), std::size_t(1));
        }
        Opened opened;
        const Result<void> result = openSession(opened, m_path);
        QVERIFY2(result, qPrintable(result ? QString() : result.error().arguments.join(u' ')));
        QCOMPARE(opened.session->stateHash(), hash);
        QCOMPARE(opened.session->history().rows().size(), edits.size());
    }

    /// What stood on disk when it filled up opens again, even if the rest is lost with the process.
    void whatWasWrittenBeforeTheDiskFilledUpStays()
    {
        reference::ReferenceEngine engine;
        QByteArray hash;
        {
            auto session = *EditSession::create(engine, test::smallStudy(), {.file = m_path});
            session->setErrorListener([](const Error&) {});
            QVERIFY(session->apply(test::drillAt(0)));
            QVERIFY(session->settle());
            hash = session->stateHash();
            const test::FileSizeLimit limit(1);
            QVERIFY(session->apply(test::drillAt(3)));
            QVERIFY(!session->settle());
            session.reset();
        }
        Opened opened;
        QVERIFY(openSession(opened, m_path));
        QCOMPARE(opened.session->stateHash(), hash);
        QCOMPARE(opened.session->history().rows().size(), std::size_t(1));
    }

    void readOnlyFoldersAreReadAndSaidToBe()
    {
        makeSession(m_path);
        const auto everybody =
            QFileDevice::ReadOwner | QFileDevice::ReadGroup | QFileDevice::ReadOther;
        QVERIFY(QFile::setPermissions(m_path, everybody));
        QVERIFY(QFile::setPermissions(m_folder->path(),
            everybody | QFileDevice::ExeOwner | QFileDevice::ExeGroup | QFileDevice::ExeOther));
        const auto reset = qScopeGuard([this] {
            QFile::setPermissions(m_folder->path(),
                QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
        });
        const QByteArray before = test::fingerprint(m_path);
        const test::Unprivileged nobody;
        {
            const auto file = SessionFile::open(m_path, SessionFile::Access::ReadOnly);
            QVERIFY2(file, qPrintable(file ? QString() : file.error().arguments.join(u' ')));
            QCOMPARE((*file)->contents().rows.size(), test::manyEdits().size() + 2);
            QVERIFY(!(*file)->readDelta(5)->empty());
        }
        Opened opened;
        QCOMPARE(openSession(opened, m_path).error().code, ErrorCode::FileUnwritable);
        reference::ReferenceEngine engine;
        const auto created = EditSession::create(
            engine, test::smallStudy(), {.file = m_folder->filePath(QStringLiteral("b.burin"))});
        QVERIFY(!created);
        QCOMPARE(created.error().code, ErrorCode::FileUnwritable);
        const auto viewed = EditSession::view(
            engine, test::smallStudy(), m_path, QStringLiteral("its folder cannot be written"));
        QVERIFY(viewed);
        QVERIFY((*viewed)->goTo(3));
        QVERIFY((*viewed)->settle());
        QCOMPARE((*viewed)->apply(test::drillAt(0)).error().code, ErrorCode::SessionReadOnly);
        QCOMPARE(test::fingerprint(m_path), before);
        QCOMPARE(filesIn(*m_folder), QStringList{QStringLiteral("a.burin")});
    }
};

BURIN_TEST(SessionFileTest)

} // namespace sessionFileTest

#include "SessionFileTest.moc"
