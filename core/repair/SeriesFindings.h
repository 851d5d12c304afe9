// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/StudyListing.h"
#include "core/volume/Volume.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace core {

/// Something that can be done about a finding; ui::repairTitle() and ui::repairEffect() word it.
struct RepairOffer {
    enum class Kind : std::uint8_t {
        ShearTilt, ///< the tilt is sheared away; the picture gets more columns and rows
        FillGaps, ///< `made` slices are interpolated, `kept` keep their values
        EvenSpacing, ///< slices are interpolated at even distances from the `kept` existing ones
        Part, ///< only slices first to last are opened: part number `part` of `parts`
        FirstDuplicates,
        LastDuplicates,
        GivenSpacing, ///< with the spacing that was stated on opening
        OtherStack, ///< another stack of the series is opened: `stack`
        AsRepaired, ///< repaired on opening by something that is no single offer: `repair`
    };
    Kind kind = Kind::AsRepaired;
    QString repair{}; ///< in the form of `--repair`; empty: another series is opened instead
    QString series{}; ///< another stack or point in time, in the form of `--series`; else empty
    VolumeGeometry result{}; ///< the grid with this repair alone
    int columns = 0;
    int rows = 0;
    int made = 0;
    int kept = 0;
    int first = 0; ///< 1-based
    int last = 0;
    int part = 0; ///< 1-based
    int parts = 0;
    Clause stack{}; ///< SeriesAlternatives::Stack::part
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
