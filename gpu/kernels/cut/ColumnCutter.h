// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/cut/CoverageWriter.h"
#include "gpu/kernels/cut/CutColumns.h"

#include <vector>

namespace gpu {

/// Cuts the columns of a mask plane into the coverage of a sculpt layer (core/sculpt/CutFrame.h,
/// rule 6; columnCut.comp). Engine thread only.
class ColumnCutter {
public:
    /// @param cut the compiled kernel; used by one cutter at a time
    ColumnCutter(Program& cut, VoxelFields& fields, BeforeImages& before,
        const core::CutFrame& frame, const CoverageWriter::Target& target);

    /// Cuts the columns that were set since the last call. The caller tells VoxelFields.
    [[nodiscard]] std::vector<std::uint32_t> lay(CutColumns& columns);

    /// All bricks that changed so far, ascending.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const
    {
        return m_writer.touchedBricks();
    }

private:
    Program& m_cut;
    VoxelFields& m_fields;
    core::CutFrame m_frame;
    CoverageWriter m_writer;
};

} // namespace gpu
