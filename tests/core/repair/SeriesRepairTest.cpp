// SPDX-License-Identifier: Apache-2.0
#include "core/repair/SeriesRepair.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace seriesRepairTest {

using core::SeriesRepair;

/// The words that name a repair.
class SeriesRepairTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wordsComeBackInTheirOrder_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("canonical");
        const auto row = [](const char* words, const char* canonical) {
            QTest::newRow(words) << QString::fromLatin1(words) << QString::fromLatin1(canonical);
        };
        row("", "");
        row("tilt", "tilt");
        row("tilt,gap=fill", "gap=fill,tilt");
        row("gap=fill,tilt", "gap=fill,tilt");
        row(" tilt , spacing=even ", "spacing=even,tilt");
        row("tilt,tilt", "tilt");
        row("gap=split:2,duplicates=last,tilt", "duplicates=last,gap=split:2,tilt");
    }
    void wordsComeBackInTheirOrder()
    {
        QFETCH(QString, words);
        QFETCH(QString, canonical);
        const auto repair = SeriesRepair::fromText(words);
        QVERIFY(repair);
        QCOMPARE(repair->toText(), canonical);
        QCOMPARE(repair->isNone(), canonical.isEmpty());
        QCOMPARE(repair->inWords().isEmpty(), canonical.isEmpty());
        QVERIFY(SeriesRepair::fromText(canonical) == repair);
    }

    void isAClauseInWords()
    {
        const auto repair = SeriesRepair::fromText(
            QStringLiteral("duplicates=last,gap=split:2,tilt,spacing=0.5x0.5x2"));
        QVERIFY(repair);
        const core::Clause words = repair->inWords();
        QCOMPARE(words.english(),
            QStringLiteral("the last of several images at one place taken, split at gaps, part 2 "
                           "taken, tilt sheared out, voxels of 0.5 × 0.5 × 2 mm as given"));
        // Each of them is one, so that ui can word it.
        QVERIFY(words.form() != nullptr);
        for (const core::Clause& argument : words.arguments())
            QVERIFY(argument.form() != nullptr);
    }

    void whatIsNoRepairIsSaid_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* words, const char* named) {
            QTest::newRow(words) << QString::fromLatin1(words) << QString::fromLatin1(named);
        };
        row("straighten", "straighten");
        row("tilt,gap", "'gap'");
        row("gap=split:0", "gap=split:0");
        row("gap=split:two", "gap=split:two");
        row("gap=fill,spacing=even", "contradicts");
        row("gap=split:1,gap=split:2", "contradicts");
        row("duplicates=first,duplicates=last", "contradicts");
    }
    void whatIsNoRepairIsSaid()
    {
        QFETCH(QString, words);
        QFETCH(QString, named);
        core::Clause why;
        QVERIFY(!SeriesRepair::fromText(words, &why));
        QVERIFY2(why.contains(named), qPrintable(why));
    }
};

BURIN_TEST(SeriesRepairTest)

} // namespace seriesRepairTest

#include "SeriesRepairTest.moc"
