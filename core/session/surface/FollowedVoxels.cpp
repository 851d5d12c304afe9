// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/FollowedVoxels.h"

#include "core/refine/voxels/SurfaceFill.h"
#include "core/volume/WorldToIndex.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace core {

namespace {

enum Flag : std::uint8_t { Tool = 1, Yellow = 2, Reached = 4 };

std::vector<FaceId> facesMovedBy(const SimplexMeshDelta& change, const SimplexMesh& after)
{
    std::vector<FaceId> faces;
    for (const SimplexMeshDelta::VertexChange& vertex : change.vertices) {
        if (vertex.after)
            faces.insert(faces.end(), vertex.after->faces.begin(), vertex.after->faces.end());
    }
    for (const SimplexMeshDelta::FaceChange& face : change.faces)
        faces.push_back(face.id);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::erase_if(faces, [&after](FaceId face) { return !after.hasFace(face); });
    return faces;
}

/// Voxels, ascending, and what is known of each.
class FlaggedVoxels {
public:
    FlaggedVoxels(const VoxelRuns& voxels, const glm::ivec3& size)
        : m_size(size)
    {
        m_places.reserve(std::size_t(voxels.voxelCount()));
        for (const VoxelRun& run : voxels.runs()) {
            for (std::uint64_t at = run.first; at < run.first + run.count; ++at)
                m_places.push_back(at);
        }
        m_flags.resize(m_places.size(), 0);
    }

    /// @param least, most both included; may reach beyond the volume
    template <typename Visit>
    void forEachIn(const glm::ivec3& least, const glm::ivec3& most, const Visit& visit)
    {
        const glm::ivec3 first = glm::max(least, glm::ivec3(0));
        const glm::ivec3 last = glm::min(most, m_size - 1);
        if (last.x < first.x)
            return;
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                const std::uint64_t end = placeOf({last.x, y, z});
                auto at =
                    std::lower_bound(m_places.begin(), m_places.end(), placeOf({first.x, y, z}));
                for (; at != m_places.end() && *at <= end; ++at)
                    visit(std::size_t(at - m_places.begin()));
            }
        }
    }
    void flag(const glm::ivec3& least, const glm::ivec3& most, Flag flag)
    {
        forEachIn(least, most, [this, flag](std::size_t i) { m_flags[i] |= flag; });
    }

    /// Reached is what the tool moved, and what hangs together with it.
    void reach()
    {
        std::vector<std::size_t> reached;
        const auto take = [&](std::size_t i) {
            if ((m_flags[i] & Reached) != 0 || (m_flags[i] & (Tool | Yellow)) == Yellow)
                return;
            m_flags[i] |= Reached;
            reached.push_back(i);
        };
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            if ((m_flags[i] & Tool) != 0)
                take(i);
        }
        while (!reached.empty()) {
            const glm::ivec3 voxel = voxelAt(m_places[reached.back()]);
            reached.pop_back();
            forEachIn(voxel - 1, voxel + 1, take);
        }
    }
    [[nodiscard]] VoxelRuns notReached() const
    {
        VoxelRuns voxels;
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            if ((m_flags[i] & Reached) == 0)
                voxels.append(m_places[i], 1);
        }
        return voxels;
    }

private:
    [[nodiscard]] std::uint64_t placeOf(const glm::ivec3& voxel) const
    {
        return (std::uint64_t(voxel.z) * std::uint64_t(m_size.y) + std::uint64_t(voxel.y))
            * std::uint64_t(m_size.x)
            + std::uint64_t(voxel.x);
    }
    [[nodiscard]] glm::ivec3 voxelAt(std::uint64_t place) const
    {
        const auto width = std::uint64_t(m_size.x);
        const auto height = std::uint64_t(m_size.y);
        return {int(place % width), int(place / width % height), int(place / width / height)};
    }

    glm::ivec3 m_size;
    std::vector<std::uint64_t> m_places;
    std::vector<std::uint8_t> m_flags;
};

} // namespace

bool movesYellow(const SimplexMeshDelta& change)
{
    return std::any_of(change.vertices.begin(), change.vertices.end(),
        [](const SimplexMeshDelta::VertexChange& vertex) {
            return vertex.after && vertex.after->mark == SurfaceMark::Yellow
                && (!vertex.before || vertex.before->positionLps != vertex.after->positionLps);
        });
}

VoxelRuns followedVoxels(const VoxelRuns& moved, const SimplexMesh& after,
    const SimplexMeshDelta& change, const VolumeGeometry& geometry)
{
    const WorldToIndex toIndex(geometry);
    FlaggedVoxels voxels(moved, geometry.size);
    for (const FaceId face : facesMovedBy(change, after)) {
        glm::ivec3 least(std::numeric_limits<int>::max());
        glm::ivec3 most(std::numeric_limits<int>::min());
        bool isYellow = true;
        for (const VertexId id : after.ring(face)) {
            const glm::ivec3 place = latticePoint(toIndex(after.position(id)));
            least = glm::min(least, place);
            most = glm::max(most, place);
            isYellow = isYellow && after.mark(id) == SurfaceMark::Yellow;
        }
        // Down and up to whole voxels: a shift rounds down, below 0 as well.
        voxels.flag(least >> LatticeSurface::bits,
            (most + ((1 << LatticeSurface::bits) - 1)) >> LatticeSurface::bits,
            isYellow ? Yellow : Tool);
    }
    voxels.reach();
    return voxels.notReached();
}

} // namespace core
