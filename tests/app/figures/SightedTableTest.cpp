// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/SightedTable.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace sightedTableTest {

using namespace core;
using namespace reenact;

namespace {

/// The robots' rules and numbers were chosen by what came of seeds 1 to 3; the table is of others.
constexpr std::uint64_t firstPrintedSeed = 101;
constexpr int printedSeeds = 10;
constexpr std::uint64_t buildingSeed = 1;
/// What 3 mm voxels are to a phantom's of 2.2 mm, for the reach of necks.
constexpr double realScale = 0.7;
constexpr int vertices = 12'000;

/// Neither a heart nor a whole lung is in it: those are phantoms, at real size.
bool isInSharedStudy(const TableRow& row)
{
    return row.into != Organ::Heart && row.organ != Organ::Lung;
}

struct Spread {
    double median = 0.0;
    double worst = 0.0;
};
template <class Value> Spread spreadOf(const std::vector<SightedAttempt>& attempts, Value valueOf)
{
    std::vector<double> values;
    for (const SightedAttempt& attempt : attempts)
        values.push_back(double(valueOf(attempt)));
    std::sort(values.begin(), values.end());
    return {0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]), values.back()};
}

QString told(const Spread& spread, int decimals)
{
    return QStringLiteral("%1 (%2)")
        .arg(spread.median, 0, 'f', decimals)
        .arg(spread.worst, 0, 'f', decimals);
}

} // namespace

/// Table 1 of the paper (seed B, section 7.3; issue 34) on real organs, and on phantoms of real
/// size where the shared study has none, by robots that see what a user sees: planes with grey
/// values and contours, and where a reader takes the organ's border to be, wrong by 1 mm. They
/// neither plan on the reference, nor take back or stop by it; it measures them afterwards. With
/// BURIN_LONG=1 all rows with ten seeds each (BURIN_SEEDS: with so many), else three rows with one
/// that the rules were made on.
class SightedTableTest : public QObject {
    Q_OBJECT

private:
    QStringList m_table;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void masksAreMended_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < sightedRows().size(); ++i) {
            const TableRow& row = sightedRows()[i].row;
            const QByteArray number(row.number);
            if (!test::longRun() && number != "1b" && number != "6" && number != "8a")
                continue;
            QTest::addRow("%s", row.number) << int(i);
        }
    }

    void masksAreMended()
    {
        QFETCH(int, row);
        const SightedRow& asked = sightedRows()[std::size_t(row)];
        const bool isReal = isInSharedStudy(asked.row);
        const double scale = isReal ? realScale : 1.0;
        const std::optional<OrganScene> scene = isReal ? realOrgans(asked.row.organ, asked.row.into)
                                                       : organPhantom(asked.row.organ, scale);
        if (!scene)
            QSKIP("the shared test data are not there");
        const auto truth =
            Truth::of(scene->maskOf(asked.row.organ), scene->study.volume.geometry, vertices);
        QVERIFY(truth);
        std::vector<SightedAttempt> attempts;
        const int seeds = test::longRun() ? qEnvironmentVariableIntValue("BURIN_SEEDS") > 0
                ? qEnvironmentVariableIntValue("BURIN_SEEDS")
                : printedSeeds
                                          : 1;
        const std::uint64_t first = test::longRun() ? firstPrintedSeed : buildingSeed;
        for (int i = 0; i < seeds; ++i) {
            attempts.push_back(
                attemptSighted(*scene, asked.row, *truth, scale, first + std::uint64_t(i)));
            const SightedAttempt& made = attempts.back();
            QVERIFY(std::abs(made.before - asked.row.before) <= 0.15);
            qInfo("%s, seed %d, %.1f %% | surface: %s | brush: %s", asked.row.number,
                int(first) + i, made.before,
                qPrintable(made.surface.log.join(QStringLiteral(", "))),
                qPrintable(made.brush.log.join(QStringLiteral(", "))));
        }
        addRow(asked, attempts);
        // What a user ends with is better than what they began with; a vessel may stay as it was.
        const Spread after =
            spreadOf(attempts, [](const auto& made) { return made.surface.after; });
        QVERIFY2(after.median < asked.row.before, qPrintable(m_table.back()));
        QVERIFY2(after.worst <= asked.row.before + 0.1, qPrintable(m_table.back()));
        const Spread actions =
            spreadOf(attempts, [](const auto& made) { return made.surface.actions; });
        QVERIFY2(actions.worst <= 12.0, qPrintable(m_table.back()));
    }

    void cleanupTestCase()
    {
        qInfo(
            "Medians of the seeds, in brackets the worst. rVE in per cent against the organ (v: "
            "against the voxels in its first surface). Actions: in all; until the paper's second "
            "error, by those that came there; of the brush, until it was as good as the surface in "
            "the end, likewise");
        qInfo("| row | before | surface | v | paper | actions | to paper's | planes | brush | "
              "actions | to paper's | as good |");
        for (const QString& line : m_table)
            qInfo("%s", qPrintable(line));
    }

private:
    void addRow(const SightedRow& asked, const std::vector<SightedAttempt>& attempts)
    {
        const auto over = [&attempts](int decimals, auto valueOf) {
            return told(spreadOf(attempts, valueOf), decimals);
        };
        // Of those that came there alone.
        const auto until = [&attempts](auto actionsOf) {
            std::vector<SightedAttempt> there;
            for (const SightedAttempt& made : attempts) {
                if (actionsOf(made) > 0)
                    there.push_back(made);
            }
            const QString share = QStringLiteral("%1 of %2").arg(there.size()).arg(attempts.size());
            return there.empty() ? QStringLiteral("none")
                : there.size() == attempts.size()
                ? told(spreadOf(there, actionsOf), 1)
                : QStringLiteral("%1, %2").arg(told(spreadOf(there, actionsOf), 1), share);
        };
        const double wanted = asked.row.after;
        const QString place = isInSharedStudy(asked.row) ? QString() : QStringLiteral(" (phantom)");
        const QStringList cells{QStringLiteral("%1 %2%3").arg(QLatin1String(asked.row.number),
                                    QLatin1String(asked.row.text), place),
            QString::number(asked.row.before, 'f', 1),
            over(2, [](const auto& made) { return made.surface.after; }),
            over(2, [](const auto& made) { return made.surface.afterVoxelised; }),
            QStringLiteral("%1%2")
                .arg(wanted, 0, 'f', 1)
                .arg(asked.isOfPaper ? QString() : QStringLiteral(" (ours)")),
            over(1, [](const auto& made) { return made.surface.actions; }),
            until([wanted](const auto& made) { return made.surface.actionsTo(wanted); }),
            over(0, [](const auto& made) { return made.surface.looks; }),
            over(2, [](const auto& made) { return made.brush.after; }),
            over(1, [](const auto& made) { return made.brush.actions; }),
            until([wanted](const auto& made) { return made.brush.actionsTo(wanted); }),
            until([](const auto& made) { return made.brush.actionsTo(made.surface.after); })};
        m_table << QStringLiteral("| %1 |").arg(cells.join(QStringLiteral(" | ")));
        qInfo("%s", qPrintable(m_table.back()));
    }
};

BURIN_TEST(SightedTableTest)

} // namespace sightedTableTest

#include "SightedTableTest.moc"
