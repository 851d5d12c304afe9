// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"

#include <QProcess>
#include <QTest>

#include <csignal>
#include <cstdlib>

namespace crashingTestSelfTest {

namespace {

constexpr const char* howToCrash = "BURIN_HOW_TO_CRASH";

} // namespace

/// What crashes: only CrashingTestSelfTest tells it to.
class TestThatCrashes : public QObject {
    Q_OBJECT

    /// The allocator notices, inside of which nobody may ask for memory.
    static void breakTheHeap()
    {
        constexpr std::size_t bytes = 64;
        // Volatile, so that the compiler leaves all of it in.
        void* volatile memory = std::malloc(bytes);
        std::free(memory);
        std::free(memory);
    }

private Q_SLOTS:
    void crashes()
    {
        const QByteArray how = qgetenv(howToCrash);
        if (how.isEmpty())
            QSKIP("CrashingTestSelfTest starts it");
        if (how == "heap")
            breakTheHeap();
        else if (how == "abort")
            std::abort();
        else if (how == "fatal")
            qFatal("told so");
        else
            std::raise(SIGSEGV);
    }
};

/// A test that crashes ends at once and says where: Qt's own handler starts a debugger, for which a
/// broken heap waits for ever.
class CrashingTestSelfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void endsWithItsStack_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("heap") << SIGABRT;
        QTest::newRow("abort") << SIGABRT;
        QTest::newRow("fatal") << SIGABRT;
        QTest::newRow("memory") << SIGSEGV;
    }
    void endsWithItsStack()
    {
        QFETCH(int, signal);
        if (test::underSanitizer)
            QSKIP("the sanitizer tells the stack itself");
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(howToCrash), QLatin1String(QTest::currentDataTag()));
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("TestThatCrashes")});
        // One that hangs is seen by that alone.
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitStatus(), QProcess::CrashExit);
        QCOMPARE(process.exitCode(), signal);
        const QList<QByteArray> said = process.readAllStandardError().split('\n');
        const qsizetype stack =
            said.indexOf("The test crashed; its stack (addr2line -Cfpe tells the lines):");
        QVERIFY(stack >= 0);
        // The program's own frames are among them, with their addresses.
        const QByteArray program = QCoreApplication::applicationFilePath().toUtf8();
        QVERIFY(said.size() - stack > 4);
        qsizetype own = 0;
        for (const QByteArray& line : said.mid(stack))
            own += line.startsWith(program) && line.contains("(+0x") ? 1 : 0;
        QVERIFY2(own >= 3, said.mid(stack).join('\n').constData());
    }
};

BURIN_TEST(TestThatCrashes)
BURIN_TEST(CrashingTestSelfTest)

} // namespace crashingTestSelfTest

#include "CrashingTestSelfTest.moc"
