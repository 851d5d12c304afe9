// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/voxelfile/StoredScalars.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <memory>

namespace core {

/// Where a header (NRRD, MetaImage) says that its voxels are, and how they are written there.
struct VoxelSource {
    enum class Encoding {
        Raw,
        Gzip, ///< RFC 1952, one member or several
        Zlib, ///< RFC 1950 or 1952, whichever it begins with
        Text, ///< numbers in words, apart by blanks or commas
        Hex, ///< two digits a byte
    };

    QString header; ///< the file that was opened: errors name it
    QStringList files; ///< each holds an equal share, in the order of the slices
    Encoding encoding = Encoding::Raw;
    ScalarType type = ScalarType::Int16;
    bool bigEndian = false;
    std::size_t voxels = 0;
    qint64 start = 0; ///< where data begin that follow their header in the same file
    qint64 lineSkip = 0; ///< lines to leave out from there
    qint64 byteSkip = 0; ///< bytes to leave out then, unpacked where they are packed
    bool atEnd = false; ///< raw only: the voxels are the last bytes of the file

    [[nodiscard]] std::size_t byteCount() const { return voxels * bytesPerScalar(type); }
};

/// Whether the files are there and long enough for what the header says; reads none of them.
/// FileUnreadable, FileTruncated.
[[nodiscard]] Result<void> checkVoxelFiles(const VoxelSource& source);

/// The voxels in the machine's byte order.
struct VoxelBytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;
    bool surplus = false; ///< the file holds more than its header says
};

/// Reads no more than the header implies, whatever a packed file would unpack to.
/// FileUnreadable, FileTruncated, OutOfMemory, Cancelled.
[[nodiscard]] Result<VoxelBytes> readVoxels(const VoxelSource& source, const Progress& progress);

} // namespace core
