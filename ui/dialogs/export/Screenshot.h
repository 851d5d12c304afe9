// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/ScreenshotExport.h"

#include <QString>

class QImage;
class QWidget;

namespace ui {

class Workspace;

/// Whether a picture of this name is a DICOM Secondary Capture: it ends in .dcm.
[[nodiscard]] bool isDicomPicture(const QString& file);

/// Writes a picture of the window: as DICOM Secondary Capture of the volume's patient and study
/// where the name ends in .dcm, read again and checked; else as PNG, without checksum and patient.
/// Replaces a file of that name. Errors: those of core::exportScreenshot(); FileUnwritable.
[[nodiscard]] core::Result<core::ExportReport> savePicture(
    const QImage& picture, const core::Volume* volume, const QString& file);

/// Takes a picture of the window as it is, asks where to, and saves it. @return what was written
/// and checked, in a sentence; empty: nothing was
[[nodiscard]] QString askAndSavePicture(Workspace& workspace, QWidget& window);

} // namespace ui
