// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"
#include "core/volume/Volume.h"

#include <QString>

#include <vector>

namespace core {

/// Something that can be done about a finding.
struct RepairOffer {
    QString repair; ///< as `--repair` takes it; empty: another series is opened instead
    QString series; ///< of another stack or point in time: what `--series` takes; else empty
    QString title; ///< "Fill the gaps"
    QString effect; ///< what it does to which slices; a sentence or two
    VolumeGeometry result; ///< the grid with this repair alone
};

/// What was found about a series, and what can be done about it. Opening it as it is can always.
struct SeriesFinding {
    VolumeProblem problem;
    std::vector<RepairOffer> offers{};
};

/// What else an entry's series can be opened as. @param time the point that is opened, 0-based
[[nodiscard]] SeriesAlternatives seriesAlternatives(
    const StudyListing& listing, const SeriesEntry& entry, int time = 0);

/// The findings of an entry of a listing, from headers alone: its problems, and that it is one of
/// several stacks where it is.
[[nodiscard]] std::vector<SeriesFinding> seriesFindings(
    const StudyListing& listing, const SeriesEntry& entry);

/// The findings of a volume: what was found on the slices as they are, also on decoding them, with
/// what was done about it. Other stacks and duplicates while Volume::alternatives knows of them.
[[nodiscard]] std::vector<SeriesFinding> seriesFindings(const Volume& volume);

} // namespace core
