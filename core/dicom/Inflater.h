// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/DicomElement.h"

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

    /// Goes on until @p size bytes are there or no more come.
    State growTo(std::size_t size);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] DicomBytes bytes() const { return m_output; }

private:
    struct Stream;

    std::unique_ptr<Stream> m_stream;
    std::vector<std::uint8_t> m_output;
    State m_state = State::More;
};

} // namespace core
