// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/JpegCheck.h"

namespace core {

namespace {

constexpr std::uint8_t startOfImage = 0xd8;
constexpr std::uint8_t startOfScan = 0xda;
constexpr std::uint8_t endOfImage = 0xd9;
constexpr std::uint8_t temporary = 0x01;
constexpr std::uint8_t jpegLsFrame = 0xf7;

bool isFrameHeader(std::uint8_t marker)
{
    // SOF0 … SOF15 without DHT, JPG and DAC, which share their range (ITU-T T.81 table B.1).
    return marker == jpegLsFrame
        || (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc);
}

} // namespace

JpegFacts checkJpeg(std::span<const std::uint8_t> stream, const PixelLayout& layout)
{
    const auto two = [&](std::size_t at) { return int(stream[at]) << 8 | int(stream[at + 1]); };
    const JpegFacts damaged{.wrong = QStringLiteral("damaged JPEG data")};
    if (stream.size() < 4 || stream[0] != 0xff || stream[1] != startOfImage)
        return damaged;
    int precision = 0;
    bool isJpegLs = false;
    std::size_t at = 2;
    while (stream.size() - at >= 4) {
        if (stream[at] != 0xff)
            return damaged;
        const std::uint8_t marker = stream[at + 1];
        if (marker == 0xff) {
            ++at;
            continue;
        }
        if (marker == temporary)
            return damaged;
        const auto length = std::size_t(two(at + 2));
        if (length < 2 || length > stream.size() - at - 2)
            return damaged;
        if (isFrameHeader(marker)) {
            if (length < 8 || precision != 0)
                return damaged;
            precision = stream[at + 4];
            const int rows = two(at + 5);
            const int columns = two(at + 7);
            const int components = stream[at + 9];
            if (rows != layout.rows || columns != layout.columns || components != 1) {
                return {.wrong = QStringLiteral("its JPEG image is %1 × %2 with %3 components")
                                     .arg(columns)
                                     .arg(rows)
                                     .arg(components)};
            }
            isJpegLs = marker == jpegLsFrame;
        }
        at += 2 + length;
        if (marker == startOfScan)
            break;
    }
    if (precision == 0)
        return damaged;
    // JPEG-LS stuffs bits, so FF01 is ordinary there; in JPEG it never is.
    for (; !isJpegLs && at + 1 < stream.size(); ++at) {
        if (stream[at] == 0xff && stream[at + 1] == temporary)
            return damaged;
        if (stream[at] == 0xff && stream[at + 1] == endOfImage)
            break;
    }
    return {.wrong = {}, .precision = precision};
}

} // namespace core
