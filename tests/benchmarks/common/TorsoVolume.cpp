// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/TorsoVolume.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

const glm::dvec3 spacing(0.75, 0.75, 1.0);
const glm::dvec3 origin = -0.5 * spacing * (glm::dvec3(TorsoVolume::size) - 1.0);
const glm::dvec3 liverMiddle(-55.0, -10.0, 20.0);
const glm::dvec3 liverAxes(85.0, 62.0, 66.0);
constexpr double sheathMm = 4.0;
constexpr double codeOfZero = 1024.0;

std::uint32_t hashed(std::uint32_t x)
{
    x = (x ^ x >> 16) * 0x7FEB352DU;
    x = (x ^ x >> 15) * 0x846CA68BU;
    return x ^ x >> 16;
}

/// About normal: the sum of four even ones of 8 bits.
double noise(std::size_t voxel)
{
    const std::uint32_t bits = hashed(std::uint32_t(voxel));
    const int sum =
        int(bits & 255U) + int(bits >> 8 & 255U) + int(bits >> 16 & 255U) + int(bits >> 24);
    return (sum - 510.0) / 147.8 * TorsoVolume::noiseHu;
}

/// Roughly millimetres outside the liver's surface; negative inside.
double outsideLiver(const glm::dvec3& p)
{
    const glm::dvec3 q = (p - liverMiddle) / liverAxes;
    const double bumps = 0.05 * std::sin(0.09 * p.x + 1.0) * std::sin(0.11 * p.y)
        + 0.04 * std::sin(0.13 * p.z + 0.05 * p.x)
        + 0.015 * std::sin(0.4 * p.x) * std::sin(0.35 * p.z);
    return (glm::length(q) - 1.0 - bumps) * 65.0;
}

/// Within one of the vessels that branch through the liver.
bool inVessel(const glm::dvec3& p)
{
    const glm::dvec3 q = p - liverMiddle;
    for (int branch = 0; branch < 7; ++branch) {
        const double turn = 0.9 * branch;
        const glm::dvec3 along =
            glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), 0.3 * (branch - 3)));
        const double t = glm::dot(q, along);
        const double radius = 4.5 - 0.05 * std::abs(t);
        if (t > 0.0 && radius > 1.0 && glm::length(q - t * along) < radius)
            return true;
    }
    return false;
}

double valueAt(const glm::dvec3& p)
{
    const double body = glm::length(glm::dvec2(p) / TorsoVolume::bodyMm);
    if (body > 1.0)
        return -1000.0;
    if (body > 0.9)
        return -95.0; // fat under the skin
    const double outside = outsideLiver(p);
    if (outside > sheathMm)
        return 45.0; // muscle and bowel
    if (outside > 0.0)
        return -95.0;
    return inVessel(p) ? 190.0 : TorsoVolume::liverHu;
}

} // namespace

core::LoadedVolume TorsoVolume::make(int slices)
{
    const int first = (size.z - slices) / 2;
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.geometry.size = {size.x, size.y, slices};
    for (int axis = 0; axis < 3; ++axis) {
        volume.geometry.indexToWorld[axis][axis] = spacing[axis];
        volume.geometry.indexToWorld[3][axis] = origin[axis];
    }
    volume.geometry.indexToWorld[3][2] += first * spacing.z;
    volume.encoding.rescaleIntercept = -codeOfZero;
    volume.unit = QStringLiteral("HU");
    volume.minimum = -1024.0;
    volume.maximum = 400.0;
    volume.identity.modality = QStringLiteral("CT");
    volume.identity.seriesUid = QStringLiteral("2.25.512512600");
    volume.sourcePath = QStringLiteral("/made/by/formulas");
    volume.voxelsSha256 = QByteArray(64, '0');
    loaded.codes.resize(volume.geometry.voxelCount());
    core::parallelFor(slices, [&](int slice) {
        const int k = first + slice; // of the whole
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const std::size_t voxel = std::size_t(i)
                    + std::size_t(size.x) * (std::size_t(j) + std::size_t(size.y) * std::size_t(k));
                const double value = valueAt(origin + spacing * glm::dvec3(i, j, k)) + noise(voxel);
                const std::size_t before =
                    std::size_t(first) * std::size_t(size.x) * std::size_t(size.y);
                loaded.codes[voxel - before] =
                    std::uint16_t(std::max(std::lround(value + codeOfZero), 0L));
            }
        }
    });
    return loaded;
}

glm::dvec3 TorsoVolume::liverLps()
{
    return liverMiddle + glm::dvec3(3.0, -20.0, 20.0);
}

} // namespace bench
