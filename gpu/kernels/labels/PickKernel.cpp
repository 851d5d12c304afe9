// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/PickKernel.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

unsigned groupsFor(std::size_t count)
{
    return unsigned(count + 63) / 64;
}

using Planes = std::array<const Texture3D*, core::mostLabelPlanes>;

/// Plane 0 stands for each that is not in use.
void bindPlanes(const Planes& planes, const std::array<GLuint, core::mostLabelPlanes>& units)
{
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
        (planes[plane] ? planes[plane] : planes.front())->bindUnit(units[plane]);
}

} // namespace

PickKernel::PickKernel(const ShaderLibrary& library)
    : m_library(library)
    , m_probe(library,
          ComputeProgramOptions{
              .label = "probe", .path = "kernels/labels/probe.comp", .defines = {}})
{
}

Program& PickKernel::programFor(const core::PickVoxels& command, const VoxelFields& fields)
{
    const Planes planes = fields.labelPlanes();
    const bool further = std::any_of(
        planes.begin() + 1, planes.end(), [](const Texture3D* plane) { return plane != nullptr; });
    const bool inPlanes = command.seenBy == core::SeenBy::Segment && further;
    Program& program = inPlanes ? m_pickInPlanes : m_pick.at(std::size_t(command.seenBy));
    if (!program) {
        ShaderDefines defines{{"SEEN_BY", int(command.seenBy)}};
        if (inPlanes)
            defines.emplace_back("FURTHER_PLANES", 1);
        program = Program(m_library,
            ComputeProgramOptions{.label = "pick",
                .path = "kernels/labels/pick.comp",
                .defines = std::move(defines)});
    }
    return program;
}

std::vector<std::optional<glm::ivec3>> PickKernel::pick(
    VoxelFields& fields, const core::PickVoxels& command)
{
    if (command.rays.empty())
        return {};
    struct Ray {
        glm::ivec4 origin;
        glm::ivec4 perSample;
    };
    std::vector<Ray> rays;
    for (const core::PickRay& ray : command.rays)
        rays.push_back({glm::ivec4(ray.origin, ray.samples), glm::ivec4(ray.step, 0)});
    std::vector<std::uint32_t> opacities = command.opacityOfCode;
    opacities.resize(256, 0);
    const Buffer rayBuffer = bufferOf("pick rays", rays);
    const Buffer opacityBuffer = bufferOf("pick opacities", opacities);
    Buffer hitBuffer({.label = "pick hits", .bytes = rays.size() * sizeof(glm::ivec4)});
    fields.codes().bindUnit(0);
    fields.radiation().bindUnit(1);
    bindPlanes(fields.labelPlanes(), {2, 3, 4, 5});
    rayBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    hitBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    opacityBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    Program& program = programFor(command, fields);
    program.set("volumeSize", fields.grid().volumeSize)
        .set("rayCount", unsigned(rays.size()))
        .set("thresholdCode", command.thresholdCode)
        .set("segments", command.segments);
    program.dispatch({groupsFor(rays.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<glm::ivec4> hits(rays.size());
    hitBuffer.read(std::span<glm::ivec4>(hits));
    std::vector<std::optional<glm::ivec3>> picks(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].w != 0)
            picks[i] = glm::ivec3(hits[i]);
    }
    return picks;
}

std::vector<core::ProbedVoxel> PickKernel::probe(
    VoxelFields& fields, const core::ProbeVoxels& command)
{
    if (command.voxels.empty())
        return {};
    std::vector<glm::ivec4> voxels;
    for (const glm::ivec3& voxel : command.voxels)
        voxels.emplace_back(voxel, 0);
    const Buffer voxelBuffer = bufferOf("probe voxels", voxels);
    Buffer foundBuffer({.label = "probe answers", .bytes = voxels.size() * sizeof(glm::uvec4)});
    fields.codes().bindUnit(0);
    const Planes planes = fields.labelPlanes();
    bindPlanes(planes, {1, 5, 6, 7});
    const ToleranceField& field = fields.tolerance();
    (field.stands ? field.tolerances : fields.codes()).bindUnit(2);
    BrickField& words = fields.seedWords(command.plane);
    words.pageTable().bindUnit(3);
    words.atlas().bindUnit(4);
    voxelBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    foundBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_probe.set("voxelCount", unsigned(voxels.size())).set("hasTolerances", field.stands);
    m_probe.dispatch({groupsFor(voxels.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<glm::uvec4> found(voxels.size());
    foundBuffer.read(std::span<glm::uvec4>(found));
    std::vector<core::ProbedVoxel> probes;
    for (const glm::uvec4& each : found) {
        core::ProbedVoxel probe{.code = int(each.x), .seedOf = std::uint8_t(each.w)};
        for (std::size_t plane = 0; plane < planes.size(); ++plane)
            probe.labels[plane] = planes[plane] ? std::uint8_t(each.y >> 8 * plane) : 0;
        if (command.plane < planes.size())
            probe.label = probe.labels[command.plane];
        if (int(each.z) <= core::ToleranceRule::greatest)
            probe.tolerance = int(each.z);
        probes.push_back(probe);
    }
    return probes;
}

} // namespace gpu
