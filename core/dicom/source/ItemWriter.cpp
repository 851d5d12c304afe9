// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/ItemWriter.h"

#include "core/dicom/items/PatientHeader.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <map>
#include <set>

namespace core {

DcmItem* ItemWriter::append(DcmItem* parent, const DcmTagKey& sequence) const
{
    DcmItem* item = nullptr;
    if (parent != nullptr)
        m_chain(parent->findOrCreateSequenceItem(sequence, item, -2), "sequence");
    return item;
}

void ItemWriter::put(DcmItem* item, const DcmTagKey& tag, const std::string& value) const
{
    if (item != nullptr)
        m_chain(item->putAndInsertString(tag, value.c_str()), "attribute");
}

void ItemWriter::put(DcmItem* item, const DcmTagKey& tag, const QString& value) const
{
    put(item, tag, value.toStdString());
}

void ItemWriter::put(DcmItem* item, const DcmTagKey& tag, const char* value) const
{
    put(item, tag, std::string(value));
}

void ItemWriter::putWord(DcmItem* item, const DcmTagKey& tag, int value) const
{
    if (item != nullptr)
        m_chain(item->putAndInsertUint16(tag, Uint16(value)), "attribute");
}

void ItemWriter::putFloats(
    DcmItem* item, const DcmTagKey& tag, const std::vector<glm::dvec3>& places) const
{
    if (item == nullptr)
        return;
    std::vector<Float32> numbers;
    for (const glm::dvec3& place : places) {
        for (int axis = 0; axis < 3; ++axis)
            numbers.push_back(Float32(place[axis]));
    }
    m_chain(item->putAndInsertFloat32Array(
                tag, numbers.data(), static_cast<unsigned long>(numbers.size())),
        "attribute");
}

void ItemWriter::putCode(DcmItem* item, const DcmTagKey& sequence, const CodedConcept& code) const
{
    DcmItem* coded = append(item, sequence);
    put(coded, DCM_CodeValue, code.value);
    put(coded, DCM_CodingSchemeDesignator, code.scheme);
    put(coded, DCM_CodeMeaning, code.meaning);
}

void ItemWriter::refer(DcmItem* item, const SegSlice& slice) const
{
    put(item, DCM_ReferencedSOPClassUID, slice.sopClassUid);
    put(item, DCM_ReferencedSOPInstanceUID, slice.sopInstanceUid);
    if (slice.multiFrame)
        put(item, DCM_ReferencedFrameNumber, std::to_string(slice.frame + 1));
}

void ItemWriter::referAll(DcmItem* parent, const DcmTagKey& seriesSequence,
    const DcmTagKey& imageSequence, const std::vector<SegSlice>& slices) const
{
    std::map<std::string, DcmItem*> series;
    std::set<std::string> named;
    for (const SegSlice& slice : slices) {
        if (!named.insert(slice.sopInstanceUid).second)
            continue;
        auto [item, isNew] = series.try_emplace(slice.seriesUid, nullptr);
        if (isNew) {
            item->second = append(parent, seriesSequence);
            put(item->second, DCM_SeriesInstanceUID, slice.seriesUid);
        }
        DcmItem* image = append(item->second, imageSequence);
        put(image, DCM_ReferencedSOPClassUID, slice.sopClassUid);
        put(image, DCM_ReferencedSOPInstanceUID, slice.sopInstanceUid);
    }
}

bool fitsCodeSequence(const CodedConcept& code)
{
    const auto fits = [](const QString& text, int length) {
        return !text.isEmpty() && text == singleValueText(text, length);
    };
    const auto plain = [](const QString& text) {
        return std::all_of(
            text.begin(), text.end(), [](QChar letter) { return letter.unicode() < 128; });
    };
    return fits(code.value, 16) && fits(code.scheme, 16) && fits(code.meaning, 64)
        && plain(code.value) && plain(code.scheme);
}

} // namespace core
