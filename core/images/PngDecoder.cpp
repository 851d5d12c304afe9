// SPDX-License-Identifier: Apache-2.0
#include "core/images/PngDecoder.h"

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

#include <png.h>

namespace core {

namespace {

/// All that one decoding uses: libpng leaves it by a long jump, which runs no destructors, so that
/// nothing that has one lives below it.
struct PngRead {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::span<const std::uint8_t> left{};
    std::array<char, 120> message{};
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    auto* read = static_cast<PngRead*>(png_get_error_ptr(png));
    std::strncpy(read->message.data(), message, read->message.size() - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) { }

void onRead(png_structp png, png_bytep to, std::size_t size)
{
    auto* read = static_cast<PngRead*>(png_get_io_ptr(png));
    if (size > read->left.size())
        png_error(png, "its data break off");
    std::memcpy(to, read->left.data(), size);
    read->left = read->left.subspan(size);
}

/// @return whether it is done; else PngRead::message says why
bool decode(PngRead& read, const PixelGrid& grid, png_bytepp rows)
{
    // NOLINTNEXTLINE(cert-err52-cpp): the only way that libpng reports errors.
    if (setjmp(png_jmpbuf(read.png)) != 0)
        return false;
    png_set_read_fn(read.png, &read, onRead);
    constexpr png_uint_32 longestSide = 32768;
    constexpr png_alloc_size_t largestChunk = 1 << 20;
    png_set_user_limits(read.png, longestSide, longestSide);
    png_set_chunk_malloc_max(read.png, largestChunk);
    png_read_info(read.png, read.info);
    const bool isKnown = png_get_color_type(read.png, read.info) == PNG_COLOR_TYPE_GRAY
        && png_get_image_width(read.png, read.info) == png_uint_32(grid.columns)
        && png_get_image_height(read.png, read.info) == png_uint_32(grid.rows)
        && png_get_bit_depth(read.png, read.info) == 8 * grid.pixelBytes;
    if (!isKnown)
        png_error(read.png, "its header changed");
    if (grid.pixelBytes == 2 && std::endian::native == std::endian::little)
        png_set_swap(read.png);
    png_set_interlace_handling(read.png);
    png_read_update_info(read.png, read.info);
    if (png_get_rowbytes(read.png, read.info) != grid.rowBytes())
        png_error(read.png, "its rows have another length");
    png_read_image(read.png, rows);
    png_read_end(read.png, nullptr);
    return true;
}

} // namespace

QString decodePng(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels)
{
    std::vector<png_bytep> rows;
    for (std::size_t row = 0; row < std::size_t(grid.rows); ++row)
        rows.push_back(pixels.data() + row * grid.rowBytes());
    PngRead read{.left = bytes};
    read.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &read, onError, onWarning);
    read.info = read.png != nullptr ? png_create_info_struct(read.png) : nullptr;
    const bool done = read.info != nullptr && decode(read, grid, rows.data());
    png_destroy_read_struct(&read.png, &read.info, nullptr);
    if (done)
        return {};
    return read.message[0] != '\0'
        ? QStringLiteral("damaged pixel data (%1)").arg(QLatin1String(read.message.data()))
        : QStringLiteral("no memory for its pixel data");
}

} // namespace core
