// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditTransaction.h"

#include "gpu/gl/GlFailure.h"
#include "gpu/kernels/cut/LayerWriter.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"
#include "gpu/kernels/shrink/CutGrown.h"

#include <algorithm>

namespace gpu {

core::EditStatistics statisticsOf(const std::vector<core::BrickChange>& changes)
{
    core::EditStatistics statistics;
    for (const core::BrickChange& change : changes) {
        if (change.key.field == core::Field::SeedWords || change.key.field == core::Field::Beneath)
            continue;
        ++statistics.bricks;
        for (std::size_t i = 0; i < core::BrickGrid::voxelsPerBrick; ++i) {
            const std::uint8_t before = change.before.empty() ? 0 : change.before[i];
            const std::uint8_t after = change.after.empty() ? 0 : change.after[i];
            statistics.voxelsChanged += before != after ? 1 : 0;
        }
    }
    return statistics;
}

core::Result<std::unique_ptr<EditTransaction>> EditTransaction::begin(
    EditPrograms& programs, VoxelFields& fields, const core::EngineEdit& edit)
{
    if (const core::Result<void> checked = checkEdit(edit, fields.grid()); !checked)
        return tl::unexpected(checked.error());

    std::unique_ptr<EditTransaction> transaction(new EditTransaction(programs.growth, fields));
    transaction->m_edit = edit;
    try {
        if (const core::Result<void> started = transaction->start(programs); !started)
            return tl::unexpected(started.error());
        requireNoError();
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        transaction->abandon(error);
        throw GlFailure(error);
    }
    return transaction;
}

core::Result<void> EditTransaction::start(EditPrograms& programs)
{
    if (const auto* seeds = std::get_if<core::SeedPlacement>(&m_edit)) {
        m_seedBricks = placeSeeds(programs.growth, m_fields, m_before, *seeds);
    } else if (const auto* grow = std::get_if<core::GrowBurst>(&m_edit)) {
        m_growth.emplace(programs.growth, m_fields, m_before, *grow);
        m_growth->open();
    } else if (const auto* drill = std::get_if<core::DrillCut>(&m_edit)) {
        m_drill.emplace(programs.mask, m_fields, m_before, *drill);
    } else if (const auto* laser = std::get_if<core::LaserCut>(&m_edit)) {
        m_laser.emplace(programs.laser, m_fields, m_before, *laser);
    } else if (const auto* erase = std::get_if<core::EraseLabel>(&m_edit)) {
        m_wholeKeys = eraseLabel(programs.erase, m_fields, m_before, *erase);
    } else if (const auto* paint = std::get_if<core::PaintLabel>(&m_edit)) {
        m_capsule.emplace(programs.capsule, m_fields, m_before, *paint);
    } else if (const auto* barrier = std::get_if<core::PaintBarrier>(&m_edit)) {
        m_capsule.emplace(programs.capsule, m_fields, m_before, *barrier);
    } else if (const auto* cut = std::get_if<core::CapsuleCut>(&m_edit)) {
        m_capsule.emplace(programs.capsule, m_fields, m_before, *cut);
    } else if (const auto* peel = std::get_if<core::MaskPeel>(&m_edit)) {
        m_peel.emplace(programs.mask, m_fields, m_before, *peel);
    } else if (const auto* scissors = std::get_if<core::MaskScissors>(&m_edit)) {
        m_scissored = cutWithScissors(programs.mask, m_fields, m_before, *scissors);
    } else if (const auto* carved = std::get_if<core::LabelCarved>(&m_edit)) {
        m_wholeKeys = labelCarved(programs.label, m_fields, m_before, *carved);
    } else if (const auto* seen = std::get_if<core::LabelSeen>(&m_edit)) {
        m_wholeKeys = labelSeen(programs.label, m_fields, m_before, *seen);
    } else if (const auto* listed = std::get_if<core::LabelListed>(&m_edit)) {
        m_wholeKeys = labelListed(programs.label, m_fields, m_before, *listed);
    } else if (const auto* relabelled = std::get_if<core::RelabelListed>(&m_edit)) {
        m_wholeKeys = relabelListed(programs.label, m_fields, m_before, *relabelled);
    } else if (const auto* shut = std::get_if<core::ShutListed>(&m_edit)) {
        m_wholeKeys = shutListed(programs.shut, m_fields, m_before, *shut);
    } else if (const auto* cover = std::get_if<core::CoverLabel>(&m_edit)) {
        m_wholeKeys = coverLabel(programs.erase, m_fields, m_before, *cover);
    } else if (const auto* fold = std::get_if<core::FoldLayer>(&m_edit)) {
        m_wholeKeys = foldLayer(m_fields, m_before, *fold);
    } else if (const auto* shrink = std::get_if<core::ShrinkGrowth>(&m_edit)) {
        m_shrink.emplace(programs.growth.shrink, m_fields, m_before, *shrink);
    } else if (const auto* grown = std::get_if<core::CutGrowth>(&m_edit)) {
        core::Result<CutOutcome> outcome = cutGrown(m_fields, m_before, *grown);
        if (!outcome)
            return tl::unexpected(outcome.error());
        m_wholeKeys = std::move(outcome->keys);
        m_cutTo = outcome->generation;
    } else if (const auto* spread = std::get_if<core::SpreadLabels>(&m_edit)) {
        auto kernel = SpreadKernel::begin(programs.spread, m_fields, m_before, *spread);
        if (!kernel)
            return tl::unexpected(kernel.error());
        m_spread = *std::move(kernel);
    }
    return {};
}

core::Result<void> EditTransaction::extend(const core::EngineExtension& extension)
{
    if (const auto* path = std::get_if<core::DrillPath>(&extension)) {
        if (!m_drill && !m_laser)
            return refusal("extension", "the open edit is no stroke of drill or laser");
        if (m_drill)
            m_drill->extend(path->samples);
        else
            m_laser->extend(path->samples);
        return {};
    }
    if (const auto* path = std::get_if<core::CapsulePath>(&extension)) {
        if (!m_capsule)
            return refusal("extension", "the open edit is no stroke of a brush");
        m_capsule->extend(path->capsules);
        return {};
    }
    if (const auto* depth = std::get_if<core::PeelDepth>(&extension)) {
        if (!m_peel)
            return refusal("extension", "the open edit is no peel");
        if (depth->depth < 0)
            return refusal("depth", "is below 0");
        m_peel->setDepth(depth->depth);
        return {};
    }
    if (const auto* shrink = std::get_if<core::ShrinkTo>(&extension)) {
        if (!m_shrink)
            return refusal("extension", "the open edit is no shrinking");
        if (shrink->keep > m_shrink->openedAt())
            return refusal("keep", "is more than there is");
        m_shrink->shrinkTo(shrink->keep, shrink->keep == 0);
        return {};
    }
    if (std::holds_alternative<core::ForgetSpread>(extension)) {
        if (!m_spread)
            return refusal("extension", "the open edit does not grow from seeds");
        m_spread->forget();
        return {};
    }
    if (!m_growth)
        return refusal("extension", "the open edit is no growth");
    if (const auto* anew = std::get_if<core::GrowAnew>(&extension))
        return growAnew(anew->burst);
    if (const auto* steps = std::get_if<core::GrowAdvance>(&extension)) {
        m_generationsPerSecond = steps->generationsPerSecond;
        m_stepsLeft = steps->steps < 0 || m_stepsLeft < 0 ? core::GrowAdvance::toClosure
                                                          : m_stepsLeft + steps->steps;
    } else {
        m_stepsLeft = 0;
    }
    return {};
}

core::Result<void> EditTransaction::growAnew(const core::GrowBurst& burst)
{
    if (const core::Result<void> checked = checkEdit(burst, m_fields.grid()); !checked)
        return checked;
    if (burst.plane != std::get<core::GrowBurst>(m_edit).plane)
        return refusal("plane", "is another one");
    m_before.restore(touchedKeys());
    m_growth->releaseUnused();
    m_growth->releaseBeneath({});
    m_edit = burst;
    m_growth.emplace(m_growthPrograms, m_fields, m_before, burst);
    m_growth->open();
    m_stepsLeft = 0;
    return {};
}

bool EditTransaction::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    const auto append = [](auto& path, const auto& more) {
        path.insert(path.end(), more.begin(), more.end());
        return true;
    };
    if (earlier.index() != next.index())
        return false;
    if (auto* path = std::get_if<core::DrillPath>(&earlier); path && (m_drill || m_laser))
        return append(path->samples, std::get<core::DrillPath>(next).samples);
    if (auto* shrink = std::get_if<core::ShrinkTo>(&earlier); shrink && m_shrink) {
        // The last word counts; one that is refused must be refused by itself.
        const core::ShrinkTo& later = std::get<core::ShrinkTo>(next);
        if (std::max(shrink->keep, later.keep) > m_shrink->openedAt())
            return false;
        *shrink = later;
        return true;
    }
    if (auto* path = std::get_if<core::CapsulePath>(&earlier); path && m_capsule)
        return append(path->capsules, std::get<core::CapsulePath>(next).capsules);
    return false;
}

void EditTransaction::advance(int rings)
{
    if (m_spread)
        return m_spread->advance(std::size_t(4 * rings * rings));
    const int wanted = m_stepsLeft < 0 ? rings : std::min(rings, m_stepsLeft);
    const int done = m_growth->advance(wanted);
    if (done < std::min(wanted, GrowthKernel::ringsPerBatch))
        m_stepsLeft = 0; // at closure, alarmed, or at the last generation a word can hold
    else if (m_stepsLeft > 0)
        m_stepsLeft -= done;
}

std::vector<core::BrickKey> EditTransaction::touchedKeys() const
{
    std::vector<core::BrickKey> keys = m_wholeKeys;
    const auto add = [&keys](core::Field field, std::uint8_t plane,
                         const std::vector<std::uint32_t>& bricks) {
        for (const std::uint32_t brick : bricks)
            keys.push_back({.field = field, .plane = plane, .brick = brick});
    };
    if (const auto* seeds = std::get_if<core::SeedPlacement>(&m_edit))
        add(core::Field::SeedWords, seeds->plane, m_seedBricks);
    if (const auto* grow = std::get_if<core::GrowBurst>(&m_edit)) {
        const std::vector<std::uint32_t> touched = m_growth->touchedBricks();
        add(core::Field::Labels, grow->plane, touched);
        add(core::Field::SeedWords, grow->plane, touched);
        if (m_growth->keepsBeneath())
            add(core::Field::Beneath, grow->plane, touched);
    }
    if (const auto* drill = std::get_if<core::DrillCut>(&m_edit))
        add(core::Field::Coverage, drill->layer, m_drill->touchedBricks());
    if (const auto* laser = std::get_if<core::LaserCut>(&m_edit))
        add(core::Field::Coverage, laser->layer, m_laser->touchedBricks());
    if (const auto* peel = std::get_if<core::MaskPeel>(&m_edit))
        add(core::Field::Coverage, peel->layer, m_peel->touchedBricks());
    if (const auto* scissors = std::get_if<core::MaskScissors>(&m_edit))
        add(core::Field::Coverage, scissors->layer, m_scissored.bricks);
    if (m_capsule)
        return m_capsule->touchedKeys();
    if (m_shrink)
        return m_shrink->touchedKeys();
    if (m_spread)
        return m_spread->touchedKeys();
    return keys;
}

void EditTransaction::commit(core::EngineResult& result)
{
    result.changes = m_before.changes(touchedKeys());
    result.statistics = statisticsOf(result.changes);
    for (const core::BrickChange& change : result.changes) {
        if (change.key.field == core::Field::Beneath && change.after.empty())
            m_fields.beneath(change.key.plane).release(std::span(&change.key.brick, 1));
    }
    if (m_spread)
        m_spread->close(true);
    if (m_growth) {
        m_growth->releaseUnused();
        m_growth->releaseBeneath(result.changes);
        result.generation = m_growth->generation();
        result.atClosure = m_growth->atClosure();
        result.alarm = m_growth->alarm();
        result.statistics.generations = int(m_growth->frontSizes().size());
    }
    if (m_shrink) {
        result.generation = m_shrink->generation();
        result.statistics.generations = int(m_shrink->openedAt() - m_shrink->generation());
    }
    if (const auto* cut = std::get_if<core::CutGrowth>(&m_edit)) {
        result.generation = m_cutTo;
        result.statistics.generations = std::max(int(cut->generation) - int(m_cutTo), 0);
    }
    result.statistics.searchedTo = m_drill ? m_drill->searchedTo()
        : m_laser                          ? m_laser->searchedTo()
        : m_peel                           ? m_peel->searchedTo()
                                           : m_scissored.searchedTo;
}

void EditTransaction::rollBack(core::EngineResult& result)
{
    m_before.restore(touchedKeys());
    if (m_spread)
        m_spread->close(false);
    if (const auto* grow = std::get_if<core::GrowBurst>(&m_edit)) {
        m_growth->releaseUnused();
        m_growth->releaseBeneath({});
        result.generation = grow->generation;
    }
    if (m_shrink)
        result.generation = m_shrink->openedAt();
    if (const auto* cut = std::get_if<core::CutGrowth>(&m_edit))
        result.generation = cut->generation;
}

void EditTransaction::abandon(const core::Error& why)
{
    m_abandoned = why;
    m_stepsLeft = 0;
    // What they hold is of no use, and its memory is wanted.
    m_growth.reset();
    m_shrink.reset();
    m_drill.reset();
    m_laser.reset();
    m_peel.reset();
    m_capsule.reset();
    m_spread.reset();
    if (std::holds_alternative<core::SpreadLabels>(m_edit))
        m_fields.spread().release();
    constexpr int tries = 3;
    for (int i = 0; i < tries; ++i) {
        try {
            return m_before.restoreAll();
        } catch (const FieldsLost&) {
            throw;
        } catch (const std::exception&) {
            // No memory for what was there; it may be had by now.
        }
    }
    throw FieldsLost(why);
}

core::GrowthProgress EditTransaction::progress() const
{
    if (m_abandoned)
        return {};
    if (m_spread)
        return {.running = hasStepsLeft()};
    if (!m_growth)
        return {};
    return {.open = true,
        .running = m_stepsLeft != 0,
        .atClosure = m_growth->atClosure(),
        .generation = m_growth->generation(),
        .members = m_growth->members(),
        .frontSizes = m_growth->frontSizes(),
        .alarm = m_growth->alarm()};
}

} // namespace gpu
