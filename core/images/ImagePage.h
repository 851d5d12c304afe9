// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/voxelfile/StoredScalars.h"

#include <QString>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// A range of bytes in a file: a strip or a tile.
struct FileSpan {
    std::uint64_t begin = 0;
    std::uint64_t size = 0;
};

/// One grey-scale picture of a PNG or TIFF file, as described by its header. The header was checked
/// to fit the file; nothing was decoded.
struct ImagePage {
    enum class Form : std::uint8_t { Png, Tiff };

    QString file;
    Form form = Form::Png;
    int columns = 0;
    int rows = 0;
    ScalarType type = ScalarType::UInt8;
    bool isInverted = false; ///< 0 is white; values are as stored
    bool isUpright = true; ///< false: the file is to be displayed rotated or mirrored
    /// Distances of voxels along columns, rows and slices as stated in the file; 0 if not stated.
    glm::dvec3 spacingMm{0.0};

    // TIFF only: what the decoder must know.
    bool bigEndian = false;
    int compression = 1;
    int predictor = 1;
    int partColumns = 0; ///< of a tile; for strips the whole width
    int partRows = 0; ///< of a tile or strip
    bool isTiled = false;
    std::vector<FileSpan> parts{}; ///< in the order of the format

    [[nodiscard]] std::size_t byteCount() const
    {
        return std::size_t(columns) * std::size_t(rows) * bytesPerScalar(type);
    }
    /// "512 × 512 of 16 bits"
    [[nodiscard]] QString inWords() const;
    /// Whether both can be slices of one volume.
    [[nodiscard]] bool isLike(const ImagePage& other) const
    {
        return columns == other.columns && rows == other.rows && type == other.type
            && isInverted == other.isInverted;
    }
};

/// The longest side of a picture that is accepted.
constexpr int longestImageSide = 32768;

/// Whether a file name is .png, .tif or .tiff and not hidden.
[[nodiscard]] bool isImageName(const QString& path);
/// The kind of a file according to its first bytes. A DICOM file may begin like a TIFF.
enum class FirstBytes : std::uint8_t { Image, Dicom, Other };
[[nodiscard]] FirstBytes firstBytesOf(const QString& path);

/// The pictures of a PNG (one) or TIFF file, from headers alone; at least one. Errors:
/// FileUnreadable, FileTruncated (less data than the header states, or fewer than can unpack to
/// that much), UnsupportedFormat (colours, or a depth or compression that is not supported),
/// InvalidGeometry.
[[nodiscard]] Result<std::vector<ImagePage>> readImagePages(const QString& path);

} // namespace core
