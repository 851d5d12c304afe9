// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/filling/BetweenSlices.h"

#include "core/morphology/SliceDistances.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace reference {

namespace {

using core::SliceAxis;
using core::SliceSteps;

using Pixel = std::pair<int, int>; ///< down, across: ordered as in memory
using Pixels = std::set<Pixel>;

__extension__ using Wide = __int128;

std::int64_t squaredStep(const SliceSteps& steps, const Pixel& one, const Pixel& other)
{
    const std::int64_t down = one.first - other.first;
    const std::int64_t across = one.second - other.second;
    return steps.yy * down * down + steps.xx * across * across;
}

struct Slices {
    std::span<const std::uint8_t> labels;
    glm::ivec3 size;
    SliceAxis axis;

    [[nodiscard]] int count() const { return size[alongOf(axis)]; }
    [[nodiscard]] int down() const { return size[downOf(axis)]; }
    [[nodiscard]] int across() const { return size[acrossOf(axis)]; }
    [[nodiscard]] std::size_t at(const Pixel& pixel, int slice) const
    {
        glm::ivec3 voxel;
        voxel[alongOf(axis)] = slice;
        voxel[downOf(axis)] = pixel.first;
        voxel[acrossOf(axis)] = pixel.second;
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    [[nodiscard]] Pixels drawn(int slice, std::uint8_t label) const
    {
        Pixels pixels;
        for (int y = 0; y < down(); ++y) {
            for (int x = 0; x < across(); ++x) {
                if (labels[at({y, x}, slice)] == label)
                    pixels.insert({y, x});
            }
        }
        return pixels;
    }
};

std::vector<Pixels> partsOf(Pixels drawn)
{
    std::vector<Pixels> parts;
    while (!drawn.empty()) {
        Pixels part;
        std::vector<Pixel> waiting{*drawn.begin()};
        drawn.erase(drawn.begin());
        while (!waiting.empty()) {
            const Pixel pixel = waiting.back();
            waiting.pop_back();
            part.insert(pixel);
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    const Pixel next(pixel.first + y, pixel.second + x);
                    if (drawn.erase(next) > 0)
                        waiting.push_back(next);
                }
            }
        }
        parts.push_back(part);
    }
    return parts;
}

/// Halves go up.
int rounded(std::int64_t number, std::int64_t divisor)
{
    std::int64_t twice = 2 * number + divisor;
    std::int64_t result = 0;
    while (twice < 0) {
        twice += 2 * divisor;
        --result;
    }
    return int(result + twice / (2 * divisor));
}

Pixel centroidOf(const Pixels& part)
{
    std::int64_t down = 0;
    std::int64_t across = 0;
    for (const Pixel& pixel : part) {
        down += pixel.first;
        across += pixel.second;
    }
    const auto count = std::int64_t(part.size());
    return {rounded(down, count), rounded(across, count)};
}

/// The first of those whose places lie nearest.
template <class Places, class PlaceOf>
std::size_t nearestPlace(
    const Places& places, const PlaceOf& placeOf, const Pixel& to, const SliceSteps& steps)
{
    std::size_t best = 0;
    std::size_t number = 0;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const auto& each : places) {
        if (const std::int64_t now = squaredStep(steps, placeOf(each), to); now < least) {
            least = now;
            best = number;
        }
        ++number;
    }
    return best;
}

bool overlap(const Pixels& one, const Pixels& other)
{
    return std::any_of(
        one.begin(), one.end(), [&](const Pixel& pixel) { return other.count(pixel) > 0; });
}

/// The pixels of a shape that touch one outside, and those outside.
struct Border {
    std::vector<Pixel> inner;
    std::vector<Pixel> outer;
};
Border borderOf(const Pixels& shape)
{
    Border border;
    for (const Pixel& pixel : shape) {
        for (const auto& [down, across] : {Pixel(-1, 0), Pixel(1, 0), Pixel(0, -1), Pixel(0, 1)}) {
            const Pixel beside(pixel.first + down, pixel.second + across);
            if (shape.count(beside) > 0)
                continue;
            border.inner.push_back(pixel);
            border.outer.push_back(beside);
        }
    }
    return border;
}

/// The squared distance to the other side, less than 0 outside. What lies beyond the slice is
/// outside; the nearest pixel of the other side always touches one of this side.
std::int64_t signedSquare(
    const Pixels& shape, const Border& border, const Pixel& pixel, const SliceSteps& steps)
{
    const bool isIn = shape.count(pixel) > 0;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const Pixel& other : isIn ? border.outer : border.inner)
        least = std::min(least, squaredStep(steps, pixel, other));
    return isIn ? least : -least;
}

Pixels moved(const Pixels& shape, const Pixel& by)
{
    Pixels pixels;
    for (const Pixel& pixel : shape)
        pixels.insert({pixel.first + by.first, pixel.second + by.second});
    return pixels;
}

struct Pair {
    Pixels lower;
    Pixels upper;
    Pixel way{0, 0};
};

std::vector<Pair> pairsOf(
    const std::vector<Pixels>& lower, const std::vector<Pixels>& upper, const SliceSteps& steps)
{
    std::vector<Pair> pairs;
    for (const Pixels& part : lower)
        pairs.push_back({part, {}});
    for (const Pixels& part : upper) {
        Pair joined{{}, part};
        std::erase_if(pairs, [&](const Pair& each) {
            if (!overlap(each.lower, part))
                return false;
            joined.lower.insert(each.lower.begin(), each.lower.end());
            joined.upper.insert(each.upper.begin(), each.upper.end());
            return true;
        });
        pairs.push_back(joined);
    }
    // What is alone looks for company.
    for (Pair& one : pairs) {
        if (one.lower.empty() || !one.upper.empty() || upper.empty())
            continue;
        const Pixel centroid = centroidOf(one.lower);
        const Pixels& found = upper[nearestPlace(upper, &centroidOf, centroid, steps)];
        const Pixel other = centroidOf(found);
        if (lower[nearestPlace(lower, &centroidOf, other, steps)] != one.lower)
            continue;
        for (Pair& its : pairs) {
            if (its.lower.empty() && its.upper == found) {
                one.upper = found;
                one.way = {other.first - centroid.first, other.second - centroid.second};
                its.upper.clear();
            }
        }
    }
    std::erase_if(pairs, [](const Pair& each) { return each.lower.empty() && each.upper.empty(); });
    const auto middleOf = [&steps](const Pixels& part) {
        const auto itself = [](const Pixel& pixel) { return pixel; };
        auto middle = part.begin();
        std::advance(middle, std::ptrdiff_t(nearestPlace(part, itself, centroidOf(part), steps)));
        return *middle;
    };
    for (Pair& each : pairs) {
        if (each.lower.empty())
            each.lower.insert(middleOf(each.upper));
        else if (each.upper.empty())
            each.upper.insert(middleOf(each.lower));
    }
    return pairs;
}

std::vector<int> drawnAcross(Slices slices, SliceAxis axis, std::uint8_t label)
{
    slices.axis = axis;
    std::vector<int> drawn;
    for (int slice = 0; slice < slices.count(); ++slice) {
        if (!slices.drawn(slice, label).empty())
            drawn.push_back(slice);
    }
    return drawn;
}

SliceAxis axisOf(const Slices& slices, std::uint8_t label)
{
    double least = 1.0;
    SliceAxis best = SliceAxis::K;
    for (const SliceAxis axis : {SliceAxis::K, SliceAxis::J, SliceAxis::I}) {
        const std::vector<int> drawn = drawnAcross(slices, axis, label);
        if (drawn.empty())
            continue;
        // Exact enough: shares of so few slices differ by more than a grain, or not at all.
        const double share = double(drawn.size()) / double(drawn.back() - drawn.front() + 1);
        if (share < least - 1e-9) {
            least = share;
            best = axis;
        }
    }
    return best;
}

} // namespace

std::vector<bool> voxelsBetween(std::span<const std::uint8_t> labels,
    const core::VolumeGeometry& geometry, std::uint8_t label, std::optional<SliceAxis> axis)
{
    Slices slices{labels, geometry.size, SliceAxis::K};
    slices.axis = axis.value_or(axisOf(slices, label));
    const SliceSteps steps = core::sliceSteps(geometry, slices.axis);
    const std::vector<int> drawn = drawnAcross(slices, slices.axis, label);
    std::vector<bool> between(labels.size(), false);
    for (std::size_t at = 1; at < drawn.size(); ++at) {
        const int of = drawn[at] - drawn[at - 1];
        if (of < 2)
            continue;
        for (const Pair& each : pairsOf(partsOf(slices.drawn(drawn[at - 1], label)),
                 partsOf(slices.drawn(drawn[at], label)), steps)) {
            const Pixels upper = moved(each.upper, {-each.way.first, -each.way.second});
            const Border lowerBorder = borderOf(each.lower);
            const Border upperBorder = borderOf(upper);
            Pixels all = each.lower;
            all.insert(upper.begin(), upper.end());
            for (const Pixel& pixel : all) {
                const Wide lowerSquare = signedSquare(each.lower, lowerBorder, pixel, steps);
                const Wide upperSquare = signedSquare(upper, upperBorder, pixel, steps);
                for (int done = 1; done < of; ++done) {
                    // A blend of roots is not negative where its terms, squared with their signs,
                    // are not.
                    const Wide blend =
                        lowerSquare * (of - done) * (of - done) + upperSquare * done * done;
                    const Pixel there(pixel.first + rounded(each.way.first * done, of),
                        pixel.second + rounded(each.way.second * done, of));
                    const bool inSlice = there.first >= 0 && there.second >= 0
                        && there.first < slices.down() && there.second < slices.across();
                    if (blend >= 0 && inSlice)
                        between[slices.at(there, drawn[at - 1] + done)] = true;
                }
            }
        }
    }
    return between;
}

} // namespace reference
