// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/Corruptor.h"
#include "tests/reenactment/SurfaceRobot.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace refinementTableTest {

using namespace core;
using namespace reenact;

namespace {

/// The robots' rules and numbers were chosen by what came of seeds 1 to 5; the table is of others.
constexpr std::uint64_t firstPrintedSeed = 101;
constexpr int printedSeeds = 10;
constexpr std::uint64_t buildingSeed = 1;
/// Of lengths in voxels: a liver has some 23 000.
constexpr double phantomScale = 0.6;
/// What 3 mm voxels are to the phantom's of 2.2 mm, for the reach of necks.
constexpr double realScale = 0.7;
constexpr int vertices = 12'000;

/// What came of a row with one seed.
struct Attempt {
    double before = 0.0;
    double after = 0.0;
    double afterPlain = 0.0;
    double dice = 0.0;
    double hausdorff95Voxels = 0.0;
    double seconds = 0.0;
    int actions = 0; ///< to the row's second error, or until nothing more was gained
    int toCommon = 0; ///< to 2.7 %; 0: never
    double afterSurface = 0.0; ///< without chunks
    int surfaceActions = 0;
    int ballActions = 0;
    int ballToCommon = 0;
    int discActions = 0;
    int discToCommon = 0;
};

template <class Value> double median(const std::vector<Attempt>& attempts, Value Attempt::*value)
{
    std::vector<double> values;
    for (const Attempt& attempt : attempts)
        values.push_back(double(attempt.*value));
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

template <class Value> double most(const std::vector<Attempt>& attempts, Value Attempt::*value)
{
    double most = 0.0;
    for (const Attempt& attempt : attempts)
        most = std::max(most, double(attempt.*value));
    return most;
}

} // namespace

/// Table 1 of the paper, by robots (seed B, section 7.3; issue 7): masks spoilt as its own were,
/// and mended by the tools of this program, by these without chunks, and by a brush alone: a ball,
/// and a disc on the slices. With BURIN_LONG=1 all rows with ten seeds each, on phantoms and on the
/// shared data's organs; else two rows, small.
class RefinementTableTest : public QObject {
    Q_OBJECT

private:
    QStringList m_table;

    [[nodiscard]] static Attempt attempt(const OrganScene& scene, const TableRow& row,
        const Truth& truth, double scale, std::uint64_t seed);

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void masksAreMended_data();
    void masksAreMended();
    void cleanupTestCase();
};

Attempt RefinementTableTest::attempt(const OrganScene& scene, const TableRow& row,
    const Truth& truth, double scale, std::uint64_t seed)
{
    const VolumeGeometry& geometry = scene.study.volume.geometry;
    const Corrupted poor = corrupted(scene, row, scale, seed);
    const RobotGoal goal{.error = row.after};
    Attempt made{.before = poor.error};
    {
        RefinementBench bench(scene.study, poor.mask);
        const RobotRun run = runSurfaceRobot(bench, truth, goal, {.vertices = vertices}, seed);
        made.after = truth.errorOf(run.mask);
        made.afterPlain = truth.plainErrorOf(run.mask);
        made.actions = run.actions;
        made.toCommon = run.actionsToCommon;
        made.seconds = run.seconds;
        const auto compared = compareMasks(runsOf(run.mask), runsOf(truth.plain), geometry, {});
        if (compared) {
            made.dice = compared->dice;
            made.hausdorff95Voxels =
                compared->distances->hausdorff95Mm / std::cbrt(geometry.voxelVolumeMm3());
        }
    }
    {
        RefinementBench bench(scene.study, poor.mask);
        const RobotRun run =
            runSurfaceRobot(bench, truth, goal, {.chunks = false, .vertices = vertices}, seed);
        made.afterSurface = truth.errorOf(run.mask);
        made.surfaceActions = run.actions;
    }
    for (const auto shape : {BrushPath::Shape::Ball, BrushPath::Shape::Disc}) {
        RefinementBench bench(scene.study, poor.mask);
        const RobotRun run = runBrushRobot(bench, truth, goal, shape, seed);
        const bool isBall = shape == BrushPath::Shape::Ball;
        (isBall ? made.ballActions : made.discActions) = run.actions;
        (isBall ? made.ballToCommon : made.discToCommon) = run.actionsToCommon;
    }
    return made;
}

void RefinementTableTest::masksAreMended_data()
{
    QTest::addColumn<int>("row");
    QTest::addColumn<bool>("isReal");
    for (const bool isReal : {false, true}) {
        for (std::size_t i = 0; i < tableRows().size(); ++i) {
            const TableRow& row = tableRows()[i];
            const QByteArray number(row.number);
            if (!test::longRun() && (isReal || (number != "1b" && number != "5")))
                continue;
            // Neither hearts nor whole lungs are in the shared study.
            if (isReal && (row.into == Organ::Heart || row.organ == Organ::Lung))
                continue;
            QTest::addRow("%s, %s", row.number, isReal ? "real" : "phantom") << int(i) << isReal;
        }
    }
}

void RefinementTableTest::masksAreMended()
{
    QFETCH(int, row);
    QFETCH(bool, isReal);
    const TableRow& asked = tableRows()[std::size_t(row)];
    const double scale = isReal ? realScale : phantomScale;
    const std::optional<OrganScene> scene =
        isReal ? realOrgans(asked.organ) : organPhantom(asked.organ, scale);
    if (!scene)
        QSKIP("the shared test data are not there");
    const auto truth =
        Truth::of(scene->maskOf(asked.organ), scene->study.volume.geometry, vertices);
    QVERIFY(truth);
    std::vector<Attempt> attempts;
    if (test::longRun()) {
        for (int i = 0; i < printedSeeds; ++i)
            attempts.push_back(
                attempt(*scene, asked, *truth, scale, firstPrintedSeed + std::uint64_t(i)));
    } else {
        attempts.push_back(attempt(*scene, asked, *truth, scale, buildingSeed));
    }
    for (const Attempt& made : attempts)
        QVERIFY2(
            std::abs(made.before - asked.before) <= 0.1, qPrintable(QString::number(made.before)));
    const double after = median(attempts, &Attempt::after);
    m_table << QStringLiteral("%1 %2 %3 %4 (%5) %6 %7 | %8 (%9) %10 | %11 %12 | %13 %14 | %15 "
                              "%16 | %17 %18 %19")
                   .arg(QLatin1String(asked.number), -2)
                   .arg((isReal ? QStringLiteral("real ") : QString()) + QLatin1String(asked.text),
                       -40)
                   .arg(asked.before, 5, 'f', 1)
                   .arg(after, 5, 'f', 2)
                   .arg(most(attempts, &Attempt::after), 5, 'f', 2)
                   .arg(median(attempts, &Attempt::afterPlain), 5, 'f', 2)
                   .arg(asked.after, 4, 'f', 1)
                   .arg(median(attempts, &Attempt::actions), 4, 'f', 1)
                   .arg(most(attempts, &Attempt::actions), 2, 'f', 0)
                   .arg(median(attempts, &Attempt::toCommon), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::surfaceActions), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::afterSurface), 5, 'f', 2)
                   .arg(median(attempts, &Attempt::ballActions), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::ballToCommon), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::discActions), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::discToCommon), 4, 'f', 1)
                   .arg(median(attempts, &Attempt::seconds), 5, 'f', 1)
                   .arg(median(attempts, &Attempt::dice), 6, 'f', 4)
                   .arg(median(attempts, &Attempt::hausdorff95Voxels), 4, 'f', 1);
    qInfo("%s", qPrintable(m_table.back()));
    QVERIFY2(median(attempts, &Attempt::toCommon) > 0.0, "2.7 % was not reached");
    if (test::longRun())
        return;
    const Attempt& made = attempts.front();
    QVERIFY2(made.after <= 2.7, qPrintable(m_table.back()));
    QVERIFY2(made.toCommon <= 12, qPrintable(m_table.back()));
    QVERIFY2(made.afterSurface < 0.25 * asked.before, qPrintable(m_table.back()));
    QVERIFY2(made.discToCommon >= 2 * made.toCommon, qPrintable(m_table.back()));
}

void RefinementTableTest::cleanupTestCase()
{
    qInfo(
        "rVE in per cent; medians of the seeds, and in brackets the worst; actions to the paper's "
        "second error, then to 2.7 %% (0: never)");
    qInfo("%-43s before after (most)  plain paper | actions to 2.7 | no chunks    | ball to 2.7 | "
          "disc to 2.7 | s  Dice  HD95 (voxels)",
        "row");
    for (const QString& line : m_table)
        qInfo("%s", qPrintable(line));
}

BURIN_TEST(RefinementTableTest)

} // namespace refinementTableTest

#include "RefinementTableTest.moc"
