// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/DicomElement.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// Inflates a deflated data set (PS3.5 A.5) as far as it is asked for: 2.0 GiB out of 2 MB were
/// measured, and a header is a few KB.
class Inflater {
public:
    enum class State {
        More, ///< there may be more to come
        Finished, ///< the stream has ended as it should
        Damaged, ///< the stream is cut or no deflated one; what came before stands
        TooLarge, ///< it grows beyond any sensible size
    };

    /// @p deflated must outlive it.
    explicit Inflater(DicomBytes deflated);
    ~Inflater();

    /// Goes on until @p size bytes are there or no more come. So many as @p freeBytes may come out
    /// of however few; beyond, what came must be in some proportion to what it came out of.
    State growTo(std::size_t size, std::size_t freeBytes = std::size_t(64) << 20);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] DicomBytes bytes() const { return m_output; }

private:
    struct Stream;

    std::unique_ptr<Stream> m_stream;
    std::vector<std::uint8_t> m_output;
    State m_state = State::More;
};

} // namespace core
