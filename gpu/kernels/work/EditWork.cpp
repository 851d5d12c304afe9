// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/work/EditWork.h"

#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"

namespace gpu {

namespace {

/// Why an extension does not fit; one of a kind that has no sentence does not compile.
struct Misfits {
    core::Clause operator()(const core::DrillPath&) const
    {
        return core::Clause::saying("the open edit is no stroke of drill or laser");
    }
    core::Clause operator()(const core::CapsulePath&) const
    {
        return core::Clause::saying("the open edit is no stroke of a brush");
    }
    core::Clause operator()(const core::PeelDepth&) const
    {
        return core::Clause::saying("the open edit is no peel");
    }
    core::Clause operator()(const core::ShrinkTo&) const
    {
        return core::Clause::saying("the open edit is no shrinking");
    }
    core::Clause operator()(const core::CutFurther&) const
    {
        return core::Clause::saying("the open edit is no cut backwards");
    }
    core::Clause operator()(const core::ForgetSpread&) const
    {
        return core::Clause::saying("the open edit does not grow from seeds");
    }
    core::Clause operator()(const core::GrowAdvance&) const { return noGrowth(); }
    core::Clause operator()(const core::GrowPause&) const { return noGrowth(); }
    core::Clause operator()(const core::GrowAnew&) const { return noGrowth(); }

    static core::Clause noGrowth() { return core::Clause::saying("the open edit is no growth"); }
};

} // namespace

core::Result<void> EditWork::extend(const core::EngineExtension& extension)
{
    return core::failure(core::ErrorCode::InvalidField, QStringLiteral("extension"),
        std::visit(Misfits(), extension));
}

bool EditWork::join(core::EngineExtension&, core::EngineExtension&) const
{
    return false;
}

void EditWork::advance(int) { }

void EditWork::finish(core::EngineResult&) { }

void EditWork::rollBack(core::EngineResult&) { }

std::vector<core::BrickKey> keysOf(
    core::Field field, std::uint8_t plane, const std::vector<std::uint32_t>& bricks)
{
    std::vector<core::BrickKey> keys;
    keys.reserve(bricks.size());
    for (const std::uint32_t brick : bricks)
        keys.push_back({.field = field, .plane = plane, .brick = brick});
    return keys;
}

} // namespace gpu
