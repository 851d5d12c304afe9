// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/BurinProgram.h"

#include <QTemporaryDir>
#include <QTest>

namespace libraryMemoryTest {

/// A library gets no memory once while a study is read, for instance as it loads its tables under a
/// lock: nothing waits for that lock ever after.
class LibraryMemoryTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }
    /// @param which of the allocations of libraries is refused; 0: none, they are counted
    [[nodiscard]] test::Outcome readAStudy(qlonglong which) const
    {
        test::Surroundings around;
        around.variables = {{QStringLiteral("LD_PRELOAD"), QStringLiteral(BURIN_REFUSED_MEMORY)},
            {QStringLiteral("BURIN_REFUSE_NTH"), QString::number(which)},
            {QStringLiteral("BURIN_REFUSE_LEAST"), QStringLiteral("1")},
            {QStringLiteral("BURIN_REFUSE_OURS"), QStringLiteral("0")},
            {QStringLiteral("BURIN_REFUSE_LIBRARIES"), QStringLiteral("1")},
            {QStringLiteral("BURIN_REFUSE_ON"), QStringLiteral("0")},
            {QStringLiteral("BURIN_REFUSE_REPORT"), path("count.txt")}};
        return test::burin({QStringLiteral("info"), path("ct")}, around);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(!test::writeSeries(test::SyntheticSeries(), path("ct")).isEmpty());
    }
    void init() { test::failOnUnexpectedMessages(); }

    void nothingWaitsForEver_data()
    {
        QTest::addColumn<qlonglong>("which");
        const test::Outcome counted = readAStudy(0);
        QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
        const qlonglong count = test::bytesOf(path("count.txt")).trimmed().toLongLong();
        QVERIFY(count > 1000);
        const qlonglong rows = test::longRun() ? 200 : 12;
        for (qlonglong i = 0; i < rows; ++i) {
            const qlonglong which = 1 + count * i / rows;
            QTest::addRow("%lld of %lld", which, count) << which;
        }
    }

    void nothingWaitsForEver()
    {
        QFETCH(qlonglong, which);
        const test::Outcome outcome = readAStudy(which);
        QVERIFY2(outcome.status != test::Outcome::hung, qPrintable(outcome.complaint));
        QVERIFY(outcome.status == 0 || !outcome.complaint.isEmpty());
    }
};

BURIN_TEST(LibraryMemoryTest)

} // namespace libraryMemoryTest

#include "LibraryMemoryTest.moc"
