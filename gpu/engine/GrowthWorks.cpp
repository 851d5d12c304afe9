// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/IntervalOpener.h"
#include "gpu/engine/BeginWork.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/kernels/growth/GrowthKernel.h"
#include "gpu/kernels/shrink/CutBackwards.h"
#include "gpu/kernels/shrink/CutGrown.h"
#include "gpu/kernels/shrink/ShrinkKernel.h"
#include "gpu/kernels/work/JoinPieces.h"

#include <algorithm>
#include <utility>

namespace gpu {

namespace {

class SeedWork final : public EditWork {
public:
    SeedWork(const core::SeedPlacement& seeds, const WorkContext& context)
        : m_plane(seeds.plane)
        , m_bricks(placeSeeds(context.programs.growth, context.fields, context.before, seeds))
    {
    }
    std::vector<core::BrickKey> touchedKeys() const override
    {
        return keysOf(core::Field::SeedWords, m_plane, m_bricks);
    }

private:
    std::uint8_t m_plane;
    std::vector<std::uint32_t> m_bricks;
};

class GrowthWork final : public EditWork {
public:
    GrowthWork(const core::GrowBurst& burst, const WorkContext& context)
        : m_context(context)
    {
        open(burst);
    }

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        return std::visit([this](const auto& known) { return take(known); }, extension);
    }
    bool hasStepsLeft() const override { return m_stepsLeft != 0; }
    double generationsPerSecond() const override { return m_generationsPerSecond; }
    void advance(int rings) override
    {
        const int wanted = m_stepsLeft < 0 ? rings : std::min(rings, m_stepsLeft);
        const int done = m_kernel->advance(wanted);
        if (done < std::min(wanted, GrowthKernel::ringsPerBatch))
            m_stepsLeft = 0; // at closure, alarmed, or at the last generation a word can hold
        else if (m_stepsLeft > 0)
            m_stepsLeft -= done;
    }

    std::vector<core::BrickKey> touchedKeys() const override
    {
        const std::vector<std::uint32_t> bricks = m_kernel->touchedBricks();
        std::vector<core::BrickKey> keys = keysOf(core::Field::Labels, m_plane, bricks);
        append(keys, keysOf(core::Field::SeedWords, m_plane, bricks));
        if (m_kernel->keepsOverwritten())
            append(keys, keysOf(core::Field::Overwritten, m_plane, bricks));
        return keys;
    }
    void finish(core::EngineResult& result) override
    {
        m_kernel->releaseUnused();
        m_kernel->releaseOverwritten(result.changes);
        result.generation = m_kernel->generation();
        result.atClosure = m_kernel->atClosure();
        result.alarm = m_kernel->alarm();
        result.statistics.generations = int(m_kernel->frontSizes().size());
    }
    void rollBack(core::EngineResult& result) override
    {
        m_kernel->releaseUnused();
        m_kernel->releaseOverwritten({});
        result.generation = m_openedAt;
    }
    core::GrowthProgress progress() const override
    {
        return {.open = true,
            .running = hasStepsLeft(),
            .atClosure = m_kernel->atClosure(),
            .generation = m_kernel->generation(),
            .members = m_kernel->members(),
            .frontSizes = m_kernel->frontSizes(),
            .alarm = m_kernel->alarm()};
    }
    std::optional<std::uint8_t> growingPlane() const override { return m_plane; }

private:
    void open(const core::GrowBurst& burst)
    {
        m_plane = burst.plane;
        m_openedAt = burst.generation;
        core::IntervalOpener* const opener = openerFor(burst);
        m_kernel.emplace(m_context.programs.growth, m_context.fields, m_context.before, burst);
        if (opener)
            m_kernel->open(*opener);
        else
            m_kernel->open();
    }
    /// What opens the burst by what its interval changes; null where it opens by asking all. Every
    /// opening finds the fields as they were before the edit, so one reading of them serves all.
    core::IntervalOpener* openerFor(const core::GrowBurst& burst)
    {
        if (m_asksAll || !opensByChange(burst))
            return nullptr;
        if (!m_opener || !m_opener->serves(burst)) {
            m_opener.reset();
            m_opener = readGrowth(m_context.fields, burst);
            m_asksAll = !m_opener;
        }
        return m_opener.get();
    }
    core::Result<void> take(const core::GrowAdvance& steps)
    {
        m_generationsPerSecond = steps.generationsPerSecond;
        m_stepsLeft = steps.steps < 0 || m_stepsLeft < 0 ? core::GrowAdvance::toClosure
                                                         : m_stepsLeft + steps.steps;
        return {};
    }
    core::Result<void> take(const core::GrowPause&)
    {
        m_stepsLeft = 0;
        return {};
    }
    core::Result<void> take(const core::GrowAnew& anew)
    {
        const core::GrowBurst& burst = anew.burst;
        if (const core::Result<void> checked = core::checkSound(burst, m_context.fields.grid());
            !checked)
            return checked;
        if (burst.plane != m_plane)
            return refusal("plane", core::Clause::saying("is another one"));
        m_context.before.restore(touchedKeys());
        m_kernel->releaseUnused();
        m_kernel->releaseOverwritten({});
        open(burst);
        m_stepsLeft = 0;
        return {};
    }
    template <class Other> core::Result<void> take(const Other& ofAnotherKind)
    {
        return EditWork::extend(ofAnotherKind);
    }

    WorkContext m_context;
    std::uint8_t m_plane = 0;
    std::uint32_t m_openedAt = 0; ///< generation
    std::optional<GrowthKernel> m_kernel;
    std::unique_ptr<core::IntervalOpener> m_opener;
    bool m_asksAll = false; ///< no such thing serves this growth
    int m_stepsLeft = 0; ///< negative: to closure
    double m_generationsPerSecond = 0.0;
};

class ShrinkWork final : public EditWork {
public:
    ShrinkWork(const core::ShrinkGrowth& shrink, const WorkContext& context)
        : m_kernel(context.programs.growth.shrink, context.fields, context.before, shrink)
    {
    }

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        const auto* shrink = std::get_if<core::ShrinkTo>(&extension);
        if (!shrink)
            return EditWork::extend(extension);
        if (shrink->keep > m_kernel.openedAt())
            return refusal("keep", core::Clause::saying("is more than there is"));
        m_kernel.shrinkTo(shrink->keep, shrink->keep == 0);
        return {};
    }
    /// The last word counts; one that is refused must be refused by itself.
    bool join(core::EngineExtension& earlier, core::EngineExtension& next) const override
    {
        auto* shrink = std::get_if<core::ShrinkTo>(&earlier);
        if (!shrink)
            return false;
        const core::ShrinkTo& later = std::get<core::ShrinkTo>(next);
        if (std::max(shrink->keep, later.keep) > m_kernel.openedAt())
            return false;
        *shrink = later;
        return true;
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_kernel.touchedKeys(); }
    void finish(core::EngineResult& result) override
    {
        result.generation = m_kernel.generation();
        result.statistics.generations = int(m_kernel.openedAt() - m_kernel.generation());
    }
    void rollBack(core::EngineResult& result) override { result.generation = m_kernel.openedAt(); }

private:
    ShrinkKernel m_kernel;
};

/// What was cut off a growth, at once.
class CutWork final : public EditWork {
public:
    CutWork(std::uint32_t openedAt, CutOutcome outcome)
        : m_openedAt(openedAt)
        , m_outcome(std::move(outcome))
    {
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_outcome.keys; }
    void finish(core::EngineResult& result) override
    {
        result.generation = m_outcome.generation;
        result.statistics.generations = std::max(int(m_openedAt) - int(m_outcome.generation), 0);
    }
    void rollBack(core::EngineResult& result) override { result.generation = m_openedAt; }

private:
    std::uint32_t m_openedAt; ///< generation
    CutOutcome m_outcome;
};

/// A growth that is taken back from a sketch, generation by generation.
class BackwardWork final : public EditWork {
public:
    BackwardWork(std::uint32_t openedAt, std::unique_ptr<CutBackwards> cut)
        : m_openedAt(openedAt)
        , m_cut(std::move(cut))
    {
    }
    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        const auto* further = std::get_if<core::CutFurther>(&extension);
        if (!further)
            return EditWork::extend(extension);
        if (further->steps < 1)
            return refusal("steps", core::Clause::saying("are none"));
        m_cut->advanceTo(further->steps);
        return {};
    }
    /// One that is refused must be refused by itself.
    bool join(core::EngineExtension& earlier, core::EngineExtension& next) const override
    {
        auto* further = std::get_if<core::CutFurther>(&earlier);
        if (!further)
            return false;
        const core::CutFurther& later = std::get<core::CutFurther>(next);
        if (std::min(further->steps, later.steps) < 1)
            return false;
        further->steps = std::max(further->steps, later.steps);
        return true;
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_cut->touchedKeys(); }
    void finish(core::EngineResult& result) override
    {
        result.generation = m_cut->generation();
        result.statistics.generations = int(m_cut->progress().steps);
    }
    void rollBack(core::EngineResult& result) override { result.generation = m_openedAt; }
    core::GrowthProgress progress() const override { return {.backwards = m_cut->progress()}; }

private:
    std::uint32_t m_openedAt; ///< generation
    std::unique_ptr<CutBackwards> m_cut;
};

class SpreadWork final : public EditWork {
public:
    SpreadWork(std::unique_ptr<SpreadKernel> kernel, VoxelFields& fields)
        : m_kernel(std::move(kernel))
        , m_fields(fields)
    {
    }

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        if (!std::holds_alternative<core::ForgetSpread>(extension))
            return EditWork::extend(extension);
        m_kernel->forget();
        return {};
    }
    bool hasStepsLeft() const override { return !m_kernel->done(); }
    void advance(int rings) override { m_kernel->advance(std::size_t(4 * rings * rings)); }
    std::vector<core::BrickKey> touchedKeys() const override { return m_kernel->touchedKeys(); }
    void finish(core::EngineResult&) override { m_kernel->close(true); }
    void rollBack(core::EngineResult&) override { m_kernel->close(false); }
    void abandon() override
    {
        m_kernel.reset();
        m_fields.spread().release();
    }
    core::GrowthProgress progress() const override { return {.running = hasStepsLeft()}; }

private:
    std::unique_ptr<SpreadKernel> m_kernel;
    VoxelFields& m_fields;
};

BegunWork begun(const core::SeedPlacement& edit, const WorkContext& context)
{
    return std::make_unique<SeedWork>(edit, context);
}

BegunWork begun(const core::GrowBurst& edit, const WorkContext& context)
{
    return std::make_unique<GrowthWork>(edit, context);
}

BegunWork begun(const core::ShrinkGrowth& edit, const WorkContext& context)
{
    return std::make_unique<ShrinkWork>(edit, context);
}

BegunWork begun(const core::CutGrowth& edit, const WorkContext& context)
{
    if (edit.how == core::CutGrowth::How::Backwards) {
        auto cut = CutBackwards::begin(context.fields, context.before, edit);
        if (!cut)
            return tl::unexpected(cut.error());
        return std::make_unique<BackwardWork>(edit.generation, *std::move(cut));
    }
    core::Result<CutOutcome> outcome = cutGrown(context.fields, context.before, edit);
    if (!outcome)
        return tl::unexpected(outcome.error());
    return std::make_unique<CutWork>(edit.generation, *std::move(outcome));
}

BegunWork begun(const core::SpreadLabels& edit, const WorkContext& context)
{
    try {
        auto kernel =
            SpreadKernel::begin(context.programs.spread, context.fields, context.before, edit);
        if (!kernel)
            return tl::unexpected(kernel.error());
        return std::make_unique<SpreadWork>(*std::move(kernel), context.fields);
    } catch (...) {
        context.fields.spread().release();
        throw;
    }
}

} // namespace

BegunWork beginWork(core::GrowthEdits::Pointer edit, const WorkContext& context)
{
    return std::visit([&context](const auto* known) { return begun(*known, context); }, edit);
}

} // namespace gpu
