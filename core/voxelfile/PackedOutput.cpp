// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/PackedOutput.h"

#include <QFile>

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace core {

namespace {

const char* modeOf(PackedOutput::Form form)
{
    switch (form) {
    case PackedOutput::Form::Plain:
        return "wbT";
    case PackedOutput::Form::Gzip:
        return "wb6";
    case PackedOutput::Form::GzipBehind:
        break;
    }
    return "ab6";
}

} // namespace

PackedOutput::PackedOutput(const QString& path, Form form)
{
    errno = 0;
    m_stream = gzopen(QFile::encodeName(path).constData(), modeOf(form));
    if (m_stream == nullptr)
        keepReason();
}

void PackedOutput::write(const void* bytes, std::size_t size)
{
    constexpr std::size_t chunk = 1U << 26;
    const char* next = static_cast<const char*>(bytes);
    while (size > 0 && m_reason.isEmpty()) {
        const std::size_t part = std::min(size, chunk);
        errno = 0;
        if (gzwrite(m_stream, next, unsigned(part)) != int(part))
            keepReason();
        next += part;
        size -= part;
    }
}

Clause PackedOutput::close()
{
    if (m_stream != nullptr) {
        errno = 0;
        if (gzclose(m_stream) != Z_OK && m_reason.isEmpty())
            keepReason();
        m_stream = nullptr;
    }
    return m_reason;
}

void PackedOutput::keepReason()
{
    m_reason = errno != 0 ? Clause(QString::fromLocal8Bit(std::strerror(errno)))
                          : Clause::saying("compression failed");
}

} // namespace core
