// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <random>
#include <vector>

namespace test {

/// Bytes that were put together to hurt a reader of DICOM.
struct HostileDicom {
    const char* name;
    QByteArray bytes;
    const char* reason; ///< part of the sentence that refuses it
    bool onlyWhenDecoded = false; ///< its header is sound
};

/// One of each kind that crashes or hangs DCMTK 3.6.7, or makes it take more memory than there is.
/// Those with pixels come from @p honest, a small image in explicit VR little endian.
[[nodiscard]] std::vector<HostileDicom> hostileDicoms(const QByteArray& honest);

/// Files whose deep nesting shows only if their bytes are read as DCMTK reads them.
[[nodiscard]] std::vector<HostileDicom> hiddenNests();

/// A small deflated file whose pixel data claim 2 GB and are 256 MB of zeros, of which the image
/// needs few.
[[nodiscard]] QByteArray deflatedBomb(int rows, int columns);

/// Elements, sequences, items and noise, rarely sound, often deep.
[[nodiscard]] QByteArray randomDataSet(std::mt19937& random, bool explicitVr);

[[nodiscard]] QByteArray explicitElement(
    std::uint32_t tag, const char* vr, const QByteArray& value);
/// Pixel data of these fragments; the first is the offset table.
[[nodiscard]] QByteArray encapsulated(const std::vector<QByteArray>& fragments);
/// 32-bit words, little endian.
[[nodiscard]] QByteArray words(std::initializer_list<std::uint32_t> values);

} // namespace test
