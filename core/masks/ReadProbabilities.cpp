// SPDX-License-Identifier: Apache-2.0
#include "core/masks/ReadProbabilities.h"

#include "core/base/ParallelFor.h"
#include "core/chunks/ProbabilityMap.h"
#include "core/masks/LatticeMap.h"
#include "core/masks/MaskParts.h"
#include "core/masks/StoredGrid.h"
#include "core/metaimage/MetaImageReader.h"
#include "core/nifti/NiftiReader.h"
#include "core/nrrd/NrrdReader.h"

#include <algorithm>

namespace core {

namespace {

/// The probabilities of the grid's own voxels. Errors: UnsupportedFormat.
Result<std::vector<std::uint8_t>> probabilitiesIn(const StoredGrid& stored, const QString& path)
{
    if (stored.layers != 1)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying(
                "it holds %1 numbers a voxel, and a probability map has one", stored.layers));
    const std::size_t voxels = stored.voxels();
    double least = 0.0;
    double greatest = 0.0;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
        const double number = stored.value(voxel, 0);
        least = std::min(least, number);
        greatest = std::max(greatest, number);
    }
    constexpr double slack = StoredGrid::slack;
    const bool plain = stored.slope == 1.0 && stored.intercept == 0.0;
    const bool bytes = plain && stored.type == ScalarType::UInt8 && greatest > 1.0 + slack;
    if (least < -slack || greatest > (bytes ? 255.0 : 1.0 + slack))
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its values, %1 to %2, are not probabilities: these are from 0 to 1, or "
                           "bytes from 0 to 255",
                least, greatest));
    std::vector<std::uint8_t> probabilities(voxels);
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
        probabilities[voxel] =
            ProbabilityMap::byteOf(stored.value(voxel, 0) / (bytes ? 255.0 : 1.0));
    return probabilities;
}

/// Each voxel of the volume gets the number of the grid's voxel that is nearest to its centre.
std::vector<std::uint8_t> onVolume(const VolumeGeometry& volume, const VolumeGeometry& grid,
    const LatticeMap& map, const std::vector<std::uint8_t>& probabilities)
{
    std::vector<std::uint8_t> placed(std::size_t(volume.voxelCount()), std::uint8_t(0));
    parallelFor(volume.size.z, [&](int k) {
        for (int j = 0; j < volume.size.y; ++j) {
            LatticeMap::Place place = map.rowStart(j, k);
            std::uint8_t* row =
                &placed[(std::size_t(k) * std::size_t(volume.size.y) + std::size_t(j))
                    * std::size_t(volume.size.x)];
            for (int i = 0; i < volume.size.x; ++i) {
                const auto x = LatticeMap::nearest(place[0]);
                const auto y = LatticeMap::nearest(place[1]);
                const auto z = LatticeMap::nearest(place[2]);
                const bool inside = x >= 0 && y >= 0 && z >= 0 && x < grid.size.x && y < grid.size.y
                    && z < grid.size.z;
                if (inside)
                    row[i] = probabilities[std::size_t((z * grid.size.y + y) * grid.size.x + x)];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] += map.step()[axis];
            }
        }
    });
    return placed;
}

Result<ProbabilitiesOnVolume> readGridProbabilities(
    const QString& path, const Volume& volume, const Progress& progress)
{
    const Result<StoredGrid> stored = readStoredGrid(path, progress);
    if (!stored)
        return tl::unexpected(stored.error());
    const Result<std::vector<std::uint8_t>> own = probabilitiesIn(*stored, path);
    if (!own)
        return tl::unexpected(own.error());
    const LatticeMap map(volume.geometry, stored->geometry.worldToIndex());
    if (!map.isSound())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its voxels are out of all proportion to the study's"));
    ProbabilitiesOnVolume read{
        .probabilities = onVolume(volume.geometry, stored->geometry, map, *own)};
    for (const VolumeProblem& problem : stored->problems) {
        if (problem.caution)
            read.notes.push_back({.code = MaskNote::Code::GridInDoubt, .doubt = problem.said});
    }
    if (!map.isOneToOne())
        read.notes.push_back({.code = MaskNote::Code::MapOnAnotherGrid});
    return read;
}

} // namespace

Result<ReadProbabilities> readProbabilities(const DivideSegment& edit, const QString& segment,
    const Volume& volume, const Progress& progress)
{
    const QString path = edit.probabilityFile.value_or(QString());
    const bool isGrid = isNiftiName(path) || isNrrdName(path) || isMetaImageName(path);
    Result<ProbabilitiesOnVolume> read = isGrid
        ? readGridProbabilities(path, volume, progress)
        : readSegProbabilities(path, segment, volume, progress);
    if (!read)
        return tl::unexpected(read.error());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    const auto& bytes = read->probabilities;
    if (std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == 0; }))
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("nothing of it lies inside the study's volume"));
    ReadProbabilities result{.edit = edit, .notes = std::move(read->notes)};
    result.edit.probabilityFile.reset();
    result.edit.probabilities = ProbabilityMap::packed(bytes);
    return result;
}

} // namespace core
