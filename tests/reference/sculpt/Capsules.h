// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/LabelCommands.h"
#include "core/engine/LayerCommands.h"
#include "core/engine/StrokeExtensions.h"
#include "core/growth/GrowthCommands.h"
#include "tests/reference/fields/DenseFields.h"

#include <optional>
#include <variant>

namespace reference {

/// One open stroke of a brush (core/sculpt/CapsuleSweep.h): every voxel of the volume against every
/// piece of the path. Codes and fields are borrowed.
class Capsules {
public:
    Capsules(const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::PaintLabel paint);
    Capsules(
        const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::PaintBarrier command);
    Capsules(const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::CapsuleCut cut);

    void extend(const core::CapsulePath& path);

private:
    [[nodiscard]] std::array<std::int64_t, 3> position(const glm::ivec3& voxel) const;
    /// Rule 3, D².
    [[nodiscard]] std::optional<std::int64_t> distance(
        const core::Capsule& capsule, std::array<std::int64_t, 3> position) const;
    void paint(const core::PaintLabel& paint, const glm::ivec3& voxel);
    /// Whether a capsule holds the voxel (rule 4).
    [[nodiscard]] bool isWithin(const core::Capsule& capsule, const glm::ivec3& voxel) const;
    /// The same for a brush that follows edges: paints every member that there is by now, found
    /// anew in passes over the whole volume.
    void followEdges(const core::PaintLabel& paint, const core::CapsulePath& path);
    [[nodiscard]] int edgeValue(const glm::ivec3& start) const;
    [[nodiscard]] bool areNeighbours(const glm::ivec3& step) const;
    void setBarrier(const core::PaintBarrier& command, const glm::ivec3& voxel);
    /// @param radius of the capsule, mm16
    void cut(const core::CapsuleCut& cut, const glm::ivec3& voxel, std::int64_t squared,
        std::int64_t radius);

    const DenseArray<std::uint16_t>& m_codes;
    DenseFields& m_fields;
    std::variant<core::PaintLabel, core::PaintBarrier, core::CapsuleCut> m_edit;
    core::CapsuleFrame m_frame;
    DenseArray<std::uint8_t> m_alike; ///< of a brush that follows edges: 1 where a voxel is
    DenseArray<std::uint8_t> m_under;
};

} // namespace reference
