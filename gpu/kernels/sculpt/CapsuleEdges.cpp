// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/CapsuleKernel.h"

#include <algorithm>
#include <span>
#include <utility>

namespace gpu {

namespace {

using MemberBits = core::EdgeRegion::Bits;
constexpr std::size_t memberBricksAtOnce = 1024;

} // namespace

void CapsuleKernel::setEdges(const core::PaintLabel& paint) const
{
    const core::VoxelBox box = core::edgeValueBox(*paint.edges, m_fields.grid());
    const glm::ivec3 size = box.maximum - box.minimum;
    std::vector<std::uint16_t> codes(std::size_t(size.x) * std::size_t(size.y * size.z));
    m_fields.codes().read(
        box.minimum, size, std::as_writable_bytes(std::span<std::uint16_t>(codes)));
    const int value = core::edgeValue(*paint.edges, m_frame, m_fields.grid(), codes);
    const int tolerance = paint.edges->tolerance;
    const int low = std::max({0, paint.lowCode, value - tolerance});
    const int high = std::min(paint.highCode, value + tolerance);
    m_programs.alike()
        .set("lowCode", low > high ? 65536u : unsigned(low))
        .set("highCode", low > high ? 0u : unsigned(high))
        .set("value", value)
        .set("tolerance", tolerance);
}

void CapsuleKernel::followEdges(const core::CapsulePath& path)
{
    m_edges->addUnder(path.under);
    follow(path.capsules); // finds what is alike
    paintMembers(std::get<core::PaintLabel>(m_edit));
}

void CapsuleKernel::findAlike(
    const Candidates& candidates, const std::vector<core::Capsule>& capsules)
{
    std::vector<MemberBits> alike(candidates.bricks.size());
    const Buffer buffer(
        {.label = "brush voxels alike", .bytes = alike.size() * sizeof(MemberBits)});
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    m_fields.codes().bindUnit(0);
    static_cast<void>(run(m_programs.alike(), candidates, capsules));
    buffer.read(std::span<MemberBits>(alike));
    const auto isAny = [](const MemberBits& bits) {
        return std::any_of(bits.begin(), bits.end(), [](const auto word) { return word != 0; });
    };
    for (std::size_t i = 0; i < alike.size(); ++i) {
        if (isAny(alike[i]))
            m_edges->addAlike(candidates.bricks[i], alike[i]);
    }
}

void CapsuleKernel::paintMembers(const core::PaintLabel& paint)
{
    Candidates batch;
    std::vector<MemberBits> members;
    const auto write = [&] {
        const Buffer buffer = bufferOf("brush members", members);
        buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        writeLabels(painting(paint), paint.plane, paint.seeds && !paint.erase, batch, {});
        batch = {};
        members.clear();
    };
    for (const auto& [brick, bits] : m_edges->takeNew()) {
        if (nothingFor(paint, brick))
            continue;
        batch.bricks.push_back(brick);
        batch.near.emplace_back(); // bits say which voxels
        members.push_back(bits);
        if (members.size() == memberBricksAtOnce)
            write();
    }
    if (!members.empty())
        write();
}

} // namespace gpu
