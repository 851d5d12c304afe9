// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <type_traits>
#include <utility>

namespace core {

/// What is being handled, as a value; only inside a catch block. Memory or a thread that cannot be
/// had: OutOfMemory, with what was needed where that is known. Anything else: Internal, with what
/// it says. Throws nothing.
[[nodiscard]] Error errorBeingHandled() noexcept;

/// Calls @p work, which returns nothing or a Result; what it throws is its error. Between code that
/// may throw and whoever waits for a Result: at the top of every thread, command and task.
template <class Work> [[nodiscard]] auto guarded(Work&& work)
{
    using Returned = std::invoke_result_t<Work>;
    using Value = std::conditional_t<std::is_void_v<Returned>, Result<void>, Returned>;
    try {
        if constexpr (std::is_void_v<Returned>) {
            std::forward<Work>(work)();
            return Value();
        } else {
            return Value(std::forward<Work>(work)());
        }
    } catch (...) {
        return Value(tl::unexpected<Error>(errorBeingHandled()));
    }
}

} // namespace core
