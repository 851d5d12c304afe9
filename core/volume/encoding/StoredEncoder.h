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

/// Stored values of one slice by itself to codes, exactly and whatever values the others have: sets
/// encoding, minimum and maximum of @p volume. @param codes: stored values in, codes out
void encodeSlice(Volume& volume, std::span<std::uint16_t> codes, const SliceRescale& rescale);

/// encodeStoredValues() for slices that are still coming: counts each and adds it to the checksum
/// as it comes, on the thread that brings it, so that little is left to do after the last.
class StoredEncoder {
public:
    /// @param loaded stays where it is; its geometry is set, and its codes have their size
    /// @param slices one per slice k
    StoredEncoder(LoadedVolume& loaded, std::vector<SliceRescale> slices);

    /// The codes of slice @p k are stored values now, and stay. Any thread; once for each.
    void sliceIsThere(int k);
    /// What encodeStoredValues() says. @pre all slices are there
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
    std::vector<std::unique_ptr<Counts>> m_counts; ///< that nobody is adding to

    std::optional<int> m_shift; ///< values are stored numbers and this one
    std::vector<std::vector<float>> m_valueOfBits; ///< of unsigned, of signed stored values
    Sha256 m_hash;
    SliceChain m_chain;
};

} // namespace core
