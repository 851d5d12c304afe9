// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Inflater.h"

#include <zlib.h>

#include <algorithm>
#include <new>

namespace core {

struct Inflater::Stream : z_stream {
    explicit Stream(DicomBytes deflated)
        : z_stream{}
        , rest(deflated)
    {
    }

    DicomBytes rest; ///< beyond what avail_in, 32 bits, has been given
};

Inflater::Inflater(DicomBytes deflated)
    : m_stream(std::make_unique<Stream>(deflated))
{
    if (inflateInit2(m_stream.get(), -MAX_WBITS) != Z_OK)
        throw std::bad_alloc(); // nothing was read that could be wrong
}

Inflater::~Inflater()
{
    inflateEnd(m_stream.get());
}

Inflater::State Inflater::growTo(std::size_t size, std::size_t freeBytes)
{
    constexpr std::size_t maximumRatio = 200;
    constexpr std::size_t maximumOutput = std::size_t(1) << 30;
    constexpr std::size_t chunk = 1 << 18;
    while (m_state == State::More && m_output.size() < size) {
        const std::size_t before = m_output.size();
        if (before >= maximumOutput
            || (before > freeBytes && before / maximumRatio > m_stream->total_in)) {
            m_state = State::TooLarge;
            break;
        }
        if (m_stream->avail_in == 0) {
            const std::size_t next = std::min<std::size_t>(m_stream->rest.size(), 1u << 30);
            m_stream->next_in = const_cast<Bytef*>(m_stream->rest.data());
            m_stream->avail_in = uInt(next);
            m_stream->rest = m_stream->rest.subspan(next);
        }
        const std::size_t wanted = std::min(chunk, size - before);
        m_output.resize(before + wanted);
        m_stream->next_out = m_output.data() + before;
        m_stream->avail_out = uInt(wanted);
        const int result = inflate(m_stream.get(), Z_NO_FLUSH);
        if (result == Z_MEM_ERROR)
            throw std::bad_alloc();
        m_output.resize(before + wanted - m_stream->avail_out);
        if (result == Z_STREAM_END)
            m_state = State::Finished;
        else if (result != Z_OK && !(result == Z_BUF_ERROR && !m_stream->rest.empty()))
            m_state = State::Damaged;
    }
    return m_state;
}

} // namespace core
