// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ModalityLut.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

namespace core {

namespace {

/// One number of the descriptor by its bits: some writers call them signed, others do not.
bool descriptor(DcmItem& item, unsigned long index, std::uint16_t& bits)
{
    Uint16 plain = 0;
    if (item.findAndGetUint16(DCM_LUTDescriptor, plain, index).good()) {
        bits = plain;
        return true;
    }
    Sint16 withSign = 0;
    const bool found = item.findAndGetSint16(DCM_LUTDescriptor, withSign, index).good();
    bits = std::uint16_t(withSign);
    return found;
}

} // namespace

void ModalityLut::apply(std::span<std::uint16_t> stored, bool isSigned) const
{
    const int last = int(values.size()) - 1;
    for (std::uint16_t& value : stored) {
        const int number = isSigned ? int(std::int16_t(value)) : int(value);
        value = values[std::size_t(std::clamp(number - first, 0, last))];
    }
}

bool hasModalityLut(DcmItem& set)
{
    DcmElement* element = nullptr;
    if (set.findAndGetElement(DCM_ModalityLUTSequence, element).bad())
        return false;
    const auto* sequence = dynamic_cast<const DcmSequenceOfItems*>(element);
    return sequence ? sequence->card() > 0 : element->getLength() > 0;
}

std::shared_ptr<const ModalityLut> readModalityLut(DcmItem& set, bool isSigned)
{
    DcmItem* item = nullptr;
    std::uint16_t entries = 0;
    std::uint16_t first = 0;
    std::uint16_t bits = 0;
    if (set.findAndGetSequenceItem(DCM_ModalityLUTSequence, item).bad()
        || !descriptor(*item, 0, entries) || !descriptor(*item, 1, first)
        || !descriptor(*item, 2, bits))
        return nullptr;
    const std::size_t wanted = entries == 0 ? 65536 : entries;
    const Uint16* data = nullptr;
    unsigned long count = 0;
    if (item->findAndGetUint16Array(DCM_LUTData, data, &count).bad() || data == nullptr)
        return nullptr;
    auto lut = std::make_shared<ModalityLut>();
    lut->first = isSigned ? int(std::int16_t(first)) : int(first);
    if (count >= wanted) {
        lut->values.assign(data, data + wanted);
    } else if (bits == 8 && 2 * count >= wanted) {
        // Two entries of eight bits in each word.
        for (std::size_t entry = 0; entry < wanted; ++entry)
            lut->values.push_back(std::uint16_t((data[entry / 2] >> (entry % 2 * 8)) & 0xffu));
    } else {
        return nullptr;
    }
    return lut;
}

} // namespace core
