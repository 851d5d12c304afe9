// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <type_traits>
#include <utility>

namespace core {

/// Converts the current exception to an error; only inside a catch block. Memory or a thread that
/// is not available gives OutOfMemory, with what was needed if that is known. Anything else gives
/// Internal, with its message. Throws nothing.
[[nodiscard]] Error errorBeingHandled() noexcept;

/// Calls @p work, which returns nothing or a Result, and converts what it throws to an error. It is
/// used between code that may throw and code that expects a Result: at the top of every thread,
/// command and task.
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
