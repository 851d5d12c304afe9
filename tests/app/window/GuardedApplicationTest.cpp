// SPDX-License-Identifier: Apache-2.0
#include "app/window/GuardedApplication.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>
#include <QTimer>

#include <cstdlib>
#include <new>
#include <optional>

namespace guardedApplicationTest {

namespace {

int argumentCount = 1;
char programName[] = "test";
char* programArguments[] = {programName, nullptr};

} // namespace

/// What is thrown while an event is handled is told to whoever can close what is open.
class GuardedApplicationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        m_application.emplace(argumentCount, programArguments);
    }
    void cleanupTestCase() { m_application.reset(); }

    void theRescueIsToldAndTheLoopGoesOn()
    {
        int told = 0;
        core::ErrorCode code = core::ErrorCode::Internal;
        m_application->setRescue([&](const core::Error& error) {
            ++told;
            code = error.code;
        });
        QTimer::singleShot(0, [] { throw std::bad_alloc(); });
        QTimer::singleShot(0, [] { throw std::bad_alloc(); });
        QTimer::singleShot(100, [] { QCoreApplication::exit(5); });
        QCOMPARE(QCoreApplication::exec(), 5);
        QCOMPARE(told, 1); // of both
        QCOMPARE(code, core::ErrorCode::OutOfMemory);
    }

    void whereThatThrowsTheProgramEnds()
    {
        m_application->setRescue([](const core::Error&) { throw std::bad_alloc(); });
        QTimer::singleShot(0, [] { throw std::bad_alloc(); });
        QTimer::singleShot(20000, [] { QCoreApplication::exit(5); });
        QCOMPARE(QCoreApplication::exec(), EXIT_FAILURE);
    }

    void whereThereIsNoneTheProgramEnds()
    {
        m_application->setRescue({});
        QTimer::singleShot(0, [] { throw std::bad_alloc(); });
        QTimer::singleShot(20000, [] { QCoreApplication::exit(5); });
        QCOMPARE(QCoreApplication::exec(), EXIT_FAILURE);
    }

private:
    std::optional<app::GuardedApplication> m_application;
};

BURIN_PLAIN_TEST(GuardedApplicationTest)

} // namespace guardedApplicationTest

#include "GuardedApplicationTest.moc"
