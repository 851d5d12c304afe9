// SPDX-License-Identifier: Apache-2.0
#include "ui/SeedStatistics.h"

#include "core/session/EditSession.h"

#include <cmath>

namespace ui {

std::vector<glm::ivec3> seedVoxels(const core::EditSession& session, int label)
{
    std::vector<glm::ivec3> voxels;
    const core::VolumeGeometry& geometry = session.document().volumes.front().geometry;
    const core::History& history = session.history();
    for (const core::RowId id : history.standing()) {
        const auto* stroke = std::get_if<core::SeedStroke>(&history.row(id).edit);
        if (!stroke || stroke->segment != label)
            continue;
        for (const glm::dvec3& point : stroke->pointsLps) {
            const glm::ivec3 voxel(glm::round(geometry.toIndex(point)));
            if (geometry.contains(voxel))
                voxels.push_back(voxel);
        }
    }
    return voxels;
}

int sketchedSeeds(const core::EditSession& session)
{
    std::size_t count = 0;
    const core::History& history = session.history();
    for (const core::RowId id : history.standing()) {
        const auto* stroke = std::get_if<core::SeedStroke>(&history.row(id).edit);
        // Those of a segment that was deleted went with it.
        if (stroke && session.document().segment(stroke->segment))
            count += stroke->pointsLps.size();
    }
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

} // namespace ui
