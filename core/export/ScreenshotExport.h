// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SecondaryCapture.h"
#include "core/export/common/ExportMask.h"

namespace core {

/// A request to export a picture of the window.
struct ScreenshotRequest {
    QString file;
    bool force = false; ///< replace a file of that name
    ScreenPicture picture;
};

/// Writes a picture of the window as a DICOM Secondary Capture with the volume's patient and study,
/// then opens it and a source image and compares pixels, patient and study. The file appears under
/// its name only after that. Any thread.
/// Errors: UnsupportedFormat (not a DICOM study), FileExists, FileUnwritable, ExportMismatch,
/// Cancelled, and those of reading the sources.
[[nodiscard]] Result<ExportReport> exportScreenshot(
    const Volume& volume, const ScreenshotRequest& request, const Progress& progress);

/// Checks that a picture may be written under a name: the name must be free, or belong to another
/// picture of the same kind (.dcm: a Secondary Capture; else PNG). Call this before anything else
/// is open, because it reads the file. Errors: those of checkFileTarget(); FileUnwritable (it is
/// something else).
[[nodiscard]] Result<void> checkPictureTarget(const QString& file);

} // namespace core
