// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/StudyLoader.h"

#include <QByteArray>

#include <vector>

namespace core {

/// One point of a series in time.
struct TimeFacts {
    QString key; ///< SeriesEntry::keyAtTime()
    Clause label; ///< SeriesEntry::times
    double minimum = 0.0;
    double maximum = 0.0;
    QByteArray voxelsSha256; ///< Volume::voxelsSha256
};

/// What is known of one volume: from its headers, and from its voxels if they could be read.
struct VolumeFacts {
    const SeriesEntry& entry;
    QString repair; ///< the requested one
    Result<LoadedVolume> loaded; ///< for a series in time the first point, or the first that failed
    std::vector<TimeFacts> times{};
    double minimum = 0.0; ///< over all points in time
    double maximum = 0.0;
    /// Over all points in time, one after the other; empty if the values do not follow from codes.
    QByteArray voxelsSha256{};
};

/// Loads a volume; of a series in time every point in turn, with the first and one more in memory
/// at a time.
/// @param repair to be done (core/repair/SeriesRepair.h); empty: none
[[nodiscard]] VolumeFacts volumeFacts(
    const Study& study, const SeriesEntry& entry, const QString& repair = {});

} // namespace core
