// SPDX-License-Identifier: Apache-2.0
#include "core/brick/SeedWordForecast.h"

#include "core/growth/SeedWord.h"

#include <optional>

namespace core {

namespace {

constexpr std::uint32_t generationBits = seedWord::maxGeneration << 13;

bool becameMember(std::uint32_t difference)
{
    return (difference & seedWord::notMember) != 0;
}

/// Exact where the voxel was unvisited; elsewhere as good a number as any.
std::uint32_t generationOf(std::uint32_t difference)
{
    return seedWord::generation(~difference);
}

std::uint32_t withGeneration(std::uint32_t difference, std::uint32_t value)
{
    return (difference & ~generationBits) | (value & seedWord::maxGeneration) << 13;
}

std::uint32_t folded(std::uint32_t distance)
{
    distance &= seedWord::maxGeneration;
    const bool negative = distance > seedWord::maxGeneration / 2;
    return negative ? 2 * (seedWord::maxGeneration - distance) + 1 : 2 * distance;
}

std::uint32_t unfolded(std::uint32_t code)
{
    return (code & 1U) != 0 ? seedWord::maxGeneration - code / 2 : code / 2;
}

/// What is known when a voxel's turn comes: all before it, and its own word but for the generation.
class Forecaster {
public:
    explicit Forecaster(const WordDifferences& differences)
        : m_differences(differences)
    {
    }

    std::uint32_t at(int voxel) const
    {
        const std::uint32_t direction = seedWord::direction(~m_differences[std::size_t(voxel)]);
        if (direction < 6) {
            const std::uint32_t axis = direction / 2;
            if (const auto lower = before(voxel, axis == 0, axis == 1, axis == 2))
                return direction % 2 == 0 ? *lower + 1 : *lower - 1;
        }
        const auto a = before(voxel, 1, 0, 0);
        const auto b = before(voxel, 0, 1, 0);
        const auto c = before(voxel, 0, 0, 1);
        const auto ab = before(voxel, 1, 1, 0);
        const auto ac = before(voxel, 1, 0, 1);
        const auto bc = before(voxel, 0, 1, 1);
        const auto abc = before(voxel, 1, 1, 1);
        if (a && b && c && ab && ac && bc && abc)
            return *a + *b + *c - *ab - *ac - *bc + *abc;
        if (a && b && ab)
            return *a + *b - *ab;
        if (a && c && ac)
            return *a + *c - *ac;
        if (b && c && bc)
            return *b + *c - *bc;
        for (const auto& one : {a, b, c}) {
            if (one)
                return *one;
        }
        return m_last;
    }
    void passed(int voxel) { m_last = generationOf(m_differences[std::size_t(voxel)]); }

private:
    std::optional<std::uint32_t> before(int voxel, int dx, int dy, int dz) const
    {
        constexpr int side = BrickGrid::side;
        if (voxel % side < dx || voxel / side % side < dy || voxel / (side * side) < dz)
            return std::nullopt;
        const std::uint32_t difference =
            m_differences[std::size_t(voxel - dx - side * (dy + side * dz))];
        return becameMember(difference) ? std::optional(generationOf(difference)) : std::nullopt;
    }

    const WordDifferences& m_differences;
    std::uint32_t m_last = 0;
};

} // namespace

WordDifferences withForecast(const WordDifferences& differences)
{
    WordDifferences forecast = differences;
    Forecaster forecaster(differences);
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        const std::uint32_t difference = differences[std::size_t(voxel)];
        if (!becameMember(difference))
            continue;
        const std::uint32_t distance = generationOf(difference) - forecaster.at(voxel);
        forecast[std::size_t(voxel)] = withGeneration(difference, folded(distance));
        forecaster.passed(voxel);
    }
    return forecast;
}

WordDifferences withoutForecast(const WordDifferences& forecast)
{
    WordDifferences differences = forecast;
    Forecaster forecaster(differences);
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        std::uint32_t& word = differences[std::size_t(voxel)];
        if (!becameMember(word))
            continue;
        const std::uint32_t generation =
            forecaster.at(voxel) + unfolded(word >> 13 & seedWord::maxGeneration);
        word = withGeneration(word, ~generation);
        forecaster.passed(voxel);
    }
    return differences;
}

} // namespace core
