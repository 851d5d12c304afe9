// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegWriter.h"

namespace core {

/// Writes a LABELMAP DICOM SEG (supplement 243) at @p path, which it creates or overwrites: a frame
/// a slice, a pixel the number of its segment, 0 the background, which is described as such.
///
/// @param content of type LabelMap: its frames name no segment, its pixels are bytes
/// Patient, places and errors: as writeSeg().
Result<SegWritten> writeLabelMapSeg(
    const QString& path, const SegContent& content, const Progress& progress);

} // namespace core
