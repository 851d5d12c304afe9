// SPDX-License-Identifier: Apache-2.0
#include "core/images/TiffEntries.h"

#include "core/images/TiffTags.h"

#include <QFile>

#include <algorithm>

namespace core {

namespace {

/// More slices no volume has.
constexpr std::size_t mostDirectories = 65536;
constexpr std::uint64_t mostEntries = 4096;
/// Of one list, and of a file of few bytes: what it can make us read.
constexpr std::uint64_t mostNumbers = std::uint64_t(1) << 22;
/// A larger file may have as many in all directories together as it needs for strips of twice as
/// many bytes, each of which has a place and a size.
constexpr std::uint64_t fewestBytesPerNumber = 64;
constexpr std::uint64_t longestText = 65536;

int bytesOf(int type)
{
    switch (type) {
    case tiff::Byte:
    case tiff::Ascii:
        return 1;
    case tiff::Short:
        return 2;
    case tiff::Long:
        return 4;
    case tiff::Rational:
    case tiff::Long8:
        return 8;
    default:
        return 0;
    }
}

} // namespace

TiffEntries::TiffEntries(QFile& file)
    : m_file(file)
    , m_fileBytes(std::uint64_t(file.size()))
    , m_numbersLeft(std::max(mostNumbers, m_fileBytes / fewestBytesPerNumber))
{
    constexpr int bigTiff = 43;
    const QByteArray begin = bytesAt(0, 16);
    if (begin.size() < 8)
        return;
    m_big = begin.startsWith('M');
    const bool isBigTiff = integer(begin, 2, 2) == bigTiff;
    if (isBigTiff && begin.size() == 16 && integer(begin, 4, 2) == 8) {
        m_offsetBytes = 8;
        m_next = integer(begin, 8, 8);
    } else if (!isBigTiff) {
        m_next = integer(begin, 4, 4);
    }
}

QByteArray TiffEntries::bytesAt(std::uint64_t at, std::uint64_t size) const
{
    if (at > m_fileBytes || size > m_fileBytes - at || !m_file.seek(qint64(at)))
        return {};
    return m_file.read(qint64(size));
}

std::uint64_t TiffEntries::integer(const QByteArray& bytes, qsizetype at, int size) const
{
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) {
        const qsizetype from = m_big ? at + i : at + size - 1 - i;
        value = (value << 8) | std::uint8_t(bytes[from]);
    }
    return value;
}

bool TiffEntries::fail(const Clause& reason)
{
    m_reason = reason;
    return false;
}

bool TiffEntries::next()
{
    m_entries.clear();
    if (m_next == 0)
        return m_seen.empty() ? fail(Clause::saying("it has no directory")) : false;
    if (!m_seen.insert(m_next).second || m_seen.size() > mostDirectories)
        return fail(Clause::saying("its directories do not come to an end"));
    const bool isLong = m_offsetBytes == 8;
    const int countBytes = isLong ? 8 : 2;
    const int entryBytes = isLong ? 20 : 12;
    const QByteArray head = bytesAt(m_next, std::uint64_t(countBytes));
    const std::uint64_t count = head.size() == countBytes ? integer(head, 0, countBytes) : 0;
    if (count == 0 || count > mostEntries)
        return fail(Clause::saying("a directory of it is damaged"));
    const std::uint64_t size = count * std::uint64_t(entryBytes);
    const QByteArray all =
        bytesAt(m_next + std::uint64_t(countBytes), size + std::uint64_t(m_offsetBytes));
    if (all.isEmpty())
        return fail(Clause::saying("a directory of it is cut short"));
    for (qsizetype at = 0; at < qsizetype(size); at += entryBytes) {
        m_entries.emplace(int(integer(all, at, 2)),
            Entry{.type = int(integer(all, at + 2, 2)),
                .count = integer(all, at + 4, m_offsetBytes),
                .value = all.mid(at + 4 + m_offsetBytes, m_offsetBytes)});
    }
    m_next = integer(all, qsizetype(size), m_offsetBytes);
    return true;
}

QByteArray TiffEntries::valuesOf(const Entry& entry, std::uint64_t count) const
{
    const auto each = std::uint64_t(bytesOf(entry.type));
    if (each == 0 || entry.count < count || count > mostNumbers)
        return {};
    if (entry.count * each <= std::uint64_t(m_offsetBytes) && entry.count <= mostNumbers)
        return entry.value.left(qsizetype(count * each));
    return bytesAt(integer(entry.value, 0, m_offsetBytes), count * each);
}

std::optional<std::uint64_t> TiffEntries::number(int tag, std::uint64_t otherwise) const
{
    const auto found = m_entries.find(tag);
    if (found == m_entries.end())
        return otherwise;
    const int type = found->second.type;
    if (type != tiff::Byte && type != tiff::Short && type != tiff::Long && type != tiff::Long8)
        return std::nullopt;
    const QByteArray bytes = valuesOf(found->second, 1);
    return bytes.isEmpty() ? std::nullopt : std::optional(integer(bytes, 0, bytesOf(type)));
}

std::optional<std::vector<std::uint64_t>> TiffEntries::numbers(int tag, std::uint64_t atLeast)
{
    const auto found = m_entries.find(tag);
    if (found == m_entries.end() || atLeast > m_numbersLeft)
        return std::nullopt;
    const int type = found->second.type;
    if (type != tiff::Short && type != tiff::Long && type != tiff::Long8)
        return std::nullopt;
    m_numbersLeft -= atLeast;
    const QByteArray bytes = valuesOf(found->second, atLeast);
    const int each = bytesOf(type);
    if (std::uint64_t(bytes.size()) != atLeast * std::uint64_t(each))
        return std::nullopt;
    std::vector<std::uint64_t> values(atLeast);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = integer(bytes, qsizetype(i) * each, each);
    return values;
}

double TiffEntries::rational(int tag) const
{
    const auto found = m_entries.find(tag);
    if (found == m_entries.end() || found->second.type != tiff::Rational)
        return 0.0;
    const QByteArray bytes = valuesOf(found->second, 1);
    const std::uint64_t under = bytes.size() == 8 ? integer(bytes, 4, 4) : 0;
    return under == 0 ? 0.0 : double(integer(bytes, 0, 4)) / double(under);
}

QByteArray TiffEntries::text(int tag) const
{
    const auto found = m_entries.find(tag);
    if (found == m_entries.end() || found->second.type != tiff::Ascii)
        return {};
    return valuesOf(found->second, std::min(found->second.count, longestText));
}

} // namespace core
