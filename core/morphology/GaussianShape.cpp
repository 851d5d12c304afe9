// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianShape.h"

#include "core/brick/LabelBox.h"
#include "core/morphology/BoxRows.h"
#include "core/morphology/GaussianFilter.h"
#include "core/morphology/GridGaussian.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

/// A box with a margin, as far as it lies in the volume.
VoxelBox widened(const VoxelBox& box, const glm::ivec3& margin, const glm::ivec3& size)
{
    return {.minimum = glm::max(box.minimum - margin, glm::ivec3(0)),
        .maximum = glm::min(box.maximum + margin, size)};
}

struct Competitor {
    std::uint8_t label = 0; ///< 0: no segment
    VoxelBox box{};
};

/// Which label has had the greatest value so far, for each voxel of a box.
class Winners {
public:
    Winners(std::span<const std::uint8_t> labels, const BoxRows& rows)
        : m_labels(labels)
        , m_rows(rows)
        , m_most(voxelsOf(rows))
        , m_winners(voxelsOf(rows))
    {
        m_rows.forEach([&](std::size_t of, std::size_t in, std::size_t width) {
            std::copy_n(&m_labels[of], width, &m_winners[in]);
        });
    }

    /// Must be called with ascending labels, so that on a tie the lowest label wins.
    /// @param rows of the values; those outside the box are ignored
    void compete(std::uint8_t label, const BoxRows& rows, const BoxValues& values)
    {
        rows.forEachWithin(m_rows, [&](std::size_t in, std::size_t here, std::size_t width) {
            for (std::size_t x = 0; x < width; ++x) {
                if (values.values[in + x] <= m_most[here + x])
                    continue;
                m_most[here + x] = values.values[in + x];
                m_winners[here + x] = label;
            }
        });
    }

    /// Voxels that were one of the segments', and become no segment's.
    [[nodiscard]] VoxelRuns freed(std::span<const std::uint8_t> segments) const
    {
        return runs(0, segments);
    }
    /// Voxels that were another's or nobody's, and become the segment's.
    [[nodiscard]] VoxelRuns gained(
        std::uint8_t segment, std::span<const std::uint8_t> segments) const
    {
        return runs(segment, segments);
    }

private:
    static std::size_t voxelsOf(const BoxRows& rows)
    {
        const glm::ivec3 size = rows.boxSize();
        return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    }
    [[nodiscard]] VoxelRuns runs(std::uint8_t winner, std::span<const std::uint8_t> segments) const
    {
        std::array<bool, 256> mayChange{true};
        for (const std::uint8_t segment : segments)
            mayChange.at(segment) = true;
        VoxelRuns runs;
        m_rows.forEach([&](std::size_t of, std::size_t in, std::size_t width) {
            for (std::size_t x = 0; x < width; ++x) {
                const std::uint8_t held = m_labels[of + x];
                if (m_winners[in + x] == winner && held != winner && mayChange[held])
                    runs.append(of + x, 1);
            }
        });
        return runs;
    }

    std::span<const std::uint8_t> m_labels;
    const BoxRows& m_rows;
    std::vector<std::uint16_t> m_most;
    /// Initially the present label, which stays if all values are 0.
    std::vector<std::uint8_t> m_winners;
};

} // namespace

Result<ShapeChange> gaussianChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const GridGaussian& gaussian, const Progress& progress)
{
    const VoxelBox own = boxOfLabel(labels, size, label);
    if (own.empty())
        return ShapeChange();
    const BoxRows rows(own, size, progress);
    if (const Result<void> enough =
            checkBytes(gaussianBytes(rows.boxSize()), Clause::saying("the segment"));
        !enough)
        return tl::unexpected(enough.error());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    const Result<BoxValues> blurry =
        blurred(rows.mask(labels, label), gaussian, rows.ends(), {.progress = progress});
    if (!blurry)
        return tl::unexpected(blurry.error());
    const std::vector<std::uint16_t>& values = blurry->values;
    ShapeChange change{.given = rows.voxels(labels, 0,
                           [&](std::size_t voxel) { return values[voxel] > BoxValues::half; }),
        .taken = rows.voxels(
            labels, label, [&](std::size_t voxel) { return values[voxel] < BoxValues::half; })};
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return change;
}

Result<JointChange> jointGaussianChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::span<const std::uint8_t> segments, const GridGaussian& gaussian,
    const Progress& progress, int number, int of)
{
    JointChange change{.given = std::vector<VoxelRuns>(segments.size()), .freed = {}};
    VoxelBox all;
    std::vector<Competitor> competitors(1); // no segment, around all of them
    for (const std::uint8_t label : segments) {
        const VoxelBox own = boxOfLabel(labels, size, label);
        all = all.united(own);
        if (!own.empty())
            competitors.push_back({.label = label, .box = widened(own, gaussian.reach(), size)});
    }
    if (all.empty())
        return change;
    // Farther away no segment has a value; free space must be known as far again, to be blurred in
    // that box.
    const BoxRows rows(widened(all, gaussian.reach(), size), size, progress);
    competitors.front().box = widened(all, 2 * gaussian.reach(), size);
    const BoxRows widest(competitors.front().box, size, progress);
    if (const Result<void> enough =
            checkBytes(2.0 * gaussianBytes(widest.boxSize()), Clause::saying("the segments"));
        !enough)
        return tl::unexpected(enough.error());
    Winners winners(labels, rows);
    const auto stages = int(competitors.size());
    int stage = number * stages;
    for (const Competitor& each : competitors) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const BoxRows its(each.box, size, progress);
        const Result<BoxValues> values = blurred(its.mask(labels, each.label), gaussian, its.ends(),
            {.progress = progress, .number = stage++, .of = of * stages});
        if (!values)
            return tl::unexpected(values.error());
        winners.compete(each.label, its, *values);
    }
    change.freed = winners.freed(segments);
    for (std::size_t segment = 0; segment < segments.size(); ++segment)
        change.given[segment] = winners.gained(segments[segment], segments);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return change;
}

} // namespace core
