// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/filling/FloodFill.h"

#include "core/base/FixedPoint.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/BrushPath.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace reference {

namespace {

struct Voxels {
    glm::ivec3 size;

    [[nodiscard]] std::size_t at(const glm::ivec3& voxel) const
    {
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    [[nodiscard]] bool holds(const glm::ivec3& voxel) const
    {
        return voxel.x >= 0 && voxel.y >= 0 && voxel.z >= 0 && voxel.x < size.x && voxel.y < size.y
            && voxel.z < size.z;
    }
};

/// An oblique slice, one voxel thick: the slab of a flat brush (core/sculpt/CapsuleSweep.h).
class ObliqueSlice {
public:
    ObliqueSlice(const core::FloodFill& edit, const core::VolumeGeometry& geometry)
        : m_disc{.radiusMm = 2.0,
            .shape = core::BrushPath::Shape::Disc,
            .normalLps = edit.normalLps,
            .pointsLps = {edit.placeLps}}
        , m_frame(core::capsuleFrame(m_disc, geometry, {}).value())
        , m_first(core::voxelsUnder(m_disc, geometry).at(0))
    {
    }
    [[nodiscard]] const glm::ivec3& first() const { return m_first; }
    [[nodiscard]] bool holds(const glm::ivec3& voxel) const
    {
        constexpr int side = 16; // of a brick, from whose first voxel heights are counted
        const glm::ivec3 local(voxel.x % side, voxel.y % side, voxel.z % side);
        const glm::ivec3 begin = voxel - local;
        const std::int64_t base = core::fixedPoint::round14(m_frame.origin[2]
            + begin.x * m_frame.perI[2] + begin.y * m_frame.perJ[2] + begin.z * m_frame.perK[2]);
        const std::array<std::int64_t, 3> rises = this->rises();
        const std::int64_t height =
            base + local.x * rises[0] + local.y * rises[1] + local.z * rises[2];
        return voxel == m_first || std::abs(height) <= m_frame.halfThickness;
    }
    /// How many steps in the plane lead from voxel to voxel; that along the axis to which it is
    /// steepest is none.
    [[nodiscard]] int stepsOf(const glm::ivec3& step) const
    {
        const std::array<std::int64_t, 3> rises = this->rises();
        std::size_t steepest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis) {
            if (std::abs(rises[axis]) > std::abs(rises[steepest]))
                steepest = axis;
        }
        int steps = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            steps += axis == steepest ? 0 : std::abs(step[int(axis)]);
        return steps;
    }

private:
    [[nodiscard]] std::array<std::int64_t, 3> rises() const
    {
        return {core::fixedPoint::round14(m_frame.perI[2]),
            core::fixedPoint::round14(m_frame.perJ[2]), core::fixedPoint::round14(m_frame.perK[2])};
    }

    core::BrushPath m_disc;
    core::CapsuleFrame m_frame;
    glm::ivec3 m_first;
};

/// Whether a neighbour that counts was found before.
bool touchesFound(const core::FloodFill& edit, const std::optional<ObliqueSlice>& slice,
    const Voxels& grid, const glm::ivec3& voxel, const std::vector<bool>& found)
{
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec3 step(x, y, z);
                const int sides = std::abs(x) + std::abs(y) + std::abs(z);
                const bool byFace = slice ? slice->stepsOf(step) <= 1 : sides == 1;
                const glm::ivec3 next = voxel + step;
                if ((byFace || edit.corners) && grid.holds(next) && found[grid.at(next)])
                    return true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<bool> floodedVoxels(const core::FloodFill& edit, const core::LoadedVolume& study,
    std::span<const std::uint8_t> labels)
{
    const core::VolumeGeometry& geometry = study.volume.geometry;
    const Voxels grid{geometry.size};
    const glm::dvec3 index = geometry.toIndex(edit.placeLps);
    std::optional<ObliqueSlice> slice;
    if (edit.normalLps)
        slice.emplace(edit, geometry);
    const glm::ivec3 nearest{int(std::floor(index.x + 0.5)), int(std::floor(index.y + 0.5)),
        int(std::floor(index.z + 0.5))};
    const glm::ivec3 first = slice ? slice->first() : nearest;
    const auto valueAt = [&](std::size_t voxel) {
        return study.volume.encoding.value(study.codes[voxel]);
    };
    const double value = valueAt(grid.at(first));
    const auto mayBelong = [&](const glm::ivec3& voxel) {
        if (edit.within && voxel[alongOf(*edit.within)] != first[alongOf(*edit.within)])
            return false;
        if (slice && !slice->holds(voxel))
            return false;
        if (edit.erase)
            return int(labels[grid.at(voxel)]) == edit.segment;
        return std::abs(valueAt(grid.at(voxel)) - value) <= edit.tolerance;
    };
    std::vector<bool> found(study.codes.size(), false);
    found[grid.at(first)] = mayBelong(first);
    // To and fro, so that what winds about takes few sweeps.
    bool forth = true;
    for (bool more = found[grid.at(first)]; more; forth = !forth) {
        more = false;
        for (std::size_t step = 0; step < found.size(); ++step) {
            const std::size_t at = forth ? step : found.size() - 1 - step;
            const auto columns = std::size_t(grid.size.x);
            const auto rows = std::size_t(grid.size.y);
            const glm::ivec3 voxel{
                int(at % columns), int(at / columns % rows), int(at / columns / rows)};
            if (found[at] || !mayBelong(voxel) || !touchesFound(edit, slice, grid, voxel, found))
                continue;
            found[at] = true;
            more = true;
        }
    }
    return found;
}

} // namespace reference
