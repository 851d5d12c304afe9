// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "gpu/fields/VoxelFields.h"

#include <optional>
#include <span>
#include <vector>

namespace gpu {

/// Casts rays from elements of a mask plane onto the visible surface, as it was when the edit began
/// (core/sculpt/CutFrame.h, rules 2 to 5; surfaceCast.comp). For that it keeps a copy of the
/// radiation of every brick that the edit changes. Engine thread only.
class SurfaceCaster {
public:
    /// @param cast the compiled kernel; used by one caster at a time
    SurfaceCaster(Program& cast, VoxelFields& fields, const core::CutFrame& frame);

    /// Where the ray of each element meets the surface. Waits; cost ∝ elements.
    [[nodiscard]] std::vector<core::SurfaceHit> cast(std::span<const glm::ivec2> elements);
    /// How deep the rays of all cast elements looked (core::searchEnd()); none if none was cast.
    [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return m_searchedTo; }
    /// Makes a program that includes snapshot.glsl see the same surface: sets its uniforms and
    /// binds units 0 and 1 and buffers 2 and 3.
    void show(Program& program) const;
    /// Copies the radiation that is about to change with the coverage of these bricks. Call it
    /// before VoxelFields::noteChanged().
    void keepRadiation(std::span<const std::uint32_t> bricks);

private:
    Program& m_cast;
    VoxelFields& m_fields;
    core::CutFrame m_frame;
    std::optional<std::int32_t> m_searchedTo;
    Buffer m_snapshotSlots;
    std::vector<std::uint32_t> m_snapshotOf; ///< slot + 1, by brick
    std::uint32_t m_snapshotCount = 0;
    std::uint32_t m_snapshotCapacity = 0;
    Buffer m_snapshots;
};

} // namespace gpu
