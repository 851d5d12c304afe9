// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/BetweenSlices.h"

#include "core/base/ParallelFor.h"
#include "core/brick/BrickGrid.h"
#include "core/morphology/SliceParts.h"
#include "core/morphology/StageCounter.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <tuple>

namespace core {

namespace {

/// Where the voxels of a slice lie in a volume, x fastest.
class SlicePlaces {
public:
    SlicePlaces(const glm::ivec3& size, SliceAxis axis)
        : m_strides(1, std::size_t(size.x), std::size_t(size.x) * std::size_t(size.y))
        , m_axis(axis)
        , m_size(size[acrossOf(axis)], size[downOf(axis)])
    {
    }
    [[nodiscard]] const glm::ivec2& size() const { return m_size; }
    [[nodiscard]] std::size_t at(const glm::ivec2& pixel, int slice) const
    {
        return std::size_t(pixel.x) * m_strides[acrossOf(m_axis)]
            + std::size_t(pixel.y) * m_strides[downOf(m_axis)]
            + std::size_t(slice) * m_strides[alongOf(m_axis)];
    }

private:
    glm::u64vec3 m_strides;
    SliceAxis m_axis;
    glm::ivec2 m_size;
};

/// A product of 128 bits, upper half first.
std::tuple<std::uint64_t, std::uint64_t> product(std::uint64_t square, std::uint64_t weight)
{
    constexpr int half = 32;
    constexpr std::uint64_t lower = (std::uint64_t(1) << half) - 1;
    const std::uint64_t squared = weight * weight; // at most 2³²: a volume's sides are below 2¹⁶
    const std::uint64_t low = (square & lower) * squared;
    return {(square >> half) * squared + (low >> half), low & lower};
}

/// Whether the blend of two signed distances, of which the squares are given, is 0 or more.
bool isInside(std::int64_t lower, int fromLower, std::int64_t upper, int fromUpper)
{
    if ((lower > 0) == (upper > 0))
        return lower > 0;
    const auto lowerShare = product(std::uint64_t(std::abs(lower)), std::uint64_t(fromUpper));
    const auto upperShare = product(std::uint64_t(std::abs(upper)), std::uint64_t(fromLower));
    return lower > 0 ? lowerShare >= upperShare : upperShare >= lowerShare;
}

/// The part of a way that is covered after `done` of `of` slices, rounded to whole pixels, halves
/// up.
int partOfWay(int way, int done, int of)
{
    const std::int64_t twice = 2 * std::int64_t(way) * done + of;
    const std::int64_t divisor = 2 * std::int64_t(of);
    return int(twice / divisor - (twice % divisor < 0 ? 1 : 0));
}

struct DrawnShape {
    glm::ivec2 begin{0};
    glm::ivec2 end{0};
};

/// The slices between two neighbouring drawn ones.
class Gap {
public:
    Gap(std::span<const std::uint8_t> labels, const SlicePlaces& places, std::uint8_t label,
        const SliceSteps& steps, int lower, int upper)
        : m_places(places)
        , m_steps(steps)
        , m_lowerAt(lower)
        , m_upperAt(upper)
        , m_lower(partsIn(labels, label, lower))
        , m_upper(partsIn(labels, label, upper))
    {
    }
    /// @param visit called with each pixel and slice that belongs to the segment
    template <class Visit> void fill(const Progress& progress, const Visit& visit) const
    {
        for (const MatchedParts& each : matchedParts(m_lower, m_upper, m_steps)) {
            if (progress.cancelled())
                return;
            blend(each, progress, visit);
        }
    }

private:
    [[nodiscard]] SliceParts partsIn(
        std::span<const std::uint8_t> labels, std::uint8_t label, int slice) const
    {
        SliceMask mask{.size = m_places.size()};
        mask.pixels.reserve(std::size_t(mask.size.x) * std::size_t(mask.size.y));
        for (int y = 0; y < mask.size.y; ++y) {
            for (int x = 0; x < mask.size.x; ++x)
                mask.pixels.push_back(labels[m_places.at({x, y}, slice)] == label ? 1 : 0);
        }
        return sliceParts(mask, m_steps);
    }
    /// How far the parts in the upper slice lie from those in the lower one.
    [[nodiscard]] glm::ivec2 wayOf(const MatchedParts& each) const
    {
        if (each.overlap || each.lower.empty() || each.upper.empty())
            return glm::ivec2(0);
        // If parts do not overlap, there is only one in each slice.
        return m_upper.parts[std::size_t(each.upper.front())].centroid
            - m_lower.parts[std::size_t(each.lower.front())].centroid;
    }
    /// The rectangle around the chosen parts. Without parts it is an empty one that does not
    /// enlarge another by union.
    static DrawnShape boxOf(const SliceParts& slice, const std::vector<int>& chosen)
    {
        DrawnShape box{.begin = slice.size};
        for (const int each : chosen) {
            const SlicePart& part = slice.parts[std::size_t(each)];
            box.begin = glm::min(box.begin, part.begin);
            box.end = glm::max(box.end, part.end);
        }
        return box;
    }
    /// @param first the mask's first pixel in the slice
    static void draw(const SliceParts& slice, const std::vector<int>& chosen,
        const glm::ivec2& first, SliceMask& mask)
    {
        const DrawnShape box = boxOf(slice, chosen);
        for (int y = box.begin.y; y < box.end.y; ++y) {
            for (int x = box.begin.x; x < box.end.x; ++x) {
                const int part =
                    slice.partAt[std::size_t(y) * std::size_t(slice.size.x) + std::size_t(x)];
                if (part >= 0 && std::binary_search(chosen.begin(), chosen.end(), part))
                    mask.pixels[mask.indexOf(glm::ivec2(x, y) - first)] = 1;
            }
        }
    }
    template <class Visit>
    void blend(const MatchedParts& each, const Progress& progress, const Visit& visit) const
    {
        const glm::ivec2 way = wayOf(each);
        const DrawnShape lowerBox = boxOf(m_lower, each.lower);
        const DrawnShape upperBox = boxOf(m_upper, each.upper);
        // The upper parts are moved onto the lower ones; the rectangle around both gets an empty
        // border of one pixel.
        const glm::ivec2 first = glm::min(lowerBox.begin, upperBox.begin - way) - 1;
        const glm::ivec2 end = glm::max(lowerBox.end, upperBox.end - way) + 1;
        const glm::ivec2 size = end - first;
        SliceMask lower{.size = size,
            .pixels = std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y), 0)};
        SliceMask upper = lower;
        draw(m_lower, each.lower, first, lower);
        draw(m_upper, each.upper, first + way, upper);
        if (each.lower.empty())
            lower.pixels[lower.indexOf(middleOf(m_upper, each.upper) - first)] = 1;
        if (each.upper.empty())
            upper.pixels[upper.indexOf(middleOf(m_lower, each.lower) - first)] = 1;
        const std::vector<std::int64_t> fromLower = signedSquares(lower, m_steps);
        const std::vector<std::int64_t> fromUpper = signedSquares(upper, m_steps);
        for (int slice = m_lowerAt + 1; slice < m_upperAt; ++slice) {
            if (progress.cancelled())
                return;
            const int done = slice - m_lowerAt;
            const int of = m_upperAt - m_lowerAt;
            const glm::ivec2 moved =
                first + glm::ivec2(partOfWay(way.x, done, of), partOfWay(way.y, done, of));
            std::size_t at = 0;
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x, ++at) {
                    const glm::ivec2 pixel = moved + glm::ivec2(x, y);
                    if (isInside(fromLower[at], done, fromUpper[at], of - done) && pixel.x >= 0
                        && pixel.y >= 0 && pixel.x < m_places.size().x
                        && pixel.y < m_places.size().y)
                        visit(pixel, slice);
                }
            }
        }
    }
    static glm::ivec2 middleOf(const SliceParts& slice, const std::vector<int>& only)
    {
        return slice.parts[std::size_t(only.front())].middle;
    }

    const SlicePlaces& m_places;
    const SliceSteps& m_steps;
    int m_lowerAt;
    int m_upperAt;
    SliceParts m_lower;
    SliceParts m_upper;
};

} // namespace

int DrawnSlices::emptySlices() const
{
    return slices.empty() ? 0 : slices.back() - slices.front() + 1 - int(slices.size());
}

int DrawnSlices::gaps() const
{
    int count = 0;
    for (std::size_t at = 1; at < slices.size(); ++at)
        count += slices[at] > slices[at - 1] + 1 ? 1 : 0;
    return count;
}

std::array<DrawnSlices, 3> drawnSlices(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label)
{
    std::array<std::vector<bool>, 3> drawn;
    for (int axis = 0; axis < 3; ++axis)
        drawn.at(std::size_t(axis)).resize(std::size_t(size[axis]), false);
    auto next = labels.begin();
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y, next += size.x) {
            bool any = false;
            for (int x = 0; x < size.x; ++x) {
                if (next[x] != label)
                    continue;
                drawn[0][std::size_t(x)] = true;
                any = true;
            }
            drawn[1][std::size_t(y)] = drawn[1][std::size_t(y)] || any;
            drawn[2][std::size_t(z)] = drawn[2][std::size_t(z)] || any;
        }
    }
    std::array<DrawnSlices, 3> all;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        all.at(axis).axis = SliceAxis(axis);
        for (std::size_t slice = 0; slice < drawn.at(axis).size(); ++slice) {
            if (drawn.at(axis)[slice])
                all.at(axis).slices.push_back(int(slice));
        }
    }
    return all;
}

std::optional<SliceAxis> drawnAxis(const std::array<DrawnSlices, 3>& drawn)
{
    const DrawnSlices* sparsest = nullptr;
    const auto extent = [](const DrawnSlices& each) {
        return std::int64_t(each.slices.size()) + each.emptySlices();
    };
    for (const DrawnSlices& each : drawn) {
        if (each.emptySlices() == 0)
            continue;
        if (!sparsest
            || std::int64_t(each.slices.size()) * extent(*sparsest)
                <= std::int64_t(sparsest->slices.size()) * extent(each))
            sparsest = &each;
    }
    return sparsest ? std::optional(sparsest->axis) : std::nullopt;
}

Result<VoxelRuns> voxelsBetween(std::span<const std::uint8_t> labels,
    const VolumeGeometry& geometry, std::uint8_t label, const DrawnSlices& drawn,
    const Progress& progress)
{
    std::vector<int> before; // each gap: the drawn slice before it, by its place in the list
    for (std::size_t at = 1; at < drawn.slices.size(); ++at) {
        if (drawn.slices[at] > drawn.slices[at - 1] + 1)
            before.push_back(int(at - 1));
    }
    if (before.empty())
        return VoxelRuns();
    if (const Result<void> enough =
            checkBytes(double(labels.size()), Clause::saying("what lies between the drawn slices"));
        !enough)
        return tl::unexpected(enough.error());
    // A byte for each voxel, so that gaps can be worked out side by side.
    std::vector<std::uint8_t> given(labels.size(), 0);
    const SlicePlaces places(geometry.size, drawn.axis);
    const SliceSteps steps = sliceSteps(geometry, drawn.axis);
    const FilterStage stage{progress};
    StageCounter counter(stage, std::int64_t(before.size()));
    parallelFor(int(before.size()), [&](int number) {
        if (counter.cancelled())
            return;
        const auto at = std::size_t(before[std::size_t(number)]);
        const Gap gap(labels, places, label, steps, drawn.slices[at], drawn.slices[at + 1]);
        gap.fill(progress,
            [&](const glm::ivec2& pixel, int slice) { given[places.at(pixel, slice)] = 1; });
        counter.stepDone();
    });
    if (counter.cancelled())
        return failure(ErrorCode::Cancelled);
    VoxelRuns runs;
    for (std::size_t at = 0; at < given.size();) {
        const std::size_t begin = at;
        while (at < given.size() && given[at] != 0 && labels[at] == 0)
            ++at;
        if (at > begin)
            runs.append(begin, at - begin);
        else
            ++at;
    }
    return runs;
}

} // namespace core
