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

/// One export of a recipe.
struct RecipeExport {
    enum class What { Segments, Coverage, CarvedVolume };
    What what = What::Segments;
    ExportFormat format = ExportFormat::DicomSeg; ///< for segments
    QString file; ///< for a carved volume also a folder that does not exist yet
    int layer = 0; ///< for coverage
    std::optional<double> fill{}; ///< for a carved volume: modality units
    MeshSpace space = MeshSpace::Lps; ///< for surfaces
    SegSettings seg{}; ///< for DICOM SEG; its codes are in `codes` until the segments are known
    std::map<QString, SegCodes> codes{}; ///< by name of a segment
    std::optional<DeidentifyOptions> deidentify{}; ///< none: the patient's identity is kept
    QByteArray secret{}; ///< for de-identification; empty: a random one for the run
};

/// One entry of "export". Errors: InvalidField ("export.layer").
[[nodiscard]] Result<RecipeExport> exportFromJson(const QJsonValue& json);

/// The files that are written: the target itself and, for a report (SR), the SEG beside it.
[[nodiscard]] QStringList filesWritten(const RecipeExport& target);

/// Checks, from a target's name and place, whether it can be written.
/// Errors: UnsupportedFormat, FileExists (unless @p replaceExisting), FileUnwritable.
[[nodiscard]] Result<void> checkExportTarget(
    const RecipeExport& target, const Volume& volume, bool replaceExisting);

} // namespace core
