// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/BrickDelta.h"

#include <memory>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace core {

/// Compresses the bytes of a difference with zstd, and cuts the stream into pieces.
class DeltaWriter {
public:
    DeltaWriter();
    ~DeltaWriter();
    void add(const void* data, std::size_t size);
    template <typename Bytes> void add(const Bytes& bytes) { add(bytes.data(), bytes.size()); }
    [[nodiscard]] std::vector<QByteArray> finish();

private:
    void feed(const void* data, std::size_t size, bool end);

    std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> m_stream;
    std::vector<QByteArray> m_pieces;
    std::size_t m_filled = 0; ///< bytes in the last piece
};

/// Decompresses such a stream. It never returns more bytes than requested, whatever the pieces
/// hold.
class DeltaReader {
public:
    explicit DeltaReader(const BrickDelta& delta); ///< must outlive this
    ~DeltaReader();
    /// @return the number of bytes that were left, up to @p size
    [[nodiscard]] std::size_t take(void* data, std::size_t size);
    /// Fills a container. @return false: there were fewer bytes
    template <typename Bytes> [[nodiscard]] bool fill(Bytes& bytes)
    {
        return take(bytes.data(), bytes.size()) == bytes.size();
    }
    /// Whether everything was read and the stream ended properly.
    [[nodiscard]] bool complete();

private:
    const BrickDelta& m_delta;
    std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> m_stream;
    std::size_t m_piece = 0;
    std::size_t m_position = 0; ///< in the piece
    bool m_failed = false;
    bool m_complete = false;
};

} // namespace core
