// SPDX-License-Identifier: Apache-2.0
#include "core/doubts/FaintBorder.h"

#include "core/base/ParallelFor.h"
#include "core/brick/LabelBox.h"
#include "core/doubts/PartMiddle.h"
#include "core/islands/VoxelIslands.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace core {

namespace {

constexpr int rimVoxels = 2;
constexpr int asideQuarters = 9; // quarters of a squared voxel: the square of 1½ voxels
constexpr std::int64_t finely = 16; // means are computed in 16ths of a code
constexpr std::int64_t faintPart = 4; // of the median
constexpr std::int64_t leastVoxels = 9;
constexpr std::int64_t leastPartOfBorder = 1000;

struct BorderVoxel {
    std::uint64_t number = 0; ///< in the volume
    std::int64_t areaUm2 = 0;
    std::int64_t contrast = 0; ///< in 16ths of a code
};

std::int64_t wholeRoot(std::int64_t square)
{
    auto root = std::int64_t(std::sqrt(double(square)));
    while (root * root > square)
        --root;
    while ((root + 1) * (root + 1) <= square)
        ++root;
    return root;
}

/// Finds the border's voxels slice by slice.
class BorderWalk {
public:
    explicit BorderWalk(const BorderSource& source)
        : m_source(source)
        , m_size(source.geometry.size)
        , m_boxSize(source.box.maximum - source.box.minimum)
    {
        const glm::i64vec3 side = spacingUm(source.geometry);
        const std::int64_t finest = std::min({side.x, side.y, side.z});
        for (int axis = 0; axis < 3; ++axis)
            m_reach[axis] = int(std::clamp<std::int64_t>(2 * finest / side[axis], 1, rimVoxels));
        m_faces = {side.y * side.z, side.x * side.z, side.x * side.y};
    }

    [[nodiscard]] std::vector<BorderVoxel> slice(int z) const
    {
        std::vector<BorderVoxel> found;
        const VoxelBox& box = m_source.box;
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const glm::ivec3 at(x, y, z);
                if (!isOwn(at))
                    continue;
                if (const std::int64_t area = areaAt(at); area > 0)
                    found.push_back(
                        {.number = numberOf(at), .areaUm2 = area, .contrast = contrastAt(at)});
            }
        }
        return found;
    }

private:
    [[nodiscard]] std::uint64_t numberOf(const glm::ivec3& at) const
    {
        return (std::uint64_t(at.z) * std::uint64_t(m_size.y) + std::uint64_t(at.y))
            * std::uint64_t(m_size.x)
            + std::uint64_t(at.x);
    }
    [[nodiscard]] bool isOwn(const glm::ivec3& at) const
    {
        return m_source.labels[numberOf(at)] == m_source.label;
    }
    [[nodiscard]] std::int64_t codeAt(const glm::ivec3& at) const
    {
        const glm::ivec3 in = at - m_source.box.minimum;
        return m_source.codes[(std::size_t(in.z) * std::size_t(m_boxSize.y) + std::size_t(in.y))
                * std::size_t(m_boxSize.x)
            + std::size_t(in.x)];
    }

    /// A slanting border consists of steps whose faces have a larger area than the border itself.
    /// Therefore areas across the three axes are added like the sides of a right angle, not as
    /// numbers.
    [[nodiscard]] std::int64_t areaAt(const glm::ivec3& at) const
    {
        glm::i64vec3 area(0);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                glm::ivec3 beside = at;
                beside[axis] += way;
                if (beside[axis] >= 0 && beside[axis] < m_size[axis] && !isOwn(beside))
                    area[axis] += m_faces[axis];
            }
        }
        return wholeRoot(area.x * area.x + area.y * area.y + area.z * area.z);
    }

    /// The sum of the directions in which the faces of a border voxel point; 0 if they cancel out.
    [[nodiscard]] glm::ivec3 outward(const glm::ivec3& at) const
    {
        glm::ivec3 out(0);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                glm::ivec3 beside = at;
                beside[axis] += way;
                if (beside[axis] >= 0 && beside[axis] < m_size[axis] && !isOwn(beside))
                    out[axis] += way;
            }
        }
        return out;
    }

    /// Visits the voxels near the line through a voxel in a direction, or all around it if the
    /// direction is 0.
    template <class Visit>
    void forEachNear(const glm::ivec3& at, const glm::ivec3& way, const Visit& visit) const
    {
        const int length = way.x * way.x + way.y * way.y + way.z * way.z;
        const glm::ivec3 low = glm::max(at - m_reach, m_source.box.minimum);
        const glm::ivec3 high = glm::min(at + m_reach, m_source.box.maximum - 1);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) {
                    const glm::ivec3 near(x, y, z);
                    const glm::ivec3 off = near - at;
                    const int along = off.x * way.x + off.y * way.y + off.z * way.z;
                    const int apart = off.x * off.x + off.y * off.y + off.z * off.z;
                    // Both sides are multiplied by the square of the direction's length.
                    if (asideQuarters * length >= 4 * (apart * length - along * along))
                        visit(isOwn(near) ? 1U : 0U, codeAt(near));
                }
            }
        }
    }

    [[nodiscard]] std::int64_t contrastAt(const glm::ivec3& at) const
    {
        const glm::ivec3 way = outward(at);
        // Index 0: outside, 1: inside. Neither is empty: the voxel itself is inside, and the one
        // beyond one of its faces outside.
        std::int64_t counts[2] = {0, 0};
        std::int64_t sums[2] = {0, 0};
        forEachNear(at, way, [&](unsigned side, std::int64_t code) {
            ++counts[side];
            sums[side] += code;
        });
        const std::int64_t inner = finely * sums[1] / counts[1];
        const std::int64_t ofMeans = std::abs(inner - finely * sums[0] / counts[0]);
        std::int64_t away[2] = {0, 0};
        forEachNear(at, way, [&](unsigned side, std::int64_t code) {
            away[side] += std::abs(finely * code - inner);
        });
        return std::max(ofMeans, away[0] / counts[0] - away[1] / counts[1]);
    }

    const BorderSource& m_source;
    glm::ivec3 m_size;
    glm::ivec3 m_boxSize;
    glm::ivec3 m_reach{rimVoxels};
    glm::i64vec3 m_faces{0}; ///< their areas, across each axis
};

Result<std::vector<BorderVoxel>> borderOf(const BorderSource& source, const Progress& progress)
{
    const BorderWalk walk(source);
    const int first = source.box.minimum.z;
    const int slices = source.box.maximum.z - first;
    std::vector<std::vector<BorderVoxel>> bySlice{std::size_t(slices)};
    parallelFor(slices, [&](int slice) {
        if (!progress.cancelled())
            bySlice[std::size_t(slice)] = walk.slice(first + slice);
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    std::vector<BorderVoxel> border;
    for (const std::vector<BorderVoxel>& each : bySlice)
        border.insert(border.end(), each.begin(), each.end());
    return border;
}

/// The contrast below which there is no edge.
std::int64_t faintLimit(const std::vector<BorderVoxel>& border)
{
    std::vector<std::int64_t> contrasts;
    contrasts.reserve(border.size());
    for (const BorderVoxel& each : border)
        contrasts.push_back(each.contrast);
    const auto median = contrasts.begin() + std::ptrdiff_t(contrasts.size() / 2);
    std::nth_element(contrasts.begin(), median, contrasts.end());
    return *median / faintPart;
}

} // namespace

VoxelBox boxAroundBorder(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label)
{
    VoxelBox box = boxOfLabel(labels, size, label);
    if (box.empty())
        return {};
    box.minimum = glm::max(box.minimum - rimVoxels, glm::ivec3(0));
    box.maximum = glm::min(box.maximum + rimVoxels, size);
    return box;
}

Result<FaintBorder> FaintBorder::of(const BorderSource& source, const Progress& progress)
{
    FaintBorder faint;
    if (source.box.empty())
        return faint;
    const Result<std::vector<BorderVoxel>> border = borderOf(source, progress);
    if (!border)
        return tl::unexpected(border.error());
    // A segment that fills the volume has no border.
    if (border->empty())
        return faint;
    const std::int64_t limit = faintLimit(*border);
    VoxelRuns without;
    for (const BorderVoxel& each : *border) {
        faint.wholeAreaUm2 += each.areaUm2;
        if (each.contrast < limit)
            without.append(each.number, 1);
    }
    Result<std::vector<VoxelRuns>> islands =
        islandsOf(without, source.geometry.size, leastVoxels, progress);
    if (!islands)
        return tl::unexpected(islands.error());
    for (VoxelRuns& island : *islands) {
        Part part{.voxels = std::move(island)};
        // Both are ascending.
        auto at = border->begin();
        for (const VoxelRun& run : part.voxels.runs()) {
            at = std::lower_bound(at, border->end(), run.first,
                [](const BorderVoxel& each, std::uint64_t number) { return each.number < number; });
            for (std::uint64_t i = 0; i < run.count; ++i, ++at) {
                part.areaUm2 += at->areaUm2;
                part.doubt += at->areaUm2 * (limit - at->contrast) / limit;
            }
        }
        if (part.areaUm2 >= faint.wholeAreaUm2 / leastPartOfBorder)
            faint.parts.push_back(std::move(part));
    }
    std::stable_sort(faint.parts.begin(), faint.parts.end(),
        [](const Part& one, const Part& other) { return one.doubt > other.doubt; });
    return faint;
}

} // namespace core
