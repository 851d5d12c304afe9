// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/FieldPrograms.h"

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

} // namespace

CopyPrograms::CopyPrograms(const ShaderLibrary& library)
    : packDense(program(library, "fields/bricks/packBricks.comp", {{"FIELD_DENSE", 1}}))
    , packBytes(program(library, "fields/bricks/packBricks.comp"))
    , packWords(program(library, "fields/bricks/packBricks.comp", {{"FIELD_WORDS", 1}}))
    , unpackDense(program(library, "fields/bricks/unpackBricks.comp", {{"FIELD_DENSE", 1}}))
    , unpackBytes(program(library, "fields/bricks/unpackBricks.comp"))
    , unpackWords(program(library, "fields/bricks/unpackBricks.comp", {{"FIELD_WORDS", 1}}))
{
    packBytes.set("emptyVoxel", 0u);
    packWords.set("emptyVoxel", 0xFFFFFFFFu);
}

RadiationPrograms::RadiationPrograms(const ShaderLibrary& library)
    : gatherCoverage(
        program(library, "kernels/radiation/radiationGather.comp", {{"SOURCE_COVERAGE", 1}}))
    , gatherLabels(program(library, "kernels/radiation/radiationGather.comp"))
    , blur{program(library, "kernels/radiation/radiationBlur.comp", {{"AXIS", 0}}),
          program(library, "kernels/radiation/radiationBlur.comp", {{"AXIS", 1}}),
          program(library, "kernels/radiation/radiationBlur.comp", {{"AXIS", 2}})}
    , raise(program(library, "kernels/radiation/radiationRaise.comp"))
    , m_library(library)
{
}

Program& RadiationPrograms::gatherAtTolerance()
{
    if (!m_gatherAtTolerance)
        m_gatherAtTolerance =
            program(m_library, "kernels/radiation/radiationGather.comp", {{"AT_TOLERANCE", 1}});
    return m_gatherAtTolerance;
}

FieldPrograms::FieldPrograms(const ShaderLibrary& library)
    : copy(library)
    , radiation(library)
    , pieceCells(library, {.label = "piece cells", .path = "fields/textures/pieceCells.comp"})
    , m_library(library)
{
}

Program& FieldPrograms::findBarriers()
{
    if (!m_findBarriers)
        m_findBarriers = program(m_library, "fields/bricks/findBarriers.comp");
    return m_findBarriers;
}

Program& FieldPrograms::composeLabels()
{
    if (!m_composeLabels)
        m_composeLabels = program(m_library, "fields/textures/composeLabels.comp");
    return m_composeLabels;
}

} // namespace gpu
