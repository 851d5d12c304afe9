// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/RefineSurface.h"

#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/repair/FaceThinning.h"
#include "core/surface/SegmentSurface.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>

namespace core {

namespace {

/// A byte each, while the borders are laid.
constexpr std::uint64_t mostCells = std::uint64_t(1) << 29;
/// More cells to the shortest side of a voxel show nothing of it that fewer do not.
constexpr int mostCuts = 3;
/// As long again as wide: cells that are not are cut before there are too few of them.
constexpr double mostUneven = 1.5;

/// Into how many cells a voxel is cut along each axis.
class CellCuts {
public:
    CellCuts(const BoxMask& mask, const VolumeGeometry& geometry)
        : m_faces(mask.borderFaces())
        , m_spacing(geometry.spacingMm())
        , m_voxels(std::uint64_t(mask.size().x) * std::uint64_t(mask.size().y)
              * std::uint64_t(mask.size().z))
    {
    }

    [[nodiscard]] glm::ivec3 cutsFor(std::uint64_t triangles) const
    {
        glm::ivec3 cuts(1);
        for (;;) {
            int widest = 0;
            double narrow = m_spacing[0] / cuts[0];
            for (int axis = 1; axis < 3; ++axis) {
                const double width = m_spacing[axis] / cuts[axis];
                if (width > m_spacing[widest] / cuts[widest])
                    widest = axis;
                narrow = std::min(narrow, width);
            }
            glm::ivec3 finer = cuts;
            ++finer[widest];
            const bool isUneven = m_spacing[widest] / cuts[widest] > mostUneven * narrow;
            const double finest = std::min({m_spacing.x, m_spacing.y, m_spacing.z}) / mostCuts;
            const bool isWanted = (trianglesOf(cuts) < triangles
                                      && m_spacing[widest] / finer[widest] > 0.999 * finest)
                || (isUneven && trianglesOf(finer) <= 4 * triangles);
            const std::uint64_t cells =
                m_voxels * std::uint64_t(finer.x) * std::uint64_t(finer.y) * std::uint64_t(finer.z);
            if (!isWanted || cells > mostCells)
                return cuts;
            cuts = finer;
        }
    }

private:
    [[nodiscard]] std::uint64_t trianglesOf(const glm::ivec3& cuts) const
    {
        std::uint64_t quads = 0;
        for (int axis = 0; axis < 3; ++axis)
            quads += m_faces[axis] * std::uint64_t(cuts[(axis + 1) % 3])
                * std::uint64_t(cuts[(axis + 2) % 3]);
        return 2 * quads;
    }

    glm::u64vec3 m_faces;
    glm::dvec3 m_spacing;
    std::uint64_t m_voxels;
};

std::vector<std::uint8_t> cellsOf(const BoxMask& mask, const glm::ivec3& cuts)
{
    const glm::ivec3 size = mask.size() * cuts;
    std::vector<std::uint8_t> cells(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++at)
                cells[at] = mask.contains(mask.first() + glm::ivec3(x, y, z) / cuts) ? 1 : 0;
        }
    }
    return cells;
}

/// The dual of borders between cells, into which the voxels of a mask were cut.
Result<SimplexMesh> dualOfBorders(SegmentSurface&& borders, const BoxMask& mask,
    const glm::ivec3& cuts, const VolumeGeometry& geometry)
{
    std::vector<glm::dvec3> pointsLps;
    pointsLps.reserve(borders.vertices.size());
    for (const glm::vec3& vertex : borders.vertices) {
        const glm::dvec3 index =
            (glm::dvec3(vertex) + 0.5) / glm::dvec3(cuts) - 0.5 + glm::dvec3(mask.first());
        pointsLps.push_back(worldBetweenSlices(geometry, index));
    }
    if (glm::determinant(glm::dmat3(geometry.indexToWorld)) < 0.0) {
        for (glm::uvec3& triangle : borders.triangles)
            std::swap(triangle.y, triangle.z);
    }
    return dualOf(pointsLps, borders.triangles);
}

} // namespace

Result<SimplexMesh> refineSurfaceOf(
    const BoxMask& mask, const VolumeGeometry& geometry, int vertices, const Progress& progress)
{
    if (mask.empty())
        return SimplexMesh();
    const glm::ivec3 cuts = CellCuts(mask, geometry).cutsFor(std::uint64_t(vertices));
    SegmentSurface borders = segmentSurface(cellsOf(mask, cuts), 1, mask.size() * cuts);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    Result<SimplexMesh> mesh = dualOfBorders(std::move(borders), mask, cuts, geometry);
    if (!mesh)
        return mesh;
    return thinnedOut(*std::move(mesh), std::size_t(vertices), progress);
}

Result<SimplexMesh> borderSurfaceOf(
    const BoxMask& mask, const VolumeGeometry& geometry, int vertices, const Progress& progress)
{
    if (mask.empty())
        return SimplexMesh();
    const glm::ivec3 whole(1);
    SegmentSurface borders = segmentBorders(cellsOf(mask, whole), 1, mask.size());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    Result<SimplexMesh> mesh = dualOfBorders(std::move(borders), mask, whole, geometry);
    if (!mesh)
        return mesh;
    return thinnedOut(*std::move(mesh), std::size_t(vertices), progress, &geometry);
}

} // namespace core
