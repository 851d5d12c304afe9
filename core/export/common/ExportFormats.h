// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <span>

namespace core {

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

/// Where the axes of a surface point: LPS to the left, posterior and superior, as DICOM has it; RAS
/// to the right, anterior and superior.
enum class MeshSpace { Lps, Ras };

/// What is to be known of a format before anything is written.
struct ExportFormatFacts {
    ExportFormat format = ExportFormat::DicomSeg;
    const char* name = ""; ///< as recipes say it: "dicom-seg"
    const char* ending = ""; ///< of a file's name, as it is proposed: ".nii.gz"
    const char* otherEnding = ""; ///< that will do as well; may be empty
    bool anyEnding = false; ///< the name may end as it likes
    bool namesSourceImages = false; ///< only where dicomSegObstacle() is empty
    bool isSurface = false; ///< a MeshSpace is to be chosen
    bool isSeg = false; ///< a DICOM SEG: SegSettings apply, every segment has a code
    bool isStatistics = false; ///< numbers about segments: ExportRequest::codes are needed
    const char* title = ""; ///< for a list: "DICOM SEG"
    const char* says = ""; ///< a clause: "one object, references the source images"
};

/// All of them, in the order of a list.
[[nodiscard]] std::span<const ExportFormatFacts> exportFormats();
[[nodiscard]] const ExportFormatFacts& factsOf(ExportFormat format);
[[nodiscard]] std::optional<ExportFormat> exportFormatNamed(const QString& name);
/// The first whose names end so; none: no format's do.
[[nodiscard]] std::optional<ExportFormat> exportFormatOfFile(const QString& file);
/// "dicom-seg", "nifti" …
[[nodiscard]] QStringList exportFormatNames();
/// Why a file of this format cannot have that name, as a clause; empty if it can.
[[nodiscard]] QString exportNameObstacle(ExportFormat format, const QString& file);

} // namespace core
