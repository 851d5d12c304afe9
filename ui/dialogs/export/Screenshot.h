// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/export/ScreenshotExport.h"

#include <QString>

class QImage;
class QWidget;

namespace ui {

class Workspace;

/// Whether this name is that of a DICOM Secondary Capture, that is, ends in .dcm.
[[nodiscard]] bool isDicomPicture(const QString& file);

/// Why a picture cannot have this name, whose ending is that of another kind of picture, as a
/// clause; empty: it can.
[[nodiscard]] core::Clause pictureNameObstacle(const QString& file);

/// Writes a picture of the window. If the name ends in .dcm it becomes a DICOM Secondary Capture in
/// the volume's study, which is read again and checked; else a PNG, without checksum and patient
/// data. Replaces a file of that name. Errors: those of core::exportScreenshot(); FileUnwritable;
/// UnsupportedFormat (pictureNameObstacle()).
[[nodiscard]] core::Result<core::ExportReport> savePicture(
    const QImage& picture, const core::Volume* volume, const QString& file);

/// Takes a picture of the window, asks for a file name, and saves it.
/// @return a sentence about what was written and checked; empty if nothing was
[[nodiscard]] QString askAndSavePicture(Workspace& workspace, QWidget& window);

} // namespace ui
