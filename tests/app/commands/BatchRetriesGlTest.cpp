// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyList.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTest>

#include <cerrno>
#include <memory>

namespace batchRetriesGlTest {

using test::FileFault;
using test::key;
using test::Outcome;

/// Which failures of a study `burin batch --retries` tries again, what the next batch does, and
/// what is said of the attempts.
class BatchRetriesGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    static constexpr int always = 1 << 30;

    std::unique_ptr<test::WatchedHome> m_home;

    [[nodiscard]] QString folder() const { return m_home->path(key("out")); }
    [[nodiscard]] Outcome batch(const QStringList& more, const FileFault& fault = {}) const
    {
        const QStringList words{key("batch"), path("recipe.json"), key("--studies"),
            path("studies.csv"), key("--into"), folder()};
        return m_home->burin(words + more, fault);
    }
    [[nodiscard]] QJsonObject record() const
    {
        return QJsonDocument::fromJson(test::bytesOf(folder() + key("/one/record.json"))).object();
    }
    /// What the table says of the study.
    [[nodiscard]] QString attemptsInTable() const
    {
        const auto rows = app::readTable(
            QString::fromUtf8(test::bytesOf(folder() + key("/results.csv"))), QLatin1Char(','));
        return rows && rows->size() == 2
            ? rows->back().value(rows->front().indexOf(key("attempts")))
            : QString();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
        m_home = std::make_unique<test::WatchedHome>();
        static_cast<void>(recipe("recipe.json",
            {{key("edits"), test::toJson({test::addSegment("A"), test::drillAt(0)})}}));
        QFile list(path("studies.csv"));
        QVERIFY(list.open(QIODevice::WriteOnly));
        list.write("study,name\n" + study().toUtf8() + ",one\n");
    }

    void whatMayPassIsTriedAgain_data()
    {
        QTest::addColumn<QByteArray>("calls");
        QTest::addColumn<int>("error");
        QTest::addColumn<int>("attempts");
        QTest::newRow("no room on the disk") << QByteArray("open") << ENOSPC << 2;
        QTest::newRow("no room for this user") << QByteArray("open") << EDQUOT << 2;
        QTest::newRow("no room for this user's session") << QByteArray("write") << EDQUOT << 2;
        QTest::newRow("no room, told when it is brought to the disk")
            << QByteArray("sync") << ENOSPC << 2;
        QTest::newRow("a defective disk") << QByteArray("sync") << EIO << 1;
        QTest::newRow("no permission") << QByteArray("open") << EACCES << 1;
    }
    void whatMayPassIsTriedAgain()
    {
        QFETCH(QByteArray, calls);
        QFETCH(int, error);
        QFETCH(int, attempts);
        // The run of the study can open no file, or write into none.
        const Outcome failed = batch({key("--retries"), key("1")},
            {.under = folder(),
                .calls = calls,
                .first = 1,
                .last = always,
                .error = error,
                .of = "run"});
        QCOMPARE(failed.status, 1);
        QCOMPARE(record()[key("state")].toString(), key("failed"));
        QCOMPARE(record()[key("attempts")].toInt(), attempts);
        QCOMPARE(attemptsInTable(), QString::number(attempts));

        // The next batch tries it, whatever it was.
        const Outcome next = batch({});
        QVERIFY2(next.status == 0, qPrintable(next.complaint));
        QCOMPARE(record()[key("state")].toString(), key("done"));
        QCOMPARE(record()[key("attempts")].toInt(), 1);
        QCOMPARE(attemptsInTable(), QString::number(attempts + 1));
    }

    /// The disk fails for good, from one of the last calls on.
    void aSessionThatWasNotClosedIsTriedAgain()
    {
        QVERIFY(QDir().mkpath(folder()));
        static_cast<void>(m_home->events());
        const Outcome counted = batch({}, {.under = folder(), .of = "run"});
        QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
        int calls = 0;
        for (const test::FileEvent& event : m_home->events())
            calls += event.what == "counts" ? 1 : 0;
        QVERIFY(calls > 0);
        bool isLeftOpen = false;
        for (int back = 0; back < calls && !isLeftOpen; ++back) {
            QVERIFY(QDir(folder()).removeRecursively());
            const Outcome outcome = batch({key("--retries"), key("1")},
                {.under = folder(),
                    .first = calls - back,
                    .last = always,
                    .error = EIO,
                    .of = "run"});
            isLeftOpen = outcome.complaint.contains(key("could not be closed as one file"))
                || outcome.complaint.contains(key("it was not closed"));
        }
        QVERIFY(isLeftOpen);
        QCOMPARE(record()[key("state")].toString(), key("failed"));
        QCOMPARE(record()[key("attempts")].toInt(), 2);
        const Outcome next = batch({});
        QVERIFY2(next.status == 0, qPrintable(next.complaint));
        QCOMPARE(attemptsInTable(), QString::number(3));
    }
};

BURIN_TEST(BatchRetriesGlTest)

} // namespace batchRetriesGlTest

#include "BatchRetriesGlTest.moc"
