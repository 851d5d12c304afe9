// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/ScissorsKernel.h"

#include "core/engine/EngineResult.h"
#include "gpu/kernels/cut/ColumnCutter.h"

namespace gpu {

ScissorsKernel::ScissorsKernel(CutPrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::OutlineCut& scissors)
{
    CutColumns columns(scissors.frame, fields.grid());
    ColumnCutter cutter(programs.cut, fields, before, scissors.frame,
        {scissors.layer, scissors.laying, scissors.frame.protectedLabels});
    RasterHits cast;
    if (scissors.fromSurface)
        cast = castRaster(programs, fields, scissors.frame, scissors.mask, columns.room());
    const core::ElementBox& room = columns.room();
    std::size_t i = 0;
    for (int b = 0; b < scissors.mask.size.y; ++b) {
        for (int a = 0; a < scissors.mask.size.x; ++a, ++i) {
            const glm::ivec2 element = scissors.mask.first + glm::ivec2(a, b);
            if (glm::any(glm::lessThan(element, room.minimum))
                || glm::any(glm::greaterThan(element, room.maximum)))
                continue;
            const core::CutColumn column = core::scissorsColumn(scissors,
                cast.hits.empty() ? core::SurfaceHit{} : cast.hits[i], scissors.mask.values[i]);
            if (column.weight > 0)
                columns.set(element, column);
        }
    }
    const std::vector<std::uint32_t> changed = cutter.lay(columns);
    fields.noteChanged(core::Field::Coverage, changed);
    m_changed = keysOf(core::Field::Coverage, scissors.layer, changed);
    m_searchedTo = cast.searchedTo;
}

std::vector<core::BrickKey> ScissorsKernel::touchedKeys() const
{
    return m_changed;
}

void ScissorsKernel::finish(core::EngineResult& result)
{
    result.statistics.searchedTo = m_searchedTo;
}

} // namespace gpu
