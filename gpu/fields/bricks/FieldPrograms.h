// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"

#include <array>

namespace gpu {

/// The compiled kernels of BrickCopier (packBricks.comp, unpackBricks.comp), by kind of field.
struct CopyPrograms {
    /// @param library outlives the programs, here and below
    explicit CopyPrograms(const ShaderLibrary& library);

    Program packDense;
    Program packBytes;
    Program packWords;
    Program unpackDense;
    Program unpackBytes;
    Program unpackWords;
};

/// The compiled kernels of RadiationKernel (radiation*.comp).
struct RadiationPrograms {
    explicit RadiationPrograms(const ShaderLibrary& library);

    Program gatherCoverage;
    Program gatherLabels;
    std::array<Program, 3> blur;
    Program raise;
    /// Gathers labels, with one segment as it would be at a tolerance. Compiled when it is first
    /// needed.
    [[nodiscard]] Program& gatherAtTolerance();

private:
    const ShaderLibrary& m_library;
    Program m_gatherAtTolerance;
};

/// Every compiled kernel that VoxelFields needs. The kernels know of no volume, so one set serves
/// all volumes that are opened. Engine thread only.
struct FieldPrograms {
    explicit FieldPrograms(const ShaderLibrary& library);

    CopyPrograms copy;
    RadiationPrograms radiation;
    Program pieceCells;
    /// The kernel of BarrierBricks; compiled when it is first needed.
    [[nodiscard]] Program& findBarriers();
    /// The kernel of ShownLabels; compiled when it is first needed.
    [[nodiscard]] Program& composeLabels();

private:
    const ShaderLibrary& m_library;
    Program m_findBarriers;
    Program m_composeLabels;
};

} // namespace gpu
