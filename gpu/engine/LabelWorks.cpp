// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/BeginWork.h"
#include "gpu/kernels/cut/LayerWriter.h"
#include "gpu/kernels/labels/ScissorsReach.h"

#include <algorithm>
#include <utility>

namespace gpu {

namespace {

/// An edit that is done once it has begun.
class WholeWork final : public EditWork {
public:
    explicit WholeWork(std::vector<core::BrickKey> keys)
        : m_keys(std::move(keys))
    {
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_keys; }

private:
    std::vector<core::BrickKey> m_keys;
};

/// Goes through its bricks in slices, so that pictures are drawn in between, and that it can be
/// rolled back on the way.
class WorkOnBricks : public EditWork {
public:
    bool hasStepsLeft() const override { return m_done < m_bricks.size(); }
    void advance(int rings) override
    {
        constexpr std::size_t bricksPerRing = 64;
        const std::size_t end =
            std::min(m_done + bricksPerRing * std::size_t(rings), m_bricks.size());
        const std::vector<std::uint32_t> next(
            m_bricks.begin() + std::ptrdiff_t(m_done), m_bricks.begin() + std::ptrdiff_t(end));
        const std::vector<core::BrickKey> changed = write(next);
        m_keys.insert(m_keys.end(), changed.begin(), changed.end());
        m_done = end;
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_keys; }
    core::GrowthProgress progress() const override
    {
        constexpr std::size_t percents = 100;
        core::GrowthProgress progress{.running = hasStepsLeft()};
        if (progress.running)
            progress.percent = int(percents * m_done / m_bricks.size());
        return progress;
    }

protected:
    /// @param bricks all that may change
    WorkOnBricks(const WorkContext& context, std::vector<std::uint32_t> bricks)
        : m_context(context)
        , m_bricks(std::move(bricks))
    {
    }
    /// Carries the edit out in some of them. @return the keys of what has changed
    virtual std::vector<core::BrickKey> write(const std::vector<std::uint32_t>& bricks) = 0;
    [[nodiscard]] const WorkContext& context() const { return m_context; }

private:
    WorkContext m_context;
    std::vector<std::uint32_t> m_bricks;
    std::size_t m_done = 0; ///< of these
    std::vector<core::BrickKey> m_keys;
};

class ThresholdWork final : public WorkOnBricks {
public:
    ThresholdWork(const core::LabelThreshold& edit, const WorkContext& context)
        : WorkOnBricks(context, bricksConcerned(context.fields, edit))
        , m_edit(edit)
    {
    }

protected:
    std::vector<core::BrickKey> write(const std::vector<std::uint32_t>& bricks) override
    {
        return writeThreshold(
            context().programs.label, context().fields, context().before, m_edit, bricks);
    }

private:
    core::LabelThreshold m_edit;
};

/// Inverting a segment may change all of the volume.
class MappedWork final : public WorkOnBricks {
public:
    MappedWork(const core::MapLabels& edit, const WorkContext& context)
        : WorkOnBricks(context, bricksConcerned(context.programs.label, context.fields, edit))
        , m_edit(edit)
    {
    }

protected:
    std::vector<core::BrickKey> write(const std::vector<std::uint32_t>& bricks) override
    {
        return writeMapped(
            context().programs.label, context().fields, context().before, m_edit, bricks);
    }

private:
    core::MapLabels m_edit;
};

/// One plane after the other, each of which sees what the one before it has changed.
class MappedPlanesWork final : public EditWork {
public:
    MappedPlanesWork(const core::MapPlanes& edit, const WorkContext& context)
        : m_context(context)
        , m_planes(edit.planes)
    {
        beginNext();
    }
    bool hasStepsLeft() const override
    {
        return m_work->hasStepsLeft() || m_begun < m_planes.size();
    }
    void advance(int rings) override
    {
        if (m_work->hasStepsLeft())
            m_work->advance(rings);
        else
            beginNext();
    }
    std::vector<core::BrickKey> touchedKeys() const override
    {
        std::vector<core::BrickKey> keys = m_keys;
        const std::vector<core::BrickKey> now = m_work->touchedKeys();
        keys.insert(keys.end(), now.begin(), now.end());
        return keys;
    }
    core::GrowthProgress progress() const override
    {
        core::GrowthProgress progress{.running = hasStepsLeft()};
        if (progress.running)
            progress.percent = (100 * int(m_begun - 1)
                                   + (m_work->hasStepsLeft() ? m_work->progress().percent : 100))
                / int(m_planes.size());
        return progress;
    }

private:
    void beginNext()
    {
        if (m_work)
            m_keys = touchedKeys();
        m_work = std::make_unique<MappedWork>(m_planes[m_begun++], m_context);
    }

    WorkContext m_context;
    std::vector<core::MapLabels> m_planes;
    std::size_t m_begun = 0; ///< how many planes
    std::unique_ptr<MappedWork> m_work; ///< in the last of these
    std::vector<core::BrickKey> m_keys; ///< of those before it
};

/// Scissors: first works out how far they reach.
class ScissorsWork final : public WorkOnBricks {
public:
    ScissorsWork(const core::LabelScissors& edit, const WorkContext& context)
        : WorkOnBricks(context, bricksConcerned(context.fields, edit))
        , m_edit(edit)
        , m_reach(context.programs.label, context.fields, m_edit)
    {
    }
    void advance(int rings) override
    {
        constexpr std::size_t elementsPerRing = 2048;
        if (!m_reach.isKnown())
            return m_reach.advance(elementsPerRing * std::size_t(rings));
        WorkOnBricks::advance(rings);
    }

protected:
    std::vector<core::BrickKey> write(const std::vector<std::uint32_t>& bricks) override
    {
        return writeScissors(context().programs.label, context().fields, context().before, m_edit,
            m_reach.buffer(), bricks);
    }

private:
    core::LabelScissors m_edit;
    ScissorsReach m_reach;
};

BegunWork done(std::vector<core::BrickKey> keys)
{
    return std::make_unique<WholeWork>(std::move(keys));
}

BegunWork begun(const core::EraseLabel& edit, const WorkContext& context)
{
    return done(eraseLabel(context.programs.erase, context.fields, context.before, edit));
}

BegunWork begun(const core::BarrierListed& edit, const WorkContext& context)
{
    return done(writeBarriers(context.programs.barriers, context.fields, context.before, edit));
}

BegunWork begun(const core::CoverLabel& edit, const WorkContext& context)
{
    return done(coverLabel(context.programs.erase, context.fields, context.before, edit));
}

BegunWork begun(const core::LabelThreshold& edit, const WorkContext& context)
{
    return std::make_unique<ThresholdWork>(edit, context);
}

BegunWork begun(const core::LabelScissors& edit, const WorkContext& context)
{
    return std::make_unique<ScissorsWork>(edit, context);
}

BegunWork begun(const core::MapLabels& edit, const WorkContext& context)
{
    return std::make_unique<MappedWork>(edit, context);
}

BegunWork begun(const core::MapPlanes& edit, const WorkContext& context)
{
    return std::make_unique<MappedPlanesWork>(edit, context);
}

BegunWork begun(const core::FoldLayer& edit, const WorkContext& context)
{
    return done(foldLayer(context.fields, context.before, edit));
}

} // namespace

BegunWork beginWork(core::WholeEdits::Pointer edit, const WorkContext& context)
{
    return std::visit([&context](const auto* known) { return begun(*known, context); }, edit);
}

BegunWork beginWork(core::LabelWrites::Pointer edit, const WorkContext& context)
{
    return done(writeLabels(context.programs.label, context.fields, context.before, edit));
}

} // namespace gpu
