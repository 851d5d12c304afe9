// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/FieldPrograms.h"

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

} // namespace

CopyPrograms::CopyPrograms(const ShaderLibrary& library)
    : packDense(program(library, "edit/packBricks.comp", {{"FIELD_DENSE", 1}}))
    , packBytes(program(library, "edit/packBricks.comp"))
    , packWords(program(library, "edit/packBricks.comp", {{"FIELD_WORDS", 1}}))
    , unpackDense(program(library, "edit/unpackBricks.comp", {{"FIELD_DENSE", 1}}))
    , unpackBytes(program(library, "edit/unpackBricks.comp"))
    , unpackWords(program(library, "edit/unpackBricks.comp", {{"FIELD_WORDS", 1}}))
{
    packBytes.set("emptyVoxel", 0u);
    packWords.set("emptyVoxel", 0xFFFFFFFFu);
}

RadiationPrograms::RadiationPrograms(const ShaderLibrary& library)
    : gatherCoverage(program(library, "edit/radiationGather.comp", {{"SOURCE_COVERAGE", 1}}))
    , gatherLabels(program(library, "edit/radiationGather.comp"))
    , blur{program(library, "edit/radiationBlur.comp", {{"AXIS", 0}}),
          program(library, "edit/radiationBlur.comp", {{"AXIS", 1}}),
          program(library, "edit/radiationBlur.comp", {{"AXIS", 2}})}
    , raise(program(library, "edit/radiationRaise.comp"))
    , m_library(library)
{
}

Program& RadiationPrograms::gatherAtTolerance()
{
    if (!m_gatherAtTolerance)
        m_gatherAtTolerance =
            program(m_library, "edit/radiationGather.comp", {{"AT_TOLERANCE", 1}});
    return m_gatherAtTolerance;
}

FieldPrograms::FieldPrograms(const ShaderLibrary& library)
    : copy(library)
    , radiation(library)
    , pieceCells(library, {.label = "piece cells", .path = "textures/pieceCells.comp"})
    , m_library(library)
{
}

Program& FieldPrograms::findBarriers()
{
    if (!m_findBarriers)
        m_findBarriers = program(m_library, "edit/findBarriers.comp");
    return m_findBarriers;
}

} // namespace gpu
