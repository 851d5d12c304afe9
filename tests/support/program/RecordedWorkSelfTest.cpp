// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/RecordedWork.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace recordedWorkSelfTest {

class RecordedWorkSelfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatGrowsIsTold();
};

void RecordedWorkSelfTest::whatGrowsIsTold()
{
    std::vector<test::CountedStep> steps{
        {"undo of drill", {{"groups", 112}, {"bytes up", 5'000'000'000}}},
        {"paint", {{"groups", 12}, {"bytes up", 0}}}};
    const QByteArray record = test::recordOf(steps);
    QCOMPARE(record,
        QByteArray("undo of drill | groups 112 | bytes up 5000000000\n"
                   "paint | groups 12 | bytes up 0\n"));
    QCOMPARE(test::grownSince(record, steps), QStringList());
    steps[0].counts[0].second = 90; // less is no fault
    QCOMPARE(test::grownSince(record, steps), QStringList());
    steps[0].counts[1].second = 5'000'000'001;
    QCOMPARE(test::grownSince(record, steps),
        QStringList{
            QStringLiteral("undo of drill: 5000000001 bytes up, recorded were 5000000000")});
    steps[0].counts[1].second = 1;

    // What is new or gone has to be recorded anew.
    steps[1].counts.emplace_back("draws", 0);
    QCOMPARE(test::grownSince(record, steps),
        QStringList{QStringLiteral("paint: 0 draws, recorded were none")});
    steps[1] = {"erase", {}};
    QCOMPARE(test::grownSince(record, steps),
        QStringList({QStringLiteral("erase is not recorded"),
            QStringLiteral("paint is recorded, and no step")}));
}

BURIN_TEST(RecordedWorkSelfTest)

} // namespace recordedWorkSelfTest

#include "RecordedWorkSelfTest.moc"
