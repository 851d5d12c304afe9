// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomElement.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

bool hasShortLength(std::string_view vr)
{
    constexpr std::array<std::string_view, 20> shortOnes{"AE", "AS", "AT", "CS", "DA", "DS", "DT",
        "FD", "FL", "IS", "LO", "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL"};
    return vr == "US" || std::find(shortOnes.begin(), shortOnes.end(), vr) != shortOnes.end();
}

} // namespace

std::uint16_t readUint16(DicomBytes bytes, std::size_t at, bool bigEndian)
{
    return bigEndian ? std::uint16_t(bytes[at] << 8 | bytes[at + 1])
                     : std::uint16_t(bytes[at + 1] << 8 | bytes[at]);
}

std::uint32_t readUint32(DicomBytes bytes, std::size_t at, bool bigEndian)
{
    const std::uint32_t first = readUint16(bytes, at, bigEndian);
    const std::uint32_t second = readUint16(bytes, at + 2, bigEndian);
    return bigEndian ? first << 16 | second : second << 16 | first;
}

std::uint32_t readTag(DicomBytes bytes, std::size_t at, bool bigEndian)
{
    return std::uint32_t(readUint16(bytes, at, bigEndian)) << 16
        | readUint16(bytes, at + 2, bigEndian);
}

bool looksLikeVr(DicomBytes bytes, std::size_t at)
{
    const auto isLetter = [](std::uint8_t byte) { return byte >= 'A' && byte <= 'Z'; };
    return isLetter(bytes[at]) && isLetter(bytes[at + 1]);
}

QString tagText(std::uint32_t tag)
{
    return QStringLiteral("(%1,%2)")
        .arg(tag >> 16, 4, 16, QLatin1Char('0'))
        .arg(tag & 0xffff, 4, 16, QLatin1Char('0'));
}

bool readElement(DicomBytes bytes, std::size_t at, const DataSetForm& form, DicomElement& element)
{
    if (bytes.size() - at < 8)
        return false;
    element.tag = readTag(bytes, at, form.bigEndian);
    element.vr = {};
    element.value = at + 8;
    const bool isDelimiter = element.tag == dicom_tag::item || element.tag == dicom_tag::itemEnd
        || element.tag == dicom_tag::sequenceEnd;
    if (!form.explicitVr || isDelimiter) {
        element.length = readUint32(bytes, at + 4, form.bigEndian);
        return true;
    }
    element.vr = {reinterpret_cast<const char*>(bytes.data()) + at + 4, 2};
    // Letters that name no VR are one of the future, and those have long lengths; whatever is no
    // letters at all has a short one.
    if (hasShortLength(element.vr) || !looksLikeVr(bytes, at + 4)) {
        element.length = readUint16(bytes, at + 6, form.bigEndian);
        return true;
    }
    if (bytes.size() - at < 12)
        return false;
    element.length = readUint32(bytes, at + 8, form.bigEndian);
    element.value = at + 12;
    return true;
}

} // namespace core
