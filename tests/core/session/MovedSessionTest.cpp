// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include <sys/stat.h>
#include <unistd.h>

namespace movedSessionTest {

using namespace core;

/// What file managers, synchronising services and other people do to the file of a session that is
/// open: every step that was told to be on disk is there, in a file that opens, under a name that
/// the user was told.
class MovedSessionTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;
    reference::ReferenceEngine m_engine;
    std::unique_ptr<EditSession> m_session;
    std::vector<Error> m_told;

    QString path(const QString& name) const { return m_folder->filePath(name); }
    QString original() const { return path(QStringLiteral("in/a.burin")); }
    /// Everything below the folder, as a shell lists it.
    QStringList files() const
    {
        QStringList all;
        QDirIterator found(
            m_folder->path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (found.hasNext())
            all += QDir(m_folder->path()).relativeFilePath(found.next());
        all.sort();
        return all;
    }
    QString writtenNow() const
    {
        const Result<void> settled = m_session->settle();
        return settled ? QString() : settled.error().arguments.join(u' ');
    }
    /// The rows of a file, as another program reads it that has nothing but what is on disk now.
    std::size_t rowsOnDisk(const QString& file) const
    {
        const QTemporaryDir elsewhere;
        const QString copy = elsewhere.filePath(QStringLiteral("copy.burin"));
        // Not by this process, which would give up SQLite's locks.
        for (const char* part : {"", "-wal"}) {
            if (QFile::exists(file + QLatin1String(part)))
                QProcess::execute(
                    QStringLiteral("cp"), {file + QLatin1String(part), copy + QLatin1String(part)});
        }
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, test::smallStudy(), copy);
        return session ? (*session)->history().rows().size() : 0;
    }
    static void renameTo(const QString& from, const QString& to)
    {
        QDir().mkpath(QFileInfo(to).absolutePath());
        if (std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData())
            != 0)
            qFatal("cannot rename %s", qPrintable(from));
    }
    /// Another session comes to lie under the name.
    void replace(const QString& file) const
    {
        if (!QFile::copy(path(QStringLiteral("other.burin")), file + QStringLiteral(".new")))
            qFatal("cannot copy");
        renameTo(file + QStringLiteral(".new"), file);
    }
    static void write(const QString& file)
    {
        QFile stray(file);
        if (!stray.open(QIODevice::WriteOnly) || stray.write(QByteArray(4096, 'x')) != 4096)
            qFatal("cannot write %s", qPrintable(file));
    }
    void happens(const QString& event)
    {
        const QString a = original();
        if (event == QLatin1String("renamed"))
            renameTo(a, path(QStringLiteral("in/b.burin")));
        else if (event == QLatin1String("renamed twice")) {
            renameTo(a, path(QStringLiteral("in/x.burin")));
            renameTo(path(QStringLiteral("in/x.burin")), path(QStringLiteral("in/b.burin")));
        } else if (event == QLatin1String("put into the trash"))
            renameTo(a, path(QStringLiteral("Trash/files/a.burin")));
        else if (event == QLatin1String("renamed beside a stray log")) {
            // What a program that was killed left of another session of that name.
            renameTo(a, path(QStringLiteral("in/b.burin")));
            write(path(QStringLiteral("in/b.burin-wal")));
        } else if (event == QLatin1String("replaced, with a stray journal")) {
            replace(a);
            write(path(QStringLiteral("in/a (2).burin-journal")));
        } else if (event == QLatin1String("moved"))
            renameTo(a, path(QStringLiteral("out/a.burin")));
        else if (event == QLatin1String("folder renamed"))
            renameTo(path(QStringLiteral("in")), path(QStringLiteral("out")));
        else if (event == QLatin1String("deleted"))
            QVERIFY(QFile::remove(a));
        else if (event == QLatin1String("deleted with all parts")) {
            QVERIFY(QFile::remove(a));
            QVERIFY(QFile::remove(a + QStringLiteral("-wal")));
        } else if (event == QLatin1String("replaced"))
            replace(a);
        else if (event == QLatin1String("renamed and replaced")) {
            renameTo(a, path(QStringLiteral("in/b.burin")));
            replace(a);
        } else
            qFatal("what?");
    }

private Q_SLOTS:
    void init()
    {
        m_folder.emplace();
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("in")));
        QVERIFY(!test::makeSession(path(QStringLiteral("other.burin"))).isEmpty());
        m_told.clear();
        m_session = *EditSession::create(m_engine, test::smallStudy(), {.file = original()});
        m_session->setErrorListener([this](const Error& error) { m_told.push_back(error); });
        QVERIFY(m_session->apply(test::drillAt(3)));
        QCOMPARE(writtenNow(), QString());
    }
    void cleanup() { m_session.reset(); }

    void nothingIsLost_data()
    {
        QTest::addColumn<QString>("event");
        QTest::addColumn<QString>("now"); ///< the session's file
        QTest::addColumn<bool>("anotherStep");
        const std::vector<std::pair<const char*, const char*>> events{{"renamed", "in/b.burin"},
            {"renamed twice", "in/b.burin"}, {"moved", "out/a.burin"},
            {"folder renamed", "out/a.burin"}, {"deleted", "in/a.burin"},
            {"deleted with all parts", "in/a.burin"}, {"replaced", "in/a (2).burin"},
            {"renamed and replaced", "in/b.burin"}, {"put into the trash", "in/a.burin"},
            {"renamed beside a stray log", "in/a.burin"},
            {"replaced, with a stray journal", "in/a (3).burin"}};
        for (const auto& [event, now] : events) {
            for (const bool anotherStep : {true, false})
                QTest::addRow("%s, %s", event, anotherStep ? "then a step" : "then closed")
                    << QString::fromLatin1(event) << QString::fromLatin1(now) << anotherStep;
        }
    }
    void nothingIsLost()
    {
        QFETCH(QString, event);
        QFETCH(QString, now);
        QFETCH(bool, anotherStep);
        happens(event);
        if (anotherStep) {
            QVERIFY(m_session->apply(test::drillAt(5)));
            QCOMPARE(writtenNow(), QString());
            QCOMPARE(m_session->file(), path(now));
            QCOMPARE(rowsOnDisk(path(now)), std::size_t(2));
            QCOMPARE(m_told.size(), std::size_t(1));
            QCOMPARE(m_told.front().code, ErrorCode::SessionMoved);
            QCOMPARE(m_told.front().arguments.value(0), path(now));
            QVERIFY(m_told.front().arguments.value(1).contains(QStringLiteral("another program")));
            // And on, as if nothing had been.
            QVERIFY(m_session->apply(test::drillAt(-3)));
            QCOMPARE(writtenNow(), QString());
            QVERIFY(m_session->goTo(0));
            QVERIFY(m_session->goTo(3));
            QCOMPARE(writtenNow(), QString());
            QCOMPARE(m_told.size(), std::size_t(1));
        }
        const QByteArray hash = m_session->stateHash();
        m_session.reset();

        QStringList expected{QStringLiteral("other.burin"), now};
        if (event.contains(QLatin1String("replaced"))) {
            expected += QStringLiteral("in/a.burin");
            QCOMPARE(test::bytesOf(original()), test::bytesOf(path(QStringLiteral("other.burin"))));
        }
        if (event.contains(QLatin1String("trash")))
            expected += QStringLiteral("Trash/files/a.burin");
        if (event.contains(QLatin1String("stray log")))
            expected += {QStringLiteral("in/b.burin"), QStringLiteral("in/b.burin-wal")};
        if (event.contains(QLatin1String("stray journal")))
            expected += QStringLiteral("in/a (2).burin-journal");
        expected.sort();
        QCOMPARE(files(), expected);
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), path(now));
        QVERIFY2(opened, qPrintable(opened ? QString() : opened.error().arguments.join(u' ')));
        QCOMPARE((*opened)->history().rows().size(), std::size_t(anotherStep ? 3 : 1));
        QCOMPARE((*opened)->stateHash(), hash);
    }

    /// Closed on a disk that takes nothing, with steps that are not in the file itself.
    void whatLiesBesideItGoesWithIt_data()
    {
        QTest::addColumn<QString>("now"); ///< the session's file
        QTest::newRow("renamed") << QStringLiteral("in/b.burin");
        QTest::newRow("moved") << QStringLiteral("out/a.burin");
        QTest::newRow("renamed and replaced") << QStringLiteral("in/b.burin");
        QTest::newRow("folder renamed") << QStringLiteral("out/a.burin");
    }
    void whatLiesBesideItGoesWithIt()
    {
        QFETCH(QString, now);
        const QString event = QLatin1String(QTest::currentDataTag());
        const QByteArray hash = m_session->stateHash();
        happens(event);
        {
            const test::FileSizeLimit limit(1);
            m_session.reset();
        }
        QStringList expected{QStringLiteral("other.burin"), now, now + QStringLiteral("-wal")};
        if (event.contains(QLatin1String("replaced")))
            expected += QStringLiteral("in/a.burin");
        expected.sort();
        QCOMPARE(files(), expected);
        {
            reference::ReferenceEngine engine;
            const auto opened = EditSession::open(engine, test::smallStudy(), path(now));
            QVERIFY2(opened, qPrintable(opened ? QString() : opened.error().arguments.join(u' ')));
            QCOMPARE((*opened)->history().rows().size(), std::size_t(1));
            QCOMPARE((*opened)->stateHash(), hash);
        }
        expected.removeOne(now + QStringLiteral("-wal"));
        QCOMPARE(files(), expected);
    }

    /// What lies beside a session that nobody finds any more, or to which it cannot go, is not
    /// taken for another one's.
    void whatHasItsNameNowStaysWhole_data()
    {
        QTest::addColumn<QString>("event");
        QTest::addColumn<QString>("stray"); ///< what others have left
        QTest::addColumn<QString>("left"); ///< what lay beside the session
        QTest::newRow("once") << QStringLiteral("replaced") << QString()
                              << QStringLiteral("in/a.burin-wal.left");
        QTest::newRow("twice") << QStringLiteral("replaced")
                               << QStringLiteral("in/a.burin-wal.left")
                               << QStringLiteral("in/a.burin-wal.left2");
        QTest::newRow("its new name is taken")
            << QStringLiteral("renamed and replaced") << QStringLiteral("in/b.burin-wal")
            << QStringLiteral("in/a.burin-wal.left");
    }
    void whatHasItsNameNowStaysWhole()
    {
        QFETCH(QString, event);
        QFETCH(QString, stray);
        QFETCH(QString, left);
        if (!stray.isEmpty())
            write(path(stray));
        happens(event);
        {
            const test::FileSizeLimit limit(1);
            m_session.reset();
        }
        QCOMPARE(strayPartOf(original()), QString());
        QVERIFY2(QFile::exists(path(left)), qPrintable(files().join(u' ')));
        if (!stray.isEmpty())
            QCOMPARE(test::bytesOf(path(stray)), QByteArray(4096, 'x'));
        const auto contents = checkSession(original());
        QVERIFY(contents && contents->isWhole() && contents->leftOpen.isEmpty());
        QCOMPARE(test::bytesOf(original()), test::bytesOf(path(QStringLiteral("other.burin"))));
        // Who opens that one is told whose it is.
        for (const QString& each : files().filter(QStringLiteral("-wal.left")))
            QVERIFY2(contents->leftBeside.contains(QFileInfo(path(each)).canonicalFilePath()),
                qPrintable(contents->leftBeside));
    }

    /// Its own file was replaced, and still has another name: what was left is told with it, and
    /// read as it is told.
    void whatWasLeftIsFoundAgain()
    {
        const QByteArray hash = m_session->stateHash();
        const QString again = path(QStringLiteral("in/again.burin"));
        QVERIFY(
            ::link(QFile::encodeName(original()).constData(), QFile::encodeName(again).constData())
            == 0);
        happens(QStringLiteral("replaced"));
        {
            const test::FileSizeLimit limit(1);
            m_session.reset();
        }
        const QString left =
            QFileInfo(path(QStringLiteral("in/a.burin-wal.left"))).canonicalFilePath();
        QVERIFY(!left.isEmpty());
        const auto contents = checkSession(again);
        QVERIFY(contents);
        QVERIFY2(contents->leftOpen.contains(left), qPrintable(contents->leftOpen));
        QVERIFY(contents->leftOpen.contains(QStringLiteral("is named 'again.burin-wal'")));
        QCOMPARE(contents->leftBeside.english(), QString());
        const QString copy = path(QStringLiteral("copies/again.burin"));
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("copies")));
        QVERIFY(QFile::copy(again, copy) && QFile::copy(left, copy + QStringLiteral("-wal")));
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), copy);
        QVERIFY2(opened, qPrintable(opened ? QString() : opened.error().arguments.join(u' ')));
        QCOMPARE((*opened)->history().rows().size(), std::size_t(1));
        QCOMPARE((*opened)->stateHash(), hash);
    }

    /// Without a place it waits in memory, and is written when there is one.
    void withoutAFolderItWaits()
    {
        QVERIFY(QDir(path(QStringLiteral("in"))).removeRecursively());
        QVERIFY(m_session->apply(test::drillAt(5)));
        QVERIFY(!m_session->settle());
        const std::optional<Error> trouble = m_session->storage().trouble();
        QVERIFY(trouble);
        QCOMPARE(trouble->arguments.value(0), original());
        QVERIFY2(trouble->arguments.value(1).contains(QStringLiteral("another program deleted")),
            qPrintable(trouble->arguments.value(1)));
        QVERIFY(trouble->arguments.value(1).contains(QStringLiteral("does not exist")));
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("in")));
        m_session->storage().retryWriting();
        QCOMPARE(writtenNow(), QString());
        QVERIFY(!m_session->storage().trouble());
        QCOMPARE(rowsOnDisk(original()), std::size_t(2));
        // Or where the user says.
        QVERIFY(QDir(path(QStringLiteral("in"))).removeRecursively());
        QVERIFY(m_session->apply(test::drillAt(-3)));
        QVERIFY(!m_session->settle());
        const QString elsewhere = path(QStringLiteral("c.burin"));
        std::promise<Result<void>> saved;
        m_session->storage().saveAs(
            elsewhere, false, [&saved](const Result<void>& done) { saved.set_value(done); });
        QVERIFY(saved.get_future().get());
        QCOMPARE(writtenNow(), QString());
        QCOMPARE(m_session->file(), elsewhere);
        m_session.reset();
        QCOMPARE(rowsOnDisk(elsewhere), std::size_t(3));
        QCOMPARE(files(), QStringList({QStringLiteral("c.burin"), QStringLiteral("other.burin")}));
    }

    /// Moved to where it cannot be written, it is written anew where it was.
    void whereNothingCanBeWrittenItDoesNotGo()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("archive")));
        const QString archived = path(QStringLiteral("archive/a.burin"));
        renameTo(original(), archived);
        constexpr mode_t all = 0777;
        constexpr mode_t reading = 0444;
        for (const QString& each : {m_folder->path(), path(QStringLiteral("in"))})
            QVERIFY(::chmod(QFile::encodeName(each).constData(), all) == 0);
        QVERIFY(::chmod(QFile::encodeName(archived).constData(), reading) == 0);
        {
            const test::Unprivileged nobody;
            QVERIFY(m_session->apply(test::drillAt(5)));
            QCOMPARE(writtenNow(), QString());
        }
        QCOMPARE(m_session->file(), original());
        QCOMPARE(rowsOnDisk(original()), std::size_t(2));
    }

    void namesAreTakenAsTheyAre()
    {
        const QString odd = path(QStringLiteral("in/50%2 %1.burin"));
        renameTo(original(), odd);
        QVERIFY(m_session->apply(test::drillAt(5)));
        QCOMPARE(writtenNow(), QString());
        QCOMPARE(m_session->file(), odd);
        replace(odd);
        QVERIFY(m_session->apply(test::drillAt(-3)));
        QCOMPARE(writtenNow(), QString());
        QCOMPARE(m_session->file(), path(QStringLiteral("in/50%2 %1 (2).burin")));
        QCOMPARE(rowsOnDisk(m_session->file()), std::size_t(3));
    }

    /// Saved over itself after somebody deleted it.
    void aDeletedOneIsSavedOverItself()
    {
        QVERIFY(QFile::remove(original()));
        std::promise<Result<void>> saved;
        m_session->storage().saveAs(
            original(), true, [&saved](const Result<void>& done) { saved.set_value(done); });
        QVERIFY(saved.get_future().get());
        QVERIFY(m_session->apply(test::drillAt(5)));
        QCOMPARE(writtenNow(), QString());
        QCOMPARE(rowsOnDisk(original()), std::size_t(2));
    }
};

BURIN_TEST(MovedSessionTest)

} // namespace movedSessionTest

#include "MovedSessionTest.moc"
