// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <memory>

namespace referenceOverwrittenTest {

using namespace core;
using reference::ReferenceEngine;
using test::lastResult;

using Labels = std::vector<std::uint8_t>;

/// What a growth takes from other segments it gives back where it leaves (rules in
/// core/growth/GrowthCommands.h), on a line of voxels that label 4 grows along from its beginning.
class ReferenceOverwrittenTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void shrinkingGivesBack();
    void narrowingGivesBack();
    void growingAnewGivesBack();
    void cuttingGivesBack();
    void barriersGiveBack();
    void seedsGiveBack();
    void locksDoNotHoldItBack();
    void nothingIsRememberedForSessionsOfBefore();
    void whatMayNotBeTakenAnyMoreIsGivenBack();
    void aDeletedSegmentStaysAway();
    void whatWasPaintedMeanwhileStays();
    void nothingStaleComesBack_data();
    void nothingStaleComesBack();

private:
    EngineResult grow(GrowBurst burst = {});
    EngineResult edit(const EngineEdit& edit, std::vector<EngineExtension> extensions = {});
    void shrink(std::uint32_t keep, bool keepSeeds = false);
    /// A brush over the voxels from first to last.
    void paint(std::uint8_t label, int first, int last, bool erase = false);
    [[nodiscard]] Labels labels() const;
    [[nodiscard]] Labels overwritten() const;

    std::unique_ptr<ReferenceEngine> m_engine;
    std::uint32_t m_generation = 0;
};

namespace {

const Labels held{0, 0, 9, 9, 0, 7, 7, 0};
constexpr int mm = 65536;

CapsuleFrame brush()
{
    CapsuleFrame frame;
    frame.perI = {std::int64_t(1) << 30, 0, 0};
    frame.perJ = {0, std::int64_t(1) << 30, 0};
    frame.perK = {0, 0, std::int64_t(1) << 30};
    frame.radius = mm / 4;
    frame.rampHalfWidth = 1;
    frame.reach = 20 * mm;
    while (frame.reach >> frame.shift >= 1 << 14)
        ++frame.shift;
    return frame;
}

CapsulePath along(int first, int last)
{
    return {{{.from = {first * mm, 0, 0},
        .direction = {1 << 14, 0, 0},
        .length = (last - first) * mm}}};
}

/// That may take from both of the others.
GrowBurst taking(GrowOpening opening = GrowOpening::GoOn)
{
    GrowBurst burst{.lowCode = 5, .highCode = 6, .opening = opening};
    burst.overwritable.set(7).set(9);
    return burst;
}

} // namespace

void ReferenceOverwrittenTest::init()
{
    test::failOnUnexpectedMessages();
    m_engine = std::make_unique<ReferenceEngine>();
    m_generation = 0;
    const glm::ivec3 size(8, 1, 1);
    QVERIFY(m_engine->openVolume(size, std::vector<std::uint16_t>{5, 5, 5, 6, 6, 6, 6, 6}));
    m_engine->submit(SwapBricks{test::bricksOf({size, held}, Field::Labels, 0)});
    edit(SeedPlacement{.label = 4, .voxels = {{0, 0, 0}}});
    QCOMPARE(grow(taking()).generation, 8u);
    QCOMPARE(labels(), Labels(8, 4));
    QCOMPARE(overwritten(), held);
}

EngineResult ReferenceOverwrittenTest::grow(GrowBurst burst)
{
    burst.generation = m_generation;
    const EngineResult result = edit(burst, {GrowAdvance{}});
    m_generation = result.generation;
    return result;
}

EngineResult ReferenceOverwrittenTest::edit(
    const EngineEdit& edit, std::vector<EngineExtension> extensions)
{
    submitWhole(*m_engine, edit, std::move(extensions));
    return lastResult(*m_engine);
}

void ReferenceOverwrittenTest::shrink(std::uint32_t keep, bool keepSeeds)
{
    m_generation =
        edit(ShrinkGrowth{.generation = m_generation, .keep = keep, .keepSeeds = keepSeeds})
            .generation;
}

void ReferenceOverwrittenTest::paint(std::uint8_t label, int first, int last, bool erase)
{
    PaintLabel paint{.label = label, .erase = erase, .frame = brush()};
    paint.overwritable.set();
    edit(paint, {along(first, last)});
}

Labels ReferenceOverwrittenTest::labels() const
{
    reference::DenseFields fields = m_engine->fields();
    return fields.labels(0).values;
}

Labels ReferenceOverwrittenTest::overwritten() const
{
    reference::DenseFields fields = m_engine->fields();
    return fields.overwritten(0).values;
}

void ReferenceOverwrittenTest::shrinkingGivesBack()
{
    shrink(3);
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 7, 7, 0}));
    QCOMPARE(overwritten(), (Labels{0, 0, 9, 0, 0, 0, 0, 0}));
    grow(taking());
    QCOMPARE(labels(), Labels(8, 4));
    shrink(0, true);
    QCOMPARE(labels(), (Labels{4, 0, 9, 9, 0, 7, 7, 0}));
    shrink(0);
    QCOMPARE(labels(), held);
    QCOMPARE(overwritten(), Labels(8, 0));
}

void ReferenceOverwrittenTest::narrowingGivesBack()
{
    GrowBurst narrow = taking(GrowOpening::Narrow);
    narrow.highCode = 5;
    grow(narrow);
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 7, 7, 0}));
    grow(taking(GrowOpening::Narrow));
    QCOMPARE(labels(), Labels(8, 4));
    QCOMPARE(overwritten(), held);
}

void ReferenceOverwrittenTest::growingAnewGivesBack()
{
    GrowBurst anew = taking(GrowOpening::Restart);
    anew.overwritable.reset(7);
    grow(anew);
    QCOMPARE(labels(), (Labels{4, 4, 4, 4, 4, 7, 7, 0}));
    anew.overwritable.reset();
    grow(anew);
    QCOMPARE(labels(), (Labels{4, 4, 9, 9, 0, 7, 7, 0}));
    QCOMPARE(overwritten(), Labels(8, 0));
}

void ReferenceOverwrittenTest::cuttingGivesBack()
{
    edit(CutGrowth{.how = CutGrowth::How::Here,
        .barrier = false,
        .generation = m_generation,
        .voxels = {{3, 0, 0}, {4, 0, 0}}});
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 4, 4, 4}));
    QCOMPARE(overwritten(), (Labels{0, 0, 9, 0, 0, 7, 7, 0}));
}

void ReferenceOverwrittenTest::barriersGiveBack()
{
    edit(PaintBarrier{.frame = brush()}, {along(3, 5)});
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 7, 4, 4}));
    QCOMPARE(overwritten(), (Labels{0, 0, 9, 0, 0, 0, 7, 0}));
}

void ReferenceOverwrittenTest::seedsGiveBack()
{
    shrink(0);
    edit(SeedPlacement{.label = 4, .voxels = {{6, 0, 0}}});
    GrowBurst first = taking();
    edit(first, {GrowAdvance{0}});
    m_generation = 1;
    QCOMPARE(labels(), (Labels{4, 0, 9, 9, 0, 7, 4, 0}));
    // Where it may not stay, it waits again.
    GrowBurst narrow = taking(GrowOpening::Narrow);
    narrow.highCode = 5;
    grow(narrow);
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 7, 7, 0}));
    reference::DenseFields fields = m_engine->fields();
    QCOMPARE(fields.seedWords(0).values[6], seedWord::pendingSeed(4));
}

void ReferenceOverwrittenTest::locksDoNotHoldItBack()
{
    ShrinkGrowth locked{.generation = m_generation, .keep = 3};
    locked.lockedLabels.set(9);
    edit(locked);
    QCOMPARE(labels(), (Labels{4, 4, 4, 9, 0, 7, 7, 0}));
}

void ReferenceOverwrittenTest::nothingIsRememberedForSessionsOfBefore()
{
    shrink(0);
    GrowBurst before = taking();
    before.tellsHeld = false;
    grow(before);
    QCOMPARE(overwritten(), Labels(8, 0));
    shrink(3);
    QCOMPARE(labels(), (Labels{4, 4, 4, 0, 0, 0, 0, 0}));
}

void ReferenceOverwrittenTest::whatMayNotBeTakenAnyMoreIsGivenBack()
{
    // As growing from scratch would not take it.
    GrowBurst narrow = taking(GrowOpening::Narrow);
    narrow.overwritable.reset(7);
    grow(narrow);
    QCOMPARE(labels(), (Labels{4, 4, 4, 4, 4, 7, 7, 0}));
    QCOMPARE(overwritten(), (Labels{0, 0, 9, 9, 0, 0, 0, 0}));
}

void ReferenceOverwrittenTest::aDeletedSegmentStaysAway()
{
    const EngineResult erased = edit(EraseLabel{.label = 9});
    QCOMPARE(erased.statistics.voxelsChanged, 0);
    QCOMPARE(overwritten(), (Labels{0, 0, 0, 0, 0, 7, 7, 0}));
    SwapBricks undo;
    for (const BrickChange& change : erased.changes)
        undo.bricks.push_back({change.key, change.before});
    shrink(1);
    QCOMPARE(labels(), (Labels{4, 0, 0, 0, 0, 7, 7, 0}));
    // Undone, it is there again.
    init();
    edit(EraseLabel{.label = 9});
    m_engine->submit(undo);
    shrink(1);
    QCOMPARE(labels(), (Labels{4, 0, 9, 9, 0, 7, 7, 0}));
}

void ReferenceOverwrittenTest::whatWasPaintedMeanwhileStays()
{
    paint(7, 3, 3);
    paint(4, 5, 5, true);
    QCOMPARE(labels(), (Labels{4, 4, 4, 7, 4, 0, 4, 4}));
    shrink(1);
    QCOMPARE(labels(), (Labels{4, 0, 9, 7, 0, 0, 7, 0}));
}

void ReferenceOverwrittenTest::nothingStaleComesBack_data()
{
    QTest::addColumn<bool>("overwrites");
    QTest::addColumn<bool>("tellsHeld");
    for (const bool overwrites : {false, true})
        for (const bool tellsHeld : {false, true})
            QTest::addRow("%d, %d", int(overwrites), int(tellsHeld)) << overwrites << tellsHeld;
}

void ReferenceOverwrittenTest::nothingStaleComesBack()
{
    QFETCH(bool, overwrites);
    QFETCH(bool, tellsHeld);
    // Erased by hand where it had grown: what is remembered there is nobody's.
    paint(4, 1, 7, true);
    QCOMPARE(labels(), (Labels{4, 0, 0, 0, 0, 0, 0, 0}));
    QCOMPARE(overwritten(), held);
    GrowBurst again = taking();
    if (!overwrites)
        again.overwritable.reset();
    again.tellsHeld = tellsHeld;
    m_generation = 1;
    grow(again);
    QCOMPARE(labels(), Labels(8, 4));
    shrink(1);
    QCOMPARE(labels(), (Labels{4, 0, 0, 0, 0, 0, 0, 0}));
    // Painted by hand: growing over it takes nothing from anybody.
    paint(9, 2, 3);
    paint(9, 2, 3, true);
    paint(4, 1, 3);
    grow(again);
    shrink(1);
    QCOMPARE(
        labels(), tellsHeld ? (Labels{4, 4, 4, 4, 0, 0, 0, 0}) : (Labels{4, 0, 0, 0, 0, 0, 0, 0}));
}

BURIN_TEST(ReferenceOverwrittenTest)

} // namespace referenceOverwrittenTest

#include "ReferenceOverwrittenTest.moc"
