// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/base/words/Clauses.h"
#include "core/volume/ProblemSentence.h"
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

/// Grey mapping in modality units (DICOM PS3.3 C.11.2.1); gpu/scene/WindowMapping.h says by which
/// function.
struct WindowLevel {
    double centre = 40.0;
    double width = 400.0;
    bool operator==(const WindowLevel&) const = default;
};

/// The patient, study and series of a volume, as far as the source gives them. Text is Unicode.
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

/// The headers of source files by file name, for a volume whose files may be missing. For DICOM, a
/// data set in explicit VR little endian (core/dicom/source/KeptHeaders.h); for NIfTI, the bytes of
/// the header.
using KeptHeaders = std::map<QString, QByteArray>;

/// Slices, counted from 1 along row × column direction, both ends included.
struct SliceSpan {
    int first = 0;
    int last = 0;
    bool operator==(const SliceSpan&) const = default;
};

/// "slice 5", "slices 2–4, 7" in a sentence; spans in ascending order.
[[nodiscard]] ProblemSentence::Argument slicesInWords(const std::vector<SliceSpan>& slices);

/// Something about the source that a user must know before trusting a measurement.
struct VolumeProblem {
    enum class Kind {
        MissingSlices,
        UnevenSpacing,
        Tilt,
        AssumedSpacing,
        MixedSlices, ///< several images at every position: points in time
        DoubledSlices, ///< several images at some positions
        DuplicateSlices, ///< files with the identity of another
        DamagedSlice,
        LossyCompression,
        InexactValues,
        Other,
    };
    Kind kind = Kind::Other;
    ProblemSentence said{}; ///< one plain sentence
    /// the geometry is doubtful; a warning is shown until it is repaired or accepted
    bool caution = false;
    /// The slices concerned; for a gap, the two beside it. Empty: all.
    std::vector<SliceSpan> slices{};
    /// What was done about it on loading, in the form of `--repair` ("gap=fill"); empty: nothing.
    QString repairedBy{};
};

/// The original slices of a repaired volume. What is drawn on the repaired voxels is transferred
/// back to them (core/repair/WayBack.h).
struct SeriesAsIs {
    VolumeGeometry geometry;
    std::vector<SourceSlice> sources; ///< per slice
};

/// What else the volume's series can be opened as, while its study is available.
struct SeriesAlternatives {
    struct Stack {
        QString key; ///< what `--series` takes
        Clause part; ///< which of the stacks it is
        VolumeGeometry geometry;
    };
    QString key; ///< that of the volume, without the point in time
    Clause part; ///< which of several stacks it is; empty if it is the only one
    std::vector<Stack> stacks{}; ///< the others
    Clauses times{}; ///< for a series in time, what distinguishes its points; else empty
    int time = 0; ///< which of these points it is, 0-based
    std::optional<VolumeGeometry> undoubled{}; ///< SeriesEntry::undoubled
};

/// Voxel codes, both ends included.
struct CodeRange {
    int lowest = 0;
    int highest = 0;
    bool operator==(const CodeRange&) const = default;
};

/// Voxel counts in equal bins of the value range; for display, not for decisions.
struct Histogram {
    double minimum = 0.0;
    double maximum = 0.0;
    std::vector<std::uint32_t> counts;
};

/// The description of the study's voxels, which themselves are only on the GPU. It never changes.
struct Volume {
    StudyIdentity identity;
    VolumeGeometry geometry;
    VoxelEncoding encoding;
    QString unit; ///< "HU" for CT, "SUVbw" …, else what the source says; may be empty
    double minimum = 0.0;
    double maximum = 0.0;
    Histogram histogram;
    WindowLevel defaultWindow;
    bool displayInverted = false; ///< MONOCHROME1: dark is high; voxels are unchanged
    /// Per slice k; empty for formats without instances, and if a repair moved the voxels.
    std::vector<SourceSlice> sources;
    /// How its series was repaired on loading, in the form of `--repair`
    /// (core/repair/SeriesRepair.h); empty: it is as in its files.
    QString repair;
    std::shared_ptr<const SeriesAsIs> asIs; ///< set if there is a repair
    QString sourcePath; ///< folder or file that was opened
    /// which of the volumes there this is (SeriesEntry::keyAtTime()); may be empty
    QString seriesKey;
    std::shared_ptr<const SeriesAlternatives> alternatives; ///< null: its study is not available
    QString sourceFormat; ///< "DICOM", "NIfTI"
    QByteArray voxelsSha256; ///< hex; float32 little-endian modality values, x fastest
    /// Hex, of the codes, little-endian; only if the values do not follow from the codes.
    QByteArray codesSha256;
    /// For a volume from a session file: replaces its source files, which are then not read. Null:
    /// the files are read.
    std::shared_ptr<const KeptHeaders> keptHeaders;
    std::vector<VolumeProblem> problems;

    [[nodiscard]] bool needsCaution() const;
};

/// A volume together with its codes, for the engine (x fastest, then y, then z).
struct LoadedVolume {
    Volume volume;
    std::vector<std::uint16_t> codes;
    /// Codes of voxels outside the scanned region, if the source states them.
    std::optional<CodeRange> padding{};
    /// Why the voxels come from a session file; none: they come from the study's own files.
    std::optional<Error> notFromStudy{};
};

} // namespace core
