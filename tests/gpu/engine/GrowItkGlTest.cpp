// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/peers/ItkConnectedThreshold.h"
#include "tests/peers/ItkNeighborhoodConnected.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/growth/GrowToClosure.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace growItkGlTest {

/// Growth to closure is ITK's ConnectedThreshold, voxel for voxel, and the oracle's, word for word;
/// where all 27 voxels of a neighbourhood must qualify it is ITK's NeighborhoodConnected.
class GrowItkGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void randomVolume_data();
    void randomVolume();
    void wholeNeighbourhoods_data();
    void wholeNeighbourhoods();
    void realSeries_data();
    void realSeries();

private:
    test::EditEngineFixture m_gpu;
};

namespace {

std::int64_t countMembers(const std::vector<std::uint8_t>& mask)
{
    return std::count(mask.begin(), mask.end(), std::uint8_t{1});
}

/// Everything that the growth wrote, label plane and seed words.
std::vector<core::BrickChange> written(core::EditEngine& engine, const glm::ivec3& size,
    const std::vector<std::uint16_t>& codes, std::span<const glm::ivec3> seeds, int low, int high)
{
    if (!engine.openVolume(size, codes))
        return {};
    core::submitWhole(engine,
        core::SeedPlacement{.plane = 0, .label = 1, .voxels = {seeds.begin(), seeds.end()}});
    core::GrowBurst burst;
    burst.lowCode = low;
    burst.highCode = high;
    const core::Ticket ticket = core::submitWhole(engine, burst, {core::GrowAdvance{}});
    engine.finish();
    for (core::EngineResult& result : engine.collect()) {
        if (result.ticket == ticket)
            return std::move(result.changes);
    }
    return {};
}

bool equal(const std::vector<core::BrickChange>& a, const std::vector<core::BrickChange>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.key == y.key && x.before == y.before && x.after == y.after;
    });
}

} // namespace

void GrowItkGlTest::initTestCase()
{
    if (!m_gpu.isReady())
        QFAIL(m_gpu.why());
}

void GrowItkGlTest::randomVolume_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("share"); // accepted codes out of 1000
    // Around the percolation threshold of faces (31 %) growth takes its most tangled ways.
    QTest::newRow("noise, sparse") << 0 << 330;
    QTest::newRow("noise, tangled") << 1 << 400;
    QTest::newRow("noise, dense") << 2 << 700;
    QTest::newRow("balls in noise") << 3 << 0;
    QTest::newRow("odd size") << 4 << 360;
}

void GrowItkGlTest::randomVolume()
{
    QFETCH(int, kind);
    QFETCH(int, share);
    test::Random random(20260101U + unsigned(kind));
    const bool longRun = qEnvironmentVariableIsSet("BURIN_LONG");
    const glm::ivec3 size =
        (kind == 4 ? glm::ivec3(67, 41, 53) : glm::ivec3(80, 72, 64)) * (longRun ? 2 : 1);
    const bool inBalls = kind == 3;
    const test::Codes codes =
        inBalls ? test::balls(size, 60, random) : test::noiseVolume(size, 999, random);
    const int low = inBalls ? test::tissueCode - 200 : 0; // the noisiest of the balls are holes
    const int high = inBalls ? test::tissueCode : share - 1;
    const std::vector<glm::ivec3> seeds = test::seedsOnDiagonal(size, codes.values, low, high);

    QVERIFY(m_gpu.engine().openVolume(size, codes.values).has_value());
    const test::GrownVoxels ours = test::growToClosure(m_gpu.engine(), size, seeds, low, high);
    const std::vector<float> values(codes.values.begin(), codes.values.end());
    const peer::ItkGrown theirs =
        peer::itkConnectedThreshold<float>(size, values, seeds, float(low), float(high));
    QVERIFY(countMembers(theirs.mask) > 500);
    QCOMPARE(countMembers(ours.mask), countMembers(theirs.mask));
    QVERIFY(ours.mask == theirs.mask);

    reference::ReferenceEngine oracle;
    QVERIFY(equal(written(oracle, size, codes.values, seeds, low, high),
        written(m_gpu.engine(), size, codes.values, seeds, low, high)));
    QCOMPARE(m_gpu.newErrors(), 0);
}

void GrowItkGlTest::wholeNeighbourhoods_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("noise") << 0;
    QTest::newRow("balls in noise") << 1;
    QTest::newRow("to the rim") << 2;
}

void GrowItkGlTest::wholeNeighbourhoods()
{
    QFETCH(int, kind);
    test::Random random(20260201U + unsigned(kind));
    const glm::ivec3 size(67, 41, 53);
    std::array<glm::ivec3, 27> around;
    for (int i = 0; i < 27; ++i)
        around[std::size_t(i)] = glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    test::Codes codes = test::noiseVolume(size, 999, random);
    int low = 0;
    int high = kind == 0 ? 975 : 999;
    if (kind == 1) {
        codes = test::balls(size, 60, random);
        low = test::tissueCode / 2;
        high = test::tissueCode;
    } else if (kind == 2) {
        codes.at({30, 20, 20}) = 2000;
    }
    // ITK takes every seed, whatever lies around it; growth asks them too.
    std::vector<glm::ivec3> seeds;
    for (int i = 0; i < 4000; ++i) {
        const glm::ivec3 voxel = test::randomVoxel(random, size);
        if (std::all_of(around.begin(), around.end(), [&](const glm::ivec3& step) {
                const int code = codes.at(glm::clamp(voxel + step, glm::ivec3(0), size - 1));
                return code >= low && code <= high;
            }))
            seeds.push_back(voxel);
    }
    QVERIFY(m_gpu.engine().openVolume(size, codes.values).has_value());
    const test::GrownVoxels ours =
        test::growToClosure(m_gpu.engine(), size, seeds, low, high, {.majority = 27});
    const std::vector<std::uint8_t> theirs = peer::itkNeighborhoodConnected(
        size, codes.values, seeds, std::uint16_t(low), std::uint16_t(high));
    QVERIFY2(countMembers(theirs) > 500, qPrintable(QString::number(countMembers(theirs))));
    QCOMPARE(countMembers(ours.mask), countMembers(theirs));
    QVERIFY(ours.mask == theirs);
    QCOMPARE(m_gpu.newErrors(), 0);
}

void GrowItkGlTest::realSeries_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("lower"); // modality units
    QTest::addColumn<double>("upper");
    QTest::newRow("skull") << QStringLiteral("ct_cranium_inv3") << 226.0 << 3071.0;
    QTest::newRow("abdomen") << QStringLiteral("ct_abdomen_j2k_organs") << -29.5 << 150.5;
    QTest::newRow("brain") << QStringLiteral("mr_t1_sag_mprage") << 90.0 << 400.0;
}

void GrowItkGlTest::realSeries()
{
    QFETCH(QString, name);
    QFETCH(double, lower);
    QFETCH(double, upper);
    const test::SharedCase data = test::sharedCase(name);
    if (data.source.isEmpty())
        QSKIP("the shared test data are not there (BURIN_SHARED_DATA)");
    const auto loaded = core::loadVolume(
        data.unpacked.isEmpty() ? data.source + QStringLiteral("/dicom") : data.unpacked);
    QVERIFY(loaded.has_value());
    const glm::ivec3 size = loaded->volume.geometry.size;
    const core::VoxelEncoding& encoding = loaded->volume.encoding;
    const int low = encoding.lowestCodeAtLeast(lower);
    const int high = encoding.highestCodeAtMost(upper);
    const std::vector<glm::ivec3> seeds = test::seedsOnDiagonal(size, loaded->codes, low, high);

    QVERIFY(m_gpu.engine().openVolume(size, loaded->codes).has_value());
    const test::GrownVoxels ours = test::growToClosure(m_gpu.engine(), size, seeds, low, high);
    // ITK sees modality values and the bounds as the user gave them.
    std::vector<float> values(loaded->codes.size());
    std::transform(loaded->codes.begin(), loaded->codes.end(), values.begin(),
        [&encoding](int code) { return static_cast<float>(encoding.value(code)); });
    const peer::ItkGrown theirs =
        peer::itkConnectedThreshold<float>(size, values, seeds, float(lower), float(upper));
    QVERIFY2(countMembers(theirs.mask) > 100'000,
        qPrintable(QString::number(countMembers(theirs.mask))));
    QCOMPARE(countMembers(ours.mask), countMembers(theirs.mask));
    QVERIFY(ours.mask == theirs.mask);

    reference::ReferenceEngine oracle;
    QVERIFY(equal(written(oracle, size, loaded->codes, seeds, low, high),
        written(m_gpu.engine(), size, loaded->codes, seeds, low, high)));
    QCOMPARE(m_gpu.newErrors(), 0);
}

BURIN_TEST(GrowItkGlTest)

} // namespace growItkGlTest

#include "GrowItkGlTest.moc"
