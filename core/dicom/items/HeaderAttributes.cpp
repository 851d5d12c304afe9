// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/HeaderAttributes.h"

#include "core/dicom/base/DicomText.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QList>

namespace core {

QByteArray HeaderAttributes::bytes(const DcmTagKey& key) const
{
    OFString value;
    if (m_item.findAndGetOFStringArray(key, value).bad())
        return {};
    return QByteArray(value.c_str(), qsizetype(value.size()));
}

QString HeaderAttributes::text(const DcmTagKey& key) const
{
    return dicomText(bytes(key), m_characterSet);
}

int HeaderAttributes::integer(const DcmTagKey& key, int otherwise) const
{
    Uint16 value = 0;
    return m_item.findAndGetUint16(key, value).good() ? int(value) : otherwise;
}

std::vector<double> HeaderAttributes::numbers(const DcmTagKey& key) const
{
    std::vector<double> values;
    const QByteArray all = bytes(key);
    if (all.isEmpty())
        return values;
    for (const QByteArray& one : all.split('\\')) {
        const std::optional<double> value =
            dicomNumber(std::string_view(one.constData(), std::size_t(one.size())));
        if (!value)
            return {};
        values.push_back(*value);
    }
    return values;
}

std::optional<double> HeaderAttributes::number(const DcmTagKey& key) const
{
    const std::vector<double> values = numbers(key);
    return values.empty() ? std::nullopt : std::optional<double>(values.front());
}

bool HeaderAttributes::has(const DcmTagKey& key) const
{
    return m_item.tagExists(key);
}

} // namespace core
