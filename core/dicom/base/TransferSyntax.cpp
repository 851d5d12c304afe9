// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/TransferSyntax.h"

#include <QLatin1String>

namespace core {

namespace {

constexpr TransferSyntax table[] = {
    {"1.2.840.10008.1.2", "Implicit VR Little Endian", PixelCoding::Native, false},
    {"1.2.840.10008.1.2.1", "Explicit VR Little Endian", PixelCoding::Native},
    {"1.2.840.10008.1.2.1.99", "Deflated Explicit VR Little Endian", PixelCoding::Native, true,
        false, true},
    {"1.2.840.10008.1.2.2", "Explicit VR Big Endian", PixelCoding::Native, true, true},
    {"1.2.840.10008.1.2.4.50", "JPEG Baseline", PixelCoding::Jpeg, true, false, false, true},
    {"1.2.840.10008.1.2.4.51", "JPEG Extended", PixelCoding::Jpeg, true, false, false, true},
    {"1.2.840.10008.1.2.4.53", "JPEG Spectral Selection", PixelCoding::Jpeg, true, false, false,
        true},
    {"1.2.840.10008.1.2.4.55", "JPEG Full Progression", PixelCoding::Jpeg, true, false, false,
        true},
    {"1.2.840.10008.1.2.4.57", "JPEG Lossless", PixelCoding::Jpeg},
    {"1.2.840.10008.1.2.4.70", "JPEG Lossless, first-order prediction", PixelCoding::Jpeg},
    {"1.2.840.10008.1.2.4.80", "JPEG-LS Lossless", PixelCoding::JpegLs},
    {"1.2.840.10008.1.2.4.81", "JPEG-LS Near-lossless", PixelCoding::JpegLs, true, false, false,
        true},
    {"1.2.840.10008.1.2.4.90", "JPEG 2000 Lossless", PixelCoding::Jpeg2000},
    {"1.2.840.10008.1.2.4.91", "JPEG 2000", PixelCoding::Jpeg2000},
    {"1.2.840.10008.1.2.4.201", "HTJ2K Lossless", PixelCoding::Jpeg2000},
    {"1.2.840.10008.1.2.4.202", "HTJ2K Lossless RPCL", PixelCoding::Jpeg2000},
    {"1.2.840.10008.1.2.4.203", "HTJ2K", PixelCoding::Jpeg2000},
    {"1.2.840.10008.1.2.5", "RLE Lossless", PixelCoding::Rle},
};

constexpr TransferSyntax unknown{"", "unknown", PixelCoding::Unknown};

} // namespace

const TransferSyntax& transferSyntax(const QString& uid)
{
    for (const TransferSyntax& syntax : table) {
        if (uid == QLatin1String(syntax.uid))
            return syntax;
    }
    return unknown;
}

} // namespace core
