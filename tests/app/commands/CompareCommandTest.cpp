// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/VolumeFiles.h"
#include "tests/support/servers/BurinProgram.h"

#include <QTest>

namespace compareCommandTest {

namespace {

constexpr int edge = 12;

constexpr const char* firstLines = "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 12 12 12\n";

QByteArray header(const char* more)
{
    return QByteArray(firstLines)
        + QByteArray("space: left-posterior-superior\n"
                     "space directions: (0.5,0,0) (0,0.5,0) (0,0,2)\nspace origin: (1,2,3)\n")
        + more + "encoding: raw\n\n";
}

/// Labels 1 and 2 in boxes of 4³ that begin at these columns.
QByteArray boxes(int first, int second)
{
    QByteArray labels(edge * edge * edge, '\0');
    for (int z = 4; z < 8; ++z) {
        for (int y = 4; y < 8; ++y) {
            for (int x = 0; x < 4; ++x) {
                labels[(z * edge + y) * edge + first + x] = 1;
                labels[(z * edge + y) * edge + second + x] = 2;
            }
        }
    }
    return labels;
}

} // namespace

/// `burin compare`: what it tells of two masks, and where it fails.
class CompareCommandTest : public QObject, test::VolumeFiles {
    Q_OBJECT

    QString m_study;
    QString m_mask;
    QString m_reference;

    [[nodiscard]] test::Outcome compare(const QStringList& more) const
    {
        return test::burin(QStringList{QStringLiteral("compare"), m_mask, m_reference,
                               QStringLiteral("--study"), m_study}
            + more);
    }

private Q_SLOTS:
    void init()
    {
        makeFolder();
        m_study = put(QStringLiteral("study.nrrd"), header("") + boxes(0, 8));
        m_mask = put(QStringLiteral("mask.nrrd"), header("") + boxes(1, 8));
        m_reference = put(QStringLiteral("reference.nrrd"), header("") + boxes(0, 7));
    }

    void aLineForEachPair()
    {
        const test::Outcome outcome = compare({QStringLiteral("--json")});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.lines.size(), 2);
        for (const QJsonObject& line : outcome.lines) {
            QCOMPARE(line[QStringLiteral("voxels")].toInt(), 64);
            QCOMPARE(line[QStringLiteral("sharedVoxels")].toInt(), 48);
            QCOMPARE(line[QStringLiteral("rVE")].toDouble(), 0.5);
            QCOMPARE(line[QStringLiteral("dice")].toDouble(), 0.75);
            QCOMPARE(line[QStringLiteral("hd95Mm")].toDouble(), 0.5);
            QCOMPARE(line[QStringLiteral("hausdorffMm")].toDouble(), 0.5);
            const double mean = line[QStringLiteral("meanSurfaceDistanceMm")].toDouble();
            QVERIFY(mean > 0.0 && mean < 0.5);
        }
        QVERIFY(outcome.lines[0][QStringLiteral("segment")]
            != outcome.lines[1][QStringLiteral("segment")]);
    }

    void oneByName()
    {
        const QString second = compare({QStringLiteral("--json")})
                                   .lines.value(1)[QStringLiteral("segment")]
                                   .toString();
        const test::Outcome outcome =
            compare({QStringLiteral("--segment"), second, QStringLiteral("--json")});
        QCOMPARE(outcome.lines.size(), 1);
        QCOMPARE(outcome.lines[0][QStringLiteral("reference")].toString(), second);
    }

    /// A structure that one of them lacks is not missing without a word.
    void whatHasNoCounterpartIsTold()
    {
        QByteArray three = boxes(0, 7);
        three[0] = 3;
        m_reference = put(QStringLiteral("reference.nrrd"), header("") + three);
        const test::Outcome outcome = compare({QStringLiteral("--json")});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.lines.size(), 2);
        QVERIFY2(outcome.complaint.contains(m_reference
                     + QStringLiteral(": not compared, as the other mask has no "
                                      "counterpart: Label 3")),
            qPrintable(outcome.complaint));
        QVERIFY(!outcome.complaint.contains(m_mask + QStringLiteral(": not compared")));
        // Who asks for one pair knows that there are others.
        const test::Outcome one = compare({QStringLiteral("--segment"), QStringLiteral("Label 1")});
        QCOMPARE(one.status, 0);
        QVERIFY2(
            !one.complaint.contains(QStringLiteral("not compared")), qPrintable(one.complaint));
    }

    void inWords()
    {
        const test::Outcome outcome = compare({});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(
            outcome.output.contains("relative volume error  50.000 %"), outcome.output.constData());
        QVERIFY2(
            outcome.output.contains("Dice                   0.7500"), outcome.output.constData());
        QVERIFY2(outcome.output.contains("at most 0.500 mm"), outcome.output.constData());
    }

    /// Where the study does not say how large its voxels are, nobody has measured millimetres.
    void noDistancesOfUnknownVoxels()
    {
        const QByteArray unknown = QByteArray(firstLines) + "encoding: raw\n\n";
        m_study = put(QStringLiteral("study.nrrd"), unknown + boxes(0, 8));
        m_mask = put(QStringLiteral("mask.nrrd"), unknown + boxes(1, 8));
        m_reference = put(QStringLiteral("reference.nrrd"), unknown + boxes(0, 7));
        const test::Outcome outcome = compare({QStringLiteral("--json")});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.lines.size(), 2);
        for (const QJsonObject& line : outcome.lines) {
            QCOMPARE(line[QStringLiteral("sharedVoxels")].toInt(), 48);
            QCOMPARE(line[QStringLiteral("rVE")].toDouble(), 0.5);
            for (const char* key : {"hd95Mm", "hausdorffMm", "meanSurfaceDistanceMm"})
                QVERIFY2(line[QLatin1String(key)].isNull(), key);
        }
        const test::Outcome words = compare({});
        QCOMPARE(words.status, 0);
        QVERIFY2(
            words.output.contains("mean –, 95 % within –, at most –"), words.output.constData());
    }

    void failuresAreOneLine()
    {
        const test::Outcome none = compare({QStringLiteral("--segment"), QStringLiteral("Liver")});
        QCOMPARE(none.status, 1);
        QVERIFY2(none.complaint.contains(QStringLiteral("mask.nrrd"))
                && none.complaint.contains(QStringLiteral("--segment")),
            qPrintable(none.complaint));
        m_reference = put(QStringLiteral("torn.nrrd"), header("") + QByteArray(100, '\1'));
        const test::Outcome torn = compare({});
        QCOMPARE(torn.status, 1);
        QVERIFY2(torn.complaint.contains(QStringLiteral("torn.nrrd")), qPrintable(torn.complaint));
        const test::Outcome less = test::burin({QStringLiteral("compare"), m_mask});
        QCOMPARE(less.status, 2);
    }
};

BURIN_TEST(CompareCommandTest)

} // namespace compareCommandTest

#include "CompareCommandTest.moc"
