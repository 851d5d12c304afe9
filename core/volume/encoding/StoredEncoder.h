// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Sha256.h"
#include "core/volume/SliceChain.h"
#include "core/volume/encoding/CodeCounts.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace core {

/// Encodes the stored values of one slice exactly and independently of the other slices. Sets
/// encoding, minimum and maximum of @p volume.
/// @param codes stored values in, codes out
void encodeSlice(Volume& volume, std::span<std::uint16_t> codes, const SliceRescale& rescale);

/// Does what encodeStoredValues() does while slices are still arriving: each slice is counted and
/// added to the checksum on the thread that brings it, so that little remains to be done after the
/// last.
class StoredEncoder {
public:
    /// @param loaded must not move; its geometry is set, and its codes have their size
    /// @param slices one per slice k
    StoredEncoder(LoadedVolume& loaded, std::vector<SliceRescale> slices);

    /// The codes of slice @p k contain stored values that no longer change. Any thread; once per
    /// slice.
    void sliceIsThere(int k);
    /// Completes the encoding (encodeStoredValues()). @pre all slices are there
    void finish(bool hasWindow);

private:
    using Counts = std::vector<std::uint64_t>;

    [[nodiscard]] std::span<std::uint16_t> codesOf(int k);
    void addToHash(int k);
    void count(int k);
    void encodeOneScale(int least, int greatest, const Counts& counts, bool hasWindow);
    void encodeOnCommonScale(bool hasWindow);

    LoadedVolume& m_loaded;
    std::vector<SliceRescale> m_slices;
    bool m_oneScale;

    std::mutex m_mutex;
    std::vector<std::unique_ptr<Counts>> m_counts; ///< those to which no thread is adding

    std::optional<int> m_shift; ///< set if each value is the stored number plus this
    std::vector<std::vector<float>> m_valueOfBits; ///< for unsigned and for signed stored values
    Sha256 m_hash;
    SliceChain m_chain;
};

} // namespace core
