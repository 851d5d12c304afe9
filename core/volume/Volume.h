// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/volume/VolumeGeometry.h"
#include "core/volume/VoxelEncoding.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

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
    int frame = 0; ///< 0-based
    int instanceNumber = 0;
};

/// Headers of source files by the files' names, for a volume whose files may be missing: of DICOM a
/// data set in explicit VR little endian (core/dicom/source/KeptHeaders.h), of NIfTI the header's
/// bytes.
using KeptHeaders = std::map<QString, QByteArray>;

/// Slices, counted from 1 along row × column direction, both ends included.
struct SliceSpan {
    int first = 0;
    int last = 0;
    bool operator==(const SliceSpan&) const = default;
};

/// "slice 5", "slices 2–4, 7"; spans in ascending order.
[[nodiscard]] QString slicesInWords(const std::vector<SliceSpan>& slices);

/// Something about the source that a reader must know before trusting a measurement.
struct VolumeProblem {
    enum class Kind {
        MissingSlices,
        UnevenSpacing,
        Tilt,
        AssumedSpacing,
        MixedSlices, ///< several images at every place: points in time
        DoubledSlices, ///< several images at some places
        DuplicateSlices, ///< files with the identity of another
        DamagedSlice,
        LossyCompression,
        InexactValues,
        Other,
    };
    Kind kind = Kind::Other;
    QString text; ///< one plain sentence
    bool caution = false; ///< geometry that carries a caution bar until repaired or accepted
    /// Which slices it is about; beside a gap the two that it lies between. Empty: all of them.
    std::vector<SliceSpan> slices{};
    /// What was done about it on loading, as `--repair` takes it ("gap=fill"); empty: nothing.
    QString repairedBy{};
};

/// The slices of a repaired volume as their images have them; what is drawn on the repaired voxels
/// finds its way back to them (core/repair/WayBack.h).
struct SeriesAsIs {
    VolumeGeometry geometry;
    std::vector<SourceSlice> sources; ///< per slice
};

/// What else a volume's series can be opened as, while its study is at hand.
struct SeriesAlternatives {
    struct Stack {
        QString key; ///< what `--series` takes
        QString part; ///< which of the stacks it is, in words
        VolumeGeometry geometry;
    };
    QString key; ///< its own, without the point in time
    QString part; ///< which of several stacks it is, in words; empty where it is the only one
    std::vector<Stack> stacks{}; ///< the others
    QStringList times{}; ///< of a series in time what tells its points apart; else empty
    int time = 0; ///< which of them it is, 0-based
    std::optional<VolumeGeometry> undoubled{}; ///< SeriesEntry::undoubled
};

/// Voxel codes, both ends included.
struct CodeRange {
    int lowest = 0;
    int highest = 0;
    bool operator==(const CodeRange&) const = default;
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
    /// Per slice k; empty for formats without instances, and where a repair moved the voxels.
    std::vector<SourceSlice> sources;
    /// How its series was repaired on loading, as `--repair` takes it (core/repair/SeriesRepair.h);
    /// empty: it is as its files have it.
    QString repair;
    std::shared_ptr<const SeriesAsIs> asIs; ///< where there is a repair
    QString sourcePath; ///< folder or file that was opened
    QString seriesKey; ///< which of its volumes this is (SeriesEntry::keyAtTime()); may be empty
    std::shared_ptr<const SeriesAlternatives> alternatives; ///< null: its study is not at hand
    QString sourceFormat; ///< "DICOM", "NIfTI"
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
    /// Codes of voxels outside what was scanned, where the source says so.
    std::optional<CodeRange> padding{};
    /// Why they came out of a session file; none: they came from the study's own files.
    std::optional<Error> notFromStudy{};
};

} // namespace core
