// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/ProtectedVoxels.h"

namespace gpu {

namespace {

using PlaneBits = std::bitset<core::ProtectedLabels::mostPlanes>;

/// The planes in which a protected label may lie: one that is not in use holds 0 everywhere.
PlaneBits planesToAsk(const VoxelFields& fields, const core::ProtectedLabels& protectedLabels)
{
    if (protectedLabels.labels.none())
        return {};
    PlaneBits asked = protectedLabels.planes;
    const auto inUse = fields.labelPlanes();
    static_assert(PlaneBits().size() == inUse.size());
    for (std::size_t plane = 0; plane < asked.size(); ++plane) {
        if (!inUse[plane] && !protectedLabels.labels[0])
            asked.reset(plane);
    }
    return asked;
}

} // namespace

void setProtected(
    Program& program, const VoxelFields& fields, const core::ProtectedLabels& protectedLabels)
{
    program.set("protectedPlanes", unsigned(planesToAsk(fields, protectedLabels).to_ulong()))
        .set("protectedLabels", protectedLabels.labels);
}

void bindProtected(VoxelFields& fields, const core::ProtectedLabels& protectedLabels)
{
    constexpr GLuint firstUnit = 2;
    const PlaneBits asked = planesToAsk(fields, protectedLabels);
    for (std::size_t plane = 0; plane < asked.size(); ++plane)
        fields.labels(asked[plane] ? std::uint8_t(plane) : std::uint8_t(0))
            .bindUnit(firstUnit + GLuint(plane));
}

} // namespace gpu
