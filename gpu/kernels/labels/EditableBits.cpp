// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/EditableBits.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr std::size_t bitWordsPerBrick = core::BrickGrid::voxelsPerBrick / 32;

Program compiled(const ShaderLibrary& library, const ShaderDefines& defines)
{
    const char* path = "kernels/labels/editable.comp";
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

} // namespace

Buffer EditableBits::find(const core::EditableVoxels& editable, VoxelFields& fields,
    const std::vector<std::uint32_t>& bricks)
{
    Buffer bits = bufferOf(
        "editable voxels", std::vector<std::uint32_t>(bricks.size() * bitWordsPerBrick, 0u));
    if (bricks.empty() || (editable.inside && editable.inside->empty()))
        return bits;
    if (!m_values)
        m_values = compiled(m_library, {{"VALUES", 1}});
    const bool ofLabels = editable.inside || !editable.outside.empty();
    if (ofLabels && !m_labels)
        m_labels = compiled(m_library, {});
    const Buffer list = bufferOf("editable bricks", bricks);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    bits.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    const auto ask = [&](const core::EditableVoxels::PlaneLabels& plane, Join how) {
        fields.labels(plane.plane).bindUnit(0);
        m_labels.set("listed", plane.labels);
        run(m_labels, how, fields, bricks.size());
    };
    if (editable.inside) {
        for (const core::EditableVoxels::PlaneLabels& plane : *editable.inside)
            ask(plane, Join::Add); // nothing is set yet
    }
    const bool none = editable.lowCode > editable.highCode || editable.highCode < 0;
    const core::VoxelBox box =
        editable.box.value_or(core::VoxelBox{glm::ivec3(0), fields.grid().volumeSize});
    fields.codes().bindUnit(0);
    m_values.set("lowCode", none ? 65536u : unsigned(std::max(editable.lowCode, 0)))
        .set("highCode", none ? 0u : unsigned(editable.highCode))
        .set("boxFrom", box.minimum)
        .set("boxTo", box.maximum);
    run(m_values, editable.inside ? Join::Keep : Join::Set, fields, bricks.size());
    for (const core::EditableVoxels::PlaneLabels& plane : editable.outside)
        ask(plane, Join::Remove);
    return bits;
}

void EditableBits::run(Program& program, Join how, const VoxelFields& fields, std::size_t bricks)
{
    program.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("how", unsigned(how));
    program.dispatch({unsigned(bricks), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
