// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/DicomText.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace core {

QString dicomText(const QByteArray& bytes, const QByteArray& characterSet)
{
    const bool plain = std::all_of(
        bytes.begin(), bytes.end(), [](char byte) { return (byte & 0x80) == 0 && byte != 0x1b; });
    if (plain)
        return QString::fromLatin1(bytes).trimmed();
    DcmSpecificCharacterSet converter;
    OFString utf8;
    const OFString text(bytes.constData(), size_t(bytes.size()));
    if (converter.selectCharacterSet(characterSet.constData()).good()
        && converter.convertString(text, utf8, "\\^=").good()) {
        return QString::fromUtf8(utf8.c_str(), qsizetype(utf8.size())).trimmed();
    }
    return QString::fromLatin1(bytes).trimmed();
}

std::optional<double> dicomNumber(std::string_view text)
{
    const auto blank = [](char letter) { return letter == ' ' || letter == '\0'; };
    while (!text.empty() && blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && blank(text.back()))
        text.remove_suffix(1);
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()
        || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

QString dicomDate(const QString& date)
{
    const bool plain = date.size() == 8
        && std::all_of(date.begin(), date.end(), [](QChar letter) { return letter.isDigit(); });
    if (!plain)
        return date;
    return date.left(4) + QLatin1Char('-') + date.mid(4, 2) + QLatin1Char('-') + date.mid(6);
}

} // namespace core
