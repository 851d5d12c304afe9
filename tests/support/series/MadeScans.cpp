// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/MadeScans.h"

#include "core/demo/HeadPhantom.h"
#include "core/demo/Noise.h"
#include "tests/support/series/SyntheticSeries.h"

#include <algorithm>
#include <cmath>

namespace test {

namespace {

/// Whole numbers from 0 to below @p width.
double evenNoise(const glm::ivec3& voxel, std::uint32_t width)
{
    return double(core::demo::hash(voxel.x, voxel.y, voxel.z) % width);
}

bool isInEllipsoid(const glm::dvec3& mm, const glm::dvec3& halfAxesMm)
{
    return glm::length(mm / halfAxesMm) <= 1.0;
}

} // namespace

MadeScan::MadeScan(const glm::ivec3& size, const glm::dvec3& spacingMm, const Formula& formula)
    : m_size(size)
    , m_spacing(spacingMm)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const auto [value, part] = formula(voxel, placeLps(glm::dvec3(voxel)));
                m_hounsfield.push_back(int(std::lround(std::clamp(value, -1024.0, 3071.0))));
                m_parts.push_back(std::uint8_t(part));
            }
        }
    }
}

glm::dvec3 MadeScan::placeLps(const glm::dvec3& voxel) const
{
    return (voxel - 0.5 * glm::dvec3(m_size - 1)) * m_spacing;
}

std::size_t MadeScan::indexOf(const glm::ivec3& voxel) const
{
    return (std::size_t(voxel.z) * std::size_t(m_size.y) + std::size_t(voxel.y))
        * std::size_t(m_size.x)
        + std::size_t(voxel.x);
}

void MadeScan::write(const QString& folder) const
{
    SyntheticSeries series;
    series.size = m_size;
    series.spacing = {m_spacing.x, m_spacing.y};
    series.origin = placeLps(glm::dvec3(0.0));
    series.step = {0.0, 0.0, m_spacing.z};
    series.stored = [this](const glm::ivec3& voxel) { return m_hounsfield[indexOf(voxel)] + 1024; };
    writeSeries(series, folder);
}

std::vector<std::uint8_t> MadeScan::mask(
    const std::function<bool(int part, const glm::dvec3& placeLps)>& isMeant) const
{
    std::vector<std::uint8_t> marked;
    marked.reserve(m_parts.size());
    for (int z = 0; z < m_size.z; ++z) {
        for (int y = 0; y < m_size.y; ++y) {
            for (int x = 0; x < m_size.x; ++x)
                marked.push_back(isMeant(m_parts[indexOf({x, y, z})], placeLps({x, y, z})) ? 1 : 0);
        }
    }
    return marked;
}

MadeScan coarseHead()
{
    constexpr double noiseHu = 2.7;
    const core::HeadPhantom head;
    return {
        {154, 154, 134}, glm::dvec3(1.5), [&head](const glm::ivec3& voxel, const glm::dvec3& mm) {
            const core::HeadPhantom::Sample sample = head.at(glm::vec3(mm));
            const double noise = core::demo::gaussian(core::demo::hash(voxel.x, voxel.y, voxel.z));
            return std::pair(double(sample.hounsfield) + noiseHu * noise, int(sample.part));
        }};
}

MadeScan mistakenLiver()
{
    return {{86, 60, 60}, glm::dvec3(3.0), [](const glm::ivec3& voxel, const glm::dvec3&) {
                const glm::dvec3 at(voxel);
                const bool organ = glm::length(at - inLiver) <= 22.0;
                const bool neck = at.x > inLiver.x && at.x < inLeak.x
                    && std::hypot(at.y - inLiver.y, at.z - inLiver.z) <= 3.0;
                const bool leak = !organ && (neck || glm::length(at - inLeak) <= 12.0);
                const bool taken = leak || (organ && at.x >= 18.0);
                return std::pair((organ || leak ? 110.0 : -100.0) + evenNoise(voxel, 17),
                    (organ ? isLiver : 0) + (taken ? isTakenForLiver : 0));
            }};
}

MadeScan lungWithLesion()
{
    return {{72, 72, 60}, glm::dvec3(1.0), [](const glm::ivec3& voxel, const glm::dvec3& mm) {
                const bool lesion = isInEllipsoid(mm, {0.5 * lesionMm, 8.0, 8.0});
                const bool air = !lesion && isInEllipsoid(mm, {34.0, 34.0, 28.0});
                const double value = lesion ? 29.0 : air ? -856.0 : 34.0;
                return std::pair(value + evenNoise(voxel, 13), lesion ? 1 : 0);
            }};
}

} // namespace test
