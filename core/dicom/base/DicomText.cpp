// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomText.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>

#include <QByteArrayList>

#include <iconv.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace core {

namespace {

std::optional<QString> convert(const QByteArray& bytes, const char* encoding)
{
    const iconv_t converter = iconv_open("UTF-8", encoding);
    if (converter == iconv_t(-1))
        return std::nullopt;
    QByteArray input = bytes;
    // No character of these encodings takes more than four bytes in UTF-8.
    QByteArray output(4 * bytes.size(), Qt::Uninitialized);
    char* from = input.data();
    char* to = output.data();
    auto fromLeft = std::size_t(input.size());
    auto toLeft = std::size_t(output.size());
    const bool good = iconv(converter, &from, &fromLeft, &to, &toLeft) != std::size_t(-1);
    iconv_close(converter);
    if (!good)
        return std::nullopt;
    return QString::fromUtf8(output.constData(), output.size() - qsizetype(toLeft));
}

/// The parts between delimiters, with these at their ends. In a character of two bytes a
/// delimiter's byte is none: 秀 is 3D 28 there, and 3D is '='.
QByteArrayList delimitedParts(const QByteArray& bytes)
{
    QByteArrayList parts{QByteArray()};
    bool twoBytes = false;
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        if (bytes[i] == '\x1b' && i + 1 < bytes.size()
            && (bytes[i + 1] == '$' || bytes[i + 1] == '('))
            twoBytes = bytes[i + 1] == '$';
        parts.back() += bytes[i];
        if (!twoBytes && (bytes[i] == '=' || bytes[i] == '\\'))
            parts += QByteArray();
    }
    return parts;
}

/// Japanese text with code extensions (PS3.5 6.1.2.5): DCMTK over glibc cannot open ISO 2022 IR 87
/// and 159. Escapes make a component group ISO-2022-JP-2, bytes with the high bit JIS X 0201.
std::optional<QString> japaneseText(const QByteArray& bytes)
{
    const QByteArrayList parts = delimitedParts(bytes);
    QString all;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        QByteArray part = parts[i];
        // By itself, since a backslash is the yen sign in both encodings.
        QString delimiter;
        if (i + 1 < parts.size()) {
            delimiter = QLatin1Char(part.back());
            part.chop(1);
        }
        const std::optional<QString> text =
            convert(part, part.contains('\x1b') ? "ISO-2022-JP-2" : "SHIFT_JIS");
        if (!text)
            return std::nullopt;
        all += *text + delimiter;
    }
    return all.trimmed();
}

} // namespace

bool isPlainText(const QByteArray& bytes)
{
    return std::all_of(
        bytes.begin(), bytes.end(), [](char byte) { return (byte & 0x80) == 0 && byte != 0x1b; });
}

QString dicomText(const QByteArray& bytes, const QByteArray& characterSet)
{
    if (isPlainText(bytes))
        return QString::fromLatin1(bytes).trimmed();
    DcmSpecificCharacterSet converter;
    OFString utf8;
    const OFString text(bytes.constData(), size_t(bytes.size()));
    if (converter.selectCharacterSet(characterSet.constData()).good()
        && converter.convertString(text, utf8, "\\^=").good()) {
        return QString::fromUtf8(utf8.c_str(), qsizetype(utf8.size())).trimmed();
    }
    for (const char* term : {"IR 87", "IR 159", "IR 13"}) {
        if (!characterSet.contains(term))
            continue;
        if (const std::optional<QString> japanese = japaneseText(bytes))
            return *japanese;
    }
    // Text of another character set is hardly ever UTF-8 by chance.
    if (const std::optional<QString> unicode = convert(bytes, "UTF-8"))
        return unicode->trimmed();
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
