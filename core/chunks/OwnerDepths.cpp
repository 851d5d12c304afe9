// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/OwnerDepths.h"

#include "core/base/LargePages.h"
#include "core/base/ParallelFor.h"

#include <algorithm>
#include <limits>

namespace core {

namespace {

using Depth = std::uint16_t;
/// No other owner has been found yet. Boxes are so small that no path has this many steps.
constexpr Depth unknown = std::numeric_limits<Depth>::max();

void lower(Depth& depth, Depth neighbour)
{
    if (neighbour < depth)
        depth = std::min(depth, Depth(neighbour + 1));
}

void lowerRow(Depth* row, const Depth* from, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        lower(row[i], from[i]);
}

/// Sets 1 where the neighbour at this distance in memory has another owner.
void markBorders(const std::uint8_t* one, const std::uint8_t* other, std::size_t count, Depth* to,
    Depth* toOther)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Depth found = one[i] == other[i] ? unknown : Depth(1);
        to[i] = std::min(to[i], found);
        toOther[i] = std::min(toOther[i], found);
    }
}

} // namespace

std::vector<std::uint16_t> ownerDepths(const ChunkSource& source)
{
    const auto columns = std::size_t(source.size.x);
    const auto rows = std::size_t(source.size.y);
    const std::size_t slice = columns * rows;
    const auto slices = std::size_t(source.size.z);
    std::vector<Depth> depth;
    resizeInLargePages(depth, source.owners.size(), unknown);
    // The number of steps between two voxels is the sum over the axes, so the axes can be processed
    // one after the other.
    parallelFor(source.size.z, [&](int z) {
        Depth* here = depth.data() + std::size_t(z) * slice;
        const std::uint8_t* owners = source.owners.data() + std::size_t(z) * slice;
        for (std::size_t y = 0; y < rows; ++y) {
            Depth* row = here + y * columns;
            const std::uint8_t* its = owners + y * columns;
            markBorders(its, its + 1, columns - 1, row, row + 1);
            if (y + 1 < rows)
                markBorders(its, its + columns, columns, row, row + columns);
        }
    });
    const auto along = [&](std::size_t y, std::size_t z) { return z * slice + y * columns; };
    parallelFor(source.size.y, [&](int y) {
        for (std::size_t z = 0; z + 1 < slices; ++z) {
            const std::size_t row = along(std::size_t(y), z);
            markBorders(&source.owners[row], &source.owners[row] + slice, columns, &depth[row],
                &depth[row] + slice);
        }
        for (std::size_t z = 1; z < slices; ++z)
            lowerRow(
                &depth[along(std::size_t(y), z)], &depth[along(std::size_t(y), z - 1)], columns);
        for (std::size_t z = slices - 1; z-- > 0;)
            lowerRow(
                &depth[along(std::size_t(y), z)], &depth[along(std::size_t(y), z + 1)], columns);
    });
    parallelFor(source.size.z, [&](int z) {
        Depth* here = depth.data() + std::size_t(z) * slice;
        for (std::size_t y = 1; y < rows; ++y)
            lowerRow(here + y * columns, here + (y - 1) * columns, columns);
        for (std::size_t y = rows - 1; y-- > 0;)
            lowerRow(here + y * columns, here + (y + 1) * columns, columns);
        for (std::size_t y = 0; y < rows; ++y) {
            Depth* row = here + y * columns;
            for (std::size_t x = 1; x < columns; ++x)
                lower(row[x], row[x - 1]);
            for (std::size_t x = columns - 1; x-- > 0;)
                lower(row[x], row[x + 1]);
            for (std::size_t x = 0; x < columns; ++x)
                row[x] = row[x] == unknown ? Depth(0) : row[x];
        }
    });
    return depth;
}

} // namespace core
