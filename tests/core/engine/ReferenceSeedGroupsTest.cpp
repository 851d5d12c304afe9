// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <tuple>

namespace referenceSeedGroupsTest {

using namespace core;
using reference::ReferenceEngine;

namespace {

constexpr glm::ivec3 size{60, 12, 12};

/// Along x three tissues: 300, 450 and 600, each ± 10.
test::Codes threeTissues()
{
    test::Random random(3);
    test::Codes codes = test::noiseVolume(size, 20, random);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                codes.at({x, y, z}) = std::uint16_t(codes.at({x, y, z}) + 290 + 150 * (x / 20));
    return codes;
}

/// Grown from nothing to closure, by seeds of segment 2.
class Grown {
public:
    Grown(const test::Codes& codes, const std::vector<glm::ivec3>& seeds,
        const std::vector<SeedGroup>& groups, int sigmas256)
    {
        QVERIFY(m_engine.openVolume(codes.size, codes.values));
        submitWhole(m_engine, SeedPlacement{.label = 2, .voxels = seeds});
        m_engine.submit(ProbeSeeds{.seedGroups = groups});
        probed = test::lastResult(m_engine).seeds;
        submitWhole(m_engine,
            GrowBurst{.lowCode = 0,
                .highCode = 65535,
                .limits = {.sigmas256 = sigmas256},
                .seedGroups = groups},
            {GrowAdvance{}});
        QVERIFY(!test::lastResult(m_engine).error);
    }
    [[nodiscard]] int voxels(int fromX, int toX) const
    {
        reference::DenseFields fields = m_engine.fields();
        int count = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = fromX; x < toX; ++x)
                    count += fields.labels(0).at({x, y, z}) != 0 ? 1 : 0;
        return count;
    }
    [[nodiscard]] std::vector<std::uint32_t> words() const
    {
        reference::DenseFields fields = m_engine.fields();
        return fields.seedWords(0).values;
    }

    std::vector<ProbedSeeds> probed;

private:
    ReferenceEngine m_engine;
};

} // namespace

/// Strokes of a segment that have statistics of their own.
class ReferenceSeedGroupsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// All seeds together let the tissue between in; each stroke by itself does not.
    void whatLiesBetweenStaysOut()
    {
        const glm::ivec3 dark(10, 6, 6);
        const glm::ivec3 bright(50, 6, 6);
        const test::Codes codes = threeTissues();
        const Grown together(codes, {dark, bright}, {}, 512);
        QCOMPARE(together.voxels(20, 40), 20 * 12 * 12);
        const Grown apart(codes, {dark, bright},
            {{.label = 2, .voxels = {dark}}, {.label = 2, .voxels = {bright}}}, 512);
        QCOMPARE(apart.voxels(20, 40), 0);
        // ± 2 σ of an even distribution is all of it.
        QCOMPARE(apart.voxels(0, 20), 20 * 12 * 12);
        QCOMPARE(apart.voxels(40, 60), 20 * 12 * 12);
        QCOMPARE(apart.probed.size(), std::size_t(2));
        for (std::size_t group = 0; group < 2; ++group) {
            QCOMPARE(apart.probed[group].group, std::optional(group));
            QCOMPARE(apart.probed[group].sums.voxels, std::uint64_t(343));
        }
        QCOMPARE(together.probed.size(), std::size_t(1));
        QVERIFY(!together.probed.front().group);
    }

    /// A seed that no group names goes by itself with the others of its kind.
    void seedsInNoGroupAreOneMore()
    {
        const Grown grown(threeTissues(), {{10, 6, 6}, {50, 6, 6}},
            {{.label = 2, .voxels = {{10, 6, 6}}}, {.label = 2, .voxels = {{30, 6, 6}}}}, 512);
        QCOMPARE(grown.voxels(0, 20), 20 * 12 * 12);
        QCOMPARE(grown.voxels(20, 40), 0); // no seed lies there, whatever is listed
        QCOMPARE(grown.voxels(40, 60), 20 * 12 * 12);
        QCOMPARE(grown.probed.size(), std::size_t(2));
        QVERIFY(grown.probed[0].group == std::size_t(0) && !grown.probed[1].group);
    }

    void oneGroupOfAllIsTheWholeSegment()
    {
        const test::Codes codes = threeTissues();
        for (int number = 0; number < 12; ++number) {
            test::Random random(std::uint32_t(500 + number));
            std::vector<glm::ivec3> seeds;
            for (int i = test::randomInt(random, 1, 20); i > 0; --i)
                seeds.push_back(test::randomVoxel(random, size));
            std::sort(seeds.begin(), seeds.end(), [](const glm::ivec3& a, const glm::ivec3& b) {
                return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
            });
            seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
            const int sigmas256 = test::randomInt(random, 10, 600);
            const Grown none(codes, seeds, {}, sigmas256);
            const Grown all(codes, seeds, {{.label = 2, .voxels = seeds}}, sigmas256);
            QVERIFY(none.words() == all.words());
            QCOMPARE(all.probed.front().sums, none.probed.front().sums);
            // Strokes of another segment leave it alone.
            const Grown other(codes, seeds, {{.label = 3, .voxels = seeds}}, sigmas256);
            QVERIFY(none.words() == other.words());
        }
    }
};

BURIN_TEST(ReferenceSeedGroupsTest)

} // namespace referenceSeedGroupsTest

#include "ReferenceSeedGroupsTest.moc"
