// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTest>

/// Each folder of tests is one program; each class of tests in it runs in a process of its own:
///     core_session_test ChunksTest [FUNCTION[:ROW]…] [options of Qt Test]
/// Without a name the program prints the names it knows. A source ends with one of the macros
/// below, in place of Qt Test's own main functions.

namespace test {

/// Runs one class of tests, like main(); @p argv lacks the name of the class.
using TestRun = int (*)(int argc, char** argv);

/// Makes a class known to the program that its source is linked into, before main().
/// @p name is kept as it is: a literal.
struct RegisteredTest {
    RegisteredTest(const char* name, TestRun run);
};

/// A QApplication on an X server of its own, so that window tests neither wait for each other nor
/// steal each other's keyboard focus. BURIN_TEST_DISPLAY=inherit shows the windows on the present
/// display.
class WindowApplication {
public:
    WindowApplication(int& argc, char** argv);
    ~WindowApplication();
    WindowApplication(const WindowApplication&) = delete;
    WindowApplication& operator=(const WindowApplication&) = delete;

private:
    struct Parts;
    Parts* m_parts;
};

/// Starts no Qt application: the class needs neither events nor paths.
struct NoApplication {
    NoApplication(int&, char**) { }
};

/// As QTest::qExec(); a crash ends the process at once, with its stack on stderr. (Qt Test's own
/// handler forks a debugger, and can hang in a process whose heap is broken.)
int execute(QObject& test, int argc, char** argv);

template <typename Test, typename Application> int runTest(int argc, char** argv)
{
    const Application application(argc, argv);
    Test test;
    return execute(test, argc, argv);
}

} // namespace test

/// The class is run by @p run: int run(int argc, char** argv).
#define BURIN_TEST_RUN(Class, run)                                                                 \
    static const ::test::RegisteredTest registered##Class(#Class, run);

/// The class needs an event loop at most.
#define BURIN_TEST(Class) BURIN_TEST_RUN(Class, (&::test::runTest<Class, QCoreApplication>))
/// The class needs windows.
#define BURIN_WINDOW_TEST(Class)                                                                   \
    BURIN_TEST_RUN(Class, (&::test::runTest<Class, ::test::WindowApplication>))
/// The class needs no Qt application.
#define BURIN_PLAIN_TEST(Class)                                                                    \
    BURIN_TEST_RUN(Class, (&::test::runTest<Class, ::test::NoApplication>))
