// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/Corruptor.h"

#include "tests/reenactment/CounterRandom.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace reenact {

namespace {

constexpr double tolerance = 0.1; ///< percentage points
constexpr double jitterShare = 0.2;
constexpr double jitterWidth = 4.0; ///< voxels

enum Stream : std::uint64_t { Place = 1, Shape, Jitter };

/// What is done to an organ, by its size: more is spoilt the larger it is.
using Fault = std::function<bool(const glm::ivec3& voxel, std::size_t at, double size)>;

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

class Spoiler {
public:
    Spoiler(const OrganScene& scene, const TableRow& row, double scale, std::uint64_t seed)
        : m_row(row)
        , m_scale(scale)
        , m_seed(seed)
        , m_organ(scene.maskOf(row.organ))
        , m_neighbour(scene.maskOf(row.into))
        , m_others(scene.organs)
        , m_direction(scene.study.volume.geometry.direction())
        , m_soft(smoothed(m_organ))
        , m_voxels(double(countOf(m_organ)))
    {
    }

    Corrupted made()
    {
        const SmoothNoise noise(m_seed, Jitter, jitterWidth);
        m_noise.reserve(m_organ.values.size());
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            const float soft = m_soft.values[at];
            m_noise.push_back(
                soft > 0.05F && soft < 0.95F ? float(noise.at(glm::dvec3(voxel))) : 0.0F);
        });
        m_amplitude = bisected(jitterShare * m_row.after, 1.0,
            [&](double amplitude) { return errorOf(jittered(m_organ, amplitude)); });
        const Fault fault = faultOf();
        const auto withFault = [&](double size) {
            Mask mask = m_organ;
            const std::uint8_t spoilt = m_row.fault == TableRow::Fault::Cut ? 0 : 1;
            forEachVoxel(mask.size, [&](const glm::ivec3& voxel, std::size_t at) {
                if (mask.values[at] != spoilt && fault(voxel, at, size))
                    mask.values[at] = spoilt;
            });
            return jittered(mask, m_amplitude);
        };
        const double size = bisected(m_row.before, 2.0 * glm::length(glm::dvec3(m_organ.size)),
            [&](double tried) { return errorOf(withFault(tried)); });
        Corrupted made{.mask = withFault(size), .error = 0.0, .jitter = 0.0};
        made.error = errorOf(made.mask);
        made.jitter = errorOf(jittered(m_organ, m_amplitude));
        return made;
    }

private:
    [[nodiscard]] double errorOf(const Mask& mask) const
    {
        return 100.0 * double(differing(mask, m_organ)) / m_voxels;
    }

    /// Near the organ's own border alone: that of the fault is what it is.
    [[nodiscard]] Mask jittered(Mask mask, double amplitude) const
    {
        for (std::size_t at = 0; at < mask.values.size(); ++at) {
            const double off = double(m_soft.values[at]) - 0.5;
            const double moved = amplitude * double(m_noise[at]);
            if (mask.values[at] != m_organ.values[at] || m_noise[at] == 0.0F
                || std::abs(moved) <= std::max(std::abs(off), 0.05))
                continue;
            mask.values[at] = moved > 0.0 ? 1 : 0;
        }
        return mask;
    }

    [[nodiscard]] static double bisected(
        double wanted, double most, const std::function<double(double)>& errorAt)
    {
        double low = 0.0;
        double high = most;
        double middle = 0.5 * most;
        for (int i = 0; i < 40; ++i) {
            middle = 0.5 * (low + high);
            const double error = errorAt(middle);
            if (std::abs(error - wanted) <= 0.3 * tolerance)
                break;
            (error < wanted ? low : high) = middle;
        }
        return middle;
    }

    [[nodiscard]] glm::dvec3 middle() const
    {
        glm::dvec3 sum(0.0);
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            if (m_organ.values[at] != 0)
                sum += glm::dvec3(voxel);
        });
        return sum / m_voxels;
    }

    /// The organ's voxel that lies farthest that way.
    [[nodiscard]] glm::dvec3 endTowards(const glm::dvec3& way) const
    {
        glm::dvec3 end(0.0);
        double most = -1e9;
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            const double along = glm::dot(glm::dvec3(voxel), way);
            if (m_organ.values[at] == 0 || along <= most)
                return;
            most = along;
            end = glm::dvec3(voxel);
        });
        return end;
    }

    [[nodiscard]] Fault faultOf()
    {
        CounterRandom place(m_seed, Place);
        const double bend = 0.35;
        const glm::dvec3 towards = glm::transpose(m_direction) * m_row.towards;
        const glm::dvec3 way = glm::normalize(
            glm::normalize(towards) + bend * place.within(0.4, 1.0) * place.direction());
        if (m_row.fault == TableRow::Fault::Bump)
            return bump(way, place);
        if (m_row.fault == TableRow::Fault::Cut)
            return cut(way);
        return leak(place);
    }

    /// @param width voxels at scale 1
    [[nodiscard]] Field noiseOf(double width) const
    {
        const SmoothNoise noise(m_seed, Shape, width * m_scale);
        Field field{m_organ.size, std::vector<float>(m_organ.values.size())};
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            field.values[at] = float(noise.at(glm::dvec3(voxel)));
        });
        return field;
    }

    /// A layer of uneven thickness over an end of the organ, thicker on what looks alike.
    [[nodiscard]] Fault bump(const glm::dvec3& way, CounterRandom& place) const
    {
        const double end = glm::dot(endTowards(way), way);
        const double reach = m_scale * place.within(28.0, 38.0);
        return [=, this, off = signedDistance(m_organ), noise = noiseOf(10.0)](
                   const glm::ivec3& voxel, std::size_t at, double size) {
            const glm::dvec3 here(voxel);
            const double share = std::clamp(1.0 - (end - glm::dot(here, way)) / reach, 0.0, 1.0);
            const double alike = m_others.values[at] != 0 ? 1.6 : 1.0;
            const double thick = alike * std::sqrt(share) * (1.0 + 0.6 * double(noise.values[at]));
            return double(off.values[at]) < size * thick;
        };
    }

    /// Cut off by an uneven plane.
    [[nodiscard]] Fault cut(const glm::dvec3& way) const
    {
        const double end = glm::dot(endTowards(way), way);
        return [=, noise = noiseOf(12.0), scale = m_scale](
                   const glm::ivec3& voxel, std::size_t at, double size) {
            return glm::dot(glm::dvec3(voxel), way) + 4.0 * scale * double(noise.values[at])
                > end - size;
        };
    }

    /// A neck from the organ into the neighbour where they lie close, and what a front has filled
    /// of that: it runs ahead where it is let through, and over where the neighbour is full.
    [[nodiscard]] Fault leak(CounterRandom& place) const
    {
        const Field toNeighbour = distanceTo(m_neighbour);
        const glm::dvec3 centre = middle();
        // Of the organ's voxels that are nearest to the neighbour, one by the seed.
        float nearest = 1e9F;
        forEachVoxel(m_organ.size, [&](const glm::ivec3&, std::size_t at) {
            if (m_organ.values[at] != 0)
                nearest = std::min(nearest, toNeighbour.values[at]);
        });
        std::vector<glm::dvec3> close;
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            if (m_organ.values[at] != 0 && toNeighbour.values[at] <= nearest + float(1.5 * m_scale))
                close.emplace_back(voxel);
        });
        glm::dvec3 sum(0.0);
        for (const glm::dvec3& one : close)
            sum += one;
        sum /= double(close.size());
        // Rather from the middle of where they touch than from its rim.
        std::sort(close.begin(), close.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            const double one = glm::dot(a - sum, a - sum);
            const double other = glm::dot(b - sum, b - sum);
            return one != other
                ? one < other
                : glm::dot(a, glm::dvec3(1e6, 1e3, 1)) < glm::dot(b, glm::dvec3(1e6, 1e3, 1));
        });
        const glm::dvec3 from = close[std::size_t(place.unit() * 0.5 * double(close.size()))];
        glm::dvec3 inside(0.0);
        double deepest = 1e9;
        forEachVoxel(m_organ.size, [&](const glm::ivec3& voxel, std::size_t at) {
            if (m_neighbour.values[at] == 0)
                return;
            const double off = glm::length(glm::dvec3(voxel) - from);
            if (off >= deepest)
                return;
            deepest = off;
            inside = glm::dvec3(voxel);
        });
        const glm::dvec3 way = glm::normalize(deepest > 0.5 ? inside - from : from - centre);
        const double neck = m_scale * place.within(2.0, 4.0);
        const glm::dvec3 end = from + (deepest + 3.0 * m_scale) * way;
        return [=, arrival = arrivalFrom(end, inside)](
                   const glm::ivec3& voxel, std::size_t at, double size) {
            const glm::dvec3 here(voxel);
            const double part = std::clamp(
                glm::dot(here - from, end - from) / glm::dot(end - from, end - from), 0.0, 1.0);
            return glm::length(here - (from + part * (end - from))) <= neck
                || double(arrival.values[at]) < size;
        };
    }

    /// When a front would be at each voxel that is not the organ's.
    [[nodiscard]] Field arrivalFrom(const glm::dvec3& end, const glm::dvec3& inside) const
    {
        constexpr double unevenness = 0.7; ///< of its speed, as a logarithm
        constexpr double besideNeighbour = 5.0; ///< times as slow
        Field slowness = noiseOf(8.0);
        for (std::size_t at = 0; at < slowness.values.size(); ++at)
            slowness.values[at] = std::exp(float(unevenness) * slowness.values[at])
                * (m_neighbour.values[at] != 0 ? 1.0F : float(besideNeighbour));
        Field arrival{m_organ.size, std::vector<float>(m_organ.values.size(), 1e9F)};
        using Place = std::pair<float, std::size_t>;
        std::priority_queue<Place, std::vector<Place>, std::greater<>> front;
        glm::ivec3 begin(glm::round(end));
        if (!m_organ.contains(begin) || m_neighbour.at(begin) == 0)
            begin = glm::ivec3(inside);
        arrival.at(begin) = 0.0F;
        front.emplace(0.0F, arrival.offset(begin));
        const glm::ivec3 size = m_organ.size;
        while (!front.empty()) {
            const auto [time, at] = front.top();
            front.pop();
            if (time > arrival.values[at])
                continue;
            const glm::ivec3 voxel(
                int(at) % size.x, int(at) / size.x % size.y, int(at) / size.x / size.y);
            for (int side = 0; side < 27; ++side) {
                const glm::ivec3 step(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
                const glm::ivec3 near = voxel + step;
                if (!arrival.contains(near) || m_organ.at(near) != 0)
                    continue;
                const float then = time + slowness.at(near) * float(glm::length(glm::dvec3(step)));
                if (then >= arrival.at(near))
                    continue;
                arrival.at(near) = then;
                front.emplace(then, arrival.offset(near));
            }
        }
        return arrival;
    }

    TableRow m_row;
    double m_scale;
    std::uint64_t m_seed;
    Mask m_organ;
    Mask m_neighbour;
    Mask m_others; ///< not 0: some organ
    glm::dmat3 m_direction;
    Field m_soft;
    double m_voxels;
    std::vector<float> m_noise; ///< near the border
    double m_amplitude = 0.0;
};

} // namespace

const std::array<TableRow, 8>& tableRows()
{
    using enum TableRow::Fault;
    static const std::array<TableRow, 8> rows{{
        {"1a", "liver, left lobe over-segmented", Organ::Liver, Bump, Organ::None, {1.0, -0.2, 0.1},
            15.3, 2.7, 10.3},
        {"1b", "liver, right lobe under-segmented", Organ::Liver, Cut, Organ::None,
            {-1.0, 0.1, 0.2}, 15.3, 2.7, 12.0},
        {"2", "liver, leak into the heart", Organ::Liver, Leak, Organ::Heart, {0.0, 0.0, 1.0}, 6.7,
            2.5, 13.7},
        {"3", "liver, leak into the stomach", Organ::Liver, Leak, Organ::Stomach, {1.0, 0.0, -1.0},
            9.2, 2.6, 11.3},
        {"4", "liver, lower right lobe", Organ::Liver, Cut, Organ::None, {-0.3, 0.0, -1.0}, 4.1,
            2.7, 11.7},
        {"5", "spleen, leak into the kidney", Organ::Spleen, Leak, Organ::Kidney, {1.0, 0.0, 0.0},
            64.2, 1.9, 10.0},
        {"6", "kidney, under-segmented", Organ::Kidney, Cut, Organ::None, {0.2, 0.1, -1.0}, 8.4,
            0.5, 8.7},
        {"7", "lung, leak into the stomach", Organ::Lung, Leak, Organ::Stomach, {0.0, 0.0, -1.0},
            38.9, 1.8, 10.0},
    }};
    return rows;
}

Corrupted corrupted(const OrganScene& scene, const TableRow& row, double scale, std::uint64_t seed)
{
    return Spoiler(scene, row, scale, seed).made();
}

} // namespace reenact
