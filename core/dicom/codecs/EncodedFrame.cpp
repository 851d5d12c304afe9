// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/EncodedFrame.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace core {

namespace {

using Beginning = std::array<std::uint8_t, 4>;

bool beginsWith(DicomBytes fragment, const Beginning& mark, std::size_t length)
{
    return fragment.size() >= length
        && std::equal(mark.begin(), mark.begin() + std::ptrdiff_t(length), fragment.begin());
}

/// Marks that cannot stand inside a codestream.
bool beginsFrame(DicomBytes fragment, PixelCoding coding)
{
    switch (coding) {
    case PixelCoding::Jpeg:
    case PixelCoding::JpegLs:
        return beginsWith(fragment, {0xff, 0xd8, 0xff, 0}, 3);
    case PixelCoding::Jpeg2000:
        return beginsWith(fragment, {0xff, 0x4f, 0xff, 0x51}, 4)
            || beginsWith(fragment, {0, 0, 0, 0x0c}, 4);
    case PixelCoding::Rle:
    case PixelCoding::Native:
    case PixelCoding::Unknown:
        break;
    }
    return false;
}

} // namespace

std::optional<std::vector<std::uint8_t>> encodedFrame(
    const std::vector<DicomBytes>& fragments, int frame, int frames, PixelCoding coding)
{
    const auto wanted = std::size_t(frame);
    std::size_t first = 0;
    std::size_t end = fragments.size();
    if (frames > 1 && fragments.size() == std::size_t(frames)) {
        first = wanted;
        end = wanted + 1;
    } else if (frames > 1) {
        std::vector<std::size_t> beginnings;
        for (std::size_t index = 0; index < fragments.size(); ++index) {
            if (beginsFrame(fragments[index], coding))
                beginnings.push_back(index);
        }
        const bool told = beginnings.size() == std::size_t(frames) && beginnings.front() == 0;
        if (!told)
            return std::nullopt;
        first = beginnings[wanted];
        end = wanted + 1 < beginnings.size() ? beginnings[wanted + 1] : fragments.size();
    }
    std::vector<std::uint8_t> joined;
    for (std::size_t index = first; index < end && index < fragments.size(); ++index)
        joined.insert(joined.end(), fragments[index].begin(), fragments[index].end());
    return joined;
}

} // namespace core
