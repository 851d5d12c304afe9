// SPDX-License-Identifier: Apache-2.0
#include "core/delta/DeltaStream.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <array>
#include <new>

namespace core {

namespace {

/// Growths shrink a fifth further than at zstd's default; a stroke costs a millisecond either way.
constexpr int compressionLevel = 9;

} // namespace

DeltaWriter::DeltaWriter()
    : m_stream(ZSTD_createCStream(), ZSTD_freeCStream)
{
    if (!m_stream)
        throw std::bad_alloc();
    ZSTD_CCtx_setParameter(m_stream.get(), ZSTD_c_compressionLevel, compressionLevel);
    ZSTD_CCtx_setParameter(m_stream.get(), ZSTD_c_checksumFlag, 1);
}

DeltaWriter::~DeltaWriter() = default;

void DeltaWriter::add(const void* data, std::size_t size)
{
    feed(data, size, false);
}

std::vector<QByteArray> DeltaWriter::finish()
{
    feed(nullptr, 0, true);
    m_pieces.back().resize(qsizetype(m_filled));
    m_pieces.back().squeeze();
    return std::move(m_pieces);
}

void DeltaWriter::feed(const void* data, std::size_t size, bool end)
{
    ZSTD_inBuffer input{data, size, 0};
    while (true) {
        if (m_pieces.empty() || m_filled == BrickDelta::maxPieceBytes) {
            m_pieces.emplace_back(qsizetype(BrickDelta::maxPieceBytes), Qt::Uninitialized);
            m_filled = 0;
        }
        ZSTD_outBuffer output{m_pieces.back().data(), BrickDelta::maxPieceBytes, m_filled};
        const std::size_t left = ZSTD_compressStream2(
            m_stream.get(), &output, &input, end ? ZSTD_e_end : ZSTD_e_continue);
        if (ZSTD_isError(left))
            throw std::bad_alloc();
        m_filled = output.pos;
        if (end ? left == 0 : input.pos == input.size)
            return;
    }
}

DeltaReader::DeltaReader(const BrickDelta& delta)
    : m_delta(delta)
    , m_stream(ZSTD_createDStream(), ZSTD_freeDStream)
{
    if (!m_stream)
        throw std::bad_alloc();
}

DeltaReader::~DeltaReader() = default;

std::size_t DeltaReader::take(void* data, std::size_t size)
{
    ZSTD_outBuffer output{data, size, 0};
    while (output.pos < output.size && !m_complete && !m_failed) {
        if (m_piece < m_delta.pieces.size()
            && m_position == std::size_t(m_delta.pieces[m_piece].size())) {
            ++m_piece;
            m_position = 0;
        }
        const bool more = m_piece < m_delta.pieces.size();
        const QByteArray piece = more ? m_delta.pieces[m_piece] : QByteArray();
        ZSTD_inBuffer input{piece.constData(), std::size_t(piece.size()), m_position};
        const std::size_t before = output.pos;
        const std::size_t status = ZSTD_decompressStream(m_stream.get(), &output, &input);
        if (ZSTD_getErrorCode(status) == ZSTD_error_memory_allocation)
            throw std::bad_alloc();
        m_failed = ZSTD_isError(status) != 0;
        m_complete = status == 0;
        const bool stuck = output.pos == before && input.pos == m_position;
        m_position = input.pos;
        if (stuck && !more)
            break;
    }
    return output.pos;
}

bool DeltaReader::complete()
{
    std::array<char, 1> further{};
    return take(further.data(), further.size()) == 0 && m_complete && !m_failed;
}

} // namespace core
