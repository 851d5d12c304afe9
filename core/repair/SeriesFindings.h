// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace core {

/// Something that can be done about a finding.
struct RepairOffer {
    QString repair; ///< in the form of `--repair`; empty: another series is opened instead
    QString series; ///< another stack or point in time, in the form of `--series`; else empty
    QString title; ///< "Fill the gaps"
    QString effect; ///< one or two sentences on what it does to which slices
    VolumeGeometry result; ///< the grid with this repair alone
};

/// A problem of a series, and what can be done about it. Opening the series unchanged is always
/// possible.
struct SeriesFinding {
    VolumeProblem problem;
    std::vector<RepairOffer> offers{};
};

/// What else an entry's series can be opened as. @param time the point that is opened, 0-based
[[nodiscard]] SeriesAlternatives seriesAlternatives(
    const StudyListing& listing, const SeriesEntry& entry, int time = 0);

/// The findings for an entry of a listing, from headers alone: its problems, and whether it is one
/// of several stacks.
[[nodiscard]] std::vector<SeriesFinding> seriesFindings(
    const StudyListing& listing, const SeriesEntry& entry);

/// The findings for a volume: problems of the original slices, including those found while
/// decoding, with what was done about them. Other stacks and duplicates are included if
/// Volume::alternatives lists them.
[[nodiscard]] std::vector<SeriesFinding> seriesFindings(const Volume& volume);

} // namespace core
