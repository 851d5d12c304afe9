// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QString>

#include <memory>

namespace core {

/// The contents of a file, of a folder with its subfolders, or of an archive (zip, 7z, tar). It is
/// scanned once; then its volumes can be listed and opened. An archive is unpacked into the user's
/// cache (core/archive); archives inside folders and archives are not.
///
/// DICOM is recognised by content, whatever the file name; other formats by file name
/// (FileFormats.h), pictures by both (core/images). A DICOMDIR stands for its folder; what it lists
/// is only a hint. All calls block; do not make them on the UI thread.
class Study {
public:
    static constexpr int mostFilesScanned = 500'000;
    /// Reads only headers, on all cores. Unreadable files are part of the listing. An error is
    /// returned only if nothing could be read: FileNotFound, FolderEmpty, NoImages, the file's own
    /// error if @p path is a file, or Cancelled.
    /// @param mostFiles limit for files below a folder; if there are more: TooManyFiles
    [[nodiscard]] static Result<Study> scan(const QString& path,
        const Progress& progress = Progress(), int mostFiles = mostFilesScanned);

    Study(Study&&) noexcept;
    Study& operator=(Study&&) noexcept;
    ~Study();

    [[nodiscard]] const StudyListing& listing() const;

    /// Opens one volume with its voxels.
    ///
    /// @param series key or SeriesInstanceUID, for a series in time with the requested point
    /// (SeriesEntry::keyAtTime()), else its first; empty: the only volume. A repair may follow
    /// (withRepair()).
    /// @param progress counts decoded slices and may cancel
    /// @param early receives the middle slice long before the others, if it can be displayed then
    /// as it will be afterwards: for DICOM with a window and without repair (loadStack()) Decodes
    /// on all cores. Slices that cannot be decoded are left out and listed in Volume::problems; it
    /// is an error if none is left. Further errors: InvalidField (the repair is impossible),
    /// InvalidGeometry (pictures lack their spacing, StudyListing::lacksSpacing()), SeriesAmbiguous
    /// with one line per candidate if several are left, SeriesNotFound if none is.
    [[nodiscard]] Result<LoadedVolume> load(const QString& series = QString(),
        const Progress& progress = Progress(), const EarlySliceListener& early = {}) const;

private:
    struct Contents;
    explicit Study(std::unique_ptr<const Contents> contents);
    std::unique_ptr<const Contents> m_contents;
};

/// Study::scan() for callers that only list.
[[nodiscard]] Result<StudyListing> scanStudies(
    const QString& path, const Progress& progress = Progress());

/// Study::scan() and Study::load() in one.
[[nodiscard]] Result<LoadedVolume> loadVolume(
    const QString& path, const QString& series = QString(), const Progress& progress = Progress());

} // namespace core
