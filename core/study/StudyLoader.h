// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QString>

#include <memory>

namespace core {

/// What a file, a folder with all below it, or an archive (zip, 7z, tar) holds, read once: list it,
/// then open from it. An archive is unpacked into the user's cache (core/archive); archives within
/// folders and archives are not.
///
/// DICOM is known by content, whatever the file names; other formats by their endings
/// (FileFormats.h), pictures by both (core/images). A DICOMDIR stands for its folder: what it names
/// is a hint only. All calls block; make them beside the UI thread.
class Study {
public:
    static constexpr int mostFilesScanned = 500'000;
    /// Reads headers only, by file on all cores. Unreadable files are part of the listing; an error
    /// is returned when nothing at all could be read: FileNotFound, FolderEmpty, NoImages, the
    /// file's own error if @p path is one file, or Cancelled.
    /// @param mostFiles below a folder; where there are more: TooManyFiles
    [[nodiscard]] static Result<Study> scan(const QString& path,
        const Progress& progress = Progress(), int mostFiles = mostFilesScanned);

    Study(Study&&) noexcept;
    Study& operator=(Study&&) noexcept;
    ~Study();

    [[nodiscard]] const StudyListing& listing() const;

    /// Opens one volume with its voxels.
    ///
    /// @param series key or SeriesInstanceUID, of a series in time with the point that is wanted
    /// (SeriesEntry::keyAtTime()), else its first; empty: the only volume there is. With a repair
    /// behind it where it is to be repaired (withRepair()); InvalidField where it cannot be.
    /// InvalidGeometry where pictures lack their spacing (StudyListing::lacksSpacing()).
    /// SeriesAmbiguous, with one line per candidate, where more than one is left; SeriesNotFound
    /// where none is.
    /// Slices that cannot be decoded are left out and named in Volume::problems; an error is
    /// returned if none is left. Decodes on all cores; @p progress tells slices done and may
    /// cancel.
    /// @param early hears of the slice in the middle long before the rest is there, where it can be
    /// shown then as it will be: of DICOM that has a window and needs no repair (loadStack())
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
