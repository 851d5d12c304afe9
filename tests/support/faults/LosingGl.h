// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/faults/RedirectedGl.h"

namespace test {

/// Simulates a driver that loses a context, as after a reset of the graphics processor: at the n-th
/// check for GL errors, the context of the checking thread is lost. From then on it reports the
/// loss, and neither computes nor reads or writes anything. Contexts of other threads, and new
/// ones, are sound. One at a time, for the whole process; a context belongs to one thread.
class LosingGl {
public:
    /// How a lost context reports its loss: by an error at every check, as drivers with or without
    /// robust access do, or only by its reset status.
    enum class Tells { ByError, ByStatus };

    /// @param first the check, counted from 1, at which the context is lost; 0: never, checks are
    /// only counted
    /// @param every after so many further checks another context is lost, and so on; 0: never
    explicit LosingGl(int first, int every = 0, Tells tells = Tells::ByError);
    ~LosingGl();
    LosingGl(const LosingGl&) = delete;
    LosingGl& operator=(const LosingGl&) = delete;

    [[nodiscard]] int looks() const; ///< checks of sound contexts since the beginning
    [[nodiscard]] int lost() const; ///< contexts

private:
    RedirectedGl m_gl;
};

} // namespace test
