// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace core {

using DicomBytes = std::span<const std::uint8_t>;

namespace dicom_tag {
constexpr std::uint32_t item = 0xfffee000u;
constexpr std::uint32_t itemEnd = 0xfffee00du;
constexpr std::uint32_t sequenceEnd = 0xfffee0ddu;
constexpr std::uint32_t pixelData = 0x7fe00010u;
constexpr std::uint32_t floatPixelData = 0x7fe00008u;
constexpr std::uint32_t doublePixelData = 0x7fe00009u;
} // namespace dicom_tag

constexpr std::uint32_t undefinedLength = 0xffffffffu;

/// How the elements of a data set are written (PS3.5 section 7 and annex A).
struct DataSetForm {
    bool explicitVr = true;
    bool bigEndian = false;
};

/// The header of one data element.
struct DicomElement {
    std::uint32_t tag = 0;
    std::string_view vr{}; ///< points into the bytes; empty in implicit VR and for items
    std::uint32_t length = 0; ///< may be undefinedLength
    std::size_t value = 0; ///< where the value begins

    [[nodiscard]] bool isPrivate() const { return ((tag >> 16) & 1U) != 0; }
};

/// Reads the header that begins at @p at, which must be inside @p bytes. Length fields are taken
/// from where DCMTK takes them, also for an unknown VR: otherwise a file could show its sequences
/// to one parser and hide them from the other.
///
/// @return false if the header does not fit into the bytes
[[nodiscard]] bool readElement(
    DicomBytes bytes, std::size_t at, const DataSetForm& form, DicomElement& element);

[[nodiscard]] std::uint16_t readUint16(DicomBytes bytes, std::size_t at, bool bigEndian);
[[nodiscard]] std::uint32_t readUint32(DicomBytes bytes, std::size_t at, bool bigEndian);
[[nodiscard]] std::uint32_t readTag(DicomBytes bytes, std::size_t at, bool bigEndian);
/// Whether there are two upper-case letters.
[[nodiscard]] bool looksLikeVr(DicomBytes bytes, std::size_t at);
/// "(0028,0010)"
[[nodiscard]] QString tagText(std::uint32_t tag);

} // namespace core
