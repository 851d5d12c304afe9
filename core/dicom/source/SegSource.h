// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <QStringList>

#include <array>
#include <memory>
#include <string>
#include <vector>

class DcmDataset;

namespace core {

/// What a SEG takes from the instance of one slice: numbers as their original text (DS).
struct SegSlice {
    std::array<std::string, 3> position;
    std::array<std::string, 6> orientation;
    std::array<std::string, 2> spacing; ///< row, column
    std::string sliceThickness; ///< may be empty
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::string seriesUid;
    int frame = 0; ///< 0-based
    bool multiFrame = false; ///< the instance has several frames, so a reference must name one
};

/// What writeSeg() needs from the headers of the sources. Only for sources of core/dicom.
struct SegSource {
    std::vector<SegSlice> slices;
    /// Patient, study and frame of reference from the header of the first slice, in UTF-8 and only
    /// with values that DICOM allows.
    std::unique_ptr<DcmDataset> header;
    std::string lossyCompression; ///< "01" if a source states it
    std::string lossyRatio;
    std::string lossyMethod;
    std::string bodyPart;
    ReportLines notes; ///< what was normalised or left out

    SegSource();
    SegSource(SegSource&&) noexcept;
    SegSource& operator=(SegSource&&) noexcept;
    ~SegSource();
};

/// @param kept replaces the files (visitSourceFiles()); null: the files are read
Result<SegSource> readSegSource(
    const std::vector<SourceSlice>& sources, const KeptHeaders* kept, const Progress& progress);

/// A decimal string of at most 16 characters (PS3.5 6.2), as precise as that allows.
std::string decimalString(double value);

} // namespace core
