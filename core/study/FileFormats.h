// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"

#include <QByteArray>

namespace core {

/// A file format whose volumes are single files, or headers with separate files of voxels,
/// recognised by the file name, and by its first bytes where others have that name, too; or
/// pictures, which are found only by the name of the format.
struct FileFormat {
    const char* name; ///< as in Volume::sourceFormat
    bool (*isName)(const QString& path);
    /// Reads geometry and properties from the header. Files: the header, then those with voxels.
    Result<SeriesEntry> (*read)(const QString& path);
    /// @param time which point of SeriesEntry::times, 0-based
    Result<LoadedVolume> (*load)(const SeriesEntry& entry, int time, const Progress& progress);
    /// The part of the file that a session keeps, so that exports can be checked without the file;
    /// empty if it cannot be read.
    QByteArray (*headerBytes)(const QString& path);
    /// The grid of such a header. Null: the checks read it in another way.
    Result<VolumeGeometry> (*geometryOf)(const QByteArray& header, const QString& path);
};

/// The format of a file by its name; null if it is none of these.
[[nodiscard]] const FileFormat* fileFormatOf(const QString& path);
/// Null if there is no format of that name.
[[nodiscard]] const FileFormat* fileFormatNamed(const QString& name);

} // namespace core
