// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// How pixel data are encoded (PS3.5 section 10 and annex A). The UID string decides: DCMTK 3.6.7
/// takes unknown syntaxes for Explicit Little Endian and would display compressed bytes.
enum class PixelCoding {
    Native,
    Rle,
    Jpeg,
    JpegLs,
    Jpeg2000, ///< and High-Throughput JPEG 2000
    Unknown,
};

struct TransferSyntax {
    const char* uid;
    const char* name;
    PixelCoding coding = PixelCoding::Unknown;
    bool explicitVr = true;
    bool bigEndian = false;
    bool deflated = false;
    bool lossy = false; ///< always lossy, whatever the data set states
};

/// The transfer syntax with this UID; its coding is Unknown if Burin cannot read it.
[[nodiscard]] const TransferSyntax& transferSyntax(const QString& uid);

} // namespace core
