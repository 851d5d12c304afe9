// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/SeedValues.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/session/EditSession.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ui {

namespace {

glm::ivec3 voxelAt(const glm::dvec3& lps, const core::VolumeGeometry& geometry)
{
    return glm::ivec3(glm::round(geometry.toIndex(lps)));
}

/// An end of the interval beyond which so little of the volume lies is open: nothing else is there.
constexpr double openBeyond = 0.005;

/// The parts of the volume below and above a value.
std::pair<double, double> beside(const core::Histogram& histogram, double value)
{
    const double all = std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0);
    const double range = histogram.maximum - histogram.minimum;
    if (all == 0.0 || range <= 0.0)
        return {1.0, 1.0};
    const double at = (value - histogram.minimum) / range * double(histogram.counts.size());
    double below = 0.0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i)
        below += histogram.counts[i] * std::clamp(at - double(i), 0.0, 1.0);
    return {below / all, (all - below) / all};
}

} // namespace

std::vector<std::vector<glm::ivec3>> sketchedVoxels(const core::EditSession& session, int label)
{
    std::vector<std::vector<glm::ivec3>> sketches;
    const core::VolumeGeometry& geometry = session.document().volumes.front().geometry;
    const core::History& history = session.history();
    for (const core::RowId id : history.standing()) {
        const auto* stroke = history.row(id).edit.as<core::SeedStroke>();
        if (!stroke || stroke->segment != label)
            continue;
        if (stroke->takenLps) {
            for (const glm::dvec3& point : *stroke->takenLps) {
                for (std::vector<glm::ivec3>& voxels : sketches)
                    std::erase(voxels, voxelAt(point, geometry));
            }
        }
        std::vector<glm::ivec3> voxels;
        for (const glm::dvec3& point : stroke->pointsLps) {
            const glm::ivec3 voxel = voxelAt(point, geometry);
            if (geometry.contains(voxel))
                voxels.push_back(voxel);
        }
        sketches.push_back(std::move(voxels));
    }
    std::erase_if(sketches, [](const std::vector<glm::ivec3>& voxels) { return voxels.empty(); });
    return sketches;
}

std::vector<glm::ivec3> seedVoxels(const core::EditSession& session, int label)
{
    std::vector<glm::ivec3> all;
    for (const std::vector<glm::ivec3>& voxels : sketchedVoxels(session, label))
        all.insert(all.end(), voxels.begin(), voxels.end());
    return all;
}

int sketchedSeeds(const core::EditSession& session, std::uint8_t plane)
{
    // Those of a segment that was deleted went with it.
    std::size_t count = 0;
    for (const core::Segment& segment : session.document().segments)
        count += segment.plane == plane ? seedVoxels(session, segment.label).size() : 0;
    return int(count);
}

SeedStatistics seedStatistics(const std::vector<double>& values)
{
    SeedStatistics result;
    if (values.empty())
        return result;
    for (const double value : values)
        result.mean += value;
    result.mean /= double(values.size());
    if (values.size() < 2)
        return result;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - result.mean) * (value - result.mean);
    result.deviation = std::sqrt(squares / double(values.size() - 1));
    return result;
}

std::optional<std::pair<double, double>> offeredValues(
    const core::Volume& volume, const core::SketchedCodes& sketched, double tolerance)
{
    const core::CodeInterval codes =
        core::offeredInterval(sketched, int(std::lround(tolerance * 256.0)));
    if (codes.low > codes.high)
        return std::nullopt;
    double lower = volume.encoding.value(codes.low);
    double upper = volume.encoding.value(codes.high);
    // Outwards to numbers with few digits: history and report name them.
    const double spread = std::max(upper - lower, 1e-9);
    const double step = std::pow(10.0, std::floor(std::log10(spread / 50.0)));
    lower = std::floor(lower / step) * step;
    upper = std::ceil(upper / step) * step;
    if (lower <= volume.minimum || beside(volume.histogram, lower).first < openBeyond)
        lower = volume.minimum;
    if (upper >= volume.maximum || beside(volume.histogram, upper).second < openBeyond)
        upper = volume.maximum;
    return std::pair(lower, upper);
}

} // namespace ui
