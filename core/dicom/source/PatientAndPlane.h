// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ItemReader.h"
#include "core/dicom/source/SourceHeader.h"

class DcmDataset;

namespace core {

// Shared by the readers that check an export. Only for sources of core/dicom.

HeaderPatient readHeaderPatient(DcmDataset& dataset);

/// The plane of a frame, from functional groups or, in single-frame objects and those with frames
/// in a row (SopClass.h), from the top level.
std::optional<HeaderPlane> readHeaderPlane(const ItemReader& dataset, int frame);

} // namespace core
