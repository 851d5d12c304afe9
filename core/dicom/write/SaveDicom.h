// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

class DcmFileFormat;

namespace core {

/// Writes a DICOM file to its last byte, or tells what the system says against it: DCMTK's own
/// saveFile() does not notice a disk that fills up. For sources of core/dicom.
/// Errors: FileUnwritable.
[[nodiscard]] Result<void> saveDicom(
    DcmFileFormat& format, const QString& path, const char* transferSyntaxUid);

} // namespace core
