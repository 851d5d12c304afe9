// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <vector>

class DcmDataset;

namespace core {

/// The frames of an object whose functional groups state the position and meaning of values of each
/// frame, or whose frames lie in a row (FramesInARow.h), in the order of the file. Only for sources
/// of core/dicom.
///
/// If nothing is stated for individual frames, it returns a single header with framesUnplaced set;
/// colour objects also give a single header. If something is stated for the first frames only, one
/// more header without a position stands for all others (framesWithoutGroup).
/// @param whole what the data set states about all frames
[[nodiscard]] std::vector<ImageHeader> framesOf(
    DcmDataset& set, const QByteArray& characterSet, const ImageHeader& whole);

} // namespace core
