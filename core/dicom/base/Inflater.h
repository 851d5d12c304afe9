// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/DicomElement.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// Inflates a deflated data set (PS3.5 A.5) only as far as it is needed: a header is a few KB,
/// while 2 MB can inflate to 2.0 GiB.
class Inflater {
public:
    enum class State {
        More, ///< there may be more to come
        Finished, ///< the stream has ended properly
        Damaged, ///< the stream is cut off or invalid; the output before that is usable
        TooLarge, ///< it grows beyond any reasonable size
    };

    /// @param deflated must outlive this
    explicit Inflater(DicomBytes deflated);
    ~Inflater();

    /// Continues until @p size bytes are available or the stream ends. Up to @p freeBytes are
    /// accepted from any input; beyond that, output must be in proportion to input.
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
