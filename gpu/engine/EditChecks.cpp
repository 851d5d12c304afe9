// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditTransaction.h"

namespace gpu {

// Whether an edit is sound, before anything of it is begun.

namespace {

core::Result<void> checkVoxels(const std::vector<glm::ivec3>& voxels, const core::BrickGrid& grid)
{
    for (const glm::ivec3& voxel : voxels) {
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(voxel, grid.volumeSize)))
            return refusal("voxels", "outside the volume");
    }
    return {};
}

core::Result<void> check(const core::SeedPlacement& edit, const core::BrickGrid& grid)
{
    if (edit.label == 0)
        return refusal("label", "0 is no segment");
    const core::Result<void> taken = checkVoxels(edit.taken, grid);
    return taken ? checkVoxels(edit.voxels, grid) : taken;
}

core::Result<void> check(const core::GrowBurst& edit, const core::BrickGrid& grid)
{
    if (edit.connectivity != 6 && edit.connectivity != 18 && edit.connectivity != 26)
        return refusal("connectivity", "is not 6, 18 or 26");
    if (!core::isSound(edit))
        return refusal("limits", "are not sound");
    return gpu::check(edit.seedGroups, grid);
}

core::Result<void> check(const core::ShrinkGrowth& edit, const core::BrickGrid&)
{
    if (edit.keep > edit.generation)
        return refusal("keep", "is more than there is");
    return {};
}

core::Result<void> check(const core::SpreadLabels& edit, const core::BrickGrid& grid)
{
    if (!core::isSound(edit, grid.volumeSize))
        return refusal("spread", "is not sound");
    return {};
}

core::Result<void> check(const core::MaskFrame& frame)
{
    if (frame.pitch < 1 || frame.rampHalfWidth < 1 || frame.gapSamples < 1)
        return refusal("frame", "pitch, rampHalfWidth and gapSamples are at least 1");
    if (!core::isSound(frame.hidden))
        return refusal("hidden", "is not sound");
    return {};
}

core::Result<void> check(const core::LaserCut& edit, const core::BrickGrid&)
{
    if (const core::Result<void> checked = check(edit.frame); !checked)
        return checked;
    if (!core::isSound(edit))
        return refusal("laser", "is not sound");
    return {};
}

core::Result<void> check(const core::DrillCut& edit, const core::BrickGrid&)
{
    return check(edit.frame);
}

core::Result<void> check(const core::MaskPeel& edit, const core::BrickGrid&)
{
    return check(edit.frame);
}

core::Result<void> check(const core::MaskScissors& edit, const core::BrickGrid&)
{
    return check(edit.frame);
}

core::Result<void> check(const core::EraseLabel& edit, const core::BrickGrid&)
{
    if (edit.label == 0)
        return refusal("label", "0 is no segment");
    return {};
}

core::Result<void> check(const core::PaintLabel& edit, const core::BrickGrid&)
{
    if (edit.label == 0)
        return refusal("label", "0 is no segment");
    if (!core::isSound(edit.frame))
        return refusal("frame", "is not sound");
    return {};
}

core::Result<void> check(const core::PaintBarrier& edit, const core::BrickGrid&)
{
    if (!core::isSound(edit.frame))
        return refusal("frame", "is not sound");
    return {};
}

core::Result<void> check(const core::ShutListed& edit, const core::BrickGrid& grid)
{
    if (!core::isSound(edit, grid.brickCount()))
        return refusal("bricks", "are not sound");
    return {};
}

core::Result<void> check(const core::CapsuleCut& edit, const core::BrickGrid&)
{
    if (!core::isSound(edit.frame))
        return refusal("frame", "is not sound");
    if (!core::isSound(edit.hidden))
        return refusal("hidden", "is not sound");
    return {};
}

core::Result<void> check(const core::LabelTarget& target)
{
    if (target.label == 0)
        return refusal("label", "0 is no segment");
    return {};
}

core::Result<void> check(const core::LabelCarved& edit, const core::BrickGrid&)
{
    return check(edit.target);
}

core::Result<void> check(const core::LabelSeen& edit, const core::BrickGrid& grid)
{
    if (!core::areSound(edit.bounds, grid.volumeSize))
        return refusal("bounds", "are not sound");
    return check(edit.target);
}

core::Result<void> check(const core::LabelListed& edit, const core::BrickGrid& grid)
{
    if (!core::isSound(edit, grid.brickCount()))
        return refusal("bricks", "are not sound");
    return {};
}

core::Result<void> check(const core::RelabelListed& edit, const core::BrickGrid& grid)
{
    if (!core::isSound(edit, grid.brickCount()))
        return refusal("bricks", "are not sound");
    return check(edit.target);
}

core::Result<void> check(const core::CoverLabel& edit, const core::BrickGrid&)
{
    if (edit.label == 0)
        return refusal("label", "0 is no segment");
    return {};
}

core::Result<void> check(const core::FoldLayer& edit, const core::BrickGrid&)
{
    if (edit.into == edit.layer)
        return refusal("into", "is the layer itself");
    return {};
}

} // namespace

core::Result<void> check(const core::CutGrowth& edit, const core::BrickGrid& grid)
{
    if (edit.connectivity != 6 && edit.connectivity != 18 && edit.connectivity != 26)
        return refusal("connectivity", "is not 6, 18 or 26");
    return checkVoxels(edit.voxels, grid);
}

core::Result<void> check(const std::vector<core::SeedGroup>& groups, const core::BrickGrid& grid)
{
    if (!core::isSound(groups))
        return refusal("seedGroups", "are not sound");
    for (const core::SeedGroup& group : groups) {
        if (const core::Result<void> checked = checkVoxels(group.voxels, grid); !checked)
            return checked;
    }
    return {};
}

tl::unexpected<core::Error> refusal(const char* field, const char* reason)
{
    return core::failure(
        core::ErrorCode::InvalidField, QLatin1String(field), QLatin1String(reason));
}

core::Result<void> checkEdit(const core::EngineEdit& edit, const core::BrickGrid& grid)
{
    return std::visit([&grid](const auto& known) { return check(known, grid); }, edit);
}

} // namespace gpu
