// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/MaskGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reenact {

namespace {

constexpr float far = 1e12F;

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z), at++);
        }
    }
}

/// The lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012), along one line.
void transformLine(std::vector<float>& line, std::vector<int>& peaks, std::vector<float>& from)
{
    const int count = int(line.size());
    const std::vector<float> values = line;
    peaks.assign(std::size_t(count), 0);
    from.assign(std::size_t(count) + 1, 0.0F);
    int last = 0;
    from[0] = -std::numeric_limits<float>::infinity();
    from[1] = std::numeric_limits<float>::infinity();
    for (int q = 1; q < count; ++q) {
        const auto meets = [&](int p) {
            return ((values[std::size_t(q)] + float(q * q))
                       - (values[std::size_t(p)] + float(p * p)))
                / float(2 * (q - p));
        };
        float at = meets(peaks[std::size_t(last)]);
        while (at <= from[std::size_t(last)])
            at = meets(peaks[std::size_t(--last)]);
        ++last;
        peaks[std::size_t(last)] = q;
        from[std::size_t(last)] = at;
        from[std::size_t(last) + 1] = std::numeric_limits<float>::infinity();
    }
    int k = 0;
    for (int q = 0; q < count; ++q) {
        while (from[std::size_t(k) + 1] < float(q))
            ++k;
        const int p = peaks[std::size_t(k)];
        line[std::size_t(q)] = float((q - p) * (q - p)) + values[std::size_t(p)];
    }
}

} // namespace

core::VoxelRuns runsOf(const Mask& mask)
{
    core::VoxelRuns runs;
    for (std::size_t at = 0; at < mask.values.size(); ++at) {
        if (mask.values[at] != 0)
            runs.append(at, 1);
    }
    return runs;
}

Mask maskOf(const core::VoxelRuns& runs, const glm::ivec3& size)
{
    Mask mask{size, {}};
    mask.values.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    for (const core::VoxelRun& run : runs.runs())
        std::fill_n(mask.values.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    return mask;
}

std::size_t countOf(const Mask& mask)
{
    return std::size_t(std::count(mask.values.begin(), mask.values.end(), std::uint8_t(1)));
}

std::size_t differing(const Mask& one, const Mask& other)
{
    std::size_t count = 0;
    for (std::size_t at = 0; at < one.values.size(); ++at)
        count += one.values[at] != other.values[at] ? 1 : 0;
    return count;
}

Field distanceTo(const Mask& mask)
{
    Field field{mask.size, std::vector<float>(mask.values.size())};
    for (std::size_t at = 0; at < mask.values.size(); ++at)
        field.values[at] = mask.values[at] != 0 ? 0.0F : far;
    std::vector<int> peaks;
    std::vector<float> from;
    for (int axis = 0; axis < 3; ++axis) {
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        std::vector<float> line(std::size_t(mask.size[axis]));
        glm::ivec3 voxel(0);
        for (int a = 0; a < mask.size[second]; ++a) {
            for (int b = 0; b < mask.size[third]; ++b) {
                voxel[second] = a;
                voxel[third] = b;
                for (int i = 0; i < mask.size[axis]; ++i) {
                    voxel[axis] = i;
                    line[std::size_t(i)] = field.at(voxel);
                }
                transformLine(line, peaks, from);
                for (int i = 0; i < mask.size[axis]; ++i) {
                    voxel[axis] = i;
                    field.at(voxel) = line[std::size_t(i)];
                }
            }
        }
    }
    for (float& value : field.values)
        value = std::sqrt(value);
    return field;
}

Field signedDistance(const Mask& mask)
{
    Mask outside = mask;
    for (std::uint8_t& value : outside.values)
        value = value != 0 ? 0 : 1;
    Field field = distanceTo(mask);
    const Field inside = distanceTo(outside);
    for (std::size_t at = 0; at < field.values.size(); ++at)
        field.values[at] =
            mask.values[at] != 0 ? 0.5F - inside.values[at] : field.values[at] - 0.5F;
    return field;
}

Field smoothed(const Mask& mask)
{
    Field field{mask.size, std::vector<float>(mask.values.begin(), mask.values.end())};
    const std::array<std::ptrdiff_t, 3> strides{
        1, mask.size.x, std::ptrdiff_t(mask.size.x) * mask.size.y};
    std::vector<float> before;
    for (int axis = 0; axis < 3; ++axis) {
        before = field.values;
        const std::ptrdiff_t stride = strides[std::size_t(axis)];
        const int end = mask.size[axis] - 1;
        forEachVoxel(mask.size, [&](const glm::ivec3& voxel, std::size_t at) {
            const auto value = [&](int off) {
                const int there = std::clamp(voxel[axis] + off, 0, end);
                return before[std::size_t(std::ptrdiff_t(at) + (there - voxel[axis]) * stride)];
            };
            field.values[at] =
                (value(-2) + value(2) + 4.0F * (value(-1) + value(1)) + 6.0F * value(0)) / 16.0F;
        });
    }
    return field;
}

double sampled(const Field& field, const glm::dvec3& index)
{
    const glm::dvec3 most(field.size - 1);
    const glm::dvec3 place = glm::clamp(index, glm::dvec3(0.0), most - 1e-9);
    const glm::ivec3 cell(glm::floor(place));
    const glm::dvec3 part = place - glm::dvec3(cell);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis)
            weight *= step[axis] == 1 ? part[axis] : 1.0 - part[axis];
        if (weight > 0.0)
            sum += weight * double(field.at(cell + step));
    }
    return sum;
}

std::vector<MaskPart> partsOf(const Mask& mask)
{
    Mask outside = mask;
    for (std::uint8_t& value : outside.values)
        value = value != 0 ? 0 : 1;
    const Field depth = distanceTo(outside);
    Mask left = mask;
    std::vector<MaskPart> parts;
    forEachVoxel(mask.size, [&](const glm::ivec3& first, std::size_t) {
        if (left.at(first) == 0)
            return;
        MaskPart part;
        part.voxels.push_back(first);
        left.at(first) = 0;
        for (std::size_t i = 0; i < part.voxels.size(); ++i) {
            const glm::ivec3 voxel = part.voxels[i];
            if (depth.at(voxel) > float(part.radius)) {
                part.radius = depth.at(voxel);
                part.deepest = voxel;
            }
            for (int side = 0; side < 6; ++side) {
                glm::ivec3 near = voxel;
                near[side / 2] += side % 2 == 0 ? 1 : -1;
                if (!left.contains(near) || left.at(near) == 0)
                    continue;
                left.at(near) = 0;
                part.voxels.push_back(near);
            }
        }
        parts.push_back(std::move(part));
    });
    return parts;
}

} // namespace reenact
