// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/FollowedFile.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace followedFileTest {

using core::FollowedFile;

class FollowedFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QString::fromUtf8(name)); }
    QString write(const char* name) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write("x") != 1)
            qFatal("cannot write %s", name);
        return file.fileName();
    }

private Q_SLOTS:
    void isFoundUnderEveryName()
    {
        const FollowedFile followed(write("a (deleted)"));
        QVERIFY(followed.isAt(path("a (deleted)")));
        QCOMPARE(followed.path(), path("a (deleted)"));
        QVERIFY(QFile::rename(path("a (deleted)"), path("ä b")));
        QVERIFY(!followed.isAt(path("a (deleted)")));
        QVERIFY(followed.isAt(path("ä b")));
        QCOMPARE(followed.path(), path("ä b"));
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("in")));
        QVERIFY(QFile::rename(path("ä b"), path("in/b")));
        QVERIFY(QFile::rename(path("in"), path("into")));
        QCOMPARE(followed.path(), path("into/b"));
        // Another one in its place is not it, and it is nowhere.
        QVERIFY(QFile::remove(path("into/b")));
        write("into/b");
        write("into/b (deleted)");
        QVERIFY(!followed.isAt(path("into/b")));
        QCOMPARE(followed.path(), QString());
    }

    void whatWasThrownAwayIsNowhere()
    {
        for (const char* place : {"Trash/files", ".Trash-1000/files", ".Trash/1000/files", "nfs"}) {
            const FollowedFile followed(write("a"));
            QVERIFY(QDir(m_folder.path()).mkpath(QLatin1String(place)));
            const QString thrown = path(place) + QStringLiteral("/.nfs0001");
            const QString kept = path(place) + QStringLiteral("/a");
            QVERIFY(QFile::rename(path("a"), kept));
            QCOMPARE(followed.path(), qstrcmp(place, "nfs") == 0 ? kept : QString());
            QVERIFY(QFile::rename(kept, thrown));
            QCOMPARE(followed.path(), QString());
            QVERIFY(followed.isAt(thrown));
        }
    }

    void nothingIsEverywhere()
    {
        for (const FollowedFile& followed : {FollowedFile(), FollowedFile(path("none"))}) {
            QVERIFY(followed.isAt(path("none")));
            QCOMPARE(followed.path(), QString());
        }
    }

    /// SQLite's locks are such: closing any other descriptor of the file would drop them.
    void locksStay()
    {
        const QByteArray name = QFile::encodeName(write("locked"));
        const int locked = ::open(name.constData(), O_RDWR | O_CLOEXEC);
        struct flock lock { };
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        QCOMPARE(::fcntl(locked, F_SETLK, &lock), 0);
        {
            FollowedFile followed(path("locked"));
            followed = FollowedFile(path("locked"));
            QVERIFY(followed.isAt(path("locked")));
            QCOMPARE(followed.path(), path("locked"));
        }
        const pid_t child = ::fork();
        if (child == 0) {
            // Only another process is told of the locks of this one.
            struct flock asked = lock;
            const bool isLocked = ::fcntl(locked, F_GETLK, &asked) == 0 && asked.l_type == F_WRLCK;
            ::_exit(isLocked ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
        ::close(locked);
    }
};

BURIN_TEST(FollowedFileTest)

} // namespace followedFileTest

#include "FollowedFileTest.moc"
