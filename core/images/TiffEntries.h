// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

class QFile;

namespace core {

/// Reads the directories of a TIFF or BigTIFF as they lie there: tags and numbers, no meaning.
class TiffEntries {
public:
    /// @param file open; must outlive this
    explicit TiffEntries(QFile& file);

    /// Goes on to the next directory, the first at first. False at the end, and where reason() is
    /// not empty.
    [[nodiscard]] bool next();
    /// What is wrong with the directories; empty: nothing.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    [[nodiscard]] bool isBigEndian() const { return m_big; }

    // Of the present directory.
    [[nodiscard]] bool has(int tag) const { return m_entries.contains(tag); }
    /// The only number of a tag, or @p otherwise where it is not there; none where it is not one.
    [[nodiscard]] std::optional<std::uint64_t> number(int tag, std::uint64_t otherwise) const;
    /// So many numbers; none where there are not as many, or all directories together have too
    /// many.
    [[nodiscard]] std::optional<std::vector<std::uint64_t>> numbers(int tag, std::uint64_t atLeast);
    /// A quotient; 0 where there is none.
    [[nodiscard]] double rational(int tag) const;
    [[nodiscard]] QByteArray text(int tag) const;

private:
    struct Entry {
        int type = 0;
        std::uint64_t count = 0;
        QByteArray value; ///< itself or where it lies
    };
    [[nodiscard]] QByteArray bytesAt(std::uint64_t at, std::uint64_t size) const;
    /// An integer of as many bytes, in the file's order.
    [[nodiscard]] std::uint64_t integer(const QByteArray& bytes, qsizetype at, int size) const;
    /// The first @p count values as they lie there; empty if the file does not hold them.
    [[nodiscard]] QByteArray valuesOf(const Entry& entry, std::uint64_t count) const;
    [[nodiscard]] bool fail(const QString& reason);

    QFile& m_file;
    std::uint64_t m_fileBytes;
    QString m_reason;
    std::map<int, Entry> m_entries;
    std::uint64_t m_next = 0; ///< where the next directory lies; 0: none
    std::set<std::uint64_t> m_seen; ///< where directories lie that were read
    std::uint64_t m_numbersLeft;
    bool m_big = false; ///< byte order
    int m_offsetBytes = 4; ///< 8 in BigTIFF
};

} // namespace core
