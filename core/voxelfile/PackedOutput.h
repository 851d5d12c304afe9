// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstddef>

struct gzFile_s;

namespace core {

/// A file under way, as it is or packed with gzip, that remembers the first error.
class PackedOutput {
public:
    enum class Form {
        Plain, ///< begins the file
        Gzip, ///< begins the file
        GzipBehind, ///< one member behind what the file holds
    };

    PackedOutput(const QString& path, Form form);
    PackedOutput(const PackedOutput&) = delete;
    PackedOutput& operator=(const PackedOutput&) = delete;
    ~PackedOutput() { close(); }

    /// Nothing happens after an error.
    void write(const void* bytes, std::size_t size);
    /// @returns why the file is not whole; empty if it is
    QString close();

private:
    void keepReason();

    gzFile_s* m_stream = nullptr;
    QString m_reason;
};

} // namespace core
