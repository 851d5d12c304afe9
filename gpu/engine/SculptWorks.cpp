// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditTransaction.h"
#include "gpu/engine/EditWork.h"
#include "gpu/kernels/sculpt/DrillKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/sculpt/PeelKernel.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"

namespace gpu {

namespace {

/// What its kernel cuts is coverage of a layer.
template <class Kernel> class CoverageWork : public EditWork {
public:
    template <class Programs, class Cut>
    CoverageWork(Programs& programs, const Cut& cut, const WorkContext& context)
        : m_kernel(programs, context.fields, context.before, cut)
        , m_layer(cut.layer)
    {
    }

    std::vector<core::BrickKey> touchedKeys() const override
    {
        return keysOf(core::Field::Coverage, m_layer, m_kernel.touchedBricks());
    }
    void finish(core::EngineResult& result) override
    {
        result.statistics.searchedTo = m_kernel.searchedTo();
    }

protected:
    Kernel m_kernel;

private:
    std::uint8_t m_layer;
};

/// Drill or laser: a path of samples.
template <class Kernel> class StrokeWork final : public CoverageWork<Kernel> {
public:
    using CoverageWork<Kernel>::CoverageWork;

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        const auto* path = std::get_if<core::DrillPath>(&extension);
        if (!path)
            return EditWork::extend(extension);
        this->m_kernel.extend(path->samples);
        return {};
    }
    bool join(core::EngineExtension& earlier, core::EngineExtension& next) const override
    {
        auto* path = std::get_if<core::DrillPath>(&earlier);
        if (path)
            append(path->samples, std::get<core::DrillPath>(next).samples);
        return path != nullptr;
    }
};

class PeelWork final : public CoverageWork<PeelKernel> {
public:
    using CoverageWork::CoverageWork;

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        const auto* depth = std::get_if<core::PeelDepth>(&extension);
        if (!depth)
            return EditWork::extend(extension);
        if (depth->depth < 0)
            return refusal("depth", "is below 0");
        m_kernel.setDepth(depth->depth);
        return {};
    }
};

class ScissorsWork final : public EditWork {
public:
    ScissorsWork(const core::MaskScissors& scissors, const WorkContext& context)
        : m_layer(scissors.layer)
        , m_cut(cutWithScissors(context.programs.mask, context.fields, context.before, scissors))
    {
    }

    std::vector<core::BrickKey> touchedKeys() const override
    {
        return keysOf(core::Field::Coverage, m_layer, m_cut.bricks);
    }
    void finish(core::EngineResult& result) override
    {
        result.statistics.searchedTo = m_cut.searchedTo;
    }

private:
    std::uint8_t m_layer;
    Scissored m_cut;
};

/// A brush: it carves, paints or shuts.
class BrushWork final : public EditWork {
public:
    template <class Edit>
    BrushWork(const Edit& edit, const WorkContext& context)
        : m_kernel(context.programs.capsule, context.fields, context.before, edit)
    {
    }

    core::Result<void> extend(const core::EngineExtension& extension) override
    {
        const auto* path = std::get_if<core::CapsulePath>(&extension);
        if (!path)
            return EditWork::extend(extension);
        m_kernel.extend(path->capsules);
        return {};
    }
    bool join(core::EngineExtension& earlier, core::EngineExtension& next) const override
    {
        auto* path = std::get_if<core::CapsulePath>(&earlier);
        if (path)
            append(path->capsules, std::get<core::CapsulePath>(next).capsules);
        return path != nullptr;
    }
    std::vector<core::BrickKey> touchedKeys() const override { return m_kernel.touchedKeys(); }

private:
    CapsuleKernel m_kernel;
};

BegunWork begun(const core::DrillCut& edit, const WorkContext& context)
{
    return std::make_unique<StrokeWork<DrillKernel>>(context.programs.mask, edit, context);
}

BegunWork begun(const core::LaserCut& edit, const WorkContext& context)
{
    return std::make_unique<StrokeWork<LaserKernel>>(context.programs.laser, edit, context);
}

BegunWork begun(const core::MaskPeel& edit, const WorkContext& context)
{
    return std::make_unique<PeelWork>(context.programs.mask, edit, context);
}

BegunWork begun(const core::MaskScissors& edit, const WorkContext& context)
{
    return std::make_unique<ScissorsWork>(edit, context);
}

BegunWork begun(const core::CapsuleCut& edit, const WorkContext& context)
{
    return std::make_unique<BrushWork>(edit, context);
}

BegunWork begun(const core::PaintLabel& edit, const WorkContext& context)
{
    return std::make_unique<BrushWork>(edit, context);
}

BegunWork begun(const core::PaintBarrier& edit, const WorkContext& context)
{
    return std::make_unique<BrushWork>(edit, context);
}

} // namespace

BegunWork beginWork(core::StrokeEdits::Pointer edit, const WorkContext& context)
{
    return std::visit([&context](const auto* known) { return begun(*known, context); }, edit);
}

} // namespace gpu
