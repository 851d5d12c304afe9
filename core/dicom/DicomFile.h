// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QFile>
#include <QString>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

/// The outer structure of one DICOM file, checked before any other parser touches it.
///
/// DCMTK 3.6.7 parses sequences recursively without limit; this walk is iterative, refuses nesting
/// deeper than 64, lengths beyond the file and deflated data that grow beyond reason. It also finds
/// the pixel data, so that decoding needs no second parse. It reads up to the pixel data only: what
/// some writers leave behind them is ignored.
class DicomFile {
public:
    using Bytes = std::span<const std::uint8_t>;

    /// UnsupportedFormat for files that are not DICOM; FileTruncated, FileUnreadable.
    [[nodiscard]] static Result<DicomFile> open(const QString& path);

    [[nodiscard]] const QString& transferSyntaxUid() const { return m_transferSyntaxUid; }
    [[nodiscard]] bool isBigEndian() const { return m_bigEndian; }

    [[nodiscard]] bool hasPixels() const { return m_hasPixels; }
    /// The file ends before the pixel data do.
    [[nodiscard]] bool pixelsCut() const { return m_pixelsCut; }
    [[nodiscard]] bool isEncapsulated() const { return m_encapsulated; }
    /// Stored in 16-bit words (VR OW), which matters for big endian.
    [[nodiscard]] bool pixelsAreWords() const { return m_pixelsAreWords; }
    /// The bytes of unencapsulated pixel data.
    [[nodiscard]] Bytes pixels() const { return m_pixels; }
    /// The fragments of encapsulated pixel data without the offset table (PS3.5 A.4).
    [[nodiscard]] const std::vector<Bytes>& fragments() const { return m_fragments; }

private:
    struct Walk;

    std::unique_ptr<QFile> m_file; ///< keeps the mapping alive
    QByteArray m_inflated; ///< the data set of a deflated file
    QString m_transferSyntaxUid;
    bool m_bigEndian = false;
    bool m_hasPixels = false;
    bool m_pixelsCut = false;
    bool m_encapsulated = false;
    bool m_pixelsAreWords = true;
    Bytes m_pixels;
    std::vector<Bytes> m_fragments;
};

} // namespace core
