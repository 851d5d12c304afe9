// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

class DcmFileFormat;

namespace core {

/// Writes a DICOM file completely, or returns the system's error: DCMTK's own saveFile() does not
/// notice when the disk becomes full. For sources of core/dicom. Errors: FileUnwritable.
[[nodiscard]] Result<void> saveDicom(
    DcmFileFormat& format, const QString& path, const char* transferSyntaxUid);

} // namespace core
