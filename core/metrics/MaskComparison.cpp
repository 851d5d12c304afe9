// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/MaskComparison.h"

#include "core/base/ParallelFor.h"
#include "core/metrics/BorderVoxels.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Points as the tree wants to see them.
struct Points {
    const std::vector<glm::dvec3>& places;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return places.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const
    {
        return places[index][int(axis)];
    }
    template <class Box> [[nodiscard]] bool kdtree_get_bbox(Box& /*box*/) const { return false; }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3>;

constexpr int pointsPerJob = 8192;

/// Of each place the distance to the nearest of the others; ascending. Fewer where it is cancelled.
std::vector<double> distancesMm(const std::vector<glm::dvec3>& places,
    const std::vector<glm::dvec3>& others, const Progress& progress)
{
    const Points points{others};
    const Tree tree(3, points);
    std::vector<double> distances(places.size());
    const int jobs = int((places.size() + pointsPerJob - 1) / pointsPerJob);
    parallelFor(jobs, [&](int job) {
        if (progress.cancelled())
            return;
        const std::size_t first = std::size_t(job) * pointsPerJob;
        const std::size_t end = std::min(places.size(), first + pointsPerJob);
        for (std::size_t i = first; i < end; ++i) {
            std::uint32_t nearest = 0;
            double squared = 0.0;
            tree.knnSearch(&places[i].x, 1, &nearest, &squared);
            distances[i] = std::sqrt(squared);
        }
    });
    std::sort(distances.begin(), distances.end());
    return distances;
}

/// @pre @p ascending is not empty
double percentile(const std::vector<double>& ascending, double share)
{
    const double rank = share * double(ascending.size() - 1);
    const auto below = std::size_t(rank);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    return ascending[below] + (ascending[above] - ascending[below]) * (rank - double(below));
}

double sum(const std::vector<double>& values)
{
    double all = 0.0;
    for (const double value : values)
        all += value;
    return all;
}

Result<SurfaceDistances> surfaceDistances(const VoxelRuns& mask, const VoxelRuns& reference,
    const VolumeGeometry& geometry, const Progress& progress)
{
    const std::vector<glm::dvec3> places = borderVoxels(mask, geometry);
    const std::vector<glm::dvec3> referencePlaces = borderVoxels(reference, geometry);
    const std::vector<double> there = distancesMm(places, referencePlaces, progress);
    const std::vector<double> back = distancesMm(referencePlaces, places, progress);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    constexpr double most = 0.95;
    return SurfaceDistances{
        .hausdorff95Mm = std::max(percentile(there, most), percentile(back, most)),
        .hausdorffMm = std::max(there.back(), back.back()),
        .meanMm = (sum(there) + sum(back)) / double(there.size() + back.size())};
}

} // namespace

Result<MaskComparison> compareMasks(const VoxelRuns& mask, const VoxelRuns& reference,
    const VolumeGeometry& geometry, const Progress& progress)
{
    MaskComparison comparison{.voxels = mask.voxelCount(),
        .referenceVoxels = reference.voxelCount(),
        .sharedVoxels = core::sharedVoxels(mask, reference)};
    const std::uint64_t both = comparison.voxels + comparison.referenceVoxels;
    if (both == 0) {
        comparison.relativeVolumeError = 0.0;
        comparison.distances = SurfaceDistances();
        return comparison;
    }
    comparison.dice = 2.0 * double(comparison.sharedVoxels) / double(both);
    if (comparison.referenceVoxels > 0)
        comparison.relativeVolumeError =
            double(both - 2 * comparison.sharedVoxels) / double(comparison.referenceVoxels);
    if (mask.empty() || reference.empty())
        return comparison;
    const Result<SurfaceDistances> distances =
        surfaceDistances(mask, reference, geometry, progress);
    if (!distances)
        return tl::unexpected(distances.error());
    comparison.distances = *distances;
    return comparison;
}

} // namespace core
