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
    static constexpr std::uint8_t open = 2; ///< the rule may change it
    /// Belonged to it before the evolution and before a bubble was added.
    static constexpr std::uint8_t own = 4;
    /// Keeps its label when the contour is written, whatever the contour does here, because the
    /// editable range excludes it. The rule treats it as any other voxel. ContourTrial.h sets this
    /// flag, and ContourState counts and shows accordingly.
    static constexpr std::uint8_t held = 16;
    /// Counts for neither side, as if the volume ended before it; it is neither inside nor open.
    static constexpr std::uint8_t absent = 32;

    glm::ivec3 volumeSize{0};
    /// Contains every voxel that the contour can reach, and contourMargin() around these, cut to
    /// the volume.
    VoxelBox box{};
    std::vector<std::uint8_t> voxels{}; ///< the flags above, for each voxel of the box, x fastest
    std::vector<std::uint16_t> codes{}; ///< of the box
};

/// How many voxels beyond those that may change the rule reads, along each axis.
[[nodiscard]] glm::ivec3 contourMargin(const ContourKernel& kernel);
/// The box of a ground: the box of the start, extended by as many voxels as the contour can move in
/// a number of generations, and by contourMargin(); cut to the volume.
[[nodiscard]] VoxelBox contourBox(const VoxelBox& start, int generations,
    const ContourKernel& kernel, const glm::ivec3& volumeSize);
/// Whether a contour can evolve in a box of this size.
/// @param box not empty
/// Errors: OutOfMemory.
[[nodiscard]] Result<void> checkContourMemory(const VoxelBox& box);

/// Indices of voxels in a box, x fastest, in no particular order. They are shared, since several
/// users keep them.
using ContourPlaces = std::shared_ptr<const std::vector<std::uint32_t>>;

/// Evolves a contour by the rule of ContourRule.h. It keeps only the changes of the last
/// generation; code that needs earlier ones collects them (ContourTrack.h). Cost: a generation
/// costs ∝ the front, the first one also ∝ the box. One thread at a time.
class ContourEvolution {
public:
    ContourEvolution(ContourRule rule, ContourGround ground);

    /// Computes one more generation.
    /// @return false: nothing changes any more, or it was cancelled. A generation that is cancelled
    /// while it is computed is undone completely.
    bool step(const Progress& progress);

    [[nodiscard]] int generation() const { return m_generation; }
    /// Whether the last step() found nothing left to change.
    [[nodiscard]] bool rests() const { return m_rests; }
    /// The number of voxels that the last generation changed; 0 before the first one.
    [[nodiscard]] std::size_t lastChanges() const { return m_lastChanged->size(); }
    /// These voxels; never null.
    [[nodiscard]] const ContourPlaces& lastChanged() const { return m_lastChanged; }
    /// The voxels that the segment has gained and lost in all, a bubble included.
    [[nodiscard]] ShapeChange change() const;
    /// @param voxel of the box
    [[nodiscard]] bool isInside(const glm::ivec3& voxel) const;

private:
    using Place = std::uint32_t; ///< index of a voxel in the box
    static constexpr std::uint8_t atFront = 8; ///< flag: the voxel is in m_front

    [[nodiscard]] glm::ivec3 voxelAt(Place place) const;
    [[nodiscard]] bool isAtFront(Place place, bool isWide) const;
    [[nodiscard]] bool wantsOtherSide(Place place);
    [[nodiscard]] int edgeAt(Place place);
    [[nodiscard]] int codeNear(glm::ivec3 voxel) const;
    [[nodiscard]] std::size_t classOf(Place place) const;
    [[nodiscard]] bool findFront(const Progress& progress);
    /// Carries out rules 4 to 6 for the front.
    /// @return false: it was cancelled, and nothing has changed
    [[nodiscard]] bool ask(bool isWide, std::vector<Place>& changed, const Progress& progress);
    void comeToFront(Place place);
    void moveFront(std::span<const Place> changed);
    template <class Visit> void visitNeighbours(Place place, bool isWide, Visit&& visit) const;

    ContourRule m_rule;
    ContourGround m_ground;
    glm::ivec3 m_extent; ///< of the box
    glm::ivec3 m_period;
    std::array<std::int64_t, 3> m_strides;
    /// Steps of the kernel, as differences of indices in the box.
    std::vector<std::int64_t> m_steps;
    std::vector<std::uint8_t> m_edges; ///< g(v) of each voxel of the box; 0: not computed yet
    /// The front of a wide generation if the rule is `round`, otherwise that of a narrow one.
    std::vector<Place> m_front;
    bool m_frontKnown = false;
    bool m_rests = false;
    int m_generation = 0;
    ContourPlaces m_lastChanged = std::make_shared<const std::vector<Place>>();
};

} // namespace core
