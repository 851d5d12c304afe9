// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QProcess>
#include <QTest>

#include <thread>

namespace failingLogSelfTest {

/// The log must fail a test: this program runs its own functions again as a child and reads how
/// they ended.
class FailingLogSelfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void endsAsExpected_data();
    void endsAsExpected();

    void childWarning()
    {
        inChild([] { qWarning("from the child"); });
    }
    void childCritical()
    {
        inChild([] { qCritical("from the child"); });
    }
    void childWarningOfThread()
    {
        inChild([] { std::thread([] { qWarning("from a thread"); }).join(); });
    }
    void childAnnounced()
    {
        inChild([] {
            QTest::ignoreMessage(QtWarningMsg, "announced");
            qWarning("announced");
        });
    }
    void childQuiet()
    {
        inChild([] { qInfo("nothing wrong"); });
    }

private:
    template <class Body> void inChild(const Body& body)
    {
        if (!qEnvironmentVariableIsSet("BURIN_SELF_TEST_CHILD"))
            return;
        body();
    }
};

void FailingLogSelfTest::init()
{
    test::failOnUnexpectedMessages();
}

void FailingLogSelfTest::endsAsExpected_data()
{
    QTest::addColumn<QString>("function");
    QTest::addColumn<int>("failures");
    QTest::newRow("warning") << QStringLiteral("childWarning") << 1;
    QTest::newRow("critical") << QStringLiteral("childCritical") << 1;
    QTest::newRow("warning of a thread") << QStringLiteral("childWarningOfThread") << 1;
    QTest::newRow("announced") << QStringLiteral("childAnnounced") << 0;
    QTest::newRow("quiet") << QStringLiteral("childQuiet") << 0;
}

void FailingLogSelfTest::endsAsExpected()
{
    QFETCH(QString, function);
    QFETCH(int, failures);
    if (qEnvironmentVariableIsSet("BURIN_SELF_TEST_CHILD"))
        return;
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("BURIN_SELF_TEST_CHILD"), QStringLiteral("1"));
    child.setProcessEnvironment(environment);
    child.start(
        QCoreApplication::applicationFilePath(), {QStringLiteral("FailingLogSelfTest"), function});
    QVERIFY(child.waitForFinished());
    QCOMPARE(child.exitStatus(), QProcess::NormalExit);
    QCOMPARE(child.exitCode(), failures);
}

BURIN_TEST(FailingLogSelfTest)

} // namespace failingLogSelfTest

#include "FailingLogSelfTest.moc"
