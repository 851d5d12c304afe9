// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/criterion/GrowCriterion.h"

#include "gpu/gl/Program.h"

#include <algorithm>
#include <tuple>

namespace gpu {

namespace {

/// An empty interval is one whose low end no code reaches.
std::pair<unsigned, unsigned> interval(int lowCode, int highCode)
{
    if (lowCode > highCode || highCode < 0)
        return {65536u, 0u};
    return {unsigned(std::max(lowCode, 0)), unsigned(highCode)};
}

/// Every define of growCriterion.glsl, and whether it is needed.
std::array<std::pair<const char*, bool>, 8> questions(const core::GrowLimits& limits)
{
    return {
        {{"DIFFERENCE", limits.difference.has_value()}, {"GRADIENT", limits.gradient.has_value()},
            {"GRADIENT_DIFFERENCE", limits.gradientDifference.has_value()},
            // The voxel itself is one, or that of whose code the median is.
            {"MAJORITY", limits.majority > 1}, {"SMOOTHED", limits.smoothed},
            {"ONLY_VISIBLE", limits.onlyVisible}, {"BOXED", limits.boxed},
            {"SIGMAS", limits.sigmas256 > 0}}};
}

constexpr std::size_t voxelsPerGroup = 64;
constexpr std::size_t bitsPerTexel = 32;
constexpr std::size_t codeCount = 65536;

/// Sums as seedStatistics.comp adds them up: six words each.
class SumBuffer {
public:
    explicit SumBuffer(std::size_t count)
        : m_count(count)
        , m_words({.label = "seed sums", .bytes = count * sizeof(Words)})
    {
        m_words.fill(0);
    }
    void bind() const { m_words.bindBase(GL_SHADER_STORAGE_BUFFER, 1); }
    [[nodiscard]] std::vector<core::SeedSums> read() const
    {
        std::vector<Words> words(m_count);
        m_words.read(std::span(words));
        std::vector<core::SeedSums> sums;
        sums.reserve(m_count);
        for (const Words& each : words)
            sums.push_back({.voxels = wide(each[0], each[1]),
                .codes = wide(each[2], each[3]),
                .squares = wide(each[4], each[5])});
        return sums;
    }

private:
    using Words = std::array<std::uint32_t, 6>;
    [[nodiscard]] static std::uint64_t wide(std::uint32_t low, std::uint32_t high)
    {
        return std::uint64_t(low) | std::uint64_t(high) << 32;
    }

    std::size_t m_count;
    Buffer m_words;
};

void add(core::SeedSums& sums, const core::SeedSums& more)
{
    sums.voxels += more.voxels;
    sums.codes += more.codes;
    sums.squares += more.squares;
}

/// Each part is in the whole.
void subtract(core::SeedSums& sums, const core::SeedSums& part)
{
    sums.voxels -= part.voxels;
    sums.codes -= part.codes;
    sums.squares -= part.squares;
}

void prepare(Program& kernel, VoxelFields& fields, const core::ProbeSeeds& question)
{
    const auto [low, high] = interval(question.lowCode, question.highCode);
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("lowCode", low)
        .set("highCode", high);
    BrickField& words = fields.seedWords(question.plane);
    words.pageTable().bindUnit(1);
    words.atlas().bindUnit(0);
    fields.codes().bindUnit(2);
}

/// Runs over a list, one entry for every `perGroup` of a work group.
template <class Entry>
void runOver(Program& kernel, const std::vector<Entry>& entries, std::size_t perGroup)
{
    const std::size_t atOnce = mostWorkGroups * perGroup;
    for (std::size_t first = 0; first < entries.size(); first += atOnce) {
        const std::span<const Entry> batch =
            std::span(entries).subspan(first, std::min(atOnce, entries.size() - first));
        Buffer list({.label = "seed list", .bytes = batch.size_bytes()});
        list.write(batch);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        kernel.set("entryCount", unsigned(batch.size()));
        kernel.dispatch({unsigned((batch.size() + perGroup - 1) / perGroup), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
    }
}

/// Voxels that stand in more than one group of a label, once less than they do.
std::vector<core::SeedGroup> repeated(const std::vector<core::SeedGroup>& groups)
{
    std::array<std::vector<glm::ivec3>, 256> byLabel;
    for (const core::SeedGroup& group : groups)
        byLabel[group.label].insert(
            byLabel[group.label].end(), group.voxels.begin(), group.voxels.end());
    std::vector<core::SeedGroup> again;
    for (std::size_t label = 0; label < byLabel.size(); ++label) {
        std::vector<glm::ivec3>& voxels = byLabel[label];
        std::sort(voxels.begin(), voxels.end(), [](const glm::ivec3& a, const glm::ivec3& b) {
            return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
        });
        core::SeedGroup more{.label = std::uint8_t(label)};
        for (std::size_t i = 1; i < voxels.size(); ++i) {
            if (voxels[i] == voxels[i - 1])
                more.voxels.push_back(voxels[i]);
        }
        if (!more.voxels.empty())
            again.push_back(std::move(more));
    }
    return again;
}

/// Of each group by itself.
std::vector<core::SeedSums> sumsOf(const std::vector<core::SeedGroup>& groups, Program& kernel,
    VoxelFields& fields, const core::ProbeSeeds& question)
{
    struct Entry { // seedStatistics.comp
        glm::uvec3 voxel;
        std::uint32_t labelAndGroup;
    };
    std::vector<Entry> entries;
    for (std::size_t group = 0; group < groups.size(); ++group) {
        for (const glm::ivec3& voxel : groups[group].voxels)
            entries.push_back({glm::uvec3(voxel),
                std::uint32_t(groups[group].label) | std::uint32_t(group) << 8});
    }
    if (entries.empty())
        return std::vector<core::SeedSums>(groups.size());
    SumBuffer sums(groups.size());
    prepare(kernel, fields, question);
    sums.bind();
    runOver(kernel, entries, voxelsPerGroup);
    return sums.read();
}

} // namespace

SeedStatisticsPrograms::SeedStatisticsPrograms(const ShaderLibrary& shaders)
    : m_shaders(shaders)
    , m_inBricks(shaders,
          {.label = "seeds in bricks",
              .path = "kernels/criterion/seedStatistics.comp",
              .defines = {}})
{
}

Program& SeedStatisticsPrograms::listed()
{
    if (!m_listed)
        m_listed = Program(m_shaders,
            ComputeProgramOptions{.label = "listed seeds",
                .path = "kernels/criterion/seedStatistics.comp",
                .defines = {{"LISTED", 1}}});
    return m_listed;
}

ShaderDefines definesOf(const core::GrowLimits& limits)
{
    ShaderDefines defines;
    for (const auto& [name, isAsked] : questions(limits)) {
        if (isAsked)
            defines.emplace_back(name, 1);
    }
    return defines;
}

unsigned kindOf(const core::GrowLimits& limits)
{
    unsigned kind = 0;
    for (const auto& question : questions(limits))
        kind = 2 * kind + (question.second ? 1 : 0);
    return 2 * kind + (core::isAsked(limits.passage) ? 1 : 0);
}

void setRange(Program& program, const core::GrowthRange& range)
{
    const auto [low, high] = interval(range.lowCode, range.highCode);
    program.set("closedLabels", range.closed).set("rangeLow", low).set("rangeHigh", high);
}

core::GroupedSeedSums seedSums(
    SeedStatisticsPrograms& programs, VoxelFields& fields, const core::ProbeSeeds& question)
{
    core::GroupedSeedSums result;
    result.groups.resize(question.seedGroups.size());
    const std::vector<std::uint32_t> bricks = fields.seedWords(question.plane).heldBricks();
    if (bricks.empty())
        return result;
    SumBuffer sums(result.others.size());
    prepare(programs.inBricks(), fields, question);
    sums.bind();
    runOver(programs.inBricks(), bricks, 1);
    const std::vector<core::SeedSums> all = sums.read();
    std::copy(all.begin(), all.end(), result.others.begin());
    if (question.seedGroups.empty())
        return result;

    result.groups = sumsOf(question.seedGroups, programs.listed(), fields, question);
    const std::vector<core::SeedGroup> again = repeated(question.seedGroups);
    const std::vector<core::SeedSums> twice = sumsOf(again, programs.listed(), fields, question);
    for (std::size_t i = 0; i < again.size(); ++i)
        add(result.others[again[i].label], twice[i]);
    for (std::size_t i = 0; i < result.groups.size(); ++i)
        subtract(result.others[question.seedGroups[i].label], result.groups[i]);
    return result;
}

GrowCriterion::GrowCriterion(const core::GrowBurst& burst, const core::GroupedSeedSums& around)
    : m_limits(burst.limits)
{
    std::tie(m_lowCode, m_highCode) = interval(burst.lowCode, burst.highCode);
    if (m_limits.sigmas256 > 0)
        takeSeeds(burst, around);
}

void GrowCriterion::takeSeeds(const core::GrowBurst& burst, const core::GroupedSeedSums& around)
{
    constexpr std::size_t width = codeCount / bitsPerTexel;
    std::vector<std::uint32_t> bits;
    const auto take = [&](std::size_t label, const core::SeedSums& sums) {
        const core::CodeInterval codes = core::seedInterval(sums, m_limits.sigmas256);
        if (codes.low > codes.high)
            return;
        if (m_seedRows[label] == 0) {
            bits.resize(bits.size() + width);
            m_seedRows[label] = unsigned(bits.size() / width);
        }
        std::uint32_t* row = &bits[(m_seedRows[label] - 1) * width];
        for (std::size_t code = std::size_t(codes.low); code <= std::size_t(codes.high); ++code)
            row[code / bitsPerTexel] |= 1u << code % bitsPerTexel;
    };
    for (std::size_t group = 0; group < around.groups.size(); ++group)
        take(burst.seedGroups[group].label, around.groups[group]);
    for (std::size_t label = 0; label < around.others.size(); ++label)
        take(label, around.others[label]);
    if (bits.empty())
        bits.resize(width);
    m_seedCodes = Texture2D({.label = "codes by seeds",
        .size = {int(width), int(bits.size() / width)},
        .format = GL_R32UI});
    m_seedCodes.upload(std::span<const std::uint32_t>(bits));
}

void GrowCriterion::setUniforms(Program& program) const
{
    constexpr int greatest = 65534; // no magnitude reaches it, and it has a square
    program.set("lowCode", m_lowCode)
        .set("highCode", m_highCode)
        .set("difference", unsigned(m_limits.difference.value_or(0)))
        .set("gradientWeights", glm::uvec3(m_limits.gradientWeights))
        .set("gradient", unsigned(std::min(m_limits.gradient.value_or(0), greatest)))
        .set("gradientDifference", unsigned(m_limits.gradientDifference.value_or(0)))
        .set("majority", m_limits.majority)
        .set("boxFrom", m_limits.boxFrom)
        .set("boxTo", m_limits.boxTo)
        .set("seedRows", std::span<const unsigned>(m_seedRows));
}

void GrowCriterion::bind(VoxelFields& fields) const
{
    if (m_limits.onlyVisible)
        fields.radiation().bindUnit(0);
    if (m_seedCodes)
        m_seedCodes.bindUnit(4);
}

} // namespace gpu
