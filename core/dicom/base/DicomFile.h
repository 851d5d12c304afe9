// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/Inflater.h"
#include "core/dicom/base/Preflight.h"

#include <QFile>
#include <QString>

#include <cstdint>
#include <memory>
#include <vector>

class DcmDataset;

namespace core {

/// One DICOM file whose structure was checked (Preflight.h). DCMTK sees files only through this
/// class: a file on which DCMTK would crash or hang fails here with an error. It also locates the
/// pixel data, so that decoding needs no second parse.
class DicomFile {
public:
    using Bytes = DicomBytes;

    /// Opens a file for its header; the pixel data of a deflated file are not read.
    /// UnsupportedFormat for files that are not DICOM; FileTruncated, FileUnreadable.
    [[nodiscard]] static Result<DicomFile> open(const QString& path);
    [[nodiscard]] static Result<DicomFile> openWithPixels(const QString& path);

    /// Lets DCMTK parse the elements before the pixel data into @p set, which must be empty. Long
    /// values are read from the file when they are requested. FileUnreadable.
    [[nodiscard]] Result<void> readInto(DcmDataset& set) const;
    /// Opens a file and parses its elements. Errors: FileNotFound, and those of both functions.
    [[nodiscard]] static Result<void> readHeader(const QString& path, DcmDataset& set);

    /// As the file states it; guessed if it does not.
    [[nodiscard]] const QString& transferSyntaxUid() const { return m_transferSyntaxUid; }
    /// Of the file meta information, (0002,0002); may be empty.
    [[nodiscard]] const QString& mediaSopClassUid() const { return m_mediaSopClassUid; }
    [[nodiscard]] bool isBigEndian() const { return m_form.bigEndian; }
    [[nodiscard]] const PromisedImage& image() const { return m_facts.image; }

    [[nodiscard]] bool hasPixels() const { return m_facts.hasPixels; }
    /// 32 or 64 if pixels are floating-point numbers, else 0.
    [[nodiscard]] int floatBits() const { return m_facts.floatBits; }
    /// The file ends before the pixel data do.
    [[nodiscard]] bool pixelsCut() const { return m_facts.pixelsCut; }
    [[nodiscard]] bool isEncapsulated() const { return m_facts.pixelsEncapsulated; }
    /// Stored in 16-bit words (VR OW), which matters for big endian.
    [[nodiscard]] bool pixelsAreWords() const { return m_facts.pixelsAreWords; }
    /// Number of bytes of unencapsulated pixel data, even if they have not been read yet.
    [[nodiscard]] std::size_t pixelBytes() const { return m_facts.pixels.size; }
    /// The bytes of unencapsulated pixel data.
    [[nodiscard]] Bytes pixels() const;
    /// The fragments of encapsulated pixel data without the offset table (PS3.5 A.4).
    [[nodiscard]] std::vector<Bytes> fragments() const;

private:
    enum class Extent { Header, Pixels };

    [[nodiscard]] static Result<DicomFile> openTo(Extent extent, const QString& path);
    [[nodiscard]] Result<void> readMetaHeader(Bytes bytes);
    void chooseForm();
    [[nodiscard]] Result<void> checkPlain();
    [[nodiscard]] Result<void> checkDeflated(Extent extent);
    void inflatePixels();
    [[nodiscard]] Result<void> checkRle() const;
    [[nodiscard]] Result<void> checkCompression() const;

    QString m_path;
    std::unique_ptr<QFile> m_file; ///< keeps the mapping alive
    std::unique_ptr<Inflater> m_inflater; ///< of a deflated data set
    std::size_t m_dataSetAt = 0; ///< in the file
    Bytes m_dataSet; ///< inflated as far as necessary
    QString m_transferSyntaxUid;
    QString m_mediaSopClassUid;
    DataSetForm m_form;
    PreflightFacts m_facts;
};

/// The reason for refusing a file that is in none of the supported formats.
[[nodiscard]] Clause ofNoKnownFormat();

} // namespace core
