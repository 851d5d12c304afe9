// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <cstdint>
#include <random>
#include <vector>

namespace test {

/// A file that was made to harm a DICOM reader.
struct HostileDicom {
    const char* name;
    QByteArray bytes;
    const char* reason; ///< a part of the sentence with which it is refused
    bool onlyWhenDecoded = false; ///< its header is valid
};

/// One file of each kind that crashes or hangs DCMTK 3.6.7, or makes it take more memory than
/// exists. Those with pixels are made from @p honest, a small image in explicit VR little endian.
[[nodiscard]] std::vector<HostileDicom> hostileDicoms(const QByteArray& honest);

/// Files whose deep nesting appears only if their bytes are read as DCMTK reads them.
[[nodiscard]] std::vector<HostileDicom> hiddenNests();

/// A small deflated file whose pixel data claim 2 GB and are 256 MB of zeros, though the image
/// needs few of them.
[[nodiscard]] QByteArray deflatedBomb(int rows, int columns);

/// Random elements, sequences, items and noise, rarely valid, often deeply nested.
[[nodiscard]] QByteArray randomDataSet(std::mt19937& random, bool explicitVr);

[[nodiscard]] QByteArray explicitElement(
    std::uint32_t tag, const char* vr, const QByteArray& value);
/// Encapsulated pixel data of these fragments; the first is the offset table.
[[nodiscard]] QByteArray encapsulated(const std::vector<QByteArray>& fragments);
/// 32-bit words, little endian.
[[nodiscard]] QByteArray words(std::initializer_list<std::uint32_t> values);

} // namespace test
