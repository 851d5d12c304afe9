// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SideTask.h"

#include "core/session/state/SessionState.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <future>
#include <new>

namespace sideTaskTest {

using namespace core;

/// Work on the side thread that is given up before it comes back, comes back, or throws.
class SideTaskTest : public QObject {
    Q_OBJECT

    reference::ReferenceEngine m_engine;
    SessionState m_state{m_engine, test::smallStudy().volume};
    SideThread m_side{{}};
    SideTask m_task;
    QStringList m_said;

    void take()
    {
        m_side.finish();
        for (const SideThread::Sequel& sequel : m_side.collect())
            sequel(m_state);
    }
    void giveUp()
    {
        m_task.giveUp([this] { m_said += QStringLiteral("instead"); });
    }

private Q_SLOTS:
    void init() { m_said.clear(); }

    void whatComesBack_data()
    {
        QTest::addColumn<bool>("throws");
        QTest::addColumn<bool>("givenUp");
        QTest::addColumn<QString>("said");
        QTest::newRow("it comes back") << false << false << QStringLiteral("then");
        QTest::newRow("it throws") << true << false << QStringLiteral("failed");
        QTest::newRow("given up, it comes back") << false << true << QStringLiteral("instead");
        QTest::newRow("given up, it throws") << true << true << QStringLiteral("instead");
    }
    void whatComesBack()
    {
        QFETCH(const bool, throws);
        QFETCH(const bool, givenUp);
        QFETCH(const QString, said);
        std::promise<void> gate;
        m_task.post(
            m_side,
            [this, throws, open = gate.get_future().share()] {
                open.wait();
                if (throws)
                    throw std::bad_alloc();
                return SideThread::Sequel(
                    [this](SessionState&) { m_said += QStringLiteral("then"); });
            },
            [this](SessionState&, const Error&) { m_said += QStringLiteral("failed"); });
        QVERIFY(m_task.isAway());
        if (givenUp)
            giveUp();
        QCOMPARE(m_said, QStringList());
        gate.set_value();
        take();
        QCOMPARE(m_said, QStringList{said});
        QVERIFY(!m_task.isAway());

        // What was given up once is no matter of what is asked next.
        m_task.post(
            m_side,
            [this] {
                return SideThread::Sequel(
                    [this](SessionState&) { m_said += QStringLiteral("next"); });
            },
            [](SessionState&, const Error&) {});
        take();
        QCOMPARE(m_said, QStringList({said, QStringLiteral("next")}));
    }

    void whereNothingIsAwayItIsGivenUpAtOnce()
    {
        giveUp();
        QCOMPARE(m_said, QStringList{QStringLiteral("instead")});
    }
};

BURIN_TEST(SideTaskTest)

} // namespace sideTaskTest

#include "SideTaskTest.moc"
