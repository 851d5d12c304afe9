// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <vector>

class DcmDataset;

namespace core {

/// An object that claims more frames is not read: each costs a header.
constexpr int mostFrames = 65535;

/// The frames of an object for which haveFramesInARow() holds (SopClass.h), in the order of the
/// file. Only for sources of core/dicom.
///
/// If it does not say where each of them lies, or they are no slices (projections, phases of a
/// heart), it returns a single header with framesUnplaced set.
/// @param whole what the data set states about all frames
[[nodiscard]] std::vector<ImageHeader> framesInARow(
    DcmDataset& set, const QByteArray& characterSet, const ImageHeader& whole);

} // namespace core
