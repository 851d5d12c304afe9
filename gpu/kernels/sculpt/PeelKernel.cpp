// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/PeelKernel.h"

namespace gpu {

PeelKernel::PeelKernel(
    MaskPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::MaskPeel& peel)
    : m_fields(fields)
    , m_before(before)
    , m_peel(peel)
    , m_columns(peel.frame, fields.grid())
    , m_cutter(
          programs.cut, fields, before, peel.frame, {peel.layer, peel.laying, peel.frame.spared})
    , m_cast(castMask(programs, fields, peel.frame, peel.mask, m_columns.room()))
    , m_sheet(core::peelSheet(peel, m_cast.hits))
{
}

void PeelKernel::setDepth(std::int32_t depth)
{
    if (depth == m_depth)
        return;
    if (depth < m_depth) {
        std::vector<core::BrickKey> keys;
        for (const std::uint32_t brick : m_cutter.touchedBricks())
            keys.push_back({core::Field::Coverage, m_peel.layer, brick});
        m_before.restore(std::move(keys));
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
