// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditWork.h"
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

} // namespace

BegunWork beginWork(const core::EraseLabel& edit, const WorkContext& context)
{
    return done(eraseLabel(context.programs.erase, context.fields, context.before, edit));
}

BegunWork beginWork(const core::LabelCarved& edit, const WorkContext& context)
{
    return done(labelCarved(context.programs.label, context.fields, context.before, edit));
}

BegunWork beginWork(const core::LabelSeen& edit, const WorkContext& context)
{
    return done(labelSeen(context.programs.label, context.fields, context.before, edit));
}

BegunWork beginWork(const core::LabelListed& edit, const WorkContext& context)
{
    return done(labelListed(context.programs.label, context.fields, context.before, edit));
}

BegunWork beginWork(const core::RelabelListed& edit, const WorkContext& context)
{
    return done(relabelListed(context.programs.label, context.fields, context.before, edit));
}

BegunWork beginWork(const core::ShutListed& edit, const WorkContext& context)
{
    return done(shutListed(context.programs.shut, context.fields, context.before, edit));
}

BegunWork beginWork(const core::CoverLabel& edit, const WorkContext& context)
{
    return done(coverLabel(context.programs.erase, context.fields, context.before, edit));
}

BegunWork beginWork(const core::FoldLayer& edit, const WorkContext& context)
{
    return done(foldLayer(context.fields, context.before, edit));
}

} // namespace gpu
