// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/BeginWork.h"
#include "gpu/kernels/cut/LayerWriter.h"

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
