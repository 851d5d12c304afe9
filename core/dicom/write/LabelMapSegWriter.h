// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegWriter.h"

namespace core {

/// Writes a LABELMAP DICOM SEG (supplement 243) to @p path, which is created or overwritten: one
/// frame per slice, each pixel the number of its segment. 0 is the background, which has a
/// description of its own.
///
/// @param content of type LabelMap: its frames have no segment, its pixels are bytes
/// Patient, positions and errors: as for writeSeg().
Result<SegWritten> writeLabelMapSeg(
    const QString& path, const SegContent& content, const Progress& progress);

} // namespace core
