// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SegWriter.h"

#include <utility>

namespace core {

void FrameBits::append(std::span<const std::uint8_t> labels, std::uint8_t label)
{
    m_bytes.resize((m_bits + labels.size() + 7) / 8, 0);
    for (const std::uint8_t value : labels) {
        m_bytes[m_bits / 8] |= std::uint8_t(unsigned(value == label) << (m_bits % 8));
        ++m_bits;
    }
}

std::vector<std::uint8_t> FrameBits::take()
{
    m_bytes.resize((m_bytes.size() + 1) / 2 * 2, 0);
    m_bits = 0;
    return std::exchange(m_bytes, {});
}

} // namespace core
