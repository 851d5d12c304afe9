// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SessionUse.h"

#include "core/sessionfile/SessionFile.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <memory>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

namespace sessionUseTest {

using namespace core;

namespace {

/// Whether SQLite holds its locks on a file, as another process sees them. Looking gives them up.
bool isLocked(const QString& path)
{
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0)
        qFatal("cannot open %s", qPrintable(path));
    struct flock lock { };
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = 0x40000000;
    lock.l_len = 512;
    const bool locked = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    ::close(descriptor);
    return locked;
}

} // namespace

/// A session that this process writes is in use under each of its names, and looking whether it is
/// does not give up the locks that SQLite holds on it.
class SessionUseTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;
    std::unique_ptr<SessionFile> m_file;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    void isInUse(const QString& name) const
    {
        QVERIFY2(isSessionInUse(name), qPrintable(name));
        QVERIFY2(isSessionFile(name), qPrintable(name));
        QVERIFY(sessionLoss(name).leftOpen.isEmpty());
        for (const auto access : {SessionAccess::ReadWrite, SessionAccess::PrivateCopy}) {
            const auto opened = SessionFile::open(name, access);
            QVERIFY2(!opened, qPrintable(name));
            QCOMPARE(opened.error().code, ErrorCode::FileUnreadable);
        }
        QVERIFY(!copySession(name, path("copy.burin")));
        QVERIFY(!QFile::exists(path("copy.burin")));
    }

private Q_SLOTS:
    void init()
    {
        m_folder.emplace();
        QVERIFY(!test::makeSession(path("a.burin")).isEmpty());
        m_file = *SessionFile::open(path("a.burin"), SessionAccess::ReadWrite);
    }
    void cleanup() { m_file.reset(); }

    void underEachOfItsNames()
    {
        QVERIFY(QFile::link(path("a.burin"), path("link.burin")));
        QVERIFY(::link(QFile::encodeName(path("a.burin")).constData(),
                    QFile::encodeName(path("second.burin")).constData())
            == 0);
        for (const char* name : {"a.burin", "link.burin", "second.burin"})
            isInUse(path(name));
        QVERIFY(isLocked(path("second.burin")));
        m_file.reset();
        for (const char* name : {"a.burin", "link.burin", "second.burin"})
            QVERIFY2(!isSessionInUse(path(name)), name);
    }

    void underTheNameThatAnotherProgramGaveIt()
    {
        QVERIFY(!test::makeSession(path("other.burin")).isEmpty());
        QVERIFY(std::rename(QFile::encodeName(path("a.burin")).constData(),
                    QFile::encodeName(path("b.burin")).constData())
            == 0);
        isInUse(path("b.burin"));
        QVERIFY(isLocked(path("b.burin")));
        // Its log is still here, and would be taken for that of whatever comes here.
        QVERIFY(QFile::rename(path("other.burin"), path("a.burin")));
        isInUse(path("a.burin"));
        m_file.reset();
        QVERIFY(!isSessionInUse(path("a.burin")));
        QVERIFY(!isSessionInUse(path("b.burin")));
    }

    /// What could neither be put into a session's file nor stay beside another one's.
    void whatIsLeftOfAnotherIsNamed()
    {
        m_file.reset();
        QVERIFY(sessionLoss(path("a.burin")).leftBeside.isEmpty());
        for (const int number : {1, 3}) {
            QFile left(leftLogName(path("a.burin"), number));
            QVERIFY(left.open(QIODevice::WriteOnly) && left.write("steps") == 5);
        }
        const SessionLoss loss = sessionLoss(path("a.burin"));
        for (const char* name : {"a.burin-wal.left'", "a.burin-wal.left3'"})
            QVERIFY2(loss.leftBeside.contains(QLatin1String(name)), qPrintable(loss.leftBeside));
        // It lacks nothing for that.
        QCOMPARE(loss.leftOpen.english(), QString());
        QCOMPARE(loss.cutOff.english(), QString());
        // Nor are others told.
        QVERIFY(!test::makeSession(path("b.burin")).isEmpty());
        QVERIFY(sessionLoss(path("b.burin")).leftBeside.isEmpty());
        QVERIFY(SessionFile::open(path("a.burin"), SessionAccess::ReadWrite));
        QVERIFY(QFile::exists(path("a.burin-wal.left3")));
    }
};

BURIN_TEST(SessionUseTest)

} // namespace sessionUseTest

#include "SessionUseTest.moc"
