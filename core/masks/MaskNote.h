// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ProblemSentence.h"

#include <QStringList>

#include <cstdint>

namespace core {

/// What was resampled, left out or assumed when a mask was read; ui::maskNoteText() words it.
struct MaskNote {
    enum class Code : std::uint8_t {
        AnotherGrid, ///< the nearest voxel decides; fileMl, hereMl
        OutsideStudy, ///< `some` of `all` voxels are left out
        AnotherPatient, ///< than the study's; no name is told
        AnotherFrameOfReference, ///< its millimetres are taken for the study's
        SegmentsOverlap, ///< in `some` voxels
        /// the first segment of `names` before the second, in `some` voxels, hereMl, of both
        GoesBefore,
        OverlapsKept, ///< the segments lie in `some` label planes
        SegmentsWithoutVoxel, ///< `some` of the file's `all` segments, left out
        NothingSurrounded, ///< by the segments of `names`, left out
        Fractional, ///< voxels with one half or more are taken
        BetweenSlices, ///< the nearest contours, at most `mm` away, decide
        OpenContours, ///< of the segment `names`, left out
        UnnamedAxes, ///< taken for LPS, in millimetres
        TwoFaced, ///< triangles of the segment `names`: inside is what an odd number surrounds
        Enclosed, ///< by the segment `names`; fileMl, hereMl: the voxels with their centres inside
        GridInDoubt, ///< `doubt`
        MapOnAnotherGrid, ///< a probability map: its nearest voxel decides
    };
    Code code = Code::AnotherGrid;
    QStringList names{};
    std::uint64_t some = 0;
    std::uint64_t all = 0;
    double fileMl = 0.0; ///< in the file
    double hereMl = 0.0; ///< in the volume
    double mm = 0.0;
    ProblemSentence doubt{}; ///< VolumeProblem::said

    bool operator==(const MaskNote&) const = default;
};

} // namespace core
