// SPDX-License-Identifier: Apache-2.0
#include "core/base/OnMainThread.h"
#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <functional>
#include <memory>
#include <thread>

namespace onMainThreadTest {

using namespace core;

/// What another thread answers is told on the first one.
class OnMainThreadTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void answersAreToldOnTheFirstThread();
    void withoutItsContextNothingIsTold();
};

void OnMainThreadTest::answersAreToldOnTheFirstThread()
{
    QString told;
    std::thread::id where;
    const std::function<void(const Result<QString>&, int)> tell =
        onMainThread(this, [&](const Result<QString>& answer, int number) {
            told = *answer + QString::number(number);
            where = std::this_thread::get_id();
        });
    TaskThread thread;
    thread.run([&tell] { tell(QStringLiteral("answer "), 7); });
    QVERIFY(told.isEmpty());
    QTRY_COMPARE(told, QStringLiteral("answer 7"));
    QCOMPARE(where, std::this_thread::get_id());
}

void OnMainThreadTest::withoutItsContextNothingIsTold()
{
    bool told = false;
    auto context = std::make_unique<QObject>();
    const auto tell = onMainThread(context.get(), [&told] { told = true; });
    TaskThread thread;
    thread.run([&tell] { tell(); });
    context.reset();
    thread.run([&tell] { tell(); });
    QCoreApplication::processEvents();
    QVERIFY(!told);
}

BURIN_TEST(OnMainThreadTest)

} // namespace onMainThreadTest

#include "OnMainThreadTest.moc"
