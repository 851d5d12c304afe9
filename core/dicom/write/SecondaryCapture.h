// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/source/SourceHeader.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <QString>

#include <memory>
#include <span>
#include <vector>

namespace core {

/// A picture of a screen.
struct ScreenPicture {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> rgb; ///< row by row from the top, three bytes per pixel
    bool showsPatient = true; ///< its pixels show text that may name the patient
};

struct SecondaryCaptureContent {
    StudyIdentity identity; ///< of the study that is shown
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< of these; null: their files are read
    ScreenPicture picture;
};

/// Writes a Secondary Capture image (PS3.3 A.8.1) with the sources' patient and study, in a series
/// of its own, to @p path, which is created or overwritten.
/// @returns sentences on what was normalised or left out of the source's header
/// Errors: as for writeSeg(); UnsupportedFormat for more than 65535 pixels per side.
[[nodiscard]] Result<ReportLines> writeSecondaryCapture(
    const QString& path, const SecondaryCaptureContent& content, const Progress& progress);

/// The parts of such a file that the check compares.
struct SecondaryCaptureFile {
    HeaderPatient patient;
    QString studyUid;
    QString seriesUid;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Errors: FileNotFound, FileUnreadable, FileTruncated, UnsupportedFormat.
[[nodiscard]] Result<SecondaryCaptureFile> readSecondaryCapture(const QString& path);

} // namespace core
