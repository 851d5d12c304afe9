// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace test {

/// Simulates a driver without memory: while it lives, some allocations of the program (buffers,
/// textures, views of textures, mappings) are replaced by impossible ones, so that they fail with
/// the driver's own error. One at a time, for the whole process; GL is called by a single thread.
class RefusingGl {
public:
    enum class From { Once, OnAndOn };

    /// @param first the first call that is refused, counted from 1; 0: none, calls are only counted
    /// @param from only that call, or every call from there on
    explicit RefusingGl(int first, From from = From::Once);
    /// Commands instead of memory: the n-th dispatch, counted from 1, becomes one that no driver
    /// accepts, and so is not carried out; 0: none, dispatches are only counted.
    struct Dispatch {
        int number = 0;
    };
    explicit RefusingGl(Dispatch refused);
    /// Likewise the n-th shader that is compiled: it has an error.
    struct Shader {
        int number = 0;
    };
    explicit RefusingGl(Shader refused);
    /// A place in the program where memory is asked for, or dispatched (sites()): the first such
    /// call that is made there is refused.
    struct Site {
        std::uint64_t place = 0;
        bool isDispatch = false;
    };
    explicit RefusingGl(Site refused, From from = From::Once);
    /// Refuses single calls at random, @p least to @p most calls apart.
    RefusingGl(std::uint32_t seed, int least, int most);
    ~RefusingGl();
    RefusingGl(const RefusingGl&) = delete;
    RefusingGl& operator=(const RefusingGl&) = delete;

    [[nodiscard]] int calls() const; ///< since the beginning
    [[nodiscard]] int refused() const;
    /// Where each call was made, in order, if calls are only counted: a number that stands for the
    /// functions that were under way, so that calls which differ in nothing but data have the same.
    /// It holds in this process only.
    [[nodiscard]] const std::vector<std::uint64_t>& sites() const;
    /// Where the first call was made that was refused; 0: none was.
    [[nodiscard]] std::uint64_t refusedSite() const;

    /// While it lives nothing is refused or counted.
    class Pause {
    public:
        explicit Pause(RefusingGl& refusing);
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;
    };
};

} // namespace test
