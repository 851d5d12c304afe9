// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

/// The pixels of a picture as they lie in memory, row by row.
struct PictureBytes {
    int columns = 0;
    int rows = 0;
    int bits = 8;
    int sampleFormat = 1; ///< as in TIFF: 1 unsigned, 2 signed, 3 floating point
    QByteArray bytes{};
};

/// A picture whose pixel (column, row) of slice k is pixelAt(k, column, row), as T stores it.
template <class T> PictureBytes picture(int k, int columns, int rows);
/// The value of a pixel; it fits every type, and is negative in places for signed ones.
[[nodiscard]] int pixelAt(int k, int column, int row);

/// Writes a PNG 1.2 with zlib, following the standard byte by byte.
/// @param colourType as in the standard; 0: grey
/// @param chunks between header and data
/// @param adam7 interlaced
[[nodiscard]] QByteArray png(const PictureBytes& picture, int colourType = 0,
    const QByteArray& chunks = {}, bool adam7 = false);
/// A PNG chunk with its length and checksum.
[[nodiscard]] QByteArray pngChunk(const QByteArray& name, const QByteArray& data);

struct TiffOptions {
    bool bigEndian = false;
    bool bigTiff = false;
    int compression = 1;
    int predictor = 1;
    int tile = 0; ///< side of a tile; 0: strips
    int rowsPerStrip = 3;
    int photometric = 1;
    int orientation = 1;
    double columnsPerUnit = 0.0; ///< 0: no resolution
    double rowsPerUnit = 0.0;
    int resolutionUnit = 2;
    QByteArray description{};
};
/// Writes a TIFF with libtiff.
/// @return whether that worked
[[nodiscard]] bool writeTiff(
    const QString& path, const std::vector<PictureBytes>& pages, const TiffOptions& options = {});

template <class T> PictureBytes picture(int k, int columns, int rows)
{
    PictureBytes made{.columns = columns, .rows = rows, .bits = int(8 * sizeof(T))};
    made.sampleFormat = T(0.5) != T(0) ? 3 : T(-1) < T(0) ? 2 : 1;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int shift = made.sampleFormat == 1 ? 60 : 0;
            const T value = T(pixelAt(k, column, row) + shift);
            made.bytes.append(reinterpret_cast<const char*>(&value), qsizetype(sizeof(T)));
        }
    }
    return made;
}

} // namespace test
