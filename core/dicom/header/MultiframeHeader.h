// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <vector>

class DcmDataset;

namespace core {

/// The frames of an object whose functional groups say of each where it lies and what its values
/// mean, in the order of the file (DICOM.md 1.6). Only for sources of core/dicom.
///
/// One header, with framesUnplaced set, for several frames of which nothing is said one by one;
/// colour stays one header, too.
/// @param whole what the data set says about all of them
[[nodiscard]] std::vector<ImageHeader> framesOf(
    DcmDataset& set, const QByteArray& characterSet, const ImageHeader& whole);

} // namespace core
