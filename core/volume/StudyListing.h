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

/// One volume that can be opened, as described by headers alone.
///
/// Most DICOM series are one entry. A series whose slices differ in plane, size, frame of reference
/// or time has several entries, each with its own key.
struct SeriesEntry {
    /// The name that `loadVolume` and `--series` take: the SeriesInstanceUID; "UID#2" if several
    /// volumes share a UID; a name made from the header if the files have no UID; the file name of
    /// a NIfTI file.
    QString key{};
    StudyIdentity identity;
    VolumeGeometry geometry;
    QString unit; ///< "HU" for CT, else what the source says; may be empty
    Clause part; ///< which part of a split series; empty for a whole series
    std::vector<VolumeProblem> problems; ///< those that are visible from headers
    QStringList files{}; ///< one per slice k, or a single one that holds the volume
    /// For a series in time: what distinguishes its points, in order ("temporal
    /// position 3"); a text may be empty. Empty for a volume of one moment. All other members
    /// describe the first point.
    Clauses times{};
    /// The grid with one image at each position, if several images share positions and one of them
    /// can be chosen ("duplicates=first").
    std::optional<VolumeGeometry> undoubled{};
    /// For files that need not state the spacing of voxels (pictures): the spacing that they state,
    /// with 0 where there is none; the geometry then has 1 mm. None: the format always states it.
    std::optional<glm::dvec3> saidSpacingMm{};

    /// Whether it can only be opened with a spacing after its name ("KEY+spacing=0.5x0.5x2").
    [[nodiscard]] bool needsSpacing() const;
    [[nodiscard]] int slices() const { return geometry.size.z; }
    /// False for a single image, which is opened only on request or if there is nothing else.
    [[nodiscard]] bool isVolume() const { return slices() > 1; }
    /// An RT dose, which lies beside the images that it was planned on.
    [[nodiscard]] bool isDose() const { return identity.modality == QLatin1String("RTDOSE"); }
    /// The name that `loadVolume` and `--series` take for a point in time, 0-based: "UID@3" is the
    /// third; the key itself names the first.
    [[nodiscard]] QString keyAtTime(int time) const;
    /// One line for a list: key, patient, date, description, slices, problems.
    [[nodiscard]] Clause line() const;
};

/// A volume, by name; the point in time if it is a series in time (SeriesEntry::keyAtTime()); and
/// its repair (core/repair/SeriesRepair.h).
struct SeriesChoice {
    QString series;
    int time = 0; ///< 0-based
    QString repair{}; ///< empty: none
};

/// One study and its volumes, ordered by series number.
struct StudyEntry {
    QString studyUid; ///< from the files, or a name made from the header
    std::vector<SeriesEntry> series{};
};

/// Valid files that are not slices of a volume: SEG, RTSTRUCT, reports, DICOMDIR, localizers,
/// colour screens, multi-frame images. They are listed beside the volumes and are never an error.
struct ForeignObject {
    Clause kind; ///< "localizer", "DICOM SEG", …
    Clause reason{}; ///< why it is no volume; may be empty
    StudyIdentity identity{};
    QStringList files{};
};

/// A file that could not be used, and why.
struct UnreadableFile {
    QString file;
    Error error; ///< arguments: the file, the reason
};

/// The contents of a folder or file.
struct StudyListing {
    QString path;
    std::vector<StudyEntry> studies;
    std::vector<ForeignObject> foreign;
    std::vector<UnreadableFile> unreadable;

    /// The entries that may be opened without asking: the volumes, or single images if there is no
    /// volume. A dose beside images is none of them; it must be requested by its key.
    [[nodiscard]] std::vector<const SeriesEntry*> candidates() const;
    [[nodiscard]] const SeriesEntry* find(const QString& key) const;
    /// All entries whose key or SeriesInstanceUID is @p series; several if a UID was split.
    [[nodiscard]] std::vector<const SeriesEntry*> matching(const QString& series) const;
    /// Parses "UID@3+tilt": a repair follows the plus sign, and "@3" is a point in time if an entry
    /// has it. A name that equals that of an entry means this entry, whatever signs it contains.
    [[nodiscard]] SeriesChoice choice(const QString& series) const;
    /// The volume that the name means, if it cannot be opened because the name lacks its spacing;
    /// else null.
    [[nodiscard]] const SeriesEntry* lacksSpacing(const QString& series) const;
};

} // namespace core
