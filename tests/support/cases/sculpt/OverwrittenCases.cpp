// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/growth/GrowthAnswers.h"

#include <algorithm>
#include <array>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowAnew;
using core::GrowBurst;
using core::GrowOpening;
using core::SeedPlacement;

constexpr int closure = GrowAdvance::toClosure;

GrowBurst taking(std::initializer_list<int> labels)
{
    GrowBurst burst{.lowCode = 0, .highCode = 65535};
    for (const int label : labels)
        burst.overwritable.set(std::size_t(label));
    return burst;
}

/// A case under construction.
class OverwrittenScene {
public:
    OverwrittenScene(const QByteArray& name, std::uint32_t seed)
        : m_random(seed)
        , m_size{randomInt(m_random, 3, 40), randomInt(m_random, 3, 40), randomInt(m_random, 3, 40)}
        , m_document(randomDocument(m_size, m_random, false))
        , m_made{name,
              m_random() % 3 ? balls(m_size, 6, m_random)
                             : noiseVolume(m_size, tissueCode, m_random),
              {}}
        , m_connectivity(std::array<int, 3>{6, 18, 26}[m_random() % 3])
    {
        for (const std::uint8_t label : {1, 2, 3, 4})
            m_document.segments.push_back({.label = label, .plane = 0});
        if (m_random() % 5)
            m_made.steps.push_back(command(core::SwapBricks{
                bricksOf(labelBoxes(m_size, 8, m_random), core::Field::Labels, 0)}));
        sketch();
        sketch();
    }

    void appendAnything()
    {
        switch (m_random() % 16) {
        case 0:
            return sketch();
        case 1:
            return shut();
        case 2:
            return paint();
        case 3:
            return appendWhole(m_made.steps, core::EraseLabel{.label = label()}, {}, ending());
        case 4:
            return spread();
        case 5:
            return m_made.steps.push_back(Undo{});
        case 6:
            return m_made.steps.push_back(Redo{});
        case 7:
        case 8:
        case 9:
            return shrink();
        case 10:
            return cut();
        default:
            return grow();
        }
    }

    [[nodiscard]] EngineCase take() { return std::move(m_made); }

private:
    [[nodiscard]] std::uint8_t label() { return std::uint8_t(randomInt(m_random, 1, 4)); }
    [[nodiscard]] core::Ending ending()
    {
        return m_random() % 6 ? core::Ending::Commit : core::Ending::Rollback;
    }

    void sketch()
    {
        SeedPlacement seeds{.label = label()};
        for (int i = randomInt(m_random, 1, 3); i > 0; --i)
            seeds.voxels.push_back(randomVoxel(m_random, m_size));
        appendWhole(m_made.steps, seeds, {}, ending());
    }

    GrowBurst burst()
    {
        GrowBurst burst{.lowCode = randomInt(m_random, 0, 300),
            .highCode = randomInt(m_random, 500, tissueCode),
            .connectivity = m_random() % 8 ? m_connectivity : 6,
            .opening = std::array<GrowOpening, 6>{GrowOpening::Narrow, GrowOpening::Narrow,
                GrowOpening::Restart, GrowOpening::GoOn, GrowOpening::GoOn,
                GrowOpening::GoOn}[m_random() % 6]};
        for (std::size_t label = 1; label <= 4; ++label)
            burst.overwritable[label] = m_random() % 3 != 0;
        if (m_random() % 4 == 0)
            burst.overwritable.reset();
        burst.lockedLabels[3] = m_random() % 6 == 0;
        burst.tellsHeld = m_random() % 8 != 0;
        if (m_random() % 5 == 0)
            burst.limits.difference = randomInt(m_random, 100, tissueCode);
        if (m_random() % 6 == 0)
            burst.guard = core::GuardRule{.factor256 = 400, .excess = 10, .window = 5};
        return burst;
    }

    void grow()
    {
        m_made.steps.push_back(BeginGrowth{burst()});
        const auto advance = [this] {
            const int steps = m_random() % 2 ? closure : randomInt(m_random, 0, 6);
            m_made.steps.push_back(command(core::ExtendEdit{GrowAdvance{steps}}));
        };
        advance();
        if (m_random() % 5 == 0) {
            m_made.steps.push_back(command(core::ExtendEdit{GrowAnew{burst()}}));
            advance();
        }
        m_made.steps.push_back(command(core::EndEdit{ending()}));
    }

    void shrink()
    {
        Shrink shrink{.shrink = {}, .ending = ending()};
        if (m_random() % 4)
            shrink.generations = std::uint32_t(randomInt(m_random, 0, 8));
        shrink.shrink.lockedLabels[2] = m_random() % 6 == 0;
        for (int i = m_random() % 2 ? randomInt(m_random, 1, 4) : 0; i > 0; --i)
            shrink.then.push_back(m_random() % 4 ? std::uint32_t(m_random()) : 0);
        m_made.steps.push_back(shrink);
    }

    void cut()
    {
        using How = core::CutGrowth::How;
        core::CutGrowth cut{
            .how = std::array<How, 3>{How::Subtree, How::Neck, How::Here}[m_random() % 3],
            .barrier = m_random() % 2 == 0};
        for (int i = randomInt(m_random, 1, 30); i > 0; --i)
            cut.voxels.push_back(randomVoxel(m_random, m_size));
        m_made.steps.push_back(Cut{.cut = cut, .ending = ending()});
    }

    void shut()
    {
        core::BarrierStroke stroke{.path = randomPath(m_document, m_random)};
        stroke.erase = m_random() % 4 == 0;
        const auto barrier = core::paintBarrier(stroke, m_document);
        if (!barrier)
            return;
        core::PaintBarrier shut = *barrier;
        shut.lockedLabels[2] = m_random() % 5 == 0;
        appendWhole(m_made.steps, shut, {pathOf(stroke.path)}, ending());
    }

    void paint()
    {
        core::PaintStroke stroke = randomPaint(m_document, m_random);
        stroke.segment = label();
        if (const auto paint = core::paintLabel(stroke, m_document))
            appendWhole(m_made.steps, *paint,
                {core::paintPath(stroke, m_document.volumes.front().geometry)}, ending());
    }

    void spread()
    {
        core::SpreadLabels spread;
        spread.lengths = {4, 4, 4, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7};
        spread.seeds.set(1).set(2);
        spread.overwritable[3] = m_random() % 2;
        spread.overwritable[4] = m_random() % 2;
        appendWhole(m_made.steps, spread, {}, ending());
    }

    [[nodiscard]] core::CapsulePath pathOf(const core::BrushPath& path) const
    {
        return {core::capsules(path, m_document.volumes.front().geometry)};
    }

    Random m_random;
    glm::ivec3 m_size;
    core::Document m_document;
    EngineCase m_made;
    int m_connectivity;
};

} // namespace

std::vector<EngineCase> overwrittenCases(int randomCount)
{
    Random random(77);
    std::vector<EngineCase> cases;
    const glm::ivec3 size(50, 33, 20);
    const Bytes held = labelBoxes(size, 8, random);
    for (const bool wide : {false, true}) { // 64³ of one label: fronts as bits
        const glm::ivec3 room = wide ? glm::ivec3(64) : size;
        EngineCase taken{wide ? "taken by a wide front" : "taken and given back",
            constantVolume(room, tissueCode), {}};
        taken.steps.push_back(command(core::SwapBricks{
            bricksOf(wide ? labelBoxes(room, 8, random) : held, core::Field::Labels, 0)}));
        appendWhole(taken.steps, SeedPlacement{.label = 1, .voxels = {room / 2}});
        if (!wide)
            appendWhole(taken.steps, SeedPlacement{.label = 2, .voxels = {{3, 3, 3}, {49, 0, 0}}});
        appendBurst(taken.steps, taking({2, 3, 4}), 9);
        appendBurst(taken.steps, taking({2, 3, 4}), closure);
        taken.steps.push_back(Shrink{.shrink = {}, .generations = 12, .then = {3, 40, 0, 21}});
        appendBurst(taken.steps, taking({3}), closure);
        taken.steps.push_back(
            Shrink{.shrink = {}, .generations = 5, .then = {}, .ending = core::Ending::Rollback});
        taken.steps.push_back(Shrink{});
        for (int i = 0; i < 4; ++i)
            taken.steps.push_back(Undo{});
        for (int i = 0; i < 3; ++i)
            taken.steps.push_back(Redo{});
        // Where nothing may be taken, what was overwritten before does not come back.
        appendBurst(taken.steps, taking({}), closure);
        taken.steps.push_back(Shrink{.shrink = {}, .generations = 1000});
        cases.push_back(taken);
    }
    for (const GrowOpening opening : {GrowOpening::Narrow, GrowOpening::Restart}) {
        EngineCase moved{
            opening == GrowOpening::Narrow ? "taken, then narrowed" : "taken, then grown anew",
            balls(size, 7, random), {}};
        moved.steps.push_back(command(core::SwapBricks{bricksOf(held, core::Field::Labels, 0)}));
        appendWhole(moved.steps,
            SeedPlacement{.label = 1, .voxels = {{5, 5, 5}, {40, 20, 10}, {25, 16, 10}}});
        for (const int high : {65535, 500, 65535, 200, 800}) {
            GrowBurst burst = taking({2, 3, 4});
            burst.highCode = high;
            burst.opening = opening;
            if (high == 800)
                burst.overwritable.reset(3);
            appendBurst(moved.steps, burst, closure);
        }
        for (int i = 0; i < 5; ++i)
            moved.steps.push_back(Undo{});
        for (int i = 0; i < 5; ++i)
            moved.steps.push_back(Redo{});
        moved.steps.push_back(Shrink{});
        cases.push_back(moved);
    }
    EngineCase erased{"taken from one that is deleted", constantVolume(size, tissueCode), {}};
    erased.steps.push_back(command(core::SwapBricks{bricksOf(held, core::Field::Labels, 0)}));
    appendWhole(erased.steps, SeedPlacement{.label = 1, .voxels = {{25, 16, 10}}});
    appendBurst(erased.steps, taking({2, 3, 4}), 20);
    appendWhole(erased.steps, core::EraseLabel{.label = 2});
    appendWhole(erased.steps, core::EraseLabel{.label = 3}, {}, core::Ending::Rollback);
    erased.steps.push_back(Undo{});
    erased.steps.push_back(Redo{});
    erased.steps.push_back(Shrink{.shrink = {}, .generations = 1000});
    cases.push_back(erased);
    for (int number = 0; number < randomCount; ++number) {
        OverwrittenScene scene(
            "random taking " + QByteArray::number(number), std::uint32_t(64000 + number));
        for (int edit = 0; edit < 24; ++edit)
            scene.appendAnything();
        cases.push_back(daily(scene.take()));
    }
    return cases;
}

} // namespace test
