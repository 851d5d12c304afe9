// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>

namespace core {

/// The formats of masks, surfaces and statistics that can be written.
enum class ExportFormat {
    DicomSeg,
    DicomSegFractional,
    DicomSegLabelMap,
    RtStruct,
    Nifti,
    SegNrrd,
    Stl,
    Obj,
    Ply,
    Gltf,
    Csv,
    Json,
    Sr
};

/// The axes of a surface: LPS to the left, posterior and superior, as in DICOM; RAS to the right,
/// anterior and superior.
enum class MeshSpace { Lps, Ras };

/// The properties of a format; ui/texts/ExportFormatTexts.h says what it is called.
struct ExportFormatFacts {
    ExportFormat format = ExportFormat::DicomSeg;
    const char* name = ""; ///< the name in recipes: "dicom-seg"
    const char* ending = ""; ///< proposed file name extension: ".nii.gz"
    const char* otherEnding = ""; ///< also accepted; may be empty
    bool anyEnding = false; ///< any file name extension is accepted
    bool namesSourceImages = false; ///< available only if dicomSegObstacle() is empty
    bool isSurface = false; ///< a MeshSpace must be chosen
    bool isSeg = false; ///< a DICOM SEG: SegSettings apply, and every segment needs a code
    bool holdsCodes = false; ///< SegCodes of segments apply, where they have a type
    bool isStatistics = false; ///< numbers about segments; needs ExportRequest::codes
};

/// All formats, in the order of a list.
[[nodiscard]] std::span<const ExportFormatFacts> exportFormats();
[[nodiscard]] const ExportFormatFacts& factsOf(ExportFormat format);
[[nodiscard]] std::optional<ExportFormat> exportFormatNamed(const QString& name);
/// The first format with this file name extension; none if there is none.
[[nodiscard]] std::optional<ExportFormat> exportFormatOfFile(const QString& file);
/// "dicom-seg", "nifti" …
[[nodiscard]] QStringList exportFormatNames();
/// Why a file of this format cannot have that name, as a clause; empty if it can.
[[nodiscard]] Clause exportNameObstacle(ExportFormat format, const QString& file);

} // namespace core
