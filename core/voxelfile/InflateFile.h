// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QFile>

#include <cstddef>
#include <memory>
#include <span>

namespace core {

/// Decompresses a file from its present position on, as far as is requested.
class InflateFile {
public:
    /// The greatest possible compression ratio (RFC 1951: 258 bytes for two bits), with room for
    /// headers.
    static constexpr double greatestRatio = 1040.0;

    /// @param file open, at the first compressed byte; must outlive this
    /// @param gzipOnly whether a zlib stream is an error
    InflateFile(QFile& file, bool gzipOnly);
    InflateFile(const InflateFile&) = delete;
    InflateFile& operator=(const InflateFile&) = delete;
    ~InflateFile();

    /// @return the number of bytes read; fewer than requested at the end, or if reason() is not
    /// empty
    [[nodiscard]] std::size_t read(std::span<char> into);
    /// Why no more can be read. Empty after a proper end, and if the file ends in the middle of the
    /// requested bytes.
    [[nodiscard]] const Clause& reason() const { return m_reason; }

private:
    struct Stream;
    /// Reads input for the stream; false at the end of the file.
    bool refill();

    QFile& m_file;
    std::unique_ptr<Stream> m_stream;
    Clause m_reason;
    bool m_ended = false;
};

} // namespace core
