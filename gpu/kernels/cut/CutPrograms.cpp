// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/CutPrograms.h"

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = {}});
}

} // namespace

CutPrograms::CutPrograms(const ShaderLibrary& library)
    : cast(program(library, "kernels/cut/surfaceCast.comp"))
    , cut(program(library, "kernels/cut/columnCut.comp"))
{
}

RasterHits castRaster(CutPrograms& programs, VoxelFields& fields, const core::CutFrame& frame,
    const core::OutlineRaster& mask, const core::ElementBox& room)
{
    std::vector<std::size_t> places;
    std::vector<glm::ivec2> elements;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        const glm::ivec2 element = mask.first
            + glm::ivec2(int(i % std::size_t(mask.size.x)), int(i / std::size_t(mask.size.x)));
        if (mask.values[i] == 0 || glm::any(glm::lessThan(element, room.minimum))
            || glm::any(glm::greaterThan(element, room.maximum)))
            continue;
        places.push_back(i);
        elements.push_back(element);
    }
    SurfaceCaster caster(programs.cast, fields, frame);
    const std::vector<core::SurfaceHit> found = caster.cast(elements);
    std::vector<core::SurfaceHit> hits(mask.values.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        hits[places[i]] = found[i];
    return {std::move(hits), caster.searchedTo()};
}

} // namespace gpu
