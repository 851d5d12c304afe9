// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"

#include <QByteArray>

namespace core {

/// A format whose volumes are one file each, or one header with files of voxels beside it, known by
/// the file's name; and pictures, known by the format's name only.
struct FileFormat {
    const char* name; ///< as Volume::sourceFormat has it
    bool (*isName)(const QString& path);
    /// Geometry and facts from the header. Files: the header, then others that hold its voxels.
    Result<SeriesEntry> (*read)(const QString& path);
    Result<LoadedVolume> (*load)(const SeriesEntry& entry, const Progress& progress);
    /// What a session keeps of the file so that exports can be checked without it; empty if it
    /// cannot be read.
    QByteArray (*headerBytes)(const QString& path);
    /// The grid of such a header. Null: whoever checks reads it by other means.
    Result<VolumeGeometry> (*geometryOf)(const QByteArray& header, const QString& path);
};

/// Null: a file is none of these by its name.
[[nodiscard]] const FileFormat* fileFormatOf(const QString& path);
/// Null: no such name.
[[nodiscard]] const FileFormat* fileFormatNamed(const QString& name);

} // namespace core
