// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/ItemReader.h"

#include <QStringList>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace core {

QString ItemReader::text(const DcmTagKey& tag) const
{
    OFString value;
    if (m_item == nullptr || m_item->findAndGetOFStringArray(tag, value).bad())
        return {};
    QString text = QString::fromUtf8(value.data(), qsizetype(value.size()));
    while (text.endsWith(QChar(0)))
        text.chop(1);
    return text.trimmed();
}

std::optional<int> ItemReader::integer(const DcmTagKey& tag) const
{
    bool known = false;
    const int value = text(tag).toInt(&known);
    return known ? std::optional(value) : std::nullopt;
}

std::vector<double> ItemReader::numbers(const DcmTagKey& tag) const
{
    std::vector<double> values;
    for (const QString& one : text(tag).split(QLatin1Char('\\'))) {
        QByteArray part = one.trimmed().toLatin1();
        if (part.startsWith('+'))
            part.remove(0, 1);
        const char* end = part.constData() + part.size();
        double value = 0.0;
        const auto parsed = std::from_chars(part.constData(), end, value);
        if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value))
            return {};
        values.push_back(value);
    }
    return values;
}

template <std::size_t N>
std::optional<std::array<double, N>> ItemReader::exactly(const DcmTagKey& tag) const
{
    const std::vector<double> all = numbers(tag);
    if (all.size() != N)
        return std::nullopt;
    std::array<double, N> values{};
    std::copy(all.begin(), all.end(), values.begin());
    return values;
}

std::optional<std::array<double, 2>> ItemReader::pair(const DcmTagKey& tag) const
{
    return exactly<2>(tag);
}

std::optional<std::array<double, 3>> ItemReader::triple(const DcmTagKey& tag) const
{
    return exactly<3>(tag);
}

std::optional<std::array<double, 6>> ItemReader::sextuple(const DcmTagKey& tag) const
{
    return exactly<6>(tag);
}

std::vector<float> ItemReader::floats(const DcmTagKey& tag) const
{
    const Float32* values = nullptr;
    unsigned long count = 0;
    if (m_item == nullptr || m_item->findAndGetFloat32Array(tag, values, &count).bad()
        || values == nullptr)
        return {};
    return {values, values + count};
}

ItemReader ItemReader::item(const DcmTagKey& sequence, int index) const
{
    DcmItem* found = nullptr;
    if (m_item == nullptr || m_item->findAndGetSequenceItem(sequence, found, index).bad())
        return ItemReader(nullptr);
    return ItemReader(found);
}

int ItemReader::itemCount(const DcmTagKey& sequence) const
{
    DcmSequenceOfItems* found = nullptr;
    if (m_item == nullptr || m_item->findAndGetSequence(sequence, found).bad() || found == nullptr)
        return 0;
    return int(found->card());
}

ItemReader ItemReader::functionalGroup(const DcmTagKey& macro, int frame) const
{
    const ItemReader own = item(DCM_PerFrameFunctionalGroupsSequence, frame).item(macro);
    return own.valid() ? own : item(DCM_SharedFunctionalGroupsSequence).item(macro);
}

} // namespace core
