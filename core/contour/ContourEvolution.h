// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/contour/ContourRule.h"
#include "core/morphology/SegmentShape.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

/// The part of a volume in which a contour evolves.
struct ContourGround {
    static constexpr std::uint8_t inside = 1; ///< belongs to the segment
    static constexpr std::uint8_t open = 2; ///< may change
    static constexpr std::uint8_t own = 4; ///< belonged to it before there was a bubble
    /// Stays as it is when the contour is written, whatever it comes to; the rule reads it as any
    /// other (ContourTrial.h marks them, ContourTrack shows them).
    static constexpr std::uint8_t held = 16;

    glm::ivec3 volumeSize{0};
    /// With every voxel that can be reached, and contourMargin() around them.
    VoxelBox box{};
    std::vector<std::uint8_t> voxels{}; ///< of the box, x fastest: the flags above
    std::vector<std::uint16_t> codes{}; ///< of the box
};

/// How far beyond the voxels that may change the rule reads.
[[nodiscard]] glm::ivec3 contourMargin(const ContourKernel& kernel);
/// The box of a ground: around a start, as far as a number of generations can lead from it.
[[nodiscard]] VoxelBox contourBox(const VoxelBox& start, int generations,
    const ContourKernel& kernel, const glm::ivec3& volumeSize);
/// Errors: OutOfMemory. @param box not empty
[[nodiscard]] Result<void> checkContourMemory(const VoxelBox& box);

/// Places of voxels in a box, x fastest, in no order. Whoever keeps them shares them.
using ContourPlaces = std::shared_ptr<const std::vector<std::uint32_t>>;

/// A contour that evolves (ContourRule.h). What a generation changed is kept by whoever watches
/// (ContourTrack.h), here only that of the last one. Cost of a generation ∝ the front; of the first
/// one also the box. One thread at a time.
class ContourEvolution {
public:
    ContourEvolution(ContourRule rule, ContourGround ground);

    /// One generation more, unless it rests. @return false: it rests, or it was cancelled in the
    /// midst of a generation, which is then as if it had not begun
    bool step(const Progress& progress);

    [[nodiscard]] int generation() const { return m_generation; }
    /// Whether the last step() found that nothing changes any more.
    [[nodiscard]] bool rests() const { return m_rests; }
    /// Voxels that the last generation changed; 0 before the first one.
    [[nodiscard]] std::size_t lastChanges() const { return m_lastChanged->size(); }
    /// Where they lie in the box; never null.
    [[nodiscard]] const ContourPlaces& lastChanged() const { return m_lastChanged; }
    /// What the segment has gained and lost since before the bubble.
    [[nodiscard]] ShapeChange change() const;
    /// @param voxel of the box
    [[nodiscard]] bool isInside(const glm::ivec3& voxel) const;

private:
    using Place = std::uint32_t; ///< of a voxel of the box
    static constexpr std::uint8_t atFront = 8; ///< a flag: is in m_front

    [[nodiscard]] glm::ivec3 voxelAt(Place place) const;
    [[nodiscard]] bool isAtFront(Place place, bool isWide) const;
    [[nodiscard]] bool wantsOtherSide(Place place);
    [[nodiscard]] int edgeAt(Place place);
    [[nodiscard]] int codeNear(glm::ivec3 voxel) const;
    [[nodiscard]] std::size_t classOf(Place place) const;
    [[nodiscard]] bool findFront(const Progress& progress);
    /// Asks the front and changes what wants the other side. @return false: it was cancelled, and
    /// nothing has changed
    [[nodiscard]] bool ask(bool isWide, std::vector<Place>& changed, const Progress& progress);
    void comeToFront(Place place);
    void moveFront(std::span<const Place> changed);
    template <class Visit> void visitNeighbours(Place place, bool isWide, Visit&& visit) const;

    ContourRule m_rule;
    ContourGround m_ground;
    glm::ivec3 m_extent; ///< of the box
    glm::ivec3 m_period;
    std::array<std::int64_t, 3> m_strides;
    std::vector<std::int64_t> m_steps; ///< of the kernel, in the box
    std::vector<std::uint8_t> m_edges; ///< g(v); 0: not asked for yet
    std::vector<Place> m_front; ///< of a wide generation, if there are any
    bool m_frontKnown = false;
    bool m_rests = false;
    int m_generation = 0;
    ContourPlaces m_lastChanged = std::make_shared<const std::vector<Place>>();
};

} // namespace core
