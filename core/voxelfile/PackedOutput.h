// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>

#include <cstddef>

struct gzFile_s;

namespace core {

/// A file that is being written, plain or compressed with gzip. It remembers the first error.
class PackedOutput {
public:
    enum class Form {
        Plain, ///< begins a new file
        Gzip, ///< begins a new file
        GzipBehind, ///< appends one member to the file
    };

    PackedOutput(const QString& path, Form form);
    PackedOutput(const PackedOutput&) = delete;
    PackedOutput& operator=(const PackedOutput&) = delete;
    ~PackedOutput() { close(); }

    /// Does nothing after an error.
    void write(const void* bytes, std::size_t size);
    /// @returns why the file is incomplete; empty if it is complete
    Clause close();

private:
    void keepReason();

    gzFile_s* m_stream = nullptr;
    Clause m_reason;
};

} // namespace core
