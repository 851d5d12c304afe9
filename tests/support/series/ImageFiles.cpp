// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/ImageFiles.h"

#include <QFile>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <bit>

#include <tiffio.h>
#include <zlib.h>

namespace test {

namespace {

QByteArray bigEndian(quint32 value)
{
    std::array<char, 4> bytes{};
    qToBigEndian(value, bytes.data());
    return {bytes.data(), 4};
}

QByteArray deflated(const QByteArray& bytes)
{
    uLongf size = compressBound(uLong(bytes.size()));
    QByteArray packed(qsizetype(size), '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
        reinterpret_cast<const Bytef*>(bytes.constData()), uLong(bytes.size()));
    packed.resize(qsizetype(size));
    return packed;
}

/// Where the seven passes begin and how far apart their pixels are.
struct Pass {
    int x;
    int y;
    int dx;
    int dy;
};
constexpr std::array adam7Passes{Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8},
    Pass{2, 0, 4, 4}, Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2}, Pass{0, 1, 1, 2}};

QByteArray scanlines(const PictureBytes& picture, const Pass& pass)
{
    const qsizetype each = picture.bytes.size() / (picture.columns * picture.rows);
    QByteArray lines;
    for (int y = pass.y; y < picture.rows; y += pass.dy) {
        QByteArray line(1, '\0'); // no filter
        for (int x = pass.x; x < picture.columns; x += pass.dx) {
            QByteArray pixel = picture.bytes.mid((y * picture.columns + x) * each, each);
            if (picture.bits == 16 && std::endian::native == std::endian::little)
                qbswap<2>(pixel.constData(), pixel.size() / 2, pixel.data());
            line += pixel;
        }
        if (line.size() > 1)
            lines += line;
    }
    return lines;
}

void setTags(TIFF* tiff, const PictureBytes& page, const TiffOptions& options)
{
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.columns);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, page.rows);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, page.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, page.sampleFormat);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, options.photometric);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, options.compression);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, options.orientation);
    if (options.predictor != 1)
        TIFFSetField(tiff, TIFFTAG_PREDICTOR, options.predictor);
    if (options.photometric == PHOTOMETRIC_PALETTE) {
        std::vector<std::uint16_t> map(std::size_t(1) << page.bits);
        TIFFSetField(tiff, TIFFTAG_COLORMAP, map.data(), map.data(), map.data());
    }
    if (options.columnsPerUnit > 0.0) {
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, options.columnsPerUnit);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, options.rowsPerUnit);
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, options.resolutionUnit);
    }
    if (!options.description.isEmpty())
        TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, options.description.constData());
    if (options.tile > 0) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, options.tile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, options.tile);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, options.rowsPerStrip);
    }
}

void turnBytes(PictureBytes& page)
{
    if (page.bits == 32)
        qbswap<4>(page.bytes.constData(), page.bytes.size() / 4, page.bytes.data());
    else
        qbswap<8>(page.bytes.constData(), page.bytes.size() / 8, page.bytes.data());
}

bool writeTiles(TIFF* tiff, const PictureBytes& page, int side)
{
    const int each = page.bits / 8;
    std::vector<char> tile(std::size_t(side * side * each));
    bool good = true;
    for (int top = 0; top < page.rows; top += side) {
        for (int left = 0; left < page.columns; left += side) {
            std::fill(tile.begin(), tile.end(), '\x5a'); // what is beyond the edge is nobody's
            for (int y = 0; y < std::min(side, page.rows - top); ++y)
                std::copy_n(page.bytes.begin() + ((top + y) * page.columns + left) * each,
                    std::min(side, page.columns - left) * each,
                    tile.begin() + std::ptrdiff_t(y * side * each));
            good = good
                && TIFFWriteTile(tiff, tile.data(), std::uint32_t(left), std::uint32_t(top), 0, 0)
                    > 0;
        }
    }
    return good;
}

bool writeRows(TIFF* tiff, const PictureBytes& page)
{
    const qsizetype row = page.bytes.size() / page.rows;
    bool good = true;
    for (int y = 0; y < page.rows; ++y) {
        QByteArray line = page.bytes.mid(y * row, row); // libtiff swaps in place
        good = good && TIFFWriteScanline(tiff, line.data(), std::uint32_t(y), 0) == 1;
    }
    return good;
}

} // namespace

int pixelAt(int k, int column, int row)
{
    return (7 * k + 3 * column + 5 * row + column * row) % 113 - 50;
}

QByteArray pngChunk(const QByteArray& name, const QByteArray& data)
{
    const QByteArray summed = name + data;
    const uLong sum =
        crc32(0, reinterpret_cast<const Bytef*>(summed.constData()), uInt(summed.size()));
    return bigEndian(quint32(data.size())) + summed + bigEndian(quint32(sum));
}

QByteArray png(const PictureBytes& picture, int colourType, const QByteArray& chunks, bool adam7)
{
    QByteArray header = bigEndian(quint32(picture.columns)) + bigEndian(quint32(picture.rows));
    header += char(picture.bits);
    header += char(colourType);
    header += QByteArray(2, '\0');
    header += char(adam7 ? 1 : 0);
    QByteArray lines;
    if (adam7) {
        for (const Pass& pass : adam7Passes)
            lines += scanlines(picture, pass);
    } else {
        lines = scanlines(picture, {0, 0, 1, 1});
    }
    return QByteArray("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", header) + chunks
        + pngChunk("IDAT", deflated(lines)) + pngChunk("IEND", {});
}

bool writeTiff(
    const QString& path, const std::vector<PictureBytes>& pages, const TiffOptions& options)
{
    const QByteArray mode =
        QByteArray("w") + (options.bigEndian ? "b" : "l") + (options.bigTiff ? "8" : "4");
    TIFF* tiff = TIFFOpen(QFile::encodeName(path).constData(), mode.constData());
    if (tiff == nullptr)
        return false;
    bool good = true;
    for (PictureBytes page : pages) {
        setTags(tiff, page, options);
        // libtiff 4.5 turns the bytes of these before its predictor, which wants them as they are.
        if (options.bigEndian && options.predictor == PREDICTOR_FLOATINGPOINT)
            turnBytes(page);
        good = good
            && (options.tile > 0 ? writeTiles(tiff, page, options.tile) : writeRows(tiff, page))
            && TIFFWriteDirectory(tiff) == 1;
    }
    TIFFClose(tiff);
    return good;
}

} // namespace test
