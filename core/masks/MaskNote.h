// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ProblemSentence.h"

#include <QStringList>

#include <cstdint>

namespace core {

/// Something that was resampled, left out or assumed when a mask was read; ui::maskNoteText() puts
/// it into words. Each code states which of the other fields it uses.
struct MaskNote {
    enum class Code : std::uint8_t {
        AnotherGrid, ///< the grids differ, and the nearest voxel decides; fileMl, hereMl
        OutsideStudy, ///< `some` of `all` voxels are left out
        AnotherPatient, ///< the mask belongs to another patient than the study; no names are given
        /// Its frame of reference differs, and its coordinates are used as if it were the same.
        AnotherFrameOfReference,
        SegmentsOverlap, ///< segments of the mask overlap in `some` voxels
        /// Where two segments overlap, the first of `names` takes precedence over the second: in
        /// `some` voxels, hereMl.
        GoesBefore,
        OverlapsKept, ///< overlaps are kept: the segments lie in `some` label planes
        /// `some` of the file's `all` segments have no voxels and are left out.
        SegmentsWithoutVoxel,
        ImagesLeftOut, ///< files of a folder whose values are those of images: `names`
        SlicesLeftOut, ///< `some` DICOM files of a folder are images
        FilesWithoutVoxel, ///< `some` of a folder's `all` files have no voxel in the study
        NothingSurrounded, ///< the segments of `names` enclose nothing and are left out
        Fractional, ///< voxels with a share or probability of at least one half are taken
        BetweenSlices, ///< for slices without contours the nearest ones, at most `mm` away, decide
        OpenContours, ///< contours of the segment in `names` that are open are left out
        UnnamedAxes, ///< the file does not name its axes; LPS and millimetres are assumed
        /// Triangles of the segment in `names` face both ways; inside is what an odd number of
        /// surfaces encloses.
        TwoFaced,
        /// Volume that the surface of the segment in `names` encloses: fileMl; hereMl: that of the
        /// voxels with their centres inside.
        Enclosed,
        GridInDoubt, ///< the geometry of the file is in doubt: `doubt`
        MapOnAnotherGrid, ///< the grid of a probability map differs, and its nearest voxel decides
    };
    Code code = Code::AnotherGrid;
    QStringList names{};
    std::uint64_t some = 0;
    std::uint64_t all = 0;
    double fileMl = 0.0; ///< volume in the file
    double hereMl = 0.0; ///< volume on the grid of the study
    double mm = 0.0;
    ProblemSentence doubt{}; ///< VolumeProblem::said

    bool operator==(const MaskNote&) const = default;
};

} // namespace core
