// SPDX-License-Identifier: Apache-2.0
#include "core/volume/MemoryLimit.h"
#include "gpu/engine/MemoryFormula.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomHistory.h"
#include "tests/support/faults/RefusingGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/fixtures/WatchedEngine.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>

#include <sys/mman.h>

namespace refusedMemoryGlTest {

using namespace core;
using test::EngineCase;
using test::RefusingGl;
using test::WatchedEngine;

namespace {

std::vector<EngineCase> cases()
{
    // Few of each kind, since dozens of their storages are refused in turn, twice.
    const int count = test::longRun() ? 3 : 1;
    std::vector<EngineCase> made;
    for (auto more : {test::growthCases(count), test::growLimitCases(count),
             test::seedGroupCases(count), test::intervalCases(count), test::overwrittenCases(count),
             test::wideGrowthCases(count), test::passageCases(count), test::drillCases(count),
             test::peelCases(count), test::scissorsCases(count), test::laserCases(count),
             test::carveCases(count), test::pickCases(count), test::eraseCases(count),
             test::layerCases(count), test::capsuleCases(count), test::layerWriteCases(count),
             test::relabelCases(count), test::outlineCases(count), test::thresholdCases(count),
             test::segmentScissorsCases(count), test::mapCases(count), test::barrierCases(count),
             test::protectedCases(count), test::spreadCases(count), test::toleranceCases(count),
             test::editableCases(count), test::backwardCases(count)})
        made.insert(made.end(), more.begin(), more.end());
    if (test::longRun())
        return made;
    std::vector<EngineCase> some;
    for (std::size_t i = 0; i < made.size(); i += 7)
        some.push_back(std::move(made[i]));
    return some;
}

/// So many storages of a case are refused for their place in line.
int mostTried(bool onAndOn)
{
    constexpr int daily = 8;
    constexpr int alone = 24;
    constexpr int withAllThatFollow = 12; // which mostly ends in the same way
    if (!test::longRun())
        return daily;
    return onAndOn ? withAllThatFollow : alone;
}

/// At most so many numbers of 1 … @p calls, evenly spread, the first and the last among them.
std::vector<int> evenly(int calls, int most)
{
    const int count = std::min(calls, most);
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i)
        numbers.push_back(count == 1 ? 1 : 1 + int(std::int64_t(i) * (calls - 1) / (count - 1)));
    return numbers;
}

} // namespace

/// The GPU has no more memory: at each of the places where it is asked for some, an edit is either
/// carried out whole or refused with everything as it was.
///
/// Of the thousands of storages of a case most are asked for in the same place, by the same
/// command, once for each generation or brick. BURIN_LONG: of each case some are refused, evenly
/// spread, the first and the last among them, and besides the first of each place at which none was
/// refused in the cases before; once alone, and once with all that follow. So none is left out of
/// all places in the program, and a case takes as long as some dozens of runs.
class RefusedMemoryGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void everyEditIsWholeOrRefused_data();
    void everyEditIsWholeOrRefused();
    void anyErrorIsRefused_data();
    void anyErrorIsRefused();
    void aSessionGoesOn_data();
    void aSessionGoesOn();
    void changesAreReadInParts();
    void aVolumeThatDoesNotFit_data();
    void aVolumeThatDoesNotFit();
    void aPlaceIsMetAgain();
    void aVolumeThatIsTooLong();
    void texturesThatDoNotFitBesideTheProgram();
    void codesMakeRoomForTextures();

private:
    test::EditEngineFixture m_gpu{gpu::WorkBy::Kernels}; ///< which ask for more memory
    /// The places at which a call was refused, of storages: alone, and with all that follow.
    std::array<std::set<std::uint64_t>, 2> m_struck;
    std::set<std::uint64_t> m_struckDispatches;
    int m_failed = 0; ///< edits that an error other than memory refused
    int m_withoutDispatch = 0; ///< cases in which nothing is dispatched, as a pen that hits nothing
};

void RefusedMemoryGlTest::initTestCase()
{
    QVERIFY2(m_gpu.isReady(), m_gpu.why());
}

void RefusedMemoryGlTest::everyEditIsWholeOrRefused_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<bool>("onAndOn");
    int number = 0;
    for (const EngineCase& each : cases()) {
        QTest::addRow("%s", each.name.constData()) << number << false;
        QTest::addRow("%s, from then on", each.name.constData()) << number << true;
        ++number;
    }
}

void RefusedMemoryGlTest::everyEditIsWholeOrRefused()
{
    QFETCH(int, number);
    QFETCH(bool, onAndOn);
    static const std::vector<EngineCase> all = cases();
    const EngineCase& engineCase = all.at(std::size_t(number));
    int calls = 0;
    std::vector<std::uint64_t> sites;
    // Twice in the long run: what is kept for the next edit is asked for in the first one only.
    for (int run = 0; run < (test::longRun() ? 2 : 1); ++run) {
        RefusingGl counting(0);
        WatchedEngine watched(m_gpu, counting);
        (void)test::runCase(watched, engineCase);
        QVERIFY2(watched.found.isEmpty(), qPrintable(watched.found));
        QCOMPARE(watched.refusedEdits, 0);
        calls = counting.calls();
        sites = counting.sites();
    }
    QVERIFY(calls > 0);
    const RefusingGl::From from = onAndOn ? RefusingGl::From::OnAndOn : RefusingGl::From::Once;
    std::set<std::uint64_t>& struck = m_struck.at(onAndOn ? 1 : 0);
    int refused = 0;
    int refusedEdits = 0;
    int lost = 0;
    const auto found = [&](RefusingGl& refusing, const QString& what) {
        WatchedEngine watched(m_gpu, refusing);
        (void)test::runCase(watched, engineCase);
        if (refusing.refused() > 0) { // how much is asked for varies a little
            ++refused;
            struck.insert(refusing.refusedSite());
        }
        refusedEdits += watched.refusedEdits;
        lost += watched.lost;
        if (watched.found.isEmpty() && watched.lost > 0 && !onAndOn)
            return what + QStringLiteral("the content is lost");
        return watched.found.isEmpty() ? QString() : what + watched.found;
    };
    const std::vector<int> numbers = evenly(calls, mostTried(onAndOn));
    for (const int first : numbers) {
        RefusingGl refusing(first, from);
        const QString wrong =
            found(refusing, QStringLiteral("call %1 of %2: ").arg(first).arg(calls));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
    QVERIFY(refused > int(numbers.size()) / 2);
    int missed = 0;
    for (std::size_t i = 0; test::longRun() && i < sites.size(); ++i) {
        if (struck.contains(sites[i]))
            continue;
        RefusingGl refusing(RefusingGl::Site{.place = sites[i]}, from);
        const QString wrong =
            found(refusing, QStringLiteral("place of call %1 of %2: ").arg(i + 1).arg(calls));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        // Not tried again: what is asked for once only, as a kernel is made, is there by now.
        missed += struck.insert(sites[i]).second ? 1 : 0;
    }
    const std::set<std::uint64_t> places(sites.begin(), sites.end());
    QVERIFY2(missed * 10 <= int(places.size()),
        qPrintable(QStringLiteral("%1 of %2 places").arg(missed).arg(places.size())));
    qInfo("%d of %d storages refused, at %d places: %d edits refused, lost %d times; %d places "
          "were not met again",
        refused, calls, int(places.size()), refusedEdits, lost, missed);
}

void RefusedMemoryGlTest::anyErrorIsRefused_data()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const EngineCase& each : cases())
        QTest::addRow("%s", each.name.constData()) << number++;
}

/// The driver does not carry out a dispatch, with an error that has nothing to do with memory.
void RefusedMemoryGlTest::anyErrorIsRefused()
{
    QFETCH(int, number);
    static const std::vector<EngineCase> all = cases();
    const EngineCase& engineCase = all.at(std::size_t(number));
    int calls = 0;
    std::vector<std::uint64_t> sites;
    {
        RefusingGl counting(RefusingGl::Dispatch{0});
        WatchedEngine watched(m_gpu, counting);
        (void)test::runCase(watched, engineCase);
        QVERIFY2(watched.found.isEmpty(), qPrintable(watched.found));
        calls = counting.calls();
        sites = counting.sites();
    }
    m_withoutDispatch += calls == 0 ? 1 : 0;
    int tried = 0;
    int failed = 0;
    const auto found = [&](RefusingGl& refusing, const QString& what) {
        ++tried;
        WatchedEngine watched(m_gpu, refusing);
        (void)test::runCase(watched, engineCase);
        if (refusing.refused() > 0)
            m_struckDispatches.insert(refusing.refusedSite());
        // Where storage is asked for next, that is what is said to have been refused.
        failed += watched.failedEdits + watched.refusedEdits;
        m_failed += watched.failedEdits;
        if (watched.found.isEmpty() && watched.lost > 0)
            return what + QStringLiteral("the content is lost");
        return watched.found.isEmpty() ? QString() : what + watched.found;
    };
    for (const int first : evenly(calls, test::longRun() ? 8 : 3)) {
        RefusingGl refusing(RefusingGl::Dispatch{first});
        const QString wrong =
            found(refusing, QStringLiteral("dispatch %1 of %2: ").arg(first).arg(calls));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
    for (std::size_t i = 0; test::longRun() && i < sites.size(); ++i) {
        if (m_struckDispatches.contains(sites[i]))
            continue;
        RefusingGl refusing(RefusingGl::Site{.place = sites[i], .isDispatch = true});
        const QString wrong =
            found(refusing, QStringLiteral("place of dispatch %1 of %2: ").arg(i + 1).arg(calls));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        m_struckDispatches.insert(sites[i]);
    }
    qInfo("%d of %d dispatches refused: %d edits refused", tried, calls, failed);
    if (number + 1 == int(all.size())) {
        QVERIFY(m_failed > 0);
        QVERIFY(m_withoutDispatch * 4 < int(all.size()));
    }
}

void RefusedMemoryGlTest::aSessionGoesOn_data()
{
    QTest::addColumn<uint>("seed");
    QTest::addColumn<bool>("imports");
    for (uint seed = 71; seed < (test::longRun() ? 79u : 73u); ++seed) {
        const bool imports = seed % 2 == 0;
        QTest::addRow("seed %u%s", seed, imports ? ", with imports" : "") << seed << imports;
    }
}

/// A hasty user whose GPU refuses memory now and then: after each step the session holds what its
/// history says, and the file opens again. In every second history masks that overlap are imported,
/// for which further label planes are needed.
void RefusedMemoryGlTest::aSessionGoesOn()
{
    QFETCH(uint, seed);
    QFETCH(bool, imports);
    RefusingGl refusing(seed, 30, 90);
    std::optional<RefusingGl::Pause> pause(std::in_place, refusing);
    test::RandomHistory history =
        test::runRandomHistory(m_gpu.engine(), test::longRun() ? 500 : 400, seed,
            [&](bool acting) {
                if (acting)
                    pause.reset();
                else
                    pause.emplace(refusing);
            },
            {.planes = imports});
    QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
    int done = 0;
    for (const auto& [what, count] : history.done)
        done += count;
    const QString mask = QStringLiteral("importMask");
    qInfo("%d storages of %d refused, %d steps done; %d masks imported, %d refused",
        refusing.refused(), refusing.calls(), done, history.done[mask], history.refused[mask]);
    QVERIFY(refusing.refused() > 10);
    QVERIFY(done > 20);
    QCOMPARE(history.done[mask] > 0, imports);
}

/// What an edit has changed in thousands of bricks is read bit by bit before it is committed.
void RefusedMemoryGlTest::changesAreReadInParts()
{
    const glm::ivec3 bricks(48, 43, 1); // more than make up one part
    const glm::ivec3 size(16 * bricks.x, 16 * bricks.y, 1);
    const std::vector<std::uint16_t> codes(std::size_t(size.x * size.y), 7);
    int calls = 0;
    int refused = 0;
    int refusedEdits = 0;
    std::size_t changed = 0;
    const auto wrongWhereRefused = [&](int first) {
        RefusingGl refusing(first);
        WatchedEngine watched(m_gpu, refusing);
        {
            const RefusingGl::Pause pause(refusing);
            if (!watched.openVolume(size, codes))
                return QStringLiteral("no volume");
        }
        watched.submit(BeginEdit{LabelThreshold{.target = {.plane = 0, .label = 1}}});
        watched.submit(EndEdit{Ending::Commit});
        const std::vector<EngineResult> results = watched.collect();
        calls = refusing.calls();
        refused += refusing.refused();
        refusedEdits += watched.refusedEdits;
        changed = results.empty() ? 0 : results.back().changes.size();
        return watched.lost > 0 ? QStringLiteral("the content is lost") : watched.found;
    };
    const QString wrong = wrongWhereRefused(0);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    QCOMPARE(refusedEdits, 0);
    QVERIFY(changed >= std::size_t(bricks.x * bricks.y));
    const int asked = calls;
    for (const int first : evenly(asked, test::longRun() ? 64 : 12)) {
        const QString found = wrongWhereRefused(first);
        QVERIFY2(found.isEmpty(),
            qPrintable(QStringLiteral("call %1 of %2: %3").arg(first).arg(asked).arg(found)));
    }
    QVERIFY(refused > 0 && refusedEdits > 0);
    qInfo("%d storages, %d refused: %d edits refused", asked, refused, refusedEdits);
}

void RefusedMemoryGlTest::aVolumeThatDoesNotFit_data()
{
    QTest::addColumn<bool>("taken");
    QTest::newRow("codes that are lent") << false;
    QTest::newRow("codes that are given away") << true;
}

void RefusedMemoryGlTest::aVolumeThatDoesNotFit()
{
    QFETCH(bool, taken);
    const glm::ivec3 size(24, 24, 40); // so that codes are given back before textures are refused
    std::vector<std::uint16_t> codes(std::size_t(size.x * size.y * size.z));
    std::iota(codes.begin(), codes.end(), std::uint16_t(0));
    const auto open = [&] {
        return taken ? m_gpu.engine().takeVolume(size, codes)
                     : m_gpu.engine().openVolume(size, codes);
    };
    int calls = 0;
    {
        const RefusingGl counting(0);
        QVERIFY(open());
        calls = counting.calls();
    }
    QVERIFY(calls >= 8);
    for (int first = 1; first <= calls; ++first) {
        {
            const RefusingGl refusing(first);
            const auto opened = open();
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::OutOfMemory);
        }
        // Nothing is open, and that is said.
        m_gpu.engine().submit(ReadBricks{{{Field::Labels, 0, 0}}});
        QVERIFY(test::lastResult(m_gpu.engine()).error);
        QVERIFY(open());
        m_gpu.engine().submit(ReadCodes{.box = {glm::ivec3(0), size}});
        const EngineResult read = test::lastResult(m_gpu.engine());
        QVERIFY(!read.error);
        QVERIFY(read.codes == codes);
    }
}

/// What the long run relies on: a place in the program is known again.
void RefusedMemoryGlTest::aPlaceIsMetAgain()
{
    const std::vector<std::uint16_t> codes(std::size_t(24 * 24 * 24), 7);
    std::vector<std::uint64_t> sites;
    {
        const RefusingGl counting(0);
        QVERIFY(m_gpu.engine().openVolume({24, 24, 24}, codes));
        sites = counting.sites();
        QCOMPARE(int(sites.size()), counting.calls());
    }
    const std::set<std::uint64_t> places(sites.begin(), sites.end());
    QVERIFY(places.size() > 1);
    for (const std::uint64_t place : places) {
        const RefusingGl refusing(RefusingGl::Site{.place = place});
        QVERIFY(!m_gpu.engine().openVolume({24, 24, 24}, codes));
        QCOMPARE(refusing.refused(), 1);
        QCOMPARE(refusing.refusedSite(), place);
    }
    QVERIFY(m_gpu.engine().openVolume({24, 24, 24}, codes));
}

void RefusedMemoryGlTest::aVolumeThatIsTooLong()
{
    // Longer than the textures of any driver: the message says so, and not that memory is wanting.
    const std::vector<std::uint16_t> codes(40000, 7);
    const auto opened = m_gpu.engine().openVolume({1, 40000, 1}, codes);
    QVERIFY(!opened);
    QCOMPARE(opened.error().code, ErrorCode::OutOfMemory);
    const QString reason = opened.error().arguments.value(0);
    QVERIFY2(reason.startsWith(QStringLiteral("the volume has 1 × 40000 × 1 voxels, and "))
            && reason.endsWith(QStringLiteral(" along a side")),
        qPrintable(reason));
}

void RefusedMemoryGlTest::texturesThatDoNotFitBesideTheProgram()
{
    if (!m_gpu.rendererName().contains("llvmpipe"))
        QSKIP("the textures of this driver have a memory of their own");
    glm::ivec3 size(2048, 2048, 1);
    const auto needed = [&size] {
        return 2.0 * size.x * size.y * size.z + double(gpu::MemoryFormula::denseBytes(size));
    };
    while (needed() <= allowedBytes())
        ++size.z;
    if (size.z > 2048)
        QSKIP("this machine has memory for textures of any size");
    // The codes alone would fit; nobody looks at them.
    const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    QVERIFY(checkMemory(voxels));
    void* nothing = mmap(nullptr, voxels * sizeof(std::uint16_t), PROT_READ,
        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    QVERIFY(nothing != MAP_FAILED);
    const auto opened =
        m_gpu.engine().openVolume(size, {static_cast<const std::uint16_t*>(nothing), voxels});
    munmap(nothing, voxels * sizeof(std::uint16_t));
    QVERIFY(!opened);
    QCOMPARE(opened.error().code, ErrorCode::OutOfMemory);
    const QString reason = opened.error().arguments.value(0);
    QVERIFY2(reason.startsWith(QStringLiteral("the volume with its textures needs ")),
        qPrintable(reason));
}

void RefusedMemoryGlTest::codesMakeRoomForTextures()
{
    const glm::ivec3 size(64, 48, 70); // slices come in sixteens, and the last are fewer
    test::Random random{7};
    const std::vector<std::uint16_t> codes = test::noiseVolume(size, 3000, random).values;
    // Enough for the textures, and for half of the codes beside them.
    const AllowedBytes allowed(double(gpu::MemoryFormula::denseBytes(size)) + double(codes.size()));
    if (m_gpu.rendererName().contains("llvmpipe")) {
        const auto opened = m_gpu.engine().openVolume(size, codes);
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::OutOfMemory);
    }
    QVERIFY(m_gpu.engine().takeVolume(size, codes));
    m_gpu.engine().submit(ReadCodes{.box = {glm::ivec3(0), size}});
    const EngineResult read = test::lastResult(m_gpu.engine());
    QVERIFY(!read.error);
    QVERIFY(read.codes == codes);
    const AllowedBytes tooFew(double(gpu::MemoryFormula::denseBytes(size)) - 1.0);
    if (m_gpu.rendererName().contains("llvmpipe"))
        QVERIFY(!m_gpu.engine().takeVolume(size, codes));
}

BURIN_TEST(RefusedMemoryGlTest)

} // namespace refusedMemoryGlTest

#include "RefusedMemoryGlTest.moc"
