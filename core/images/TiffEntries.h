// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

class QFile;

namespace core {

/// Reads the directories of a TIFF or BigTIFF as tags and numbers, without interpreting them.
class TiffEntries {
public:
    /// @param file open; must outlive this
    explicit TiffEntries(QFile& file);

    /// Goes to the next directory, at first to the first one. False at the end, or if reason() is
    /// not empty.
    [[nodiscard]] bool next();
    /// What is wrong with the directories; empty: nothing.
    [[nodiscard]] const Clause& reason() const { return m_reason; }
    [[nodiscard]] bool isBigEndian() const { return m_big; }

    // These refer to the present directory.
    [[nodiscard]] bool has(int tag) const { return m_entries.contains(tag); }
    /// The single number of a tag, or @p otherwise if the tag is missing; none if it is not a
    /// single number.
    [[nodiscard]] std::optional<std::uint64_t> number(int tag, std::uint64_t otherwise) const;
    /// At least that many numbers; none if there are fewer, or if all directories together have too
    /// many for the size of the file.
    [[nodiscard]] std::optional<std::vector<std::uint64_t>> numbers(int tag, std::uint64_t atLeast);
    /// A quotient; 0 if there is none.
    [[nodiscard]] double rational(int tag) const;
    [[nodiscard]] QByteArray text(int tag) const;

private:
    struct Entry {
        int type = 0;
        std::uint64_t count = 0;
        QByteArray value; ///< the value itself, or its position
    };
    [[nodiscard]] QByteArray bytesAt(std::uint64_t at, std::uint64_t size) const;
    /// An integer of @p size bytes in the file's byte order.
    [[nodiscard]] std::uint64_t integer(const QByteArray& bytes, qsizetype at, int size) const;
    /// The first @p count values as stored; empty if the file does not contain them.
    [[nodiscard]] QByteArray valuesOf(const Entry& entry, std::uint64_t count) const;
    [[nodiscard]] bool fail(const Clause& reason);

    QFile& m_file;
    std::uint64_t m_fileBytes;
    Clause m_reason;
    std::map<int, Entry> m_entries;
    std::uint64_t m_next = 0; ///< position of the next directory; 0: none
    std::set<std::uint64_t> m_seen; ///< positions of the directories that were read
    std::uint64_t m_numbersLeft;
    bool m_big = false; ///< byte order
    int m_offsetBytes = 4; ///< 8 in BigTIFF
};

} // namespace core
