// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>

#include <cstddef>
#include <memory>
#include <span>

namespace core {

/// What a packed file holds from its place on, unpacked as far as it is asked for.
class InflateFile {
public:
    /// Nothing packs tighter than this (RFC 1951: 258 bytes for two bits), with room for headers.
    static constexpr double greatestRatio = 1040.0;

    /// @param file open, at the first packed byte; must outlive this
    /// @param gzipOnly whether a zlib stream is an error
    InflateFile(QFile& file, bool gzipOnly);
    InflateFile(const InflateFile&) = delete;
    InflateFile& operator=(const InflateFile&) = delete;
    ~InflateFile();

    /// @return how many bytes there were; fewer than asked for at the end or where reason() says
    [[nodiscard]] std::size_t read(std::span<char> into);
    /// Why no more can be read. Empty after a sound end, and where the file stops in the middle of
    /// what had been asked for.
    [[nodiscard]] const QString& reason() const { return m_reason; }

private:
    struct Stream;
    /// Input for the stream; false at the end of the file.
    bool refill();

    QFile& m_file;
    std::unique_ptr<Stream> m_stream;
    QString m_reason;
    bool m_ended = false;
};

} // namespace core
