// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/labels/EditableVoxels.h"

#include <glm/glm.hpp>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace core {

/// The labels of one plane, one for each voxel of the volume, x fastest.
struct LabelPlane {
    std::uint8_t plane = 0;
    std::span<const std::uint8_t> labels{};
};

/// Those of one of the planes; empty if it is not among them.
[[nodiscard]] std::span<const std::uint8_t> labelsOfPlane(
    std::span<const LabelPlane> planes, std::uint8_t plane);

/// The planes that have to be read to know which voxels are editable.
[[nodiscard]] std::set<std::uint8_t> planesOf(const EditableVoxels& editable);

/// Which voxels an edit must leave as they are (EditableVoxels.h, rule 1). For code that decides
/// this on the processor and has read the label planes that the rule asks about; an engine decides
/// it by itself.
class HeldVoxels {
public:
    /// @param editable must outlive this, and so must what the planes refer to
    /// @param planes with those of planesOf()
    HeldVoxels(const EditableVoxels& editable, std::span<const LabelPlane> planes);

    /// @param place of the voxel in the volume, x fastest
    [[nodiscard]] bool holds(const glm::ivec3& voxel, std::size_t place, int code) const;

private:
    struct Read {
        std::span<const std::uint8_t> labels;
        std::bitset<256> wanted;
    };
    [[nodiscard]] static std::vector<Read> read(
        const std::vector<EditableVoxels::PlaneLabels>& listed, std::span<const LabelPlane> planes);
    [[nodiscard]] static bool isInOneOf(const std::vector<Read>& listed, std::size_t place);

    const EditableVoxels& m_editable;
    std::optional<std::vector<Read>> m_inside;
    std::vector<Read> m_outside;
};

} // namespace core
