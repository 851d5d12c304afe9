// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace test {

/// While it lives the driver is asked for the impossible instead of some of the storage (buffers,
/// textures, views of textures, mappings) that the program asks for: those calls fail as they do
/// where memory has run out, with the driver's own error. One at a time, in the whole process; GL
/// is called by one thread.
class RefusingGl {
public:
    enum class From { Once, OnAndOn };

    /// @param first which call is the first to be refused, counted from 1; 0: none, they are
    /// counted only
    /// @param from only that one, or every one from there on
    explicit RefusingGl(int first, From from = From::Once);
    /// Now and then one, drawn by lot, @p least to @p most calls after the one before.
    RefusingGl(std::uint32_t seed, int least, int most);
    ~RefusingGl();
    RefusingGl(const RefusingGl&) = delete;
    RefusingGl& operator=(const RefusingGl&) = delete;

    [[nodiscard]] int calls() const; ///< since it began
    [[nodiscard]] int refused() const;

    /// Meanwhile nothing is refused or counted.
    class Pause {
    public:
        explicit Pause(RefusingGl& refusing);
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;
    };
};

} // namespace test
