// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/PeelKernel.h"

#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"

namespace gpu {

PeelKernel::PeelKernel(
    CutPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::ShellPeel& peel)
    : m_fields(fields)
    , m_before(before)
    , m_peel(peel)
    , m_columns(peel.frame, fields.grid())
    , m_cutter(programs.cut, fields, before, peel.frame,
          {peel.layer, peel.laying, peel.frame.protectedLabels})
    , m_cast(castRaster(programs, fields, peel.frame, peel.mask, m_columns.room()))
    , m_sheet(core::peelSheet(peel, m_cast.hits))
{
}

core::Result<void> PeelKernel::extend(const core::EngineExtension& extension)
{
    const auto* depth = std::get_if<core::PeelDepth>(&extension);
    if (!depth)
        return EditWork::extend(extension);
    if (depth->depth < 0)
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("depth"),
            core::Clause::saying("is below 0"));
    setDepth(depth->depth);
    return {};
}

bool PeelKernel::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    const auto* first = std::get_if<core::PeelDepth>(&earlier);
    const auto* second = std::get_if<core::PeelDepth>(&next);
    // A depth that is refused is told by itself.
    if (!first || !second || first->depth < 0 || second->depth < 0)
        return false;
    earlier = next;
    return true;
}

/// Changed at any depth.
std::vector<core::BrickKey> PeelKernel::touchedKeys() const
{
    return keysOf(core::Field::Coverage, m_peel.layer, m_cutter.touchedBricks());
}

void PeelKernel::finish(core::EngineResult& result)
{
    result.statistics.searchedTo = m_cast.searchedTo;
}

void PeelKernel::setDepth(std::int32_t depth)
{
    if (depth == m_depth)
        return;
    if (depth < m_depth) {
        m_before.restore(touchedKeys());
        m_columns.clear();
    }
    m_depth = depth;
    if (depth == 0)
        return;
    const std::vector<std::int32_t> ends =
        core::offsetSurface(m_sheet, m_peel.frame.pitch, depth, m_peel.frame.restore);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (ends[i] == core::SurfaceHit::none)
            continue;
        const glm::ivec2 place(
            int(i % std::size_t(m_sheet.size.x)), int(i / std::size_t(m_sheet.size.x)));
        m_columns.set(m_sheet.first + place,
            core::peelColumn(m_peel.frame, m_cast.hits[i], ends[i], m_peel.mask.values[i]));
    }
    m_fields.noteChanged(core::Field::Coverage, m_cutter.lay(m_columns));
}

} // namespace gpu
