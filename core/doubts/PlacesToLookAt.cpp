// SPDX-License-Identifier: Apache-2.0
#include "core/doubts/PlacesToLookAt.h"

#include "core/brick/LabelRuns.h"
#include "core/doubts/MaskDisagreement.h"
#include "core/doubts/PartMiddle.h"

#include <algorithm>

namespace core {

namespace {

using Why = DoubtfulPlace::Why;

/// How many voxels the border may lie beside the core of a difference: the outer layer of the
/// difference, and one voxel of the segment.
constexpr int besideVoxels = 2;

DoubtfulPlace placeAt(const VoxelRuns& voxels, const VolumeGeometry& geometry, Why why)
{
    DoubtfulPlace place{.why = why, .voxel = middleOf(voxels, geometry)};
    place.placeLps = geometry.toWorld(glm::dvec3(place.voxel));
    return place;
}

/// The listed disagreements, to recognise places beside them.
class Disagreements {
public:
    explicit Disagreements(const glm::ivec3& size)
        : m_size(size)
    {
    }
    void add(const VoxelRuns& voxels) { m_all = united(m_all, voxels); }
    /// Whether more than half of the voxels lie beside a listed disagreement.
    [[nodiscard]] bool hold(const VoxelRuns& voxels, const Progress& progress) const
    {
        if (m_all.empty())
            return false;
        std::int64_t beside = 0;
        for (const VoxelRun& run : voxels.runs()) {
            if (progress.cancelled())
                return false;
            for (std::uint64_t number = run.first; number < run.first + run.count; ++number)
                beside += isBeside(voxelOf(number, m_size)) ? 1 : 0;
        }
        return 2 * beside > std::int64_t(voxels.voxelCount());
    }

private:
    [[nodiscard]] bool isBeside(const glm::ivec3& at) const
    {
        const glm::ivec3 low = glm::max(at - besideVoxels, glm::ivec3(0));
        const glm::ivec3 high = glm::min(at + besideVoxels, m_size - 1);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                const std::uint64_t row =
                    (std::uint64_t(z) * std::uint64_t(m_size.y) + std::uint64_t(y))
                    * std::uint64_t(m_size.x);
                if (holdsAny(row + std::uint64_t(low.x), row + std::uint64_t(high.x)))
                    return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool holdsAny(std::uint64_t first, std::uint64_t last) const
    {
        const auto reaches = std::lower_bound(m_all.runs().begin(), m_all.runs().end(), first,
            [](const VoxelRun& run, std::uint64_t number) {
                return run.first + run.count <= number;
            });
        return reaches != m_all.runs().end() && reaches->first <= last;
    }

    glm::ivec3 m_size;
    VoxelRuns m_all;
};

struct Difference {
    LonePart part;
    Why why = Why::OnlyHere;
};

Result<std::vector<Difference>> differencesOf(
    const BorderSource& source, const VoxelRuns& second, const Progress& progress)
{
    const VoxelRuns own = labelRuns(source.labels, source.label);
    Result<std::vector<LonePart>> here = onlyIn(own, second, source.geometry, progress);
    if (!here)
        return tl::unexpected(here.error());
    Result<std::vector<LonePart>> there = onlyIn(second, own, source.geometry, progress);
    if (!there)
        return tl::unexpected(there.error());
    std::vector<Difference> all;
    for (LonePart& part : *here)
        all.push_back({std::move(part), Why::OnlyHere});
    for (LonePart& part : *there)
        all.push_back({std::move(part), Why::OnlyThere});
    std::stable_sort(all.begin(), all.end(), [](const Difference& one, const Difference& two) {
        return one.part.voxels > two.part.voxels;
    });
    return all;
}

} // namespace

Result<std::vector<DoubtfulPlace>> placesToLookAt(
    const BorderSource& source, const VoxelRuns* second, std::size_t most, const Progress& progress)
{
    const VolumeGeometry& geometry = source.geometry;
    std::vector<DoubtfulPlace> places;
    // An empty segment would differ everywhere from the second mask, which is of no use.
    if (source.box.empty())
        return places;
    std::vector<Difference> differences;
    if (second && !second->empty()) {
        Result<std::vector<Difference>> found = differencesOf(source, *second, progress);
        if (!found)
            return tl::unexpected(found.error());
        differences = *std::move(found);
    }
    Disagreements listed(geometry.size);
    if (differences.size() > most)
        differences.resize(most);
    for (const Difference& difference : differences)
        listed.add(difference.part.core);
    const Result<FaintBorder> faint = FaintBorder::of(source, progress);
    if (!faint)
        return tl::unexpected(faint.error());

    std::vector<DoubtfulPlace> edgeless;
    for (const FaintBorder::Part& part : faint->parts) {
        if (edgeless.size() == most)
            break;
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (listed.hold(part.voxels, progress))
            continue;
        edgeless.push_back(placeAt(part.voxels, geometry, Why::NoEdge));
        edgeless.back().areaMm2 = double(part.areaUm2) / 1e6;
    }
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    for (std::size_t turn = 0; turn < std::max(differences.size(), edgeless.size()); ++turn) {
        if (turn < differences.size()) {
            const Difference& difference = differences[turn];
            places.push_back(placeAt(difference.part.core, geometry, difference.why));
            places.back().volumeMm3 = double(difference.part.voxels) * geometry.voxelVolumeMm3();
        }
        if (turn < edgeless.size())
            places.push_back(edgeless[turn]);
    }
    places.resize(std::min(places.size(), most));
    return places;
}

} // namespace core
