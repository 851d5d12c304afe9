// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <memory>
#include <span>

namespace core {

class DicomFile;

/// Why Burin cannot decode this image, in words; empty if it can, as far as the header shows.
[[nodiscard]] Clause undecodableReason(const ImageHeader& header);

/// What was noticed about a frame while it was decoded.
struct DecodedFrame {
    bool cutOff = false; ///< some values did not fit BitsStored (areCutOff())
};

/// An open file whose frames are decoded one by one. It is checked and mapped once, whatever the
/// number of frames. Several threads may use it at once.
class FrameFile {
public:
    /// FileTruncated, UnsupportedFormat, FileUnreadable; all errors name the file.
    [[nodiscard]] static Result<FrameFile> open(const QString& path);
    FrameFile(FrameFile&&) noexcept;
    FrameFile& operator=(FrameFile&&) noexcept;
    ~FrameFile();

    /// Decodes the frame described by @p header into stored values (extractStoredBits), columns
    /// first. Apart from our own parser, no code sees more of the file than its pixel data.
    [[nodiscard]] Result<DecodedFrame> decode(
        const ImageHeader& header, std::span<std::uint16_t> stored) const;

    /// The same for pixels that do not fit 16 bits (PixelLayout::isWide()): floating-point numbers,
    /// and whole ones of 32 bits.
    [[nodiscard]] Result<void> decodeNumbers(
        const ImageHeader& header, std::span<double> numbers) const;

private:
    explicit FrameFile(std::unique_ptr<const DicomFile> file);

    std::unique_ptr<const DicomFile> m_file;
};

/// Opens a file for one of its frames.
[[nodiscard]] Result<DecodedFrame> decodeFrame(
    const ImageHeader& header, std::span<std::uint16_t> stored);

} // namespace core
