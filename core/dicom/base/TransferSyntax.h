// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// How pixel data are packed (PS3.5 section 10 and annex A). Decided by the UID string: DCMTK 3.6.7
/// takes syntaxes it does not know for Explicit Little Endian and would show compressed bytes.
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
    bool lossy = false; ///< always, whatever the data set says
};

/// The syntax of this UID; coding Unknown where Burin cannot read it.
[[nodiscard]] const TransferSyntax& transferSyntax(const QString& uid);

} // namespace core
