// SPDX-License-Identifier: Apache-2.0
#include "app/end/EndNote.h"
#include "app/end/SuddenEnd.h"
#include "core/base/MemoryReserve.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace endNoteTest {

namespace {

void endNobodyCatches(const std::function<void()>& work) noexcept
{
    work();
}

/// What becomes of a process that has a note and does @p work. @return as waitpid() has it
int inChild(const std::function<void()>& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
        app::watchForSuddenEnd();
        const app::EndNote note;
        endNobodyCatches(work);
        ::_exit(7);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

} // namespace

/// How a window ended that was not closed: it ends in an orderly way where that can be had, and the
/// next one knows why.
class EndNoteTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("XDG_STATE_HOME", m_folder.path().toUtf8()); }

    void whatIsClosedOrOpenIsNotTold()
    {
        {
            const app::EndNote open;
            QCOMPARE(notes().size(), 1);
            QVERIFY(app::EndNote::takeEarlier().isEmpty());
            QCOMPARE(notes().size(), 1);
        }
        QVERIFY(notes().isEmpty());
        QVERIFY(app::EndNote::takeEarlier().isEmpty());
    }

    void whatIsNotCaughtIsToldOnce_data()
    {
        QTest::addColumn<int>("way");
        QTest::addColumn<bool>("orderly");
        QTest::addColumn<QString>("told");
        const QString memory = QStringLiteral("not enough memory");
        QTest::newRow("bad_alloc that nobody catches") << 0 << true << memory;
        QTest::newRow("a library that gives up") << 1 << true << memory;
        QTest::newRow("a library that looks at nothing") << 2 << true << memory;
        QTest::newRow("an error of the program") << 3 << false << QStringLiteral("crashed");
        QTest::newRow("killed") << 4 << false << QStringLiteral("from outside");
    }

    void whatIsNotCaughtIsToldOnce()
    {
        QFETCH(int, way);
        QFETCH(bool, orderly);
        QFETCH(QString, told);
        const int status = inChild([way] {
            switch (way) {
            case 0:
                throw std::bad_alloc();
            case 1:
                core::giveUpMemoryReserve();
                std::abort();
            case 2:
                core::giveUpMemoryReserve();
                std::raise(SIGSEGV);
                break;
            case 3:
                std::abort();
            default:
                ::kill(::getpid(), SIGKILL);
            }
        });
        QCOMPARE(bool(WIFEXITED(status)), orderly);
        if (orderly)
            QCOMPARE(WEXITSTATUS(status), EXIT_FAILURE);
        const QString earlier = app::EndNote::takeEarlier();
        QVERIFY2(earlier.contains(told), qPrintable(earlier));
        QVERIFY(app::EndNote::takeEarlier().isEmpty());
        QVERIFY(notes().isEmpty());
    }

private:
    [[nodiscard]] QStringList notes() const
    {
        return QDir(m_folder.filePath(QStringLiteral("burin/windows"))).entryList(QDir::Files);
    }

    QTemporaryDir m_folder;
};

BURIN_TEST(EndNoteTest)

} // namespace endNoteTest

#include "EndNoteTest.moc"
