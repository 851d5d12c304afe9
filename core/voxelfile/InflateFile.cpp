// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/InflateFile.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

namespace core {

namespace {

constexpr int gzipHeader = 16;
constexpr int eitherHeader = 32;
constexpr unsigned char gzipMagic = 0x1f;

} // namespace

struct InflateFile::Stream {
    z_stream z{};
    std::array<unsigned char, 262144> input;
};

InflateFile::InflateFile(QFile& file, bool gzipOnly)
    : m_file(file)
    , m_stream(std::make_unique<Stream>())
{
    if (inflateInit2(&m_stream->z, MAX_WBITS + (gzipOnly ? gzipHeader : eitherHeader)) != Z_OK)
        throw std::bad_alloc(); // nothing was read that could be wrong
}

InflateFile::~InflateFile()
{
    inflateEnd(&m_stream->z);
}

bool InflateFile::refill()
{
    if (m_stream->z.avail_in > 0)
        return true;
    const qint64 got = m_file.read(
        reinterpret_cast<char*>(m_stream->input.data()), qint64(m_stream->input.size()));
    m_stream->z.next_in = m_stream->input.data();
    m_stream->z.avail_in = unsigned(std::max<qint64>(got, 0));
    return got > 0;
}

std::size_t InflateFile::read(std::span<char> into)
{
    z_stream& z = m_stream->z;
    std::size_t done = 0;
    while (done < into.size() && !m_ended && m_reason.isEmpty()) {
        if (!refill()) {
            m_ended = true;
            m_reason = Clause::saying("the packed data break off");
            break;
        }
        const auto part = unsigned(
            std::min<std::size_t>(into.size() - done, std::numeric_limits<unsigned>::max()));
        z.next_out = reinterpret_cast<unsigned char*>(into.data() + done);
        z.avail_out = part;
        const int answer = inflate(&z, Z_NO_FLUSH);
        if (answer == Z_MEM_ERROR)
            throw std::bad_alloc();
        done += part - z.avail_out;
        if (answer == Z_STREAM_END) {
            // Another member may follow; anything else behind the end is no data of ours.
            m_ended = !refill() || *z.next_in != gzipMagic || inflateReset(&z) != Z_OK;
        } else if (answer != Z_OK && answer != Z_BUF_ERROR) {
            m_reason = Clause::saying("the packed data are damaged");
        }
    }
    return done;
}

} // namespace core
