// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/export/common/ExportMask.h"

#include <QJsonValue>
#include <QString>

#include <map>
#include <optional>

namespace core {

struct RecipeExport {
    enum class What { Segments, Coverage, CarvedVolume };
    What what = What::Segments;
    ExportFormat format = ExportFormat::DicomSeg; ///< of segments
    QString file; ///< of a carved volume also a folder that is not there yet
    int layer = 0; ///< of coverage
    std::optional<double> fill{}; ///< of a carved volume: modality units
    MeshSpace space = MeshSpace::Lps; ///< of surfaces
    SegSettings seg{}; ///< of DICOM SEGs; its codes are in `codes` until the segments are known
    std::map<QString, SegCodes> codes{}; ///< by name of a segment
    std::optional<DeidentifyOptions> deidentify{}; ///< none: the patient stays named
    QByteArray secret{}; ///< of de-identification; empty: one drawn for the run
};

/// One entry of "export". Errors: InvalidField ("export.layer").
[[nodiscard]] Result<RecipeExport> exportFromJson(const QJsonValue& json);

/// The files that a target is written into: its own, and of a report (SR) the SEG beside it.
[[nodiscard]] QStringList filesWritten(const RecipeExport& target);

/// What a target's name and place say of whether it can be written.
/// Errors: UnsupportedFormat, FileExists (unless @p replaceExisting), FileUnwritable.
[[nodiscard]] Result<void> checkExportTarget(
    const RecipeExport& target, const Volume& volume, bool replaceExisting);

} // namespace core
