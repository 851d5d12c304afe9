// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace test {

/// While it lives the driver loses a context, as it does where the graphics processor is reset: at
/// the n-th time that the program looks for GL errors, the context of the thread that looks is lost
/// from then on. It says so, and neither computes nor reads or writes anything any more. Contexts
/// of other threads, and of new ones, are sound. One at a time, in the whole process; a context
/// belongs to one thread.
class LosingGl {
public:
    /// How a lost context tells it: by an error whenever it is asked for one, as drivers do with or
    /// without robust access, or by its reset status alone.
    enum class Tells { ByError, ByStatus };

    /// @param first at which look, counted from 1; 0: at none, they are counted only
    /// @param every after so many more another one, and so on; 0: never again
    explicit LosingGl(int first, int every = 0, Tells tells = Tells::ByError);
    ~LosingGl();
    LosingGl(const LosingGl&) = delete;
    LosingGl& operator=(const LosingGl&) = delete;

    [[nodiscard]] int looks() const; ///< of sound contexts, since it began
    [[nodiscard]] int lost() const; ///< contexts
};

} // namespace test
