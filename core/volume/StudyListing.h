// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <vector>

namespace core {

/// What can be opened as one volume, known from headers alone.
///
/// Most DICOM series are one entry. A series whose slices differ in plane, size, frame of reference
/// or time is several; each is named by its key.
struct SeriesEntry {
    /// What `loadVolume` and `--series` take: the SeriesInstanceUID; "UID#2" where one UID holds
    /// several volumes; a name made from the header where the files carry no UID; the file name of
    /// a NIfTI file.
    QString key{};
    StudyIdentity identity;
    VolumeGeometry geometry;
    QString unit; ///< "HU" for CT, else what the source says; may be empty
    QString part; ///< which part of a split series, in words; empty for a whole one
    std::vector<VolumeProblem> problems; ///< those that headers show
    QStringList files{}; ///< per slice k; one where a file is the volume
    /// What tells the points of a series in time apart, in words, in order ("temporal position 3");
    /// a word may be empty. Empty for a volume of one moment. The rest here is about the first.
    QStringList times{};
    /// The grid with one image at every place, where several share some and one can be chosen of
    /// them ("duplicates=first").
    std::optional<VolumeGeometry> undoubled{};
    /// Of files that need not say how far apart voxels are (pictures): what they say, 0 where
    /// nothing; the geometry has 1 mm there. None: the source says it.
    std::optional<glm::dvec3> saidSpacingMm{};

    /// Whether it opens only with the spacing behind its name ("KEY+spacing=0.5x0.5x2").
    [[nodiscard]] bool needsSpacing() const;
    [[nodiscard]] int slices() const { return geometry.size.z; }
    /// False for a single image: it opens when asked for, or when there is nothing else.
    [[nodiscard]] bool isVolume() const { return slices() > 1; }
    /// What `loadVolume` and `--series` take for a point in time, 0-based: "UID@3" is the third;
    /// the key itself names the first.
    [[nodiscard]] QString keyAtTime(int time) const;
    /// One line for a list: key, patient, date, description, slices, problems.
    [[nodiscard]] QString line() const;
};

/// What names a volume, of a series in time which point (SeriesEntry::keyAtTime()), and how it is
/// repaired (core/repair/SeriesRepair.h).
struct SeriesChoice {
    QString series;
    int time = 0; ///< 0-based
    QString repair{}; ///< empty: as it is
};

/// One study and its volumes, series in the order of their numbers.
struct StudyEntry {
    QString studyUid; ///< as the files say, else a name made from the header
    std::vector<SeriesEntry> series{};
};

/// Sound files that are no slices of a volume: SEG, RTSTRUCT, reports, DICOMDIR, localizers, colour
/// screens, multi-frame images. Listed beside the volumes, never an error.
struct ForeignObject {
    QString kind; ///< "localizer", "DICOM SEG", …
    QString reason{}; ///< why it is no volume; may be empty
    StudyIdentity identity{};
    QStringList files{};
};

/// A file that could not be used, and why.
struct UnreadableFile {
    QString file;
    Error error; ///< arguments: the file, the reason
};

/// What a folder or file holds.
struct StudyListing {
    QString path;
    std::vector<StudyEntry> studies;
    std::vector<ForeignObject> foreign;
    std::vector<UnreadableFile> unreadable;

    /// What may be opened without a choice being guessed: the volumes; single images where there is
    /// no volume.
    [[nodiscard]] std::vector<const SeriesEntry*> candidates() const;
    [[nodiscard]] const SeriesEntry* find(const QString& key) const;
    /// Every entry whose key or SeriesInstanceUID is @p series: several where a UID was split.
    [[nodiscard]] std::vector<const SeriesEntry*> matching(const QString& series) const;
    /// Takes "UID@3+tilt" apart: what follows the plus sign is a repair, and "@3" a point in time
    /// where an entry has it. The name of an entry is that entry's, whatever signs are in it.
    [[nodiscard]] SeriesChoice choice(const QString& series) const;
    /// The volume that this name would open, where it does not without its spacing: none is in it.
    [[nodiscard]] const SeriesEntry* lacksSpacing(const QString& series) const;
};

} // namespace core
