// SPDX-License-Identifier: Apache-2.0
#include "core/repair/RepairVolume.h"

#include "core/base/ParallelFor.h"
#include "core/base/StepCounter.h"
#include "core/repair/RepairLattice.h"
#include "core/volume/MemoryLimit.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

namespace core {

namespace {

/// A voxel of the source that a voxel of the lattice is made of: the same step away everywhere in
/// one slice of the lattice.
struct Tap {
    int slice = 0;
    int dx = 0;
    int dy = 0;
    std::uint64_t weight = 0; ///< all of one voxel's: 2^48
};

struct Share {
    std::int64_t at = 0;
    std::int64_t weight = 0; ///< of wholeVoxel
};

/// The slices around a plane of the lattice.
std::vector<Share> sharesOf(const std::vector<LatticePlace>& places, std::int64_t z)
{
    std::size_t below = 0;
    while (below + 1 < places.size() && places[below + 1].z <= z)
        ++below;
    const std::int64_t over = z - places[below].z;
    if (over <= 0 || below + 1 == places.size())
        return {{std::int64_t(below), wholeVoxel}};
    const std::int64_t distance = places[below + 1].z - places[below].z;
    const std::int64_t share = (over * wholeVoxel + distance / 2) / distance;
    std::vector<Share> shares{{std::int64_t(below), wholeVoxel - share}};
    shares.push_back({std::int64_t(below) + 1, share});
    std::erase_if(shares, [](const Share& each) { return each.weight == 0; });
    return shares;
}

/// Where along one axis a voxel of the lattice finds its two neighbours in a slice at @p place.
std::vector<Share> sharesAt(std::int64_t place)
{
    const std::int64_t below = -place >> 16;
    const std::int64_t over = -place - below * wholeVoxel;
    if (over == 0)
        return {{below, wholeVoxel}};
    return {{below, wholeVoxel - over}, {below + 1, over}};
}

std::vector<Tap> tapsOf(const std::vector<LatticePlace>& places, int z)
{
    std::vector<Tap> taps;
    for (const Share& slice : sharesOf(places, std::int64_t(z) * wholeVoxel)) {
        const LatticePlace& place = places[std::size_t(slice.at)];
        for (const Share& y : sharesAt(place.y)) {
            for (const Share& x : sharesAt(place.x)) {
                taps.push_back({.slice = int(slice.at),
                    .dx = int(x.at),
                    .dy = int(y.at),
                    .weight = std::uint64_t(slice.weight) * std::uint64_t(y.weight)
                        * std::uint64_t(x.weight)});
            }
        }
    }
    // The first of those that weigh most stands for all where not all of them count.
    std::stable_sort(
        taps.begin(), taps.end(), [](const Tap& a, const Tap& b) { return a.weight > b.weight; });
    return taps;
}

class Resampler {
public:
    Resampler(const LoadedVolume& source, const RepairLattice& lattice, int outside)
        : m_source(source)
        , m_size(source.volume.geometry.size)
        , m_lattice(lattice)
        , m_outside(std::uint16_t(outside))
    {
    }

    /// @return how many of the slice's voxels are outside what was scanned
    std::uint64_t fill(int z, std::uint16_t* to) const
    {
        const std::vector<Tap> taps = tapsOf(m_lattice.places, z);
        const glm::ivec3 size = m_lattice.geometry.size;
        std::uint64_t outside = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (const std::uint16_t* nearest = codeAt(taps.front(), x, y)) {
                    *to++ = mean(taps, x, y, *nearest);
                } else {
                    *to++ = m_outside;
                    ++outside;
                }
            }
        }
        return outside;
    }

private:
    [[nodiscard]] const std::uint16_t* codeAt(const Tap& tap, int x, int y) const
    {
        x += tap.dx;
        y += tap.dy;
        if (x < 0 || y < 0 || x >= m_size.x || y >= m_size.y)
            return nullptr;
        return m_source.codes.data()
            + (std::size_t(tap.slice) * std::size_t(m_size.y) + std::size_t(y))
            * std::size_t(m_size.x)
            + std::size_t(x);
    }

    [[nodiscard]] bool isPadding(std::uint16_t code) const
    {
        return m_source.padding && code >= m_source.padding->lowest
            && code <= m_source.padding->highest;
    }

    [[nodiscard]] std::uint16_t mean(
        const std::vector<Tap>& taps, int x, int y, std::uint16_t nearest) const
    {
        if (taps.size() == 1)
            return nearest;
        std::uint64_t sum = std::uint64_t(1) << 47;
        for (const Tap& tap : taps) {
            const std::uint16_t* code = codeAt(tap, x, y);
            if (code == nullptr || isPadding(*code))
                return nearest;
            sum += tap.weight * *code;
        }
        return std::uint16_t(sum >> 48);
    }

    const LoadedVolume& m_source;
    glm::ivec3 m_size;
    const RepairLattice& m_lattice;
    std::uint16_t m_outside;
};

/// The code of voxels outside what was scanned.
int outsideCode(const LoadedVolume& loaded)
{
    if (!loaded.padding || loaded.padding->highest < 0
        || loaded.padding->lowest >= VoxelEncoding::codeCount)
        return 0;
    return std::max(loaded.padding->lowest, 0);
}

void keepPart(LoadedVolume& loaded, const SliceRun& part)
{
    Volume& volume = loaded.volume;
    const std::size_t size =
        std::size_t(volume.geometry.size.x) * std::size_t(volume.geometry.size.y);
    const auto first = std::ptrdiff_t(std::size_t(part.first) * size);
    loaded.codes = {loaded.codes.begin() + first,
        loaded.codes.begin() + first + std::ptrdiff_t(std::size_t(part.count) * size)};
    volume.geometry = geometryOfPart(volume.geometry, part);
    volume.sources = {
        volume.sources.begin() + part.first, volume.sources.begin() + part.first + part.count};
}

QString repairedBy(VolumeProblem::Kind kind, const SeriesRepair& repair)
{
    SeriesRepair only;
    switch (kind) {
    case VolumeProblem::Kind::MissingSlices:
    case VolumeProblem::Kind::UnevenSpacing:
        only.part = repair.part;
        only.lattice = repair.lattice;
        break;
    case VolumeProblem::Kind::Tilt:
        only.tilt = repair.tilt;
        break;
    case VolumeProblem::Kind::DuplicateSlices:
    case VolumeProblem::Kind::DoubledSlices:
        only.duplicates = repair.duplicates;
        break;
    case VolumeProblem::Kind::MixedSlices:
    case VolumeProblem::Kind::AssumedSpacing:
    case VolumeProblem::Kind::DamagedSlice:
    case VolumeProblem::Kind::LossyCompression:
    case VolumeProblem::Kind::InexactValues:
    case VolumeProblem::Kind::Other:
        break;
    }
    return only.toText();
}

/// Whether a slice is elsewhere in the lattice, or the lattice has further ones.
bool movesSlices(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    const RepairLattice lattice = repairLattice(slices, repair);
    std::int64_t z = 0;
    for (const LatticePlace& place : lattice.places) {
        if (place.x != 0 || place.y != 0 || place.z != z)
            return true;
        z += wholeVoxel;
    }
    return lattice.geometry.size.z != slices.size.z;
}

} // namespace

Result<LoadedVolume> repairVolume(
    LoadedVolume loaded, const SeriesRepair& repair, const Progress& progress)
{
    Volume& volume = loaded.volume;
    if (repair.isNone())
        return loaded;
    if (const Clause why = repairObstacle(volume.geometry, repair); !why.isEmpty())
        return failure(ErrorCode::InvalidField, QStringLiteral("repair"),
            Clause::saying("the series cannot be repaired by '%1': %2", repair.toText(), why));
    volume.repair = repair.toText();
    volume.asIs = std::make_shared<const SeriesAsIs>(
        SeriesAsIs{.geometry = volume.geometry, .sources = volume.sources});
    for (VolumeProblem& problem : volume.problems) {
        problem.repairedBy = repairedBy(problem.kind, repair);
        problem.caution = problem.caution && problem.repairedBy.isEmpty();
    }
    std::uint64_t outside = 0;
    const int code = outsideCode(loaded);
    if (repair.part != 0)
        keepPart(loaded, gapParts(volume.geometry)[std::size_t(repair.part - 1)]);
    if (repair.movesVoxels()) {
        const RepairLattice lattice = repairLattice(volume.geometry, repair);
        const std::size_t count = lattice.geometry.voxelCount();
        if (const Result<void> fits = checkMemory(count + loaded.codes.size()); !fits)
            return tl::unexpected<Error>(fits.error());
        std::vector<std::uint16_t> codes(count);
        const glm::ivec3 size = lattice.geometry.size;
        const Resampler resampler(loaded, lattice, code);
        StepCounter counter(progress, ProgressStep::Repairing, size.z);
        std::atomic<std::uint64_t> outsideOfAll = 0;
        parallelFor(size.z, [&](int z) {
            if (progress.cancelled())
                return;
            outsideOfAll += resampler.fill(
                z, codes.data() + std::size_t(z) * std::size_t(size.x) * std::size_t(size.y));
            counter.stepDone();
        });
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        outside = outsideOfAll;
        volume.geometry = lattice.geometry;
        volume.sources.clear();
        loaded.codes = std::move(codes);
    }
    if (repair.part != 0 || repair.movesVoxels())
        describeCodes(loaded, code, outside);
    return loaded;
}

QString repairMade(const Volume& volume)
{
    std::optional<SeriesRepair> made = SeriesRepair::fromText(volume.repair);
    if (!made || !made->movesVoxels() || !volume.asIs)
        return volume.repair;
    // Of all else a series that does not need it is refused, or it is given.
    VolumeGeometry slices = volume.asIs->geometry;
    if (made->part != 0)
        slices = geometryOfPart(slices, gapParts(slices)[std::size_t(made->part - 1)]);
    if (!movesSlices(slices, {.lattice = made->lattice}))
        made->lattice = SeriesRepair::Lattice::AsIs;
    if (made->tilt && !movesSlices(slices, {.tilt = true}))
        made->tilt = false;
    return made->toText();
}

} // namespace core
