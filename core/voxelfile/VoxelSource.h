// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/voxelfile/StoredScalars.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <memory>
#include <span>

namespace core {

/// Where the voxels of a header (NRRD, MetaImage) are, and how they are encoded.
struct VoxelSource {
    enum class Encoding {
        Raw,
        Gzip, ///< RFC 1952, one member or several
        Zlib, ///< RFC 1950 or 1952, whichever it begins with
        Text, ///< numbers as text, separated by blanks or commas
        Hex, ///< two digits per byte
    };

    QString header; ///< the file that was opened; errors name it
    QStringList files; ///< each has an equal share, in the order of slices
    Encoding encoding = Encoding::Raw;
    ScalarType type = ScalarType::Int16;
    bool bigEndian = false;
    std::size_t voxels = 0;
    qint64 start = 0; ///< where the data begin if they follow their header in the same file
    qint64 lineSkip = 0; ///< lines to skip from there
    qint64 byteSkip = 0; ///< bytes to skip after that, counted after decompression
    bool atEnd = false; ///< raw only: the voxels are the last bytes of the file

    [[nodiscard]] std::size_t byteCount() const { return voxels * bytesPerScalar(type); }
};

/// Checks that the files exist and are long enough for the header, without reading them. Errors:
/// FileUnreadable, FileTruncated.
[[nodiscard]] Result<void> checkVoxelFiles(const VoxelSource& source);

/// The voxels in the machine's byte order.
struct VoxelBytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;
    bool surplus = false; ///< the file contains more than its header states
};

/// Reads at most what the header implies, whatever a compressed file would expand to. Errors:
/// FileUnreadable, FileTruncated, OutOfMemory, Cancelled.
[[nodiscard]] Result<VoxelBytes> readVoxels(const VoxelSource& source, const Progress& progress);
/// The same into @p into, which has source.byteCount() bytes. Errors: FileUnreadable,
/// FileTruncated, Cancelled. @pre checkVoxelFiles()
/// @return VoxelBytes::surplus
[[nodiscard]] Result<bool> readVoxelsInto(
    const VoxelSource& source, std::span<char> into, const Progress& progress);

} // namespace core
