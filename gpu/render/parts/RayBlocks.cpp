// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/RayBlocks.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/scene/ViewFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpu {

namespace {

/// How far from a ray's samples the caster looks: at a surface for what shadows it (surface.glsl,
/// openness), elsewhere a few voxels for gradients and for the face of a cut.
double marginMm(const VolumeScene& scene, const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const double voxels = 5.0 * std::max({spacing.x, spacing.y, spacing.z});
    return scene.mode == RenderMode::Surface ? std::max(voxels, 17.0) : voxels;
}

/// Blocks that a ball is seen through. Sums of differences: a ball costs four additions, however
/// large it is.
class Marks {
public:
    Marks(const glm::ivec2& blocks)
        : m_blocks(blocks)
        , m_differences(std::size_t(blocks.x + 1) * std::size_t(blocks.y + 1))
    {
    }
    /// @param low, high drawn pixels
    void add(const glm::dvec2& low, const glm::dvec2& high)
    {
        const glm::dvec2 end(m_blocks);
        const glm::dvec2 first = glm::floor(low / double(RayBlocks::block));
        const glm::dvec2 last = glm::floor(high / double(RayBlocks::block)) + 1.0;
        if (!(first.x < end.x && first.y < end.y && last.x > 0.0 && last.y > 0.0))
            return;
        const glm::ivec2 from(glm::max(first, 0.0));
        const glm::ivec2 to(glm::min(last, end));
        ++at(from.x, from.y);
        --at(to.x, from.y);
        --at(from.x, to.y);
        ++at(to.x, to.y);
    }
    void addAll() { add({0.0, 0.0}, glm::dvec2(m_blocks) * double(RayBlocks::block) - 0.5); }
    template <class Mark> void forEachMarked(Mark mark)
    {
        for (int y = 0; y < m_blocks.y; ++y) {
            int row = 0;
            for (int x = 0; x < m_blocks.x; ++x) {
                row += at(x, y);
                const int above = y > 0 ? m_above[std::size_t(x)] : 0;
                if (m_above.size() <= std::size_t(x))
                    m_above.push_back(0);
                m_above[std::size_t(x)] = above + row;
                if (above + row > 0)
                    mark(glm::ivec2(x, y));
            }
        }
    }

private:
    [[nodiscard]] int& at(int x, int y)
    {
        return m_differences[std::size_t(y) * std::size_t(m_blocks.x + 1) + std::size_t(x)];
    }
    glm::ivec2 m_blocks;
    std::vector<int> m_differences;
    std::vector<int> m_above;
};

/// World → drawn pixels of a view.
class Projection {
public:
    Projection(const VolumeScene& scene, const PassTarget& target)
        : m_view(ViewFrame::of(scene, target.frameSize))
        , m_ahead((m_view.ahead - m_view.middle) * m_view.mmPerPixel)
        , m_drawnOut(glm::length(m_view.across))
        , m_perFramePixel(1.0 / target.pixelScale)
    {
    }
    /// Marks what a ball may be seen through.
    void addBall(Marks& marks, const glm::dvec3& centre, double radius) const
    {
        const glm::dvec3 from = centre - m_view.targetLps;
        glm::dvec2 place = m_view.placeOf(from);
        double reachMm = radius * m_drawnOut;
        if (!m_view.orthographic) {
            const double depth = m_view.depthOf(from) * m_view.distanceMm;
            if (depth < -radius)
                return;
            // Beside the eye a ball may be seen anywhere.
            if (depth < 1.5 * radius)
                return marks.addAll();
            const double scale = m_view.distanceMm / depth;
            place *= scale;
            // Towards the border of a perspective picture a ball is drawn out.
            const glm::dvec2 aside = place - m_ahead;
            const double slant =
                1.0 + glm::dot(aside, aside) / (m_view.distanceMm * m_view.distanceMm);
            reachMm *= scale * slant * depth / (depth - radius);
        }
        const glm::dvec2 pixel = m_view.middle + place / m_view.mmPerPixel;
        const double pixels = reachMm / m_view.mmPerPixel + 1.0;
        marks.add(
            (pixel - pixels) * m_perFramePixel - 1.0, (pixel + pixels) * m_perFramePixel + 1.0);
    }

private:
    ViewFrame m_view;
    glm::dvec2 m_ahead; // of the eye, mm in the target's plane
    double m_drawnOut; // sheared to the right
    double m_perFramePixel;
};

double halfDiagonalMm(const core::VolumeGeometry& geometry, const glm::dvec3& voxels)
{
    double longest = 0.0;
    for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            longest = std::max(longest,
                glm::length(glm::dmat3(geometry.indexToWorld) * (voxels * glm::dvec3(1.0, y, z))));
    return 0.5 * longest;
}

} // namespace

RayBlocks::RayBlocks(VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target)
{
    const glm::dvec2 drawn = glm::dvec2(target.frameSize) / double(target.pixelScale);
    m_blocks = glm::ivec2(glm::ceil(drawn / double(block)));
    m_kinds.assign(std::size_t(m_blocks.x) * std::size_t(m_blocks.y), Kind::Plain);
    // In the order of what they can draw.
    markCells(volume, volume.cells().carvedCells(), Kind::Carved, scene, target);
    markCells(volume, volume.cells().segmentCells(), Kind::Sculpted, scene, target);
    markPieces(volume, scene, target);
}

void RayBlocks::markCells(VolumeTextures& volume, const std::vector<glm::ivec3>& cells, Kind kind,
    const VolumeScene& scene, const PassTarget& target)
{
    const core::VolumeGeometry& geometry = volume.geometry();
    const Projection projection(scene, target);
    const double radius =
        halfDiagonalMm(geometry, glm::dvec3(MacroCells::side + 1)) + marginMm(scene, geometry);
    Marks marks(m_blocks);
    for (const glm::ivec3& cell : cells) {
        const glm::dvec3 middle = glm::dvec3(cell * MacroCells::side) + 0.5 * MacroCells::side;
        projection.addBall(
            marks, glm::dvec3(geometry.indexToWorld * glm::dvec4(middle, 1.0)), radius);
    }
    marks.forEachMarked([&](const glm::ivec2& place) {
        m_kinds[std::size_t(place.y * m_blocks.x + place.x)] = kind;
    });
}

void RayBlocks::markPieces(
    VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target)
{
    const core::VolumeGeometry& geometry = volume.geometry();
    const Projection projection(scene, target);
    const double radius =
        halfDiagonalMm(geometry, glm::dvec3(MacroCells::side + 1)) + marginMm(scene, geometry);
    Marks marks(m_blocks);
    for (const ScenePiece& piece : scene.pieces) {
        const PieceTextures::Entry* entry = volume.pieces().entry({piece.layer, piece.segment});
        if (!entry || entry->filled.empty() || !piece.showsIn(scene.mode))
            continue;
        const double zoom = std::cbrt(std::abs(glm::determinant(glm::dmat3(piece.shownFromTrue))));
        const glm::dmat4 shownFromIndex = piece.shownFromTrue * geometry.indexToWorld;
        for (const glm::ivec3& cell : entry->cells) {
            const glm::dvec3 middle = glm::dvec3(cell * MacroCells::side) + 0.5 * MacroCells::side;
            projection.addBall(marks, glm::dvec3(shownFromIndex * glm::dvec4(middle, 1.0)),
                radius * std::max(zoom, 1.0));
        }
    }
    marks.forEachMarked([this](const glm::ivec2& place) {
        m_kinds[std::size_t(place.y * m_blocks.x + place.x)] = Kind::Pieces;
    });
}

RayBlocks::Kind RayBlocks::at(const glm::ivec2& place) const
{
    return m_kinds[std::size_t(place.y * m_blocks.x + place.x)];
}

std::array<std::vector<Tile>, RayBlocks::kinds> RayBlocks::split(const Tile& tile) const
{
    std::array<std::vector<Tile>, kinds> parts;
    const glm::ivec2 first = tile.minimum / block;
    const glm::ivec2 last = (tile.minimum + tile.size - 1) / block;
    const glm::ivec2 end = tile.minimum + tile.size;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x;) {
            const Kind kind = at({x, y});
            int next = x + 1;
            while (next <= last.x && at({next, y}) == kind)
                ++next;
            const glm::ivec2 low(x * block, y * block);
            const glm::ivec2 high = glm::min(glm::ivec2(next * block, (y + 1) * block), end);
            std::vector<Tile>& rows = parts[std::size_t(kind)];
            // Below one that is as wide: one rectangle.
            if (!rows.empty() && rows.back().minimum.x == low.x
                && rows.back().size.x == high.x - low.x
                && rows.back().minimum.y + rows.back().size.y == low.y)
                rows.back().size.y += high.y - low.y;
            else
                rows.push_back({low, high - low});
            x = next;
        }
    }
    return parts;
}

Tile blocksAround(const glm::vec3& low, const glm::vec3& high, const glm::dmat4& indexToWorld,
    const VolumeScene& scene, const PassTarget& target)
{
    const ViewFrame view = ViewFrame::of(scene, target.frameSize);
    glm::dvec2 least(1e9);
    glm::dvec2 greatest(-1e9);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const glm::dvec3 index(glm::mix(low, high, upper));
        const glm::dvec3 lps(indexToWorld * glm::dvec4(index, 1.0));
        const glm::dvec3 from = lps - view.targetLps;
        const double depth = view.depthOf(from);
        if (depth < 1e-3)
            return {glm::ivec2(0), target.frameSize}; // about the eye
        const glm::dvec2 pixel = view.middle + view.placeOf(from) / (view.mmPerPixel * depth);
        least = glm::min(least, pixel);
        greatest = glm::max(greatest, pixel);
    }
    constexpr double most = 1 << 20;
    const double block = RayBlocks::block;
    const auto inBlocks = [&](const glm::dvec2& pixel) {
        return glm::clamp(pixel / double(target.pixelScale), -most, most) / block;
    };
    const glm::ivec2 first(glm::floor(inBlocks(least - 2.0)) * block);
    const glm::ivec2 last(glm::ceil(inBlocks(greatest + 2.0)) * block);
    return {first, last - first};
}

Tile blocksAround(const core::VoxelBox& voxels, const core::VolumeGeometry& geometry,
    const VolumeScene& scene, const PassTarget& target)
{
    return blocksAround(glm::vec3(voxels.minimum) - 1.0f, glm::vec3(voxels.maximum),
        geometry.indexToWorld, scene, target);
}

} // namespace gpu
