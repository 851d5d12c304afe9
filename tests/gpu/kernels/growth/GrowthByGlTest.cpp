// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace growthByGlTest {

using test::EngineCase;

namespace {

/// Generations of so many voxels that the processor claims them on several threads; bricks at three
/// sides are not whole.
EngineCase manyAtOnce(int connectivity)
{
    const glm::ivec3 size(234, 230, 5);
    EngineCase made{"a plane of seeds, " + QByteArray::number(connectivity) + " neighbours",
        test::constantVolume(size, 7), {}};
    core::SeedPlacement seeds{.label = 1};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            seeds.voxels.emplace_back(x, y, 0);
    test::appendWhole(made.steps, seeds);
    const core::GrowBurst burst{.lowCode = 0, .highCode = 7, .connectivity = connectivity};
    test::appendBurst(made.steps, burst, core::GrowAdvance::toClosure);
    return made;
}

/// The second generation has more voxels than the kernels' queue holds at first, by when one of two
/// labels has ended: the processor takes the front over in the middle of the burst, in bricks that
/// kernels have filled. That generation also ends in a brick which no other comes to.
EngineCase takenOver()
{
    const glm::ivec3 size(384, 384, 18);
    const int width = 368; // whole bricks
    const int seeded = 15; // the last slice of the lower bricks; growth goes up into empty ones
    EngineCase made{"a front that is taken over", test::constantVolume(size, 0), {}};
    const glm::ivec3 apart(0, 0, 0);
    for (const glm::ivec3& single :
        {apart, apart + glm::ivec3(1, 0, 0), glm::ivec3(width, 1, seeded)})
        made.codes.at(single) = 7;
    for (int z = seeded; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < width; ++x)
                made.codes.at({x, y, z}) = 7;
    core::SeedPlacement seeds{.label = 1};
    for (int y = 1; y < size.y; y += 3)
        for (int x = 1; x < width; x += 3)
            seeds.voxels.emplace_back(x, y, seeded);
    test::appendWhole(made.steps, seeds);
    test::appendWhole(made.steps, core::SeedPlacement{.label = 2, .voxels = {apart}});
    const core::GrowBurst burst{.lowCode = 7, .highCode = 7, .connectivity = 26};
    test::appendBurst(made.steps, burst, core::GrowAdvance::toClosure);
    return made;
}

std::vector<EngineCase> cases()
{
    const bool all = test::longRun();
    std::vector<EngineCase> made = test::growthCases(all ? 400 : 12);
    for (auto more : {test::growLimitCases(all ? 400 : 8), test::seedGroupCases(all ? 400 : 8),
             test::intervalCases(all ? 300 : 8), test::overwrittenCases(all ? 400 : 12),
             test::wideGrowthCases(all ? 300 : 16), test::editableCases(all ? 400 : 8),
             test::barrierCases(all ? 400 : 8)})
        made.insert(made.end(), more.begin(), more.end());
    for (const int connectivity : {6, 26})
        made.push_back(manyAtOnce(connectivity));
    made.push_back(takenOver());
    return made;
}

} // namespace

/// Kernels and the processor grow alike: both are held to the oracle, whichever of them the driver
/// at hand would choose (EngineConformanceGlTest sees that one only).
class GrowthByGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup();
    void conforms_data();
    void conforms();

private:
    test::EditEngineFixture m_byKernels{gpu::WorkBy::Kernels};
    test::EditEngineFixture m_byProcessor{gpu::WorkBy::Processor};
};

void GrowthByGlTest::initTestCase()
{
    QVERIFY2(m_byKernels.isReady(), m_byKernels.why());
    QVERIFY2(m_byProcessor.isReady(), m_byProcessor.why());
}

void GrowthByGlTest::cleanup()
{
    QCOMPARE(m_byKernels.newErrors() + m_byProcessor.newErrors(), 0);
}

void GrowthByGlTest::conforms_data()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const EngineCase& each : cases())
        QTest::addRow("%s", each.name.constData()) << number++;
}

void GrowthByGlTest::conforms()
{
    QFETCH(int, number);
    static const std::vector<EngineCase> all = cases();
    const EngineCase& engineCase = all.at(std::size_t(number));
    reference::ReferenceEngine oracle;
    const test::EngineOutcome expected = test::runCase(oracle, engineCase);
    for (test::EditEngineFixture* const gpu : {&m_byKernels, &m_byProcessor}) {
        const QString found = test::difference(expected, test::runCase(gpu->engine(), engineCase));
        QVERIFY2(found.isEmpty(),
            qPrintable((gpu == &m_byKernels ? QStringLiteral("by kernels: ")
                                            : QStringLiteral("by the processor: "))
                + found));
    }
}

BURIN_TEST(GrowthByGlTest)

} // namespace growthByGlTest

#include "GrowthByGlTest.moc"
