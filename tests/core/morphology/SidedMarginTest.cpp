// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SidedMargin.h"

#include "core/morphology/MillimetreBall.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace sidedMarginTest {

namespace {

using Labels = std::vector<std::uint8_t>;

/// Axes along the patient's, in any order and direction, a little turned if wanted.
core::VolumeGeometry anyGrid(const glm::ivec3& size, std::mt19937& random, double turnedBy)
{
    std::array<int, 3> order{0, 1, 2};
    for (int swap = 0; swap < 3; ++swap)
        std::swap(order.at(random() % 3), order.at(random() % 3));
    const double cosine = std::cos(turnedBy);
    const double sine = std::sin(turnedBy);
    const glm::dmat3 turn(
        glm::dvec3(cosine, sine, 0.0), glm::dvec3(-sine, cosine, 0.0), glm::dvec3(0.0, 0.0, 1.0));
    glm::dmat3 axes(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double length = 0.5 + 0.1 * double(random() % 20);
        glm::dvec3 along(0.0);
        along[order.at(std::size_t(axis))] = random() % 2 == 0 ? length : -length;
        axes[axis] = turn * along;
    }
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld = glm::dmat4(axes);
    return geometry;
}

std::size_t indexOf(const glm::ivec3& at, const glm::ivec3& size)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

bool isIn(const glm::ivec3& at, const glm::ivec3& size)
{
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size.x && at.y < size.y && at.z < size.z;
}

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

/// Blocks of the segment 1 with specks in and beside them, and a block of another one.
Labels anyMatter(const glm::ivec3& size, std::mt19937& random)
{
    Labels labels(std::size_t(size.x * size.y * size.z), 0);
    for (const int label : {1, 1, 2}) {
        const glm::ivec3 one{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 other{int(random() & 31), int(random() & 31), int(random() & 31)};
        const glm::ivec3 from = glm::min(one % size, other % size);
        const glm::ivec3 to = glm::max(one % size, other % size);
        forEachVoxel(to - from + 1, [&](const glm::ivec3& within) {
            labels[indexOf(from + within, size)] = std::uint8_t(label);
        });
    }
    for (std::uint8_t& label : labels) {
        if (random() % 40 == 0)
            label = label == 1 ? 0 : 1;
    }
    return labels;
}

/// Whether a step leads nowhere beyond the margins, by where it leads in the patient.
bool isWithin(
    const core::VolumeGeometry& turnedBack, const glm::ivec3& step, const core::SixMargins& margins)
{
    const glm::dvec3 lps = glm::dmat3(turnedBack.indexToWorld) * glm::dvec3(step);
    const auto share = [](double along, double towardsLess, double towardsMore) {
        const double margin = along < 0.0 ? towardsLess : towardsMore;
        if (std::abs(along) < 1e-9)
            return 0.0;
        return margin > 0.0 ? along * along / (margin * margin) : 2.0;
    };
    return share(lps.x, margins.right, margins.left)
        + share(lps.y, margins.anterior, margins.posterior)
        + share(lps.z, margins.inferior, margins.superior)
        <= 1.0 + 5e-7;
}

/// Voxel against voxel: what the margins make of the segment 1.
Labels expectedAfter(const Labels& labels, const core::VolumeGeometry& turnedBack, bool grows,
    const core::SixMargins& margins)
{
    const glm::ivec3& size = turnedBack.size;
    std::vector<glm::ivec3> steps;
    forEachVoxel(2 * size - 1, [&](const glm::ivec3& at) {
        const glm::ivec3 step = at - size + 1;
        if (isWithin(turnedBack, step, margins))
            steps.push_back(step);
    });
    Labels after = labels;
    forEachVoxel(size, [&](const glm::ivec3& at) {
        const std::uint8_t label = labels[indexOf(at, size)];
        if (label != (grows ? 0 : 1))
            return;
        // What grows came by the step; what is left is left if the step does not lead out of it.
        const bool reached = std::any_of(steps.begin(), steps.end(), [&](const glm::ivec3& step) {
            const glm::ivec3 other = grows ? at - step : at + step;
            return isIn(other, size) && (labels[indexOf(other, size)] == 1) == grows;
        });
        if (reached)
            after[indexOf(at, size)] = grows ? 1 : 0;
    });
    return after;
}

Labels after(const Labels& labels, const core::ShapeChange& change)
{
    Labels now = labels;
    for (const core::VoxelRun& run : change.given.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    for (const core::VoxelRun& run : change.taken.runs())
        std::fill_n(now.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(0));
    return now;
}

core::SixMargins anyMargins(std::mt19937& random)
{
    const auto some = [&] {
        return random() % 5 == 0 ? 0.0 : 0.3 + 0.0137 * double(random() % 400);
    };
    core::SixMargins margins;
    margins.right = some();
    margins.left = some();
    margins.anterior = some();
    margins.posterior = some();
    margins.inferior = some();
    margins.superior = some();
    return margins;
}

} // namespace

class SidedMarginTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Voxel for voxel what a look at every pair of voxels tells, on grids of any order of axes;
    /// turned by a few degrees they measure along their own axes.
    void anyMatterOnAnyGrid_data()
    {
        QTest::addColumn<uint>("seed");
        QTest::addColumn<glm::ivec3>("size");
        for (uint seed = 1; seed <= 16; ++seed) {
            std::mt19937 random(100 + seed);
            glm::ivec3 size(6 + int(random() % 9)); // one after the other, whatever the compiler
            size.y = 6 + int(random() % 8);
            size.z = 5 + int(random() % 8);
            QTest::addRow("seed %u", seed) << seed << size;
        }
        QTest::newRow("long rows") << 17U << glm::ivec3(50, 3, 3);
        QTest::newRow("long columns") << 18U << glm::ivec3(3, 60, 2);
        QTest::newRow("many slices") << 19U << glm::ivec3(2, 4, 50);
        QTest::newRow("wide slices") << 20U << glm::ivec3(37, 18, 2);
    }
    void anyMatterOnAnyGrid()
    {
        QFETCH(const uint, seed);
        QFETCH(const glm::ivec3, size);
        std::mt19937 random(seed);
        std::mt19937 twin = random;
        const core::VolumeGeometry geometry = anyGrid(size, random, seed % 2 == 0 ? 0.2 : 0.0);
        const core::VolumeGeometry turnedBack = anyGrid(size, twin, 0.0);
        std::uint64_t changed = 0;
        for (int round = 0; round < 6; ++round) {
            const Labels labels = anyMatter(size, random);
            const core::SixMargins margins = anyMargins(random);
            const core::SidedBall ball = core::sidedBallOf(geometry, margins);
            for (const bool grows : {true, false}) {
                const auto change =
                    core::sidedMarginChange(labels, size, 1, grows, ball, core::Progress());
                QVERIFY(change);
                QVERIFY(
                    after(labels, *change) == expectedAfter(labels, turnedBack, grows, margins));
                changed += change->given.voxelCount() + change->taken.voxelCount();
            }
        }
        QVERIFY2(changed > 20, qPrintable(QString::number(changed)));
    }

    /// With the same margin everywhere it is the ball's.
    void alikeOnAllSides()
    {
        std::mt19937 random(3);
        const glm::ivec3 size(30, 26, 20);
        const core::VolumeGeometry geometry = anyGrid(size, random, 0.0);
        const Labels labels = anyMatter(size, random);
        for (const double mm : {0.4, 1.7, 3.3, 8.1}) {
            const core::SixMargins margins{mm, mm, mm, mm, mm, mm};
            for (const bool grows : {true, false}) {
                const auto sided = core::sidedMarginChange(
                    labels, size, 1, grows, core::sidedBallOf(geometry, margins), core::Progress());
                const auto plain = core::shapeChange(labels, size, 1,
                    grows ? core::ShapeOperation::Grow : core::ShapeOperation::Shrink,
                    core::ShellPlace::Inside, core::ballOf(geometry, mm), core::Progress());
                QVERIFY(sided && plain);
                QVERIFY(sided->given == plain->given);
                QVERIFY(sided->taken == plain->taken);
            }
        }
    }

    /// A margin of whole voxels reaches the last of them, on its side alone.
    void oneSide_data()
    {
        QTest::addColumn<double>("spacing");
        for (const double spacing : {0.1, 0.3, 1.0 / 3.0, 0.488281, 1.1, 3.0000001})
            QTest::addRow("%.9g mm", spacing) << spacing;
    }
    void oneSide()
    {
        QFETCH(const double, spacing);
        core::VolumeGeometry geometry;
        geometry.size = glm::ivec3(21, 5, 5);
        geometry.indexToWorld = glm::dmat4(glm::dmat3(glm::dvec3(-spacing, 0.0, 0.0),
            glm::dvec3(0.0, spacing, 0.0), glm::dvec3(0.0, 0.0, spacing)));
        Labels labels(21 * 25, 0);
        for (const int x : {9, 10, 11})
            labels[indexOf({x, 2, 2}, geometry.size)] = 1;
        for (int voxels = 1; voxels <= 8; ++voxels) {
            core::SixMargins margins;
            margins.right = voxels * spacing; // along x, which leads to the right here
            const core::SidedBall ball = core::sidedBallOf(geometry, margins);
            QCOMPARE(ball.behind, glm::ivec3(voxels, 0, 0));
            QCOMPARE(ball.before, glm::ivec3(0));
            const auto grown =
                core::sidedMarginChange(labels, geometry.size, 1, true, ball, core::Progress());
            QVERIFY(grown);
            QCOMPARE(grown->given.voxelCount(), std::uint64_t(voxels));
            QCOMPARE(grown->given.runs().front().first,
                std::uint64_t(indexOf({12, 2, 2}, geometry.size)));
            const auto shrunk =
                core::sidedMarginChange(labels, geometry.size, 1, false, ball, core::Progress());
            QVERIFY(shrunk);
            QCOMPARE(shrunk->taken.voxelCount(), std::uint64_t(std::min(voxels, 3)));
            QCOMPARE(shrunk->taken.end(), std::uint64_t(indexOf({12, 2, 2}, geometry.size)));
        }
    }

    void nothingAndCancelled()
    {
        std::mt19937 random(7);
        const core::VolumeGeometry geometry = anyGrid({30, 30, 30}, random, 0.0);
        const core::SidedBall ball = core::sidedBallOf(geometry, {3.0, 2.0, 1.0, 0.0, 4.0, 5.0});
        const auto none = core::sidedMarginChange(
            Labels(27000, 2), geometry.size, 1, true, ball, core::Progress());
        QVERIFY(none && none->given.empty() && none->taken.empty());
        core::Progress* mine = nullptr;
        core::Progress stopped([&](core::ProgressStep, int, int) { mine->cancel(); });
        mine = &stopped;
        const auto given = core::sidedMarginChange(
            anyMatter(geometry.size, random), geometry.size, 1, true, ball, stopped);
        QVERIFY(!given);
        QVERIFY(given.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(SidedMarginTest)

} // namespace sidedMarginTest

#include "SidedMarginTest.moc"
