// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QByteArray>

#include <glm/glm.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

namespace test::nrrd {

/// A small volume, written by hand.
inline constexpr glm::ivec3 size(5, 4, 3);
inline constexpr int voxels = 60;

/// Values that a signed byte holds, no two neighbours alike.
inline int valueOf(int voxel)
{
    return (voxel * 7) % 120 - 20;
}

template <class T> QByteArray storedAs(bool big)
{
    QByteArray bytes;
    for (int voxel = 0; voxel < voxels; ++voxel) {
        T value = T(valueOf(voxel) + (std::is_unsigned_v<T> ? 20 : 0));
        std::array<char, sizeof(T)> one{};
        std::memcpy(one.data(), &value, sizeof(T));
        if (big)
            std::reverse(one.begin(), one.end());
        bytes.append(one.data(), qsizetype(one.size()));
    }
    return bytes;
}

inline QByteArray gzipped(const QByteArray& plain, int windowBits = MAX_WBITS + 16)
{
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
    QByteArray packed(qsizetype(deflateBound(&stream, uLong(plain.size()))), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.constData()));
    stream.avail_in = uInt(plain.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    deflate(&stream, Z_FINISH);
    packed.truncate(qsizetype(stream.total_out));
    deflateEnd(&stream);
    return packed;
}

inline const QByteArray start("NRRD0004\n# made by a test\n");
inline const QByteArray shape("type: short\ndimension: 3\nsizes: 5 4 3\nendian: little\n");
inline const QByteArray place("space: left-posterior-superior\n"
                              "space directions: (0.6,0.8,0) (-0.8,0.6,0) (0,0,2.5)\n"
                              "space origin: (-12,34,56.5)\n");

/// A valid attached file of short integers.
inline QByteArray soundFile()
{
    return start + shape + place + "encoding: raw\n\n" + storedAs<std::int16_t>(false);
}

inline glm::dmat4 soundAffine()
{
    return {glm::dvec4(0.6, 0.8, 0, 0), glm::dvec4(-0.8, 0.6, 0, 0), glm::dvec4(0, 0, 2.5, 0),
        glm::dvec4(-12, 34, 56.5, 1)};
}

/// A file of these voxels, x fastest, on a volume's grid.
/// @param type as a header names it: uchar, float …
inline QByteArray onGrid(
    const core::VolumeGeometry& geometry, const QByteArray& type, const QByteArray& bytes)
{
    const auto vector = [](const glm::dvec4& of) {
        return '(' + QByteArray::number(of.x, 'g', 17) + ',' + QByteArray::number(of.y, 'g', 17)
            + ',' + QByteArray::number(of.z, 'g', 17) + ')';
    };
    QByteArray sizes;
    QByteArray directions;
    for (int axis = 0; axis < 3; ++axis) {
        sizes += ' ' + QByteArray::number(geometry.size[axis]);
        directions += ' ' + vector(geometry.indexToWorld[axis]);
    }
    return start + "type: " + type + "\nencoding: raw\nendian: little\ndimension: 3\nsizes:" + sizes
        + "\nspace: left-posterior-superior\nspace directions:" + directions
        + "\nspace origin: " + vector(geometry.indexToWorld[3]) + "\n\n" + bytes;
}

} // namespace test::nrrd
