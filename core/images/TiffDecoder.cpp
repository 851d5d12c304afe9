// SPDX-License-Identifier: Apache-2.0
#include "core/images/TiffDecoder.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include <tiffio.h>

namespace core {

namespace {

/// A file in memory, and what the library has to say about it.
struct TiffRead {
    std::span<const std::uint8_t> bytes;
    std::size_t at = 0;
    std::array<char, 120> message{};
};

TiffRead& readOf(thandle_t handle)
{
    return *static_cast<TiffRead*>(handle);
}

tmsize_t onRead(thandle_t handle, void* to, tmsize_t size)
{
    TiffRead& read = readOf(handle);
    const std::size_t part = std::min(std::size_t(size), read.bytes.size() - read.at);
    std::memcpy(to, read.bytes.data() + read.at, part);
    read.at += part;
    return tmsize_t(part);
}

tmsize_t onWrite(thandle_t, void*, tmsize_t)
{
    return -1;
}

toff_t onSeek(thandle_t handle, toff_t offset, int whence)
{
    TiffRead& read = readOf(handle);
    const toff_t from = whence == SEEK_CUR ? read.at : whence == SEEK_END ? read.bytes.size() : 0;
    const toff_t to = from + offset;
    if (to > read.bytes.size())
        return toff_t(-1);
    read.at = std::size_t(to);
    return to;
}

int onClose(thandle_t)
{
    return 0;
}

toff_t onSize(thandle_t handle)
{
    return readOf(handle).bytes.size();
}

int onError(TIFF*, void* user, const char*, const char* format, va_list arguments)
{
    // The first of them tells why; those that follow are about the way out.
    std::array<char, 120>& message = static_cast<TiffRead*>(user)->message;
    if (message[0] == '\0')
        std::vsnprintf(message.data(), message.size(), format, arguments);
    return 1; // said: nothing goes to stderr
}

int onWarning(TIFF*, void*, const char*, const char*, va_list)
{
    return 1;
}

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using Tiff = std::unique_ptr<TIFF, Close>;

Tiff open(TiffRead& read, std::size_t mostBytes)
{
    const std::unique_ptr<TIFFOpenOptions, Close> options(TIFFOpenOptionsAlloc());
    if (!options)
        return nullptr;
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), onError, &read);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), onWarning, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t(mostBytes));
    return Tiff(TIFFClientOpenExt("page", "rm", &read, onRead, onWrite, onSeek, onClose, onSize,
        nullptr, nullptr, options.get()));
}

bool readStrips(TIFF& tiff, const PixelGrid& grid, std::span<std::uint8_t> pixels)
{
    std::uint32_t rowsPerStrip = 0;
    if (TIFFGetField(&tiff, TIFFTAG_ROWSPERSTRIP, &rowsPerStrip) != 1 || rowsPerStrip == 0)
        return false;
    const std::size_t full = std::size_t(rowsPerStrip) * grid.rowBytes();
    std::uint32_t strip = 0;
    for (std::size_t at = 0; at < pixels.size(); at += full, ++strip) {
        const auto part = tmsize_t(std::min(full, pixels.size() - at));
        if (TIFFReadEncodedStrip(&tiff, strip, pixels.data() + at, part) != part)
            return false;
    }
    return true;
}

bool readTiles(TIFF& tiff, const PixelGrid& grid, std::span<std::uint8_t> pixels)
{
    std::uint32_t wide = 0;
    std::uint32_t high = 0;
    TIFFGetField(&tiff, TIFFTAG_TILEWIDTH, &wide);
    TIFFGetField(&tiff, TIFFTAG_TILELENGTH, &high);
    const std::size_t tileRow = std::size_t(wide) * grid.pixelBytes;
    if (tileRow == 0 || high == 0)
        return false;
    std::vector<std::uint8_t> cells(tileRow * std::size_t(high));
    std::uint32_t tile = 0;
    for (std::size_t row = 0; row < std::size_t(grid.rows); row += high) {
        for (std::size_t left = 0; left < grid.rowBytes(); left += tileRow, ++tile) {
            const auto size = tmsize_t(cells.size());
            if (TIFFReadEncodedTile(&tiff, tile, cells.data(), size) != size)
                return false;
            const std::size_t part = std::min(tileRow, grid.rowBytes() - left);
            const std::size_t rows = std::min(std::size_t(high), std::size_t(grid.rows) - row);
            for (std::size_t i = 0; i < rows; ++i)
                std::memcpy(pixels.data() + (row + i) * grid.rowBytes() + left,
                    cells.data() + i * tileRow, part);
        }
    }
    return true;
}

} // namespace

QString decodeTiff(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels)
{
    TiffRead read{.bytes = bytes};
    // One part and its packed bytes; tiles may be larger than the picture.
    constexpr std::size_t always = std::size_t(64) << 20;
    const Tiff tiff = open(read, always + bytes.size() + 2 * pixels.size());
    bool done = false;
    if (tiff) {
        std::uint32_t columns = 0;
        std::uint32_t rows = 0;
        std::uint16_t bits = 0;
        TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &columns);
        TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &rows);
        TIFFGetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
        const bool isKnown = columns == std::uint32_t(grid.columns)
            && rows == std::uint32_t(grid.rows) && bits == 8 * grid.pixelBytes;
        if (isKnown)
            done = TIFFIsTiled(tiff.get()) != 0 ? readTiles(*tiff, grid, pixels)
                                                : readStrips(*tiff, grid, pixels);
    }
    if (done)
        return {};
    return read.message[0] != '\0'
        ? QStringLiteral("damaged pixel data (%1)").arg(QLatin1String(read.message.data()))
        : QStringLiteral("damaged pixel data");
}

void readyTiff()
{
    // One pixel. libtiff sorts its tags on opening any file, and glibc's qsort asks once, when it
    // is first needed, how much memory the machine has.
    constexpr std::array<std::uint8_t, 99> tiff{'I', 'I', 42, 0, 8, 0, 0, 0, 7, 0, //
        0, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, // width
        1, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, // length
        2, 1, 3, 0, 1, 0, 0, 0, 8, 0, 0, 0, // bits
        3, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, // not packed
        6, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, // black is zero
        17, 1, 4, 0, 1, 0, 0, 0, 98, 0, 0, 0, // where
        23, 1, 4, 0, 1, 0, 0, 0, 1, 0, 0, 0, // bytes
        0, 0, 0, 0, 200};
    std::array<std::uint8_t, 1> pixel{};
    (void)decodeTiff(tiff, {.columns = 1, .rows = 1, .pixelBytes = 1}, pixel);
}

} // namespace core
