// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/volume/VolumeGeometry.h"
#include "core/volume/VoxelEncoding.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Grey mapping of slices in modality units (DICOM PS3.3 C.11.2.1.2, LINEAR).
struct WindowLevel {
    double centre = 40.0;
    double width = 400.0;
    bool operator==(const WindowLevel&) const = default;
};

/// Whose study it is, as the source says; empty where it does not. Text is Unicode.
struct StudyIdentity {
    QString patientName;
    QString patientId;
    QString birthDate; ///< YYYY-MM-DD
    QString sex;
    QString studyUid;
    QString studyDate; ///< YYYY-MM-DD
    QString studyDescription;
    QString accessionNumber;
    QString seriesUid;
    QString seriesNumber;
    QString seriesDescription;
    QString modality; ///< CT, MR, PT …; empty for files that do not say
    QString frameOfReferenceUid;
    QString patientPosition; ///< HFS …; information only, the geometry decides
};

/// The instance (and frame of it) that slice k was read from.
struct SourceSlice {
    QString file;
    QString sopInstanceUid;
    QString sopClassUid;
    int frame = 0;          ///< 0-based
    int instanceNumber = 0;
};

/// Headers of source files by the files' names, for a volume whose files may be missing: of DICOM a
/// data set in explicit VR little endian (core/dicom/KeptHeaders.h), of NIfTI the header's bytes.
using KeptHeaders = std::map<QString, QByteArray>;

/// Something about the source that a reader must know before trusting a measurement.
struct VolumeProblem {
    enum class Kind {
        MissingSlices,
        UnevenSpacing,
        Tilt,
        AssumedSpacing,
        MixedSlices,
        DuplicateSlices,
        DamagedSlice,
        LossyCompression,
        InexactValues,
        Other,
    };
    Kind kind = Kind::Other;
    QString text;         ///< one plain sentence
    bool caution = false; ///< geometry that carries a caution bar until repaired or accepted
};

/// Counts of voxels over equal bins of the value range; for pictures, not for decisions.
struct Histogram {
    double minimum = 0.0;
    double maximum = 0.0;
    std::vector<std::uint32_t> counts;
};

/// The study's voxels, described; the voxels themselves live on the GPU only. Nothing changes it.
struct Volume {
    StudyIdentity identity;
    VolumeGeometry geometry;
    VoxelEncoding encoding;
    QString unit; ///< "HU" for CT, else what the source says; may be empty
    double minimum = 0.0;
    double maximum = 0.0;
    Histogram histogram;
    WindowLevel defaultWindow;
    bool displayInverted = false; ///< MONOCHROME1: dark is high; voxels are unchanged
    std::vector<SourceSlice> sources; ///< per slice k; empty for formats without instances
    QString sourcePath;               ///< folder or file that was opened
    QString sourceFormat;             ///< "DICOM", "NIfTI"
    QByteArray voxelsSha256; ///< hex; float32 little-endian modality values, x fastest
    /// Hex, of the codes, little-endian; only where the values do not follow from the codes.
    QByteArray codesSha256;
    /// Of a volume that came out of a session file: what stands for its source files, which are not
    /// read then. Null: the files are.
    std::shared_ptr<const KeptHeaders> keptHeaders;
    std::vector<VolumeProblem> problems;

    [[nodiscard]] bool needsCaution() const;
};

/// A volume together with its codes, on their way to the engine (x fastest, then y, then z).
struct LoadedVolume {
    Volume volume;
    std::vector<std::uint16_t> codes;
    /// Why they came out of a session file; none: they came from the study's own files.
    std::optional<Error> notFromStudy{};
};

} // namespace core
