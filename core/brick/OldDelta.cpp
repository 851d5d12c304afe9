// SPDX-License-Identifier: Apache-2.0
#include "core/brick/OldDelta.h"

#include "core/brick/BrickMask.h"
#include "core/growth/SeedWord.h"

#include <map>
#include <utility>

namespace core {

namespace {

constexpr std::uint32_t generationBits = seedWord::maxGeneration << 13;

/// How a brick's difference stands in the stream.
enum class Form : std::uint8_t {
    Whole = 0, ///< every voxel
    Masked = 1, ///< which voxels differ, then these
    MaskedAsLabels = 2, ///< the same voxels as in the labels brick of this number and plane
};

using WordDifferences = std::array<std::uint32_t, BrickGrid::voxelsPerBrick>;

bool becameMember(std::uint32_t difference)
{
    return (difference & seedWord::notMember) != 0;
}

/// Exact where the voxel was unvisited; elsewhere as good a number as any.
std::uint32_t generationOf(std::uint32_t difference)
{
    return seedWord::generation(~difference);
}

std::uint32_t unfolded(std::uint32_t code)
{
    return (code & 1U) != 0 ? seedWord::maxGeneration - code / 2 : code / 2;
}

/// What "BDL2" foretells of a generation, from all voxels before it and the word's other bits:
/// 1. the neighbour one lower along the axis of its direction, if there is one: that one's
///    generation + 1 where it is the parent (even directions), − 1 where the parent lies on the
///    other side;
/// 2. else, from the neighbours a, b, c one lower in x, y, z, and ab one lower in x and y …:
///    a + b + c − ab − ac − bc + abc if all are there; a + b − ab, a + c − ac, b + c − bc, a, b, c,
///    whichever comes first with all it needs;
/// 3. else the member before it in the order of voxels; 0 if there is none.
/// Modulo 2¹⁸ throughout.
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

/// Generations stand as distances from their forecast, folded: 0, −1, 1, −2 … are 0, 1, 2, 3 …
void withoutForecast(std::vector<std::uint8_t>& bytes)
{
    WordDifferences differences{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        differences[i / 4] |= std::uint32_t(bytes[i]) << (8 * (i % 4));
    Forecaster forecaster(differences);
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        std::uint32_t& word = differences[std::size_t(voxel)];
        if (!becameMember(word))
            continue;
        const std::uint32_t generation =
            forecaster.at(voxel) + unfolded(word >> 13 & seedWord::maxGeneration);
        word = (word & ~generationBits) | (~generation & seedWord::maxGeneration) << 13;
        forecaster.passed(voxel);
    }
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = std::uint8_t(differences[i / 4] >> (8 * (i % 4)));
}

/// Bytes by significance, of the voxels of a mask or of all, become words.
void scatter(const std::vector<std::uint8_t>& values, const BrickMask& mask,
    std::size_t bytesPerVoxel, std::vector<std::uint8_t>& words)
{
    auto value = values.begin();
    for (std::size_t byte = 0; byte < bytesPerVoxel; ++byte)
        mask.forEach([&](std::size_t voxel) { words[voxel * bytesPerVoxel + byte] = *value++; });
}

BrickMask everyVoxel()
{
    BrickMask mask;
    mask.bits.fill(0xFF);
    return mask;
}

} // namespace

std::optional<std::vector<BrickImage>> readOldDelta(DeltaReader& reader)
{
    std::vector<BrickImage> images;
    std::map<BrickKey, BrickMask> labels;
    while (true) {
        std::array<std::uint8_t, 8> head{};
        const std::size_t got = reader.take(head.data(), head.size());
        if (got == 0 && reader.complete())
            return images;
        const bool known = head[0] >= 1 && head[0] <= 3 && head[2] <= 2 && head[3] == 0;
        if (got != head.size() || !known)
            return std::nullopt;
        BrickImage image;
        image.key = {.field = Field(head[0]),
            .plane = head[1],
            .brick = std::uint32_t(head[4]) | std::uint32_t(head[5]) << 8
                | std::uint32_t(head[6]) << 16 | std::uint32_t(head[7]) << 24};
        const auto wide = std::size_t(bytesPerVoxel(image.key.field));
        const Form form{head[2]};
        BrickMask mask = everyVoxel();
        if (form == Form::Masked && !reader.fill(mask.bits))
            return std::nullopt;
        if (form == Form::MaskedAsLabels) {
            const auto same = labels.find({Field::Labels, image.key.plane, image.key.brick});
            if (same == labels.end())
                return std::nullopt;
            mask = same->second;
        }
        std::vector<std::uint8_t> values(mask.count() * wide);
        if (!reader.fill(values))
            return std::nullopt;
        image.bytes.resize(wide * BrickGrid::voxelsPerBrick);
        scatter(values, mask, wide, image.bytes);
        if (form != Form::Whole && image.key.field == Field::SeedWords)
            withoutForecast(image.bytes);
        if (form != Form::Whole && image.key.field == Field::Labels)
            labels.emplace(image.key, mask);
        images.push_back(std::move(image));
    }
}

} // namespace core
